import * as format from "./format";

/** A line of an audit: its name, as "energy: work", and its value as the file has it. */
export interface AuditRow {
  name: string;
  value: unknown;
}

/** The lines of an audit in their order; those of bodies and the warnings are left out. */
export function auditRows(audit: Record<string, unknown>): AuditRow[] {
  const rowsOf = (prefix: string, values: Record<string, unknown>): AuditRow[] =>
    Object.entries(values).flatMap(([key, value]) => {
      if (prefix === "" && (key === "bodies" || key === "warnings")) return [];
      const name = prefix ? `${prefix}: ${key.replace(/_/g, " ")}` : key.replace(/_/g, " ");
      const isGroup = value !== null && typeof value === "object" && !Array.isArray(value);
      return isGroup ? rowsOf(name, value as Record<string, unknown>) : [{ name, value }];
    });
  return rowsOf("", audit);
}

export function auditWarnings(audit: Record<string, unknown>): string[] {
  return (audit.warnings as string[] | undefined) ?? [];
}

/** Whether nothing broke its tolerance. */
export function isSound(audit: Record<string, unknown>): boolean {
  return !auditWarnings(audit).some((warning) => warning.startsWith("violated"));
}

/** A part of a run that one scheme made. */
interface Span {
  scheme: string;
  begin: number;
  end: number;
  end_cause: string | null;
}
const isSpan = (value: unknown): value is Span => typeof value === "object" && value !== null && "scheme" in value && "begin" in value;

export function auditText(value: unknown): string {
  if (value === null || value === undefined) return "–";
  if (Array.isArray(value)) return value.every(isSpan) ? value.map(auditText).join("; ") : value.map(auditText).join(" ↔ ");
  if (isSpan(value)) return `${value.scheme} ${format.number(value.begin, 4)} to ${format.number(value.end, 4)} s${value.end_cause ? ` (${value.end_cause})` : ""}`;
  if (typeof value === "object") return JSON.stringify(value);
  if (typeof value !== "number") return String(value);
  return Number.isInteger(value) ? String(value) : format.number(value, 8);
}
