#!/usr/bin/env python3
"""How much clients that behave badly slow a live simulation (Linux, Python's standard library only).

usage: benchmarks/live_load.py RIGOR [SCENE] [SECONDS]

Starts `rigor view` as fast as it goes, with one honest page open, and reads for each load how much processor time the
simulation's thread and the server's took. The simulation is slowed by what the server takes from it: on one processor
that is at most server / (server + simulation). Also told: simulated seconds a second of the simulation's processor time,
and how long another honest page waits for its answer at most.
exit code: 0 if a page behind a thousand idle connections waits no longer than a second, else 1
"""
import json
import os
import socket
import struct
import subprocess
import sys
import threading
import time

TICKS = os.sysconf("SC_CLK_TCK")


def thread_times(process):
    """Processor seconds of each thread, the main one (the server) first."""
    times = {}
    for task in os.listdir(f"/proc/{process}/task"):
        with open(f"/proc/{process}/task/{task}/stat") as stat:
            fields = stat.read().rsplit(")", 1)[1].split()
        times[int(task)] = (int(fields[11]) + int(fields[12])) / TICKS
    return [times.pop(process), sum(times.values())]


class Page:
    """An honest WebSocket client that reads what comes and remembers the newest time."""

    def __init__(self, port, token):
        self.time = 0.0
        self.socket = socket.create_connection(("127.0.0.1", port))
        host = f"127.0.0.1:{port}"
        self.socket.sendall((f"GET /live?token={token} HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\n"
                             "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n").encode())
        self.stream = self.socket.makefile("rb")
        while self.stream.readline() != b"\r\n":
            pass
        threading.Thread(target=self.read, daemon=True).start()

    def send(self, command):
        text = json.dumps(command).encode()
        self.socket.sendall(bytes([0x81, 0x80 | len(text)]) + bytes(4) + text)

    def read(self):
        try:
            while True:
                opcode, size = self.stream.read(2)
                size &= 127
                if size > 125:
                    size = int.from_bytes(self.stream.read(2 if size == 126 else 8), "big")
                message = self.stream.read(size)
                if opcode & 15 == 9:  # a ping: the server asks for a sign of life
                    self.socket.sendall(bytes([0x8A, 0x80 | len(message)]) + bytes(4) + message)
                if opcode & 15 == 2 and message[0] == 1:  # a frame
                    self.time = struct.unpack_from("<d", message, 20)[0]
        except (OSError, ValueError):
            pass


def connections(port, over):
    while not over.is_set():
        try:
            socket.create_connection(("127.0.0.1", port), timeout=1).close()
        except OSError:
            time.sleep(0.001)


def idle_connections(port, over):
    """A thousand, half of which have begun a request that never ends."""
    clients = []
    for k in range(1000):
        clients.append(socket.create_connection(("127.0.0.1", port), timeout=5))
        if k % 2 == 0:
            clients[-1].send(b"G")
    over.wait()


def longest_wait(port, token, rounds=5):
    """Seconds after which the page has come, in the worst of some rounds."""
    request = f"GET /?token={token} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode()
    longest = 0
    for _ in range(rounds):
        begin = time.monotonic()
        with socket.create_connection(("127.0.0.1", port), timeout=60) as client:
            client.sendall(request)
            if not client.recv(1000).startswith(b"HTTP/1.1 200"):
                return float("inf")
        longest = max(longest, time.monotonic() - begin)
    return longest


def slow_clients(port, over):
    clients = []
    while not over.is_set():
        try:
            while len(clients) < 100:
                clients.append(socket.create_connection(("127.0.0.1", port), timeout=1))
            for client in clients:
                client.send(b"G")
        except OSError:
            clients = []
        over.wait(0.2)


def large_requests(port, over):
    request = b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: " + 100000 * b"a" + b"\r\n\r\n"
    while not over.is_set():
        try:
            with socket.create_connection(("127.0.0.1", port), timeout=1) as client:
                client.sendall(request)
                client.recv(1000)
        except OSError:
            time.sleep(0.001)


def foreign_requests(port, over):
    request = f"GET /live?token=0 HTTP/1.1\r\nHost: evil.example:{port}\r\nOrigin: http://evil.example\r\n\r\n".encode()
    while not over.is_set():
        try:
            with socket.create_connection(("127.0.0.1", port), timeout=1) as client:
                client.sendall(request)
                client.recv(1000)
        except OSError:
            time.sleep(0.001)


LOADS = {"an honest page alone": [], "connections without end": 4 * [connections],
         "1,000 idle connections": [idle_connections], "100 slow clients": [slow_clients],
         "requests of 100 kB": 4 * [large_requests], "a malicious page": 4 * [foreign_requests],
         "all of these": [connections, slow_clients, large_requests, foreign_requests]}


def main():
    program = sys.argv[1]
    scene = sys.argv[2] if len(sys.argv) > 2 else "scenes/gas.yaml"
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 8
    view = subprocess.Popen([program, "view", scene], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        url = view.stdout.readline().strip()
        port, token = int(url.split(":")[2].split("/")[0]), url.split("=")[1]
        page = Page(port, token)
        page.send({"do": "speed", "value": 1e6})
        page.send({"do": "run"})
        time.sleep(1)
        print(f"{'load':28} {'server takes':>13} {'simulated s a processor s':>27} {'a page waits':>13}")
        waits = {}
        for name, workers in LOADS.items():
            # What the load before has left in the queue is not of this one.
            while longest_wait(port, token, 1) > 0.05:
                time.sleep(0.1)
            over = threading.Event()
            threads = [threading.Thread(target=worker, args=(port, over)) for worker in workers]
            for thread in threads:
                thread.start()
            # A page is asked for as soon as the load is there: the server gives up requests that do not end.
            time.sleep(0.1)
            waits[name] = longest_wait(port, token)
            (server, simulation), simulated = thread_times(view.pid), page.time
            time.sleep(seconds)
            (server_end, simulation_end), simulated_end = thread_times(view.pid), page.time
            waits[name] = max(waits[name], longest_wait(port, token))
            over.set()
            for thread in threads:
                thread.join()
            server, simulation = server_end - server, simulation_end - simulation
            print(f"{name:28} {100 * server / (server + simulation):11.2f} % {(simulated_end - simulated) / simulation:27.4f} "
                  f"{waits[name]:11.3f} s", flush=True)
        return 0 if waits["1,000 idle connections"] <= 1 else 1
    finally:
        view.terminate()
        view.wait()


if __name__ == "__main__":
    sys.exit(main())
