/*! Rigor viewer, Apache-2.0. Contains three.js 0.170.0 (MIT, Copyright 2010-2024 three.js authors)
and uPlot 1.6.31 (MIT, Copyright (c) 2022 Leon Sorokin); the full notices are in NOTICE. */
"use strict";(()=>{function Kt(i,t=5){if(!Number.isFinite(i))return"\u2013";if(i===0)return"0";let e=Math.abs(i);return(e>=1e5||e<.001?i.toExponential(t-1):i.toPrecision(t)).replace(/(\.\d*?)0+(e|$)/,"$1$2").replace(/\.(e|$)/,"$1").replace("e+","e").replace(/-/g,"\u2212")}function Yi(i,t=4){return Array.from(i,e=>Kt(e,t)).join(", ")}function $i(i,t){let e=Math.min(9,Math.max(2,Math.ceil(-Math.log10(t||1))));return i.toFixed(e)}function La(i){return i<.5?`1/${Math.round(1/i)}\xD7`:`${i}\xD7`}function Da(i){let t=(e,n)=>Object.entries(n).flatMap(([s,r])=>{if(e===""&&(s==="bodies"||s==="warnings"))return[];let o=e?`${e}: ${s.replace(/_/g," ")}`:s.replace(/_/g," ");return r!==null&&typeof r=="object"&&!Array.isArray(r)?t(o,r):[{name:o,value:r}]});return t("",i)}function Rr(i){return i.warnings??[]}function zo(i){return!Rr(i).some(t=>t.startsWith("violated"))}var wf=i=>typeof i=="object"&&i!==null&&"scheme"in i&&"begin"in i;function Bs(i){return i==null?"\u2013":Array.isArray(i)?i.every(wf)?i.map(Bs).join("; "):i.map(Bs).join(" \u2194 "):wf(i)?`${i.scheme} ${Kt(i.begin,4)} to ${Kt(i.end,4)} s${i.end_cause?` (${i.end_cause})`:""}`:typeof i=="object"?JSON.stringify(i):typeof i!="number"||Number.isInteger(i)?String(i):Kt(i,8)}var yv=/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028\u2029\u202a-\u202e\u2066-\u2069]/g;function Pr(i){return i.replace(yv,t=>`\\u${t.charCodeAt(0).toString(16).padStart(4,"0")}`)}function U(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===void 0||r===!1||(s.startsWith("on")?n.addEventListener(s.slice(2),r):s==="style"?n.style.cssText=String(r):s==="text"?n.textContent=Pr(String(r)):n.setAttribute(s,r===!0?"":String(r)));for(let s of e)s!==void 0&&n.append(typeof s=="string"?Pr(s):s);return n}function Se(i,t,e){let n=i.replace(/[^\p{L}\p{N} ]/gu,"").trim(),s=t.toLowerCase().includes(n.toLowerCase());return U("button",{type:"button",title:t,"aria-label":s?t:`${n}: ${t}`,onclick:e},i)}var te={orange:"#e69f00",skyBlue:"#56b4e9",green:"#009e73",yellow:"#f0e442",blue:"#0072b2",vermilion:"#d55e00",purple:"#cc79a7",grey:"#8c8c8c"},Zc=[te.skyBlue,te.orange,te.green,te.purple,te.yellow,te.blue,te.vermilion],Pe={stick:te.green,slide:te.vermilion,open:te.grey,unknown:te.grey,normal:te.skyBlue,velocity:te.yellow,impulse:te.purple,penetration:te.vermilion,x:te.vermilion,y:te.green,z:te.blue,selected:te.orange,ghost:te.skyBlue},Jc=[te.skyBlue,te.orange,te.green,te.purple,te.vermilion,te.blue,te.yellow,te.grey];function wn(i){let t=/^#([0-9a-f])([0-9a-f])([0-9a-f])$/i.exec(i),n=(t?t.slice(1).map(s=>s+s):/^#(..)(..)(..)$/.exec(i)?.slice(1))?.map(s=>parseInt(s,16)/255)??[];return n.length===3&&n.every(Number.isFinite)?n:[.55,.55,.55]}function Ir(i){return i.map(({header:t},e)=>t.label??`run ${e+1}`)}function Ua(i){let t=/[^\s,=]+=/g,e=n=>(n.match(t)??[]).join();return i.every(n=>e(n)===e(i[0]))?i.map(n=>n.replace(t,"")):i}function Sn(i){return Jc[i%Jc.length]}function Kc(i){let t=i.map(n=>new Map(Da(n).map(({name:s,value:r})=>[s,r])));return[...new Set(t.flatMap(n=>[...n.keys()]))].map(n=>{let s=t.map(r=>r.get(n));return{name:n,isSetting:xv(n),values:s.map(Bs),differs:s.map(r=>JSON.stringify(r)!==JSON.stringify(s[0]))}})}var xv=i=>/^(method: |rigor$|scene$|scheme_?\s?reason|duration$|step$)/.test(i);function _v({header:i}){return i.stopped?U("td",{class:"broken"},U("p",{text:`\u2717 stopped: ${i.stopped}`})):zo(i.audit)?U("td",{class:"sound",text:"\u2713 audit passed"}):U("td",{class:"broken",text:"\u2717 audit violated"})}function Ef(i){let t=Ir(i),e=Ua(t),n=i.map(({header:E})=>E.audit),s=U("tr",{},U("td"),...e.map((E,S)=>U("th",{scope:"col",title:t[S]},U("span",{class:"dot",style:`background:${Sn(S)}`}),E))),r=U("tr",{},U("th",{scope:"row",text:"ended"}),...i.map(_v)),o=Kc(n),a=({name:E,values:S,differs:M,isSetting:D})=>{let P=M.includes(!0);return U("tr",{class:[P?"":"same",D?"setting":""].join(" ").trim()||void 0},U("th",{scope:"row",text:P?`\u2260 ${E}`:E}),...S.map((I,F)=>U("td",{class:M[F]?"differs":void 0,text:I})))},l=o.filter(E=>!E.isSetting),c=o.filter(E=>E.isSetting),h=c.filter(({differs:E})=>!E.includes(!0)).length,d=U("button",{type:"button",class:"link",id:"equal-settings","aria-expanded":"false",onclick:()=>{let E=y.classList.toggle("folded");d.setAttribute("aria-expanded",String(!E)),d.textContent=Sf(h,E)}},Sf(h,!0)),u=U("tr",{class:"group"},U("th",{scope:"row"},"Settings"),U("td",{colspan:n.length},h>0?d:"")),f=n.some(E=>Rr(E).length>0),g=U("tr",{},U("th",{scope:"row",text:"warnings"}),...n.map(E=>U("td",{},...Rr(E).map(S=>U("p",{class:"warning",text:S}))))),y=U("tbody",{class:"folded"},r,f?g:void 0,...l.map(a),u,...c.map(a)),m=U("table",{},U("thead",{},s),y),p=U("input",{type:"checkbox",id:"only-differences",onchange:()=>m.classList.toggle("only",p.checked)});return U("section",{class:"audits"},U("h2",{},"Audits",U("small",{text:" \u2260: not the same in all runs; marked: other than in the first"})),U("label",{},p,"only what differs"),U("div",{class:"wide",tabindex:0,role:"region","aria-label":"Audits side by side"},m))}function Sf(i,t){return`${t?"show":"hide"} the ${i} that are the same in all runs`}var cn="u-",bv="uplot",Mv=cn+"hz",wv=cn+"vt",Sv=cn+"title",Ev=cn+"wrap",Av=cn+"under",Tv=cn+"over",Cv=cn+"axis",Hs=cn+"off",Rv=cn+"select",Pv=cn+"cursor-x",Iv=cn+"cursor-y",Lv=cn+"cursor-pt",Dv=cn+"legend",Uv=cn+"live",Nv=cn+"inline",Fv=cn+"series",Ov=cn+"marker",Af=cn+"label",kv=cn+"value",Go="width",Wo="height",Vo="top",Tf="bottom",Lr="left",jc="right",ph="#000",Cf=ph+"0",Rf="mousemove",Pf="mousedown",Qc="mouseup",If="mouseenter",Lf="mouseleave",Df="dblclick",Bv="resize",zv="scroll",Uf="change",Ba="dppxchange",mh="--",zr=typeof window<"u",sh=zr?document:null,Ur=zr?window:null,Vv=zr?navigator:null,be,Na;function rh(){let i=devicePixelRatio;be!=i&&(be=i,Na&&ah(Uf,Na,rh),Na=matchMedia(`(min-resolution: ${be-.001}dppx) and (max-resolution: ${be+.001}dppx)`),Gs(Uf,Na,rh),Ur.dispatchEvent(new CustomEvent(Ba)))}function $n(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function oh(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function ze(i,t,e){i.style[t]=e+"px"}function bi(i,t,e,n){let s=sh.createElement(i);return t!=null&&$n(s,t),e?.insertBefore(s,n),s}function li(i,t){return bi("div",i,t)}var Nf=new WeakMap;function Oi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Nf.get(i);r!=o&&(i.style.transform=r,Nf.set(i,r),t<0||e<0||t>n||e>s?$n(i,Hs):oh(i,Hs))}var Ff=new WeakMap;function Of(i,t,e){let n=t+e,s=Ff.get(i);n!=s&&(Ff.set(i,n),i.style.background=t,i.style.borderColor=e)}var kf=new WeakMap;function Bf(i,t,e,n){let s=t+""+e,r=kf.get(i);s!=r&&(kf.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var gh={passive:!0},Hv={...gh,capture:!0};function Gs(i,t,e,n){t.addEventListener(i,e,n?Hv:gh)}function ah(i,t,e,n){t.removeEventListener(i,e,gh)}zr&&rh();function Mi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:Zn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Nr(i,t,e,n){for(let s=n==1?t:e;s>=t&&s<=e;s+=n)if(i[s]!=null)return s;return-1}function Gv(i,t,e,n){let s=fe,r=-fe;if(n==1)s=i[t],r=i[e];else if(n==-1)s=i[e],r=i[t];else for(let o=t;o<=e;o++){let a=i[o];a!=null&&(a<s&&(s=a),a>r&&(r=a))}return[s,r]}function Wv(i,t,e){let n=fe,s=-fe;for(let r=t;r<=e;r++){let o=i[r];o!=null&&o>0&&(o<n&&(n=o),o>s&&(s=o))}return[n,s]}function Ha(i,t,e,n){let s=Hf(i),r=Hf(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Zi:fp,a=s==1?Zn:ci,l=r==1?ci:Zn,c=a(o(an(i))),h=l(o(an(t))),d=Fr(e,c),u=Fr(e,h);return e==10&&(c<0&&(d=Ne(d,-c)),h<0&&(u=Ne(u,-h))),n||e==2?(i=d*s,t=u*r):(i=gp(i,d),t=Ga(t,u)),[i,t]}function vh(i,t,e,n){let s=Ha(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var yh=.1,zf={mode:3,pad:yh},qo={pad:0,soft:null,mode:0},Xv={min:qo,max:qo};function za(i,t,e,n){return Wa(e)?Vf(i,t,e):(qo.pad=e,qo.soft=n?0:null,qo.mode=n?3:0,Vf(i,t,Xv))}function xe(i,t){return i??t}function qv(i,t,e){for(t=xe(t,0),e=xe(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Vf(i,t,e){let n=e.min,s=e.max,r=xe(n.pad,0),o=xe(s.pad,0),a=xe(n.hard,-fe),l=xe(s.hard,fe),c=xe(n.soft,fe),h=xe(s.soft,-fe),d=xe(n.mode,0),u=xe(s.mode,0),f=t-i,g=Zi(f),y=En(an(i),an(t)),m=Zi(y),p=an(m-g);(f<1e-24||p>10)&&(f=0,(i==0||t==0)&&(f=1e-24,d==2&&c!=fe&&(r=0),u==2&&h!=-fe&&(o=0)));let E=f||y||1e3,S=Zi(E),M=Fr(10,Zn(S)),D=E*(f==0?i==0?.1:1:r),P=Ne(gp(i-D,M/10),24),I=i>=c&&(d==1||d==3&&P<=c||d==2&&P>=c)?c:fe,F=En(a,P<I&&i>=I?I:hi(I,P)),A=E*(f==0?t==0?.1:1:o),b=Ne(Ga(t+A,M/10),24),T=t<=h&&(u==1||u==3&&b>=h||u==2&&b<=h)?h:-fe,W=hi(l,b>T&&t<=T?T:En(T,b));return F==W&&F==0&&(W=100),[F,W]}var Yv=new Intl.NumberFormat(zr?Vv.language:"en-US"),xh=i=>Yv.format(i),Jn=Math,ka=Jn.PI,an=Jn.abs,Zn=Jn.floor,on=Jn.round,ci=Jn.ceil,hi=Jn.min,En=Jn.max,Fr=Jn.pow,Hf=Jn.sign,Zi=Jn.log10,fp=Jn.log2,$v=(i,t=1)=>Jn.sinh(i)*t,th=(i,t=1)=>Jn.asinh(i/t),fe=1/0;function Gf(i){return(Zi((i^i>>31)-(i>>31))|0)+1}function lh(i,t,e){return hi(En(i,t),e)}function de(i){return typeof i=="function"?i:()=>i}var Zv=()=>{},pp=i=>i,mp=(i,t)=>t,Jv=i=>null,Wf=i=>!0,Xf=(i,t)=>i==t,Kv=/\.\d*?(?=9{6,}|0{6,})/gm,Ws=i=>{if(yp(i)||_s.has(i))return i;let t=`${i}`,e=t.match(Kv);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Ws(s)}e${r}`}return Ne(i,n)};function zs(i,t){return Ws(Ne(Ws(i/t))*t)}function Ga(i,t){return Ws(ci(Ws(i/t))*t)}function gp(i,t){return Ws(Zn(Ws(i/t))*t)}function Ne(i,t=0){if(yp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return on(n)/e}var _s=new Map;function vp(i){return((""+i).split(".")[1]||"").length}function $o(i,t,e,n){let s=[],r=n.map(vp);for(let o=t;o<e;o++){let a=an(o),l=Ne(Fr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=i==10?h:Ne(h,d);s.push(u),_s.set(u,d)}}return s}var Yo={},_h=[],Or=[null,null],xs=Array.isArray,yp=Number.isInteger,jv=i=>i===void 0;function qf(i){return typeof i=="string"}function Wa(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Qv(i){return i!=null&&typeof i=="object"}var ty=Object.getPrototypeOf(Uint8Array),xp="__proto__";function kr(i,t=Wa){let e;if(xs(i)){let n=i.find(s=>s!=null);if(xs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=kr(i[s],t)}else e=i.slice()}else if(i instanceof ty)e=i.slice();else if(t(i)){e={};for(let n in i)n!=xp&&(e[n]=kr(i[n],t))}else e=i;return e}function en(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=xp&&(Wa(i[s])?en(i[s],kr(n[s])):i[s]=kr(n[s]))}return i}var ey=0,ny=1,iy=2;function sy(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function ry(i,t){if(ly(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return cy(o[0])||(o=ay(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=t?t[o][c]:ny,f=[];for(let g=0;g<h.length;g++){let y=h[g],m=r.get(l[g]);y===null?u!=ey&&(d[m]=y,u==iy&&f.push(m)):d[m]=y}sy(d,f,s),n.push(d)}}return n}var oy=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function ay(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function ly(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function cy(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=En(1,Zn((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var _p=["January","February","March","April","May","June","July","August","September","October","November","December"],bp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Mp(i){return i.slice(0,3)}var hy=bp.map(Mp),uy=_p.map(Mp),dy={MMMM:_p,MMM:uy,WWWW:bp,WWW:hy};function Ho(i){return(i<10?"0":"")+i}function fy(i){return(i<10?"00":i<100?"0":"")+i}var py={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Ho(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ho(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Ho(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ho(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ho(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>fy(i.getMilliseconds())};function bh(i,t){t=t||dy;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?py[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var my=new Intl.DateTimeFormat().resolvedOptions().timeZone;function gy(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==my?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var wp=i=>i%1==0,Va=[1,2,2.5,5],vy=$o(10,-32,0,Va),Sp=$o(10,0,32,Va),yy=Sp.filter(wp),Vs=vy.concat(Sp),Mh=`
`,Ep="{YYYY}",Yf=Mh+Ep,Ap="{M}/{D}",Xo=Mh+Ap,Fa=Xo+"/{YY}",Tp="{aa}",xy="{h}:{mm}",Dr=xy+Tp,$f=Mh+Dr,Zf=":{ss}",Ee=null;function Cp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?$o(10,0,3,Va).filter(wp):$o(10,-3,0,Va)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Ep,Ee,Ee,Ee,Ee,Ee,Ee,1],[s*28,"{MMM}",Yf,Ee,Ee,Ee,Ee,Ee,1],[s,Ap,Yf,Ee,Ee,Ee,Ee,Ee,1],[n,"{h}"+Tp,Fa,Ee,Xo,Ee,Ee,Ee,1],[e,Dr,Fa,Ee,Xo,Ee,Ee,Ee,1],[t,Zf,Fa+" "+Dr,Ee,Xo+" "+Dr,Ee,$f,Ee,1],[i,Zf+".{fff}",Fa+" "+Dr,Ee,Xo+" "+Dr,Ee,$f,Ee,1]];function h(d){return(u,f,g,y,m,p)=>{let E=[],S=m>=o,M=m>=r&&m<o,D=d(g),P=Ne(D*i,3),I=eh(D.getFullYear(),S?0:D.getMonth(),M||S?1:D.getDate()),F=Ne(I*i,3);if(M||S){let A=M?m/r:0,b=S?m/o:0,T=P==F?P:Ne(eh(I.getFullYear()+b,I.getMonth()+A,1)*i,3),W=new Date(on(T/i)),H=W.getFullYear(),q=W.getMonth();for(let J=0;T<=y;J++){let $=eh(H+b*J,q+A*J,1),nt=$-d(Ne($*i,3));T=Ne((+$+nt)*i,3),T<=y&&E.push(T)}}else{let A=m>=s?s:m,b=Zn(g)-Zn(P),T=F+b+Ga(P-F,A);E.push(T);let W=d(T),H=W.getHours()+W.getMinutes()/e+W.getSeconds()/n,q=m/n,J=u.axes[f]._space,$=p/J;for(;T=Ne(T+m,i==1?0:3),!(T>y);)if(q>1){let nt=Zn(Ne(H+q,6))%24,ot=d(T).getHours()-nt;ot>1&&(ot=-1),T-=ot*n,H=(H+q)%24;let mt=E[E.length-1];Ne((T-mt)/m,3)*$>=.7&&E.push(T)}else E.push(T)}return E}}return[l,c,h]}var[_y,by,My]=Cp(1),[wy,Sy,Ey]=Cp(.001);$o(2,-53,53,[1]);function Jf(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Kf(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,d,u,f;return n.map(g=>{let y=i(g),m=y.getFullYear(),p=y.getMonth(),E=y.getDate(),S=y.getHours(),M=y.getMinutes(),D=y.getSeconds(),P=m!=l&&a[2]||p!=c&&a[3]||E!=h&&a[4]||S!=d&&a[5]||M!=u&&a[6]||D!=f&&a[7]||a[1];return l=m,c=p,h=E,d=S,u=M,f=D,P(y)})}}function Ay(i,t){let e=bh(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function eh(i,t,e){return new Date(i,t,e)}function jf(i,t){return t(i)}var Ty="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Qf(i,t){return(e,n,s,r)=>r==null?mh:t(i(n))}function Cy(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Ry(i,t){return i.series[t].fill(i,t)}var Py={show:!0,live:!0,isolate:!1,mount:Zv,markers:{show:!0,width:2,stroke:Cy,fill:Ry,dash:"solid"},idx:null,idxs:null,values:[]};function Iy(i,t){let e=i.cursor.points,n=li(),s=e.size(i,t);ze(n,Go,s),ze(n,Wo,s);let r=s/-2;ze(n,"marginLeft",r),ze(n,"marginTop",r);let o=e.width(i,t,s);return o&&ze(n,"borderWidth",o),n}function Ly(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Dy(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Uy(i,t){return i.series[t].points.size}var nh=[0,0];function Ny(i,t,e){return nh[0]=t,nh[1]=e,nh}function Oa(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function ih(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var Fy={show:!0,x:!0,y:!0,lock:!1,move:Ny,points:{one:!1,show:Iy,size:Uy,width:0,stroke:Dy,fill:Ly},bind:{mousedown:Oa,mouseup:Oa,click:Oa,dblclick:Oa,mousemove:ih,mouseleave:ih,mouseenter:ih},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Rp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},wh=en({},Rp,{filter:mp}),Pp=en({},wh,{size:10}),Ip=en({},Rp,{show:!1}),Sh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Lp="bold "+Sh,Dp=1.5,tp={show:!0,scale:"x",stroke:ph,space:50,gap:5,size:50,labelGap:0,labelSize:30,labelFont:Lp,side:2,grid:wh,ticks:Pp,border:Ip,font:Sh,lineGap:Dp,rotate:0},Oy="Value",ky="Time",ep={show:!0,scale:"x",auto:!1,sorted:1,min:fe,max:-fe,idxs:[]};function By(i,t,e,n,s){return t.map(r=>r==null?"":xh(r))}function zy(i,t,e,n,s,r,o){let a=[],l=_s.get(s)||0;e=o?e:Ne(Ga(e,s),l);for(let c=e;c<=n;c=Ne(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ch(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Zi:fp,h=Zn(c(e));s=Fr(l,h),l==10&&(s=Vs[Mi(s,Vs)]);let d=e,u=s*l;l==10&&(u=Vs[Mi(u,Vs)]);do a.push(d),d=d+s,l==10&&!_s.has(d)&&(d=Ne(d,_s.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Vs[Mi(u,Vs)]));while(d<=n);return a}function Vy(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?ch(i,t,En(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?ch(i,t,En(l,-n),-e,s):[l]).reverse().map(u=>-u).concat(h,c)}var Up=/./,Hy=/[12357]/,Gy=/[125]/,np=/1/,hh=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Wy(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?Up:l(7,o)-h>=c?Hy:l(5,o)-h>=c?Gy:np;if(d==np){let u=an(l(1,o)-h);if(u<c)return hh(t.slice().reverse(),a.distr,d,ci(c/u)).reverse()}return hh(t,a.distr,d,1)}function Xy(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=an(l(1,o)-l(2,o));return c<a?hh(t.slice().reverse(),3,Up,ci(a/c)).reverse():t}function qy(i,t,e,n){return n==null?mh:t==null?"":xh(t)}var ip={show:!0,scale:"y",stroke:ph,space:30,gap:5,size:50,labelGap:0,labelSize:30,labelFont:Lp,side:3,grid:wh,ticks:Pp,border:Ip,font:Sh,lineGap:Dp,rotate:0};function Yy(i,t){let e=3+(i||1)*2;return Ne(e*t,3)}function $y(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=an(o-r),l=i.series[t],c=a/(l.points.space*be);return n[1]-n[0]<=c}var sp={scale:null,auto:!0,sorted:0,min:fe,max:-fe},Np=(i,t,e,n,s)=>s,rp={show:!0,auto:!0,sorted:0,gaps:Np,alpha:1,facets:[en({},sp,{scale:"x"}),en({},sp,{scale:"y"})]},op={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Np,alpha:1,points:{show:$y,filter:null},values:null,min:fe,max:-fe,idxs:[],path:null,clip:null};function Zy(i,t,e,n,s){return e/10}var Fp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Jy=en({},Fp,{time:!1,ori:1}),ap={};function Op(i,t){let e=ap[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(ap[i]=e)),e}var Br=1,uh=2;function Xs(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,g=a.width,y=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?e(s,l,c,h,d,m,p,u,f,g,y,qa,Vr,$a,Bp,Vp):e(s,l,c,h,d,p,m,f,u,y,g,Ya,Hr,Th,zp,Hp)}function Eh(i,t){let e=0,n=0,s=xe(i.bands,_h);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Ky(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ji(i,t,e,n,s,r){return Xs(i,t,(o,a,l,c,h,d,u,f,g,y,m)=>{let p=o.pxRound,E=c.dir*(c.ori==0?1:-1),S=c.ori==0?Vr:Hr,M,D;E==1?(M=e,D=n):(M=n,D=e);let P=p(d(a[M],c,y,f)),I=p(u(l[M],h,m,g)),F=p(d(a[D],c,y,f)),A=p(u(r==1?h.max:h.min,h,m,g)),b=new Path2D(s);return S(b,F,A),S(b,P,A),S(b,P,I),b})}function Xa(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?$a:Th,l=e;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&a(o,l,n,f,n+r),l=u[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function jy(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Ah(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let f=r(i[d]),g=u==d?f:r(i[u]),y=d-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let p=u+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&a.push([f,g])}return a}function lp(i){return i==0?pp:i==1?on:t=>zs(t,i)}function kp(i){let t=i==0?qa:Ya,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=hi(c,a/2,l/2),h=hi(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var qa=(i,t,e)=>{i.moveTo(t,e)},Ya=(i,t,e)=>{i.moveTo(e,t)},Vr=(i,t,e)=>{i.lineTo(t,e)},Hr=(i,t,e)=>{i.lineTo(e,t)},$a=kp(0),Th=kp(1),Bp=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},zp=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Vp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Hp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function Gp(i){return(t,e,n,s,r)=>Xs(t,e,(o,a,l,c,h,d,u,f,g,y,m)=>{let{pxRound:p,points:E}=o,S,M;c.ori==0?(S=qa,M=Bp):(S=Ya,M=zp);let D=Ne(E.width*be,3),P=(E.size-E.width)/2*be,I=Ne(P*2,3),F=new Path2D,A=new Path2D,{left:b,top:T,width:W,height:H}=t.bbox;$a(A,b-I,T-I,W+I*2,H+I*2);let q=J=>{if(l[J]!=null){let $=p(d(a[J],c,y,f)),nt=p(u(l[J],h,m,g));S(F,$+P,nt),M(F,$,nt,P,0,ka*2)}};if(r)r.forEach(q);else for(let J=n;J<=s;J++)q(J);return{stroke:D>0?F:null,fill:F,clip:A,flags:Br|uh}})}function Wp(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Qy=Wp(Vr),tx=Wp(Hr);function Xp(i){let t=xe(i?.alignGaps,0);return(e,n,s,r)=>Xs(e,n,(o,a,l,c,h,d,u,f,g,y,m)=>{let p=o.pxRound,E=ft=>p(d(ft,c,y,f)),S=ft=>p(u(ft,h,m,g)),M,D;c.ori==0?(M=Vr,D=Qy):(M=Hr,D=tx);let P=c.dir*(c.ori==0?1:-1),I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Br},F=I.stroke,A=fe,b=-fe,T,W,H,q=E(a[P==1?s:r]),J=Nr(l,s,r,1*P),$=Nr(l,s,r,-1*P),nt=E(a[J]),Q=E(a[$]),ht=!1;for(let ft=P==1?s:r;ft>=s&&ft<=r;ft+=P){let Wt=E(a[ft]),K=l[ft];Wt==q?K!=null?(W=S(K),A==fe&&(M(F,Wt,W),T=W),A=hi(W,A),b=En(W,b)):K===null&&(ht=!0):(A!=fe&&(D(F,q,A,b,T,W),H=q),K!=null?(W=S(K),M(F,Wt,W),A=b=T=W):(A=fe,b=-fe,K===null&&(ht=!0)),q=Wt)}A!=fe&&A!=b&&H!=q&&D(F,q,A,b,T,W);let[ot,mt]=Eh(e,n);if(o.fill!=null||ot!=0){let ft=I.fill=new Path2D(F),Wt=o.fillTo(e,n,o.min,o.max,ot),K=S(Wt);M(ft,Q,K),M(ft,nt,K)}if(!o.spanGaps){let ft=[];ht&&ft.push(...Ah(a,l,s,r,P,E,t)),I.gaps=ft=o.gaps(e,n,s,r,ft),I.clip=Xa(ft,c.ori,f,g,y,m)}return mt!=0&&(I.band=mt==2?[Ji(e,n,s,r,F,-1),Ji(e,n,s,r,F,1)]:Ji(e,n,s,r,F,mt)),I})}function ex(i){let t=xe(i.align,1),e=xe(i.ascDesc,!1),n=xe(i.alignGaps,0),s=xe(i.extend,!1);return(r,o,a,l)=>Xs(r,o,(c,h,d,u,f,g,y,m,p,E,S)=>{let M=c.pxRound,{left:D,width:P}=r.bbox,I=ot=>M(g(ot,u,E,m)),F=ot=>M(y(ot,f,S,p)),A=u.ori==0?Vr:Hr,b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Br},T=b.stroke,W=u.dir*(u.ori==0?1:-1);a=Nr(d,a,l,1),l=Nr(d,a,l,-1);let H=F(d[W==1?a:l]),q=I(h[W==1?a:l]),J=q,$=q;s&&t==-1&&($=D,A(T,$,H)),A(T,q,H);for(let ot=W==1?a:l;ot>=a&&ot<=l;ot+=W){let mt=d[ot];if(mt==null)continue;let ft=I(h[ot]),Wt=F(mt);t==1?A(T,ft,H):A(T,J,Wt),A(T,ft,Wt),H=Wt,J=ft}let nt=J;s&&t==1&&(nt=D+P,A(T,nt,H));let[Q,ht]=Eh(r,o);if(c.fill!=null||Q!=0){let ot=b.fill=new Path2D(T),mt=c.fillTo(r,o,c.min,c.max,Q),ft=F(mt);A(ot,nt,ft),A(ot,$,ft)}if(!c.spanGaps){let ot=[];ot.push(...Ah(h,d,a,l,W,I,n));let mt=c.width*be/2,ft=e||t==1?mt:-mt,Wt=e||t==-1?-mt:mt;ot.forEach(K=>{K[0]+=ft,K[1]+=Wt}),b.gaps=ot=c.gaps(r,o,a,l,ot),b.clip=Xa(ot,u.ori,m,p,E,S)}return ht!=0&&(b.band=ht==2?[Ji(r,o,a,l,T,-1),Ji(r,o,a,l,T,1)]:Ji(r,o,a,l,T,ht)),b})}function cp(i,t,e,n,s,r,o=fe){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=an(i[l]-i[a]);h<c&&(c=h,o=an(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function nx(i){i=i||Yo;let t=xe(i.size,[.6,fe,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=de(s),o=1-t[0],a=xe(t[1],fe),l=xe(t[2],1),c=xe(i.disp,Yo),h=xe(i.each,f=>{}),{fill:d,stroke:u}=c;return(f,g,y,m)=>Xs(f,g,(p,E,S,M,D,P,I,F,A,b,T)=>{let W=p.pxRound,H=e,q=n*be,J=a*be,$=l*be,nt,Q;M.ori==0?[nt,Q]=r(f,g):[Q,nt]=r(f,g);let ht=M.dir*(M.ori==0?1:-1),ot=M.ori==0?$a:Th,mt=M.ori==0?h:(j,et,It,gt,_t,qt,at)=>{h(j,et,It,_t,gt,at,qt)},ft=xe(f.bands,_h).find(j=>j.series[0]==g),Wt=ft!=null?ft.dir:0,K=p.fillTo(f,g,p.min,p.max,Wt),ct=W(I(K,D,T,A)),Lt,ut,Ut,Gt=b,Vt=W(p.width*be),oe=!1,ee=null,Te=null,G=null,rn=null;d!=null&&(Vt==0||u!=null)&&(oe=!0,ee=d.values(f,g,y,m),Te=new Map,new Set(ee).forEach(j=>{j!=null&&Te.set(j,new Path2D)}),Vt>0&&(G=u.values(f,g,y,m),rn=new Map,new Set(G).forEach(j=>{j!=null&&rn.set(j,new Path2D)})));let{x0:se,size:Jt}=c;if(se!=null&&Jt!=null){H=1,E=se.values(f,g,y,m),se.unit==2&&(E=E.map(It=>f.posToVal(F+It*b,M.key,!0)));let j=Jt.values(f,g,y,m);Jt.unit==2?ut=j[0]*b:ut=P(j[0],M,b,F)-P(0,M,b,F),Gt=cp(E,S,P,M,b,F,Gt),Ut=Gt-ut+q}else Gt=cp(E,S,P,M,b,F,Gt),Ut=Gt*o+q,ut=Gt-Ut;Ut<1&&(Ut=0),Vt>=ut/2&&(Vt=0),Ut<5&&(W=pp);let Nt=Ut>0,Me=Gt-Ut-(Nt?Vt:0);ut=W(lh(Me,$,J)),Lt=(H==0?ut/2:H==ht?0:ut)-H*ht*((H==0?q/2:0)+(Nt?Vt/2:0));let kt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},C=oe?null:new Path2D,x=null;if(ft!=null)x=f.data[ft.series[1]];else{let{y0:j,y1:et}=c;j!=null&&et!=null&&(S=et.values(f,g,y,m),x=j.values(f,g,y,m))}let z=nt*ut,it=Q*ut;for(let j=ht==1?y:m;j>=y&&j<=m;j+=ht){let et=S[j];if(et==null)continue;if(x!=null){let Ht=x[j]??0;if(et-Ht==0)continue;ct=I(Ht,D,T,A)}let It=M.distr!=2||c!=null?E[j]:j,gt=P(It,M,b,F),_t=I(xe(et,K),D,T,A),qt=W(gt-Lt),at=W(En(_t,ct)),vt=W(hi(_t,ct)),Bt=at-vt;if(et!=null){let Ht=et<0?it:z,Mt=et<0?z:it;oe?(Vt>0&&G[j]!=null&&ot(rn.get(G[j]),qt,vt+Zn(Vt/2),ut,En(0,Bt-Vt),Ht,Mt),ee[j]!=null&&ot(Te.get(ee[j]),qt,vt+Zn(Vt/2),ut,En(0,Bt-Vt),Ht,Mt)):ot(C,qt,vt+Zn(Vt/2),ut,En(0,Bt-Vt),Ht,Mt),mt(f,g,j,qt-Vt/2,vt,ut+Vt,Bt)}}return Vt>0?kt.stroke=oe?rn:C:oe||(kt._fill=p.width==0?p._fill:p._stroke??p._fill,kt.width=0),kt.fill=oe?Te:C,kt})}function ix(i,t){let e=xe(t?.alignGaps,0);return(n,s,r,o)=>Xs(n,s,(a,l,c,h,d,u,f,g,y,m,p)=>{let E=a.pxRound,S=nt=>E(u(nt,h,m,g)),M=nt=>E(f(nt,d,p,y)),D,P,I;h.ori==0?(D=qa,I=Vr,P=Vp):(D=Ya,I=Hr,P=Hp);let F=h.dir*(h.ori==0?1:-1);r=Nr(c,r,o,1),o=Nr(c,r,o,-1);let A=S(l[F==1?r:o]),b=A,T=[],W=[];for(let nt=F==1?r:o;nt>=r&&nt<=o;nt+=F)if(c[nt]!=null){let ht=l[nt],ot=S(ht);T.push(b=ot),W.push(M(c[nt]))}let H={stroke:i(T,W,D,I,P,E),fill:null,clip:null,band:null,gaps:null,flags:Br},q=H.stroke,[J,$]=Eh(n,s);if(a.fill!=null||J!=0){let nt=H.fill=new Path2D(q),Q=a.fillTo(n,s,a.min,a.max,J),ht=M(Q);I(nt,b,ht),I(nt,A,ht)}if(!a.spanGaps){let nt=[];nt.push(...Ah(l,c,r,o,F,S,e)),H.gaps=nt=a.gaps(n,s,r,o,nt),H.clip=Xa(nt,h.ori,g,y,m,p)}return $!=0&&(H.band=$==2?[Ji(n,s,r,o,q,-1),Ji(n,s,r,o,q,1)]:Ji(n,s,r,o,q,$)),H})}function sx(i){return ix(rx,i)}function rx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+d[u]/3,t[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,t[u+1]-l[u+1]*d[u]/3,i[u+1],t[u+1])}return a}var dh=new Set;function hp(){for(let i of dh)i.syncRect(!0)}zr&&(Gs(Bv,Ur,hp),Gs(zv,Ur,hp,!0),Gs(Ba,Ur,()=>{ln.pxRatio=be}));var ox=Xp(),ax=Gp();function up(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>fh(r,o,t,e))}function lx(i,t){return i.map((e,n)=>n==0?{}:en({},t,e))}function fh(i,t,e,n){return en({},t==0?e:n,i)}function qp(i,t,e){return t==null?Or:[t,e]}var cx=qp;function hx(i,t,e){return t==null?Or:za(t,e,yh,!0)}function Yp(i,t,e,n){return t==null?Or:Ha(t,e,i.scales[n].log,!1)}var ux=Yp;function $p(i,t,e,n){return t==null?Or:vh(t,e,i.scales[n].log,!1)}var dx=$p;function fx(i,t,e,n,s){let r=En(Gf(i),Gf(t)),o=t-i,a=Mi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?_s.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function dp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=on((e=+s)*be))+"px"),[i,t,e]}function px(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ne(t[2]*be,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ln(i,t,e){let n={mode:xe(i.mode,1)},s=n.mode;function r(v,_){return((_.distr==3?Zi(v>0?v:_.clamp(n,v,_.min,_.max,_.key)):_.distr==4?th(v,_.asinh):_.distr==100?_.fwd(v):v)-_._min)/(_._max-_._min)}function o(v,_,R,L){let B=r(v,_);return L+R*(_.dir==-1?1-B:B)}function a(v,_,R,L){let B=r(v,_);return L+R*(_.dir==-1?B:1-B)}function l(v,_,R,L){return _.ori==0?o(v,_,R,L):a(v,_,R,L)}n.valToPosH=o,n.valToPosV=a;let c=!1;n.status=0;let h=n.root=li(bv);if(i.id!=null&&(h.id=i.id),$n(h,i.class),i.title){let v=li(Sv,h);v.textContent=i.title}let d=bi("canvas"),u=n.ctx=d.getContext("2d"),f=li(Ev,h);Gs("click",f,v=>{v.target===y&&(Oe!=wr||Ge!=Sr)&&bn.click(n,v)},!0);let g=n.under=li(Av,f);f.appendChild(d);let y=n.over=li(Tv,f);i=kr(i);let m=+xe(i.pxAlign,1),p=lp(m);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let E=i.ms||.001,S=n.series=s==1?up(i.series||[],ep,op,!1):lx(i.series||[null],rp),M=n.axes=up(i.axes||[],tp,ip,!0),D=n.scales={},P=n.bands=i.bands||[];P.forEach(v=>{v.fill=de(v.fill||null),v.dir=xe(v.dir,-1)});let I=s==2?S[1].facets[0].scale:S[0].scale,F={axes:iv,series:De},A=(i.drawOrder||["axes","series"]).map(v=>F[v]);function b(v){let _=D[v];if(_==null){let R=(i.scales||Yo)[v]||Yo;if(R.from!=null)b(R.from),D[v]=en({},D[R.from],R,{key:v});else{_=D[v]=en({},v==I?Fp:Jy,R),_.key=v;let L=_.time,B=_.range,Y=xs(B);if((v!=I||s==2&&!L)&&(Y&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?zf:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?zf:{mode:1,hard:B[1],soft:B[1]}},Y=!1),!Y&&Wa(B))){let st=B;B=(lt,pt,Et)=>pt==null?Or:za(pt,Et,st)}_.range=de(B||(L?cx:v==I?_.distr==3?ux:_.distr==4?dx:qp:_.distr==3?Yp:_.distr==4?$p:hx)),_.auto=de(Y?!1:_.auto),_.clamp=de(_.clamp||Zy),_._min=_._max=null}}}b("x"),b("y"),s==1&&S.forEach(v=>{b(v.scale)}),M.forEach(v=>{b(v.scale)});for(let v in i.scales)b(v);let T=D[I],W=T.distr,H,q;T.ori==0?($n(h,Mv),H=o,q=a):($n(h,wv),H=a,q=o);let J={};for(let v in D){let _=D[v];(_.min!=null||_.max!=null)&&(J[v]={min:_.min,max:_.max},_.min=_.max=null)}let $=i.tzDate||(v=>new Date(on(v/E))),nt=i.fmtDate||bh,Q=E==1?My($):Ey($),ht=Kf($,Jf(E==1?by:Sy,nt)),ot=Qf($,jf(Ty,nt)),mt=[],ft=n.legend=en({},Py,i.legend),Wt=ft.show,K=ft.markers;ft.idxs=mt,K.width=de(K.width),K.dash=de(K.dash),K.stroke=de(K.stroke),K.fill=de(K.fill);let ct,Lt,ut,Ut=[],Gt=[],Vt,oe=!1,ee={};if(ft.live){let v=S[1]?S[1].values:null;oe=v!=null,Vt=oe?v(n,1,0):{_:0};for(let _ in Vt)ee[_]=mh}if(Wt)if(ct=bi("table",Dv,h),ut=bi("tbody",null,ct),ft.mount(n,ct),oe){Lt=bi("thead",null,ct,ut);let v=bi("tr",null,Lt);bi("th",null,v);for(var Te in Vt)bi("th",Af,v).textContent=Te}else $n(ct,Nv),ft.live&&$n(ct,Uv);let G={show:!0},rn={show:!1};function se(v,_){if(_==0&&(oe||!ft.live||s==2))return Or;let R=[],L=bi("tr",Fv,ut,ut.childNodes[_]);$n(L,v.class),v.show||$n(L,Hs);let B=bi("th",null,L);if(K.show){let lt=li(Ov,B);if(_>0){let pt=K.width(n,_);pt&&(lt.style.border=pt+"px "+K.dash(n,_)+" "+K.stroke(n,_)),lt.style.background=K.fill(n,_)}}let Y=li(Af,B);Y.textContent=v.label,_>0&&(K.show||(Y.style.color=v.width>0?K.stroke(n,_):K.fill(n,_)),Nt("click",B,lt=>{if(Ct._lock)return;le(lt);let pt=S.indexOf(v);if((lt.ctrlKey||lt.metaKey)!=ft.isolate){let Et=S.some((Tt,Pt)=>Pt>0&&Pt!=pt&&Tt.show);S.forEach((Tt,Pt)=>{Pt>0&&Ui(Pt,Et?Pt==pt?G:rn:G,!0,Qe.setSeries)})}else Ui(pt,{show:!v.show},!0,Qe.setSeries)},!1),Hi&&Nt(If,B,lt=>{Ct._lock||(le(lt),Ui(S.indexOf(v),Ar,!0,Qe.setSeries))},!1));for(var st in Vt){let lt=bi("td",kv,L);lt.textContent="--",R.push(lt)}return[L,R]}let Jt=new Map;function Nt(v,_,R,L=!0){let B=Jt.get(_)||{},Y=Ct.bind[v](n,_,R,L);Y&&(Gs(v,_,B[v]=Y),Jt.set(_,B))}function Me(v,_,R){let L=Jt.get(_)||{};for(let B in L)(v==null||B==v)&&(ah(B,_,L[B]),delete L[B]);v==null&&Jt.delete(_)}let kt=0,C=0,x=0,z=0,it=0,j=0,et=it,It=j,gt=x,_t=z,qt=0,at=0,vt=0,Bt=0;n.bbox={};let Ht=!1,Mt=!1,ne=!1,Yt=!1,_e=!1,O=!1;function yt(v,_,R){(R||v!=n.width||_!=n.height)&&tt(v,_),xr(!1),ne=!0,Mt=!0,_r()}function tt(v,_){n.width=kt=x=v,n.height=C=z=_,it=j=0,jt(),He();let R=n.bbox;qt=R.left=zs(it*be,.5),at=R.top=zs(j*be,.5),vt=R.width=zs(x*be,.5),Bt=R.height=zs(z*be,.5)}let rt=3;function St(){let v=!1,_=0;for(;!v;){_++;let R=ev(_),L=nv(_);v=_==rt||R&&L,v||(tt(n.width,n.height),Mt=!0)}}function wt({width:v,height:_}){yt(v,_)}n.setSize=wt;function jt(){let v=!1,_=!1,R=!1,L=!1;M.forEach((B,Y)=>{if(B.show&&B._show){let{side:st,_size:lt}=B,pt=st%2,Et=B.label!=null?B.labelSize:0,Tt=lt+Et;Tt>0&&(pt?(x-=Tt,st==3?(it+=Tt,L=!0):R=!0):(z-=Tt,st==0?(j+=Tt,v=!0):_=!0))}}),Li[0]=v,Li[1]=R,Li[2]=_,Li[3]=L,x-=Di[1]+Di[3],it+=Di[3],z-=Di[2]+Di[0],j+=Di[0]}function He(){let v=it+x,_=j+z,R=it,L=j;function B(Y,st){switch(Y){case 1:return v+=st,v-st;case 2:return _+=st,_-st;case 3:return R-=st,R+st;case 0:return L-=st,L+st}}M.forEach((Y,st)=>{if(Y.show&&Y._show){let lt=Y.side;Y._pos=B(lt,Y._size),Y.label!=null&&(Y._lpos=B(lt,Y.labelSize))}})}let Ct=n.cursor=en({},Fy,{drag:{y:s==2}},i.cursor);if(Ct.dataIdx==null){let v=Ct.hover,_=v.skip=new Set(v.skip??[]);_.add(void 0);let R=v.prox=de(v.prox),L=v.bias??(v.bias=0);Ct.dataIdx=(B,Y,st,lt)=>{if(Y==0)return st;let pt=st,Et=R(B,Y,st,lt)??fe,Tt=Et>=0&&Et<fe,Pt=T.ori==0?x:z,Zt=Ct.left,Ue=t[0],pe=t[Y];if(_.has(pe[st])){pt=null;let ce=null,Qt=null,zt;if(L==0||L==-1)for(zt=st;ce==null&&zt-- >0;)_.has(pe[zt])||(ce=zt);if(L==0||L==1)for(zt=st;Qt==null&&zt++<pe.length;)_.has(pe[zt])||(Qt=zt);if(ce!=null||Qt!=null)if(Tt){let Re=ce==null?-1/0:H(Ue[ce],T,Pt,0),Je=Qt==null?1/0:H(Ue[Qt],T,Pt,0),Ze=Zt-Re,Be=Je-Zt;Ze<=Be?Ze<=Et&&(pt=ce):Be<=Et&&(pt=Qt)}else pt=Qt==null?ce:ce==null?Qt:st-ce<=Qt-st?ce:Qt}else Tt&&an(Zt-H(Ue[st],T,Pt,0))>Et&&(pt=null);return pt}}let le=v=>{Ct.event=v};Ct.idxs=mt,Ct._lock=!1;let Ce=Ct.points;Ce.show=de(Ce.show),Ce.size=de(Ce.size),Ce.stroke=de(Ce.stroke),Ce.width=de(Ce.width),Ce.fill=de(Ce.fill);let pn=n.focus=en({},i.focus||{alpha:.3},Ct.focus),Hi=pn.prox>=0,Gi=Hi&&Ce.one,je=[],Ii=[],Wi=[];function Uo(v,_){let R=Ce.show(n,_);if(R)return $n(R,Lv),$n(R,v.class),Oi(R,-10,-10,x,z),y.insertBefore(R,je[_]),R}function Ds(v,_){if(s==1||_>0){let R=s==1&&D[v.scale].time,L=v.value;v.value=R?qf(L)?Qf($,jf(L,nt)):L||ot:L||qy,v.label=v.label||(R?ky:Oy)}if(Gi||_>0){v.width=v.width==null?1:v.width,v.paths=v.paths||ox||Jv,v.fillTo=de(v.fillTo||Ky),v.pxAlign=+xe(v.pxAlign,m),v.pxRound=lp(v.pxAlign),v.stroke=de(v.stroke||null),v.fill=de(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let R=Yy(En(1,v.width),1),L=v.points=en({},{size:R,width:En(1,R*.2),stroke:v.stroke,space:R*2,paths:ax,_stroke:null,_fill:null},v.points);L.show=de(L.show),L.filter=de(L.filter),L.fill=de(L.fill),L.stroke=de(L.stroke),L.paths=de(L.paths),L.pxAlign=v.pxAlign}if(Wt){let R=se(v,_);Ut.splice(_,0,R[0]),Gt.splice(_,0,R[1]),ft.values.push(null)}if(Ct.show){mt.splice(_,0,null);let R=null;Gi?_==0&&(R=Uo(v,_)):_>0&&(R=Uo(v,_)),je.splice(_,0,R),Ii.splice(_,0,0),Wi.splice(_,0,0)}yn("addSeries",_)}function Sa(v,_){_=_??S.length,v=s==1?fh(v,_,ep,op):fh(v,_,{},rp),S.splice(_,0,v),Ds(S[_],_)}n.addSeries=Sa;function yr(v){if(S.splice(v,1),Wt){ft.values.splice(v,1),Gt.splice(v,1);let _=Ut.splice(v,1)[0];Me(null,_.firstChild),_.remove()}Ct.show&&(mt.splice(v,1),je.splice(v,1)[0].remove(),Ii.splice(v,1),Wi.splice(v,1)),yn("delSeries",v)}n.delSeries=yr;let Li=[!1,!1,!1,!1];function Ea(v,_){if(v._show=v.show,v.show){let R=v.side%2,L=D[v.scale];L==null&&(v.scale=R?S[1].scale:I,L=D[v.scale]);let B=L.time;v.size=de(v.size),v.space=de(v.space),v.rotate=de(v.rotate),xs(v.incrs)&&v.incrs.forEach(st=>{!_s.has(st)&&_s.set(st,vp(st))}),v.incrs=de(v.incrs||(L.distr==2?yy:B?E==1?_y:wy:Vs)),v.splits=de(v.splits||(B&&L.distr==1?Q:L.distr==3?ch:L.distr==4?Vy:zy)),v.stroke=de(v.stroke),v.grid.stroke=de(v.grid.stroke),v.ticks.stroke=de(v.ticks.stroke),v.border.stroke=de(v.border.stroke);let Y=v.values;v.values=xs(Y)&&!xs(Y[0])?de(Y):B?xs(Y)?Kf($,Jf(Y,nt)):qf(Y)?Ay($,Y):Y||ht:Y||By,v.filter=de(v.filter||(L.distr>=3&&L.log==10?Wy:L.distr==3&&L.log==2?Xy:mp)),v.font=dp(v.font),v.labelFont=dp(v.labelFont),v._size=v.size(n,null,_,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Li[_]=!0,v._el=li(Cv,f))}}function Us(v,_,R,L){let[B,Y,st,lt]=R,pt=_%2,Et=0;return pt==0&&(lt||Y)&&(Et=_==0&&!B||_==2&&!st?on(tp.size/3):0),pt==1&&(B||st)&&(Et=_==1&&!Y||_==3&&!lt?on(ip.size/2):0),Et}let Aa=n.padding=(i.padding||[Us,Us,Us,Us]).map(v=>de(xe(v,Us))),Di=n._padding=Aa.map((v,_)=>v(n,_,Li,0)),w,k=null,X=null,Z=s==1?S[0].idxs:null,V=null,dt=!1;function bt(v,_){if(t=v??[],n.data=n._data=t,s==2){w=0;for(let R=1;R<S.length;R++)w+=t[R][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),V=t[0],w=V.length;let R=t;if(W==2){R=t.slice();let L=R[0]=Array(w);for(let B=0;B<w;B++)L[B]=B}n._data=t=R}if(xr(!0),yn("setData"),W==2&&(ne=!0),_!==!1){let R=T;R.auto(n,dt)?Ft():ms(I,R.min,R.max),Yt=Yt||Ct.left>=0,O=!0,_r()}}n.setData=bt;function Ft(){dt=!0;let v,_;s==1&&(w>0?(k=Z[0]=0,X=Z[1]=w-1,v=t[0][k],_=t[0][X],W==2?(v=k,_=X):v==_&&(W==3?[v,_]=Ha(v,v,T.log,!1):W==4?[v,_]=vh(v,v,T.log,!1):T.time?_=v+on(86400/E):[v,_]=za(v,_,yh,!0))):(k=Z[0]=v=null,X=Z[1]=_=null)),ms(I,v,_)}let Dt,Xt,$t,Ot,ue,we,Ae,mn,me,Rt;function si(v,_,R,L,B,Y){v??(v=Cf),R??(R=_h),L??(L="butt"),B??(B=Cf),Y??(Y="round"),v!=Dt&&(u.strokeStyle=Dt=v),B!=Xt&&(u.fillStyle=Xt=B),_!=$t&&(u.lineWidth=$t=_),Y!=ue&&(u.lineJoin=ue=Y),L!=we&&(u.lineCap=we=L),R!=Ot&&u.setLineDash(Ot=R)}function ge(v,_,R,L){_!=Xt&&(u.fillStyle=Xt=_),v!=Ae&&(u.font=Ae=v),R!=mn&&(u.textAlign=mn=R),L!=me&&(u.textBaseline=me=L)}function Pn(v,_,R,L,B=0){if(L.length>0&&v.auto(n,dt)&&(_==null||_.min==null)){let Y=xe(k,0),st=xe(X,L.length-1),lt=R.min==null?v.distr==3?Wv(L,Y,st):Gv(L,Y,st,B):[R.min,R.max];v.min=hi(v.min,R.min=lt[0]),v.max=En(v.max,R.max=lt[1])}}let Xi={min:null,max:null};function In(){for(let L in D){let B=D[L];J[L]==null&&(B.min==null||J[I]!=null&&B.auto(n,dt))&&(J[L]=Xi)}for(let L in D){let B=D[L];J[L]==null&&B.from!=null&&J[B.from]!=null&&(J[L]=Xi)}J[I]!=null&&xr(!0);let v={};for(let L in J){let B=J[L];if(B!=null){let Y=v[L]=kr(D[L],Qv);if(B.min!=null)en(Y,B);else if(L!=I||s==2)if(w==0&&Y.from==null){let st=Y.range(n,null,null,L);Y.min=st[0],Y.max=st[1]}else Y.min=fe,Y.max=-fe}}if(w>0){S.forEach((L,B)=>{if(s==1){let Y=L.scale,st=J[Y];if(st==null)return;let lt=v[Y];if(B==0){let pt=lt.range(n,lt.min,lt.max,Y);lt.min=pt[0],lt.max=pt[1],k=Mi(lt.min,t[0]),X=Mi(lt.max,t[0]),X-k>1&&(t[0][k]<lt.min&&k++,t[0][X]>lt.max&&X--),L.min=V[k],L.max=V[X]}else L.show&&L.auto&&Pn(lt,st,L,t[B],L.sorted);L.idxs[0]=k,L.idxs[1]=X}else if(B>0&&L.show&&L.auto){let[Y,st]=L.facets,lt=Y.scale,pt=st.scale,[Et,Tt]=t[B],Pt=v[lt],Zt=v[pt];Pt!=null&&Pn(Pt,J[lt],Y,Et,Y.sorted),Zt!=null&&Pn(Zt,J[pt],st,Tt,st.sorted),L.min=st.min,L.max=st.max}});for(let L in v){let B=v[L],Y=J[L];if(B.from==null&&(Y==null||Y.min==null)){let st=B.range(n,B.min==fe?null:B.min,B.max==-fe?null:B.max,L);B.min=st[0],B.max=st[1]}}}for(let L in v){let B=v[L];if(B.from!=null){let Y=v[B.from];if(Y.min==null)B.min=B.max=null;else{let st=B.range(n,Y.min,Y.max,L);B.min=st[0],B.max=st[1]}}}let _={},R=!1;for(let L in v){let B=v[L],Y=D[L];if(Y.min!=B.min||Y.max!=B.max){Y.min=B.min,Y.max=B.max;let st=Y.distr;Y._min=st==3?Zi(Y.min):st==4?th(Y.min,Y.asinh):st==100?Y.fwd(Y.min):Y.min,Y._max=st==3?Zi(Y.max):st==4?th(Y.max,Y.asinh):st==100?Y.fwd(Y.max):Y.max,_[L]=R=!0}}if(R){S.forEach((L,B)=>{s==2?B>0&&_.y&&(L._paths=null):_[L.scale]&&(L._paths=null)});for(let L in _)ne=!0,yn("setScale",L);Ct.show&&Ct.left>=0&&(Yt=O=!0)}for(let L in J)J[L]=null}function Ns(v){let _=lh(k-1,0,w-1),R=lh(X+1,0,w-1);for(;v[_]==null&&_>0;)_--;for(;v[R]==null&&R<w-1;)R++;return[_,R]}function De(){w>0&&(S.forEach((v,_)=>{if(_>0&&v.show&&(qn(_,!1),qn(_,!0),v._paths==null)){Rt!=v.alpha&&(u.globalAlpha=Rt=v.alpha);let R=s==2?[0,t[_][0].length-1]:Ns(t[_]);v._paths=v.paths(n,_,R[0],R[1]),Rt!=1&&(u.globalAlpha=Rt=1)}}),S.forEach((v,_)=>{if(_>0&&v.show){Rt!=v.alpha&&(u.globalAlpha=Rt=v.alpha),v._paths!=null&&fs(_,!1);{let R=v._paths!=null?v._paths.gaps:null,L=v.points.show(n,_,k,X,R),B=v.points.filter(n,_,L,R);(L||B)&&(v.points._paths=v.points.paths(n,_,k,X,B),fs(_,!0))}Rt!=1&&(u.globalAlpha=Rt=1),yn("drawSeries",_)}}))}function qn(v,_){let R=_?S[v].points:S[v];R._stroke=R.stroke(n,v),R._fill=R.fill(n,v)}function fs(v,_){let R=_?S[v].points:S[v],{stroke:L,fill:B,clip:Y,flags:st,_stroke:lt=R._stroke,_fill:pt=R._fill,_width:Et=R.width}=R._paths;Et=Ne(Et*be,3);let Tt=null,Pt=Et%2/2;_&&pt==null&&(pt=Et>0?"#fff":lt);let Zt=R.pxAlign==1&&Pt>0;if(Zt&&u.translate(Pt,Pt),!_){let Ue=qt-Et/2,pe=at-Et/2,ce=vt+Et,Qt=Bt+Et;Tt=new Path2D,Tt.rect(Ue,pe,ce,Qt)}_?ri(lt,Et,R.dash,R.cap,pt,L,B,st,Y):zn(v,lt,Et,R.dash,R.cap,pt,L,B,st,Tt,Y),Zt&&u.translate(-Pt,-Pt)}function zn(v,_,R,L,B,Y,st,lt,pt,Et,Tt){let Pt=!1;pt!=0&&P.forEach((Zt,Ue)=>{if(Zt.series[0]==v){let pe=S[Zt.series[1]],ce=t[Zt.series[1]],Qt=(pe._paths||Yo).band;xs(Qt)&&(Qt=Zt.dir==1?Qt[0]:Qt[1]);let zt,Re=null;pe.show&&Qt&&qv(ce,k,X)?(Re=Zt.fill(n,Ue)||Y,zt=pe._paths.clip):Qt=null,ri(_,R,L,B,Re,st,lt,pt,Et,Tt,zt,Qt),Pt=!0}}),Pt||ri(_,R,L,B,Y,st,lt,pt,Et,Tt)}let vi=Br|uh;function ri(v,_,R,L,B,Y,st,lt,pt,Et,Tt,Pt){si(v,_,R,L,B),(pt||Et||Pt)&&(u.save(),pt&&u.clip(pt),Et&&u.clip(Et)),Pt?(lt&vi)==vi?(u.clip(Pt),Tt&&u.clip(Tt),Ta(B,st),Fs(v,Y,_)):lt&uh?(Ta(B,st),u.clip(Pt),Fs(v,Y,_)):lt&Br&&(u.save(),u.clip(Pt),Tt&&u.clip(Tt),Ta(B,st),u.restore(),Fs(v,Y,_)):(Ta(B,st),Fs(v,Y,_)),(pt||Et||Pt)&&u.restore()}function Fs(v,_,R){R>0&&(_ instanceof Map?_.forEach((L,B)=>{u.strokeStyle=Dt=B,u.stroke(L)}):_!=null&&v&&u.stroke(_))}function Ta(v,_){_ instanceof Map?_.forEach((R,L)=>{u.fillStyle=Xt=L,u.fill(R)}):_!=null&&v&&u.fill(_)}function tv(v,_,R,L){let B=M[v],Y;if(L<=0)Y=[0,0];else{let st=B._space=B.space(n,v,_,R,L),lt=B._incrs=B.incrs(n,v,_,R,L,st);Y=fx(_,R,lt,L,st)}return B._found=Y}function Bc(v,_,R,L,B,Y,st,lt,pt,Et){let Tt=st%2/2;m==1&&u.translate(Tt,Tt),si(lt,st,pt,Et,lt),u.beginPath();let Pt,Zt,Ue,pe,ce=B+(L==0||L==3?-Y:Y);R==0?(Zt=B,pe=ce):(Pt=B,Ue=ce);for(let Qt=0;Qt<v.length;Qt++)_[Qt]!=null&&(R==0?Pt=Ue=v[Qt]:Zt=pe=v[Qt],u.moveTo(Pt,Zt),u.lineTo(Ue,pe));u.stroke(),m==1&&u.translate(-Tt,-Tt)}function ev(v){let _=!0;return M.forEach((R,L)=>{if(!R.show)return;let B=D[R.scale];if(B.min==null){R._show&&(_=!1,R._show=!1,xr(!1));return}else R._show||(_=!1,R._show=!0,xr(!1));let Y=R.side,st=Y%2,{min:lt,max:pt}=B,[Et,Tt]=tv(L,lt,pt,st==0?x:z);if(Tt==0)return;let Pt=B.distr==2,Zt=R._splits=R.splits(n,L,lt,pt,Et,Tt,Pt),Ue=B.distr==2?Zt.map(zt=>V[zt]):Zt,pe=B.distr==2?V[Zt[1]]-V[Zt[0]]:Et,ce=R._values=R.values(n,R.filter(n,Ue,L,Tt,pe),L,Tt,pe);R._rotate=Y==2?R.rotate(n,ce,L,Tt):0;let Qt=R._size;R._size=ci(R.size(n,ce,L,v)),Qt!=null&&R._size!=Qt&&(_=!1)}),_}function nv(v){let _=!0;return Aa.forEach((R,L)=>{let B=R(n,L,Li,v);B!=Di[L]&&(_=!1),Di[L]=B}),_}function iv(){for(let v=0;v<M.length;v++){let _=M[v];if(!_.show||!_._show)continue;let R=_.side,L=R%2,B,Y,st=_.stroke(n,v),lt=R==0||R==3?-1:1;if(_.label){let Un=_.labelGap*lt,Yn=on((_._lpos+Un)*be);ge(_.labelFont[0],st,"center",R==2?Vo:Tf),u.save(),L==1?(B=Y=0,u.translate(Yn,on(at+Bt/2)),u.rotate((R==3?-ka:ka)/2)):(B=on(qt+vt/2),Y=Yn),u.fillText(_.label,B,Y),u.restore()}let[pt,Et]=_._found;if(Et==0)continue;let Tt=D[_.scale],Pt=L==0?vt:Bt,Zt=L==0?qt:at,Ue=on(_.gap*be),pe=_._splits,ce=Tt.distr==2?pe.map(Un=>V[Un]):pe,Qt=Tt.distr==2?V[pe[1]]-V[pe[0]]:pt,zt=_.ticks,Re=_.border,Je=zt.show?on(zt.size*be):0,Ze=_._rotate*-ka/180,Be=p(_._pos*be),tn=(Je+Ue)*lt,Vn=Be+tn;Y=L==0?Vn:0,B=L==1?Vn:0;let Hn=_.font[0],oi=_.align==1?Lr:_.align==2?jc:Ze>0?Lr:Ze<0?jc:L==0?"center":R==3?jc:Lr,yi=Ze||L==1?"middle":R==2?Vo:Tf;ge(Hn,st,oi,yi);let xi=_.font[1]*_.lineGap,Ln=pe.map(Un=>p(l(Un,Tt,Pt,Zt))),Fi=_._values;for(let Un=0;Un<Fi.length;Un++){let Yn=Fi[Un];if(Yn!=null){L==0?B=Ln[Un]:Y=Ln[Un],Yn=""+Yn;let Cr=Yn.indexOf(`
`)==-1?[Yn]:Yn.split(/\n/gm);for(let ys=0;ys<Cr.length;ys++){let ai=Cr[ys];Ze?(u.save(),u.translate(B,Y+ys*xi),u.rotate(Ze),u.fillText(ai,0,0),u.restore()):u.fillText(ai,B,Y+ys*xi)}}}zt.show&&Bc(Ln,zt.filter(n,ce,v,Et,Qt),L,R,Be,Je,Ne(zt.width*be,3),zt.stroke(n,v),zt.dash,zt.cap);let Dn=_.grid;Dn.show&&Bc(Ln,Dn.filter(n,ce,v,Et,Qt),L,L==0?2:1,L==0?at:qt,L==0?Bt:vt,Ne(Dn.width*be,3),Dn.stroke(n,v),Dn.dash,Dn.cap),Re.show&&Bc([Be],[1],L==0?1:0,L==0?1:2,L==1?at:qt,L==1?Bt:vt,Ne(Re.width*be,3),Re.stroke(n,v),Re.dash,Re.cap)}yn("drawAxes")}function xr(v){S.forEach((_,R)=>{R>0&&(_._paths=null,v&&(s==1?(_.min=null,_.max=null):_.facets.forEach(L=>{L.min=null,L.max=null})))})}let Ca=!1,zc=!1,No=[];function sv(){zc=!1;for(let v=0;v<No.length;v++)yn(...No[v]);No.length=0}function _r(){Ca||(oy(rf),Ca=!0)}function rv(v,_=!1){Ca=!0,zc=_,v(n),rf(),_&&No.length>0&&queueMicrotask(sv)}n.batch=rv;function rf(){if(Ht&&(In(),Ht=!1),ne&&(St(),ne=!1),Mt){if(ze(g,Lr,it),ze(g,Vo,j),ze(g,Go,x),ze(g,Wo,z),ze(y,Lr,it),ze(y,Vo,j),ze(y,Go,x),ze(y,Wo,z),ze(f,Go,kt),ze(f,Wo,C),d.width=on(kt*be),d.height=on(C*be),M.forEach(({_el:v,_show:_,_size:R,_pos:L,side:B})=>{if(v!=null)if(_){let Y=B===3||B===0?R:0,st=B%2==1;ze(v,st?"left":"top",L-Y),ze(v,st?"width":"height",R),ze(v,st?"top":"left",st?j:it),ze(v,st?"height":"width",st?z:x),oh(v,Hs)}else $n(v,Hs)}),Dt=Xt=$t=ue=we=Ae=mn=me=Ot=null,Rt=1,ko(!0),it!=et||j!=It||x!=gt||z!=_t){xr(!1);let v=x/gt,_=z/_t;if(Ct.show&&!Yt&&Ct.left>=0){Ct.left*=v,Ct.top*=_,br&&Oi(br,on(Ct.left),0,x,z),Mr&&Oi(Mr,0,on(Ct.top),x,z);for(let R=0;R<je.length;R++){let L=je[R];L!=null&&(Ii[R]*=v,Wi[R]*=_,Oi(L,ci(Ii[R]),ci(Wi[R]),x,z))}}if(ke.show&&!_e&&ke.left>=0&&ke.width>0){ke.left*=v,ke.width*=v,ke.top*=_,ke.height*=_;for(let R in qc)ze(Er,R,ke[R])}et=it,It=j,gt=x,_t=z}yn("setSize"),Mt=!1}kt>0&&C>0&&(u.clearRect(0,0,d.width,d.height),yn("drawClear"),A.forEach(v=>v()),yn("draw")),ke.show&&_e&&(Ra(ke),_e=!1),Ct.show&&Yt&&(ks(null,!0,!1),Yt=!1),ft.show&&ft.live&&O&&(Wc(),O=!1),c||(c=!0,n.status=1,yn("ready")),dt=!1,Ca=!1}n.redraw=(v,_)=>{ne=_||!1,v!==!1?ms(I,T.min,T.max):_r()};function Vc(v,_){let R=D[v];if(R.from==null){if(w==0){let L=R.range(n,_.min,_.max,v);_.min=L[0],_.max=L[1]}if(_.min>_.max){let L=_.min;_.min=_.max,_.max=L}if(w>1&&_.min!=null&&_.max!=null&&_.max-_.min<1e-16)return;v==I&&R.distr==2&&w>0&&(_.min=Mi(_.min,t[0]),_.max=Mi(_.max,t[0]),_.min==_.max&&_.max++),J[v]=_,Ht=!0,_r()}}n.setScale=Vc;let Hc,Gc,br,Mr,of,af,wr,Sr,lf,cf,Oe,Ge,ps=!1,bn=Ct.drag,gn=bn.x,vn=bn.y;Ct.show&&(Ct.x&&(Hc=li(Pv,y)),Ct.y&&(Gc=li(Iv,y)),T.ori==0?(br=Hc,Mr=Gc):(br=Gc,Mr=Hc),Oe=Ct.left,Ge=Ct.top);let ke=n.select=en({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Er=ke.show?li(Rv,ke.over?y:g):null;function Ra(v,_){if(ke.show){for(let R in v)ke[R]=v[R],R in qc&&ze(Er,R,v[R]);_!==!1&&yn("setSelect")}}n.setSelect=Ra;function ov(v,_){let R=S[v],L=Wt?Ut[v]:null;if(R.show)L&&oh(L,Hs);else{L&&$n(L,Hs);let B=Gi?je[0]:je[v];Oi(B,-10,-10,x,z)}}function ms(v,_,R){Vc(v,{min:_,max:R})}function Ui(v,_,R,L){_.focus!=null&&uv(v),_.show!=null&&S.forEach((B,Y)=>{Y>0&&(v==Y||v==null)&&(B.show=_.show,ov(Y,_.show),s==2?(ms(B.facets[0].scale,null,null),ms(B.facets[1].scale,null,null)):ms(B.scale,null,null),_r())}),R!==!1&&yn("setSeries",v,_),L&&Bo("setSeries",n,v,_)}n.setSeries=Ui;function av(v,_){en(P[v],_)}function lv(v,_){v.fill=de(v.fill||null),v.dir=xe(v.dir,-1),_=_??P.length,P.splice(_,0,v)}function cv(v){v==null?P.length=0:P.splice(v,1)}n.addBand=lv,n.setBand=av,n.delBand=cv;function hv(v,_){S[v].alpha=_,Ct.show&&je[v]&&(je[v].style.opacity=_),Wt&&Ut[v]&&(Ut[v].style.opacity=_)}let qi,gs,Os,Ar={focus:!0};function uv(v){if(v!=Os){let _=v==null,R=pn.alpha!=1;S.forEach((L,B)=>{if(s==1||B>0){let Y=_||B==0||B==v;L._focus=_?null:Y,R&&hv(B,Y?1:pn.alpha)}}),Os=v,R&&_r()}}Wt&&Hi&&Nt(Lf,ct,v=>{Ct._lock||(le(v),Os!=null&&Ui(null,Ar,!0,Qe.setSeries))});function Ni(v,_,R){let L=D[_];R&&(v=v/be-(L.ori==1?j:it));let B=x;L.ori==1&&(B=z,v=B-v),L.dir==-1&&(v=B-v);let Y=L._min,st=L._max,lt=v/B,pt=Y+(st-Y)*lt,Et=L.distr;return Et==3?Fr(10,pt):Et==4?$v(pt,L.asinh):Et==100?L.bwd(pt):pt}function dv(v,_){let R=Ni(v,I,_);return Mi(R,t[0],k,X)}n.valToIdx=v=>Mi(v,t[0]),n.posToIdx=dv,n.posToVal=Ni,n.valToPos=(v,_,R)=>D[_].ori==0?o(v,D[_],R?vt:x,R?qt:0):a(v,D[_],R?Bt:z,R?at:0),n.setCursor=(v,_,R)=>{Oe=v.left,Ge=v.top,ks(null,_,R)};function hf(v,_){ze(Er,Lr,ke.left=v),ze(Er,Go,ke.width=_)}function uf(v,_){ze(Er,Vo,ke.top=v),ze(Er,Wo,ke.height=_)}let Fo=T.ori==0?hf:uf,Oo=T.ori==1?hf:uf;function fv(){if(Wt&&ft.live)for(let v=s==2?1:0;v<S.length;v++){if(v==0&&oe)continue;let _=ft.values[v],R=0;for(let L in _)Gt[v][R++].firstChild.nodeValue=_[L]}}function Wc(v,_){if(v!=null&&(v.idxs?v.idxs.forEach((R,L)=>{mt[L]=R}):jv(v.idx)||mt.fill(v.idx),ft.idx=mt[0]),Wt&&ft.live){for(let R=0;R<S.length;R++)(R>0||s==1&&!oe)&&pv(R,mt[R]);fv()}O=!1,_!==!1&&yn("setLegend")}n.setLegend=Wc;function pv(v,_){let R=S[v],L=v==0&&W==2?V:t[v],B;oe?B=R.values(n,v,_)??ee:(B=R.value(n,_==null?null:L[_],v,_),B=B==null?ee:{_:B}),ft.values[v]=B}function ks(v,_,R){lf=Oe,cf=Ge,[Oe,Ge]=Ct.move(n,Oe,Ge),Ct.left=Oe,Ct.top=Ge,Ct.show&&(br&&Oi(br,on(Oe),0,x,z),Mr&&Oi(Mr,0,on(Ge),x,z));let L,B=k>X;qi=fe,gs=null;let Y=T.ori==0?x:z,st=T.ori==1?x:z;if(Oe<0||w==0||B){L=Ct.idx=null;for(let lt=0;lt<S.length;lt++){let pt=je[lt];pt!=null&&Oi(pt,-10,-10,x,z)}Hi&&Ui(null,Ar,!0,v==null&&Qe.setSeries),ft.live&&(mt.fill(L),O=!0)}else{let lt,pt,Et;s==1&&(lt=T.ori==0?Oe:Ge,pt=Ni(lt,I),L=Ct.idx=Mi(pt,t[0],k,X),Et=H(t[0][L],T,Y,0));let Tt=-10,Pt=-10,Zt=0,Ue=0,pe=!0,ce="",Qt="";for(let zt=s==2?1:0;zt<S.length;zt++){let Re=S[zt],Je=mt[zt],Ze=Je==null?null:s==1?t[zt][Je]:t[zt][1][Je],Be=Ct.dataIdx(n,zt,L,pt),tn=Be==null?null:s==1?t[zt][Be]:t[zt][1][Be];O=O||tn!=Ze||Be!=Je,mt[zt]=Be;let Vn=Be==L?Et:H(s==1?t[0][Be]:t[zt][0][Be],T,Y,0);if(zt>0&&Re.show){let Hn=tn==null?-10:q(tn,s==1?D[Re.scale]:D[Re.facets[1].scale],st,0);if(Hi&&tn!=null){let oi=T.ori==1?Oe:Ge,yi=an(pn.dist(n,zt,Be,Hn,oi));if(yi<qi){let xi=pn.bias;if(xi!=0){let Ln=Ni(oi,Re.scale),Fi=tn>=0?1:-1,Dn=Ln>=0?1:-1;Dn==Fi&&(Dn==1?xi==1?tn>=Ln:tn<=Ln:xi==1?tn<=Ln:tn>=Ln)&&(qi=yi,gs=zt)}else qi=yi,gs=zt}}if(O||Gi){let oi,yi;T.ori==0?(oi=Vn,yi=Hn):(oi=Hn,yi=Vn);let xi,Ln,Fi,Dn,Un,Yn,Cr=!0,ys=Ce.bbox;if(ys!=null){Cr=!1;let ai=ys(n,zt);Fi=ai.left,Dn=ai.top,xi=ai.width,Ln=ai.height}else Fi=oi,Dn=yi,xi=Ln=Ce.size(n,zt);if(Yn=Ce.fill(n,zt),Un=Ce.stroke(n,zt),Gi)zt==gs&&qi<=pn.prox&&(Tt=Fi,Pt=Dn,Zt=xi,Ue=Ln,pe=Cr,ce=Yn,Qt=Un);else{let ai=je[zt];ai!=null&&(Ii[zt]=Fi,Wi[zt]=Dn,Bf(ai,xi,Ln,Cr),Of(ai,Yn,Un),Oi(ai,ci(Fi),ci(Dn),x,z))}}}}if(Gi){let zt=pn.prox,Re=Os==null?qi<=zt:qi>zt||gs!=Os;if(O||Re){let Je=je[0];Ii[0]=Tt,Wi[0]=Pt,Bf(Je,Zt,Ue,pe),Of(Je,ce,Qt),Oi(Je,ci(Tt),ci(Pt),x,z)}}}if(ke.show&&ps)if(v!=null){let[lt,pt]=Qe.scales,[Et,Tt]=Qe.match,[Pt,Zt]=v.cursor.sync.scales,Ue=v.cursor.drag;if(gn=Ue._x,vn=Ue._y,gn||vn){let{left:pe,top:ce,width:Qt,height:zt}=v.select,Re=v.scales[Pt].ori,Je=v.posToVal,Ze,Be,tn,Vn,Hn,oi=lt!=null&&Et(lt,Pt),yi=pt!=null&&Tt(pt,Zt);oi&&gn?(Re==0?(Ze=pe,Be=Qt):(Ze=ce,Be=zt),tn=D[lt],Vn=H(Je(Ze,Pt),tn,Y,0),Hn=H(Je(Ze+Be,Pt),tn,Y,0),Fo(hi(Vn,Hn),an(Hn-Vn))):Fo(0,Y),yi&&vn?(Re==1?(Ze=pe,Be=Qt):(Ze=ce,Be=zt),tn=D[pt],Vn=q(Je(Ze,Zt),tn,st,0),Hn=q(Je(Ze+Be,Zt),tn,st,0),Oo(hi(Vn,Hn),an(Hn-Vn))):Oo(0,st)}else Pa()}else{let lt=an(lf-of),pt=an(cf-af);if(T.ori==1){let Zt=lt;lt=pt,pt=Zt}gn=bn.x&&lt>=bn.dist,vn=bn.y&&pt>=bn.dist;let Et=bn.uni;Et!=null?gn&&vn&&(gn=lt>=Et,vn=pt>=Et,!gn&&!vn&&(pt>lt?vn=!0:gn=!0)):bn.x&&bn.y&&(gn||vn)&&(gn=vn=!0);let Tt,Pt;gn&&(T.ori==0?(Tt=wr,Pt=Oe):(Tt=Sr,Pt=Ge),Fo(hi(Tt,Pt),an(Pt-Tt)),vn||Oo(0,st)),vn&&(T.ori==1?(Tt=wr,Pt=Oe):(Tt=Sr,Pt=Ge),Oo(hi(Tt,Pt),an(Pt-Tt)),gn||Fo(0,Y)),!gn&&!vn&&(Fo(0,0),Oo(0,0))}if(bn._x=gn,bn._y=vn,v==null){if(R){if(Mf!=null){let[lt,pt]=Qe.scales;Qe.values[0]=lt!=null?Ni(T.ori==0?Oe:Ge,lt):null,Qe.values[1]=pt!=null?Ni(T.ori==1?Oe:Ge,pt):null}Bo(Rf,n,Oe,Ge,x,z,L)}if(Hi){let lt=R&&Qe.setSeries,pt=pn.prox;Os==null?qi<=pt&&Ui(gs,Ar,!0,lt):qi>pt?Ui(null,Ar,!0,lt):gs!=Os&&Ui(gs,Ar,!0,lt)}}O&&(ft.idx=L,Wc()),_!==!1&&yn("setCursor")}let vs=null;Object.defineProperty(n,"rect",{get(){return vs==null&&ko(!1),vs}});function ko(v=!1){v?vs=null:(vs=y.getBoundingClientRect(),yn("syncRect",vs))}function df(v,_,R,L,B,Y,st){Ct._lock||ps&&v!=null&&v.movementX==0&&v.movementY==0||(Xc(v,_,R,L,B,Y,st,!1,v!=null),v!=null?ks(null,!0,!0):ks(_,!0,!1))}function Xc(v,_,R,L,B,Y,st,lt,pt){if(vs==null&&ko(!1),le(v),v!=null)R=v.clientX-vs.left,L=v.clientY-vs.top;else{if(R<0||L<0){Oe=-10,Ge=-10;return}let[Et,Tt]=Qe.scales,Pt=_.cursor.sync,[Zt,Ue]=Pt.values,[pe,ce]=Pt.scales,[Qt,zt]=Qe.match,Re=_.axes[0].side%2==1,Je=T.ori==0?x:z,Ze=T.ori==1?x:z,Be=Re?Y:B,tn=Re?B:Y,Vn=Re?L:R,Hn=Re?R:L;if(pe!=null?R=Qt(Et,pe)?l(Zt,D[Et],Je,0):-10:R=Je*(Vn/Be),ce!=null?L=zt(Tt,ce)?l(Ue,D[Tt],Ze,0):-10:L=Ze*(Hn/tn),T.ori==1){let oi=R;R=L,L=oi}}pt&&((R<=1||R>=x-1)&&(R=zs(R,x)),(L<=1||L>=z-1)&&(L=zs(L,z))),lt?(of=R,af=L,[wr,Sr]=Ct.move(n,R,L)):(Oe=R,Ge=L)}let qc={width:0,height:0,left:0,top:0};function Pa(){Ra(qc,!1)}let ff,pf,mf,gf;function vf(v,_,R,L,B,Y,st){ps=!0,gn=vn=bn._x=bn._y=!1,Xc(v,_,R,L,B,Y,st,!0,!1),v!=null&&(Nt(Qc,sh,yf,!1),Bo(Pf,n,wr,Sr,x,z,null));let{left:lt,top:pt,width:Et,height:Tt}=ke;ff=lt,pf=pt,mf=Et,gf=Tt,Pa()}function yf(v,_,R,L,B,Y,st){ps=bn._x=bn._y=!1,Xc(v,_,R,L,B,Y,st,!1,!0);let{left:lt,top:pt,width:Et,height:Tt}=ke,Pt=Et>0||Tt>0,Zt=ff!=lt||pf!=pt||mf!=Et||gf!=Tt;if(Pt&&Zt&&Ra(ke),bn.setScale&&Pt&&Zt){let Ue=lt,pe=Et,ce=pt,Qt=Tt;if(T.ori==1&&(Ue=pt,pe=Tt,ce=lt,Qt=Et),gn&&ms(I,Ni(Ue,I),Ni(Ue+pe,I)),vn)for(let zt in D){let Re=D[zt];zt!=I&&Re.from==null&&Re.min!=fe&&ms(zt,Ni(ce+Qt,zt),Ni(ce,zt))}Pa()}else Ct.lock&&(Ct._lock=!Ct._lock,ks(null,!0,!1));v!=null&&(Me(Qc,sh),Bo(Qc,n,Oe,Ge,x,z,null))}function mv(v,_,R,L,B,Y,st){if(Ct._lock)return;le(v);let lt=ps;if(ps){let pt=!0,Et=!0,Tt=10,Pt,Zt;T.ori==0?(Pt=gn,Zt=vn):(Pt=vn,Zt=gn),Pt&&Zt&&(pt=Oe<=Tt||Oe>=x-Tt,Et=Ge<=Tt||Ge>=z-Tt),Pt&&pt&&(Oe=Oe<wr?0:x),Zt&&Et&&(Ge=Ge<Sr?0:z),ks(null,!0,!0),ps=!1}Oe=-10,Ge=-10,ks(null,!0,!0),lt&&(ps=lt)}function xf(v,_,R,L,B,Y,st){Ct._lock||(le(v),Ft(),Pa(),v!=null&&Bo(Df,n,Oe,Ge,x,z,null))}function _f(){M.forEach(px),yt(n.width,n.height,!0)}Gs(Ba,Ur,_f);let Tr={};Tr.mousedown=vf,Tr.mousemove=df,Tr.mouseup=yf,Tr.dblclick=xf,Tr.setSeries=(v,_,R,L)=>{let B=Qe.match[2];R=B(n,_,R),R!=-1&&Ui(R,L,!0,!1)},Ct.show&&(Nt(Pf,y,vf),Nt(Rf,y,df),Nt(If,y,v=>{le(v),ko(!1)}),Nt(Lf,y,mv),Nt(Df,y,xf),dh.add(n),n.syncRect=ko);let Ia=n.hooks=i.hooks||{};function yn(v,_,R){zc?No.push([v,_,R]):v in Ia&&Ia[v].forEach(L=>{L.call(null,n,_,R)})}(i.plugins||[]).forEach(v=>{for(let _ in v.hooks)Ia[_]=(Ia[_]||[]).concat(v.hooks[_])});let bf=(v,_,R)=>R,Qe=en({key:null,setSeries:!1,filters:{pub:Wf,sub:Wf},scales:[I,S[1]?S[1].scale:null],match:[Xf,Xf,bf],values:[null,null]},Ct.sync);Qe.match.length==2&&Qe.match.push(bf),Ct.sync=Qe;let Mf=Qe.key,Yc=Op(Mf);function Bo(v,_,R,L,B,Y,st){Qe.filters.pub(v,_,R,L,B,Y,st)&&Yc.pub(v,_,R,L,B,Y,st)}Yc.sub(n);function gv(v,_,R,L,B,Y,st){Qe.filters.sub(v,_,R,L,B,Y,st)&&Tr[v](null,_,R,L,B,Y,st)}n.pub=gv;function vv(){Yc.unsub(n),dh.delete(n),Jt.clear(),ah(Ba,Ur,_f),h.remove(),ct?.remove(),yn("destroy")}n.destroy=vv;function $c(){yn("init",i,t),bt(t||i.data,!1),J[I]?Vc(I,J[I]):Ft(),_e=ke.show&&(ke.width>0||ke.height>0),Yt=O=!0,yt(i.width,i.height)}return S.forEach(Ds),M.forEach(Ea),e?e instanceof HTMLElement?(e.appendChild(h),$c()):e(n,$c):$c(),n}ln.assign=en;ln.fmtNum=xh;ln.rangeNum=za;ln.rangeLog=Ha;ln.rangeAsinh=vh;ln.orient=Xs;ln.pxRatio=be;ln.join=ry;ln.fmtDate=bh,ln.tzDate=gy;ln.sync=Op;{ln.addGap=jy,ln.clipGaps=Xa;let i=ln.paths={points:Gp};i.linear=Xp,i.stepped=ex,i.bars=nx,i.spline=sx}function Gn(i,t){let e=0,n=i.length-1;for(;e<n;){let s=e+n+1>>1;i[s]<=t?e=s:n=s-1}return e}function Zp(i,t){if(i.length===0)return-1;let e=Gn(i,t);return e+1<i.length&&i[e+1]-t<t-i[e]?e+1:e}var Jp=128,Gr=class{constructor(t,e){this.element=t;this.seek=e;this.list=[];this.sync=ln.sync("time");this.lines=new Map;this.time=0;new ResizeObserver(()=>this.resize()).observe(t)}add(t,e){this.list.push(this.chart(t,e))}replace(t,e){let n=this.list[t],s=n.root.parentElement,r=e.length+1!==n.series.length||e.some(({label:o},a)=>n.series[a+1].label!==o);s&&r?(this.remove(n),this.list[t]=this.chart(s,e)):mx(n,Kp(e))}keep(t){for(let e of this.list.splice(t))this.remove(e)}setTime(t){this.time=t;for(let[e,n]of this.lines){let s=e.valToPos(t,"x");n.style.transform=`translateX(${s}px)`,n.hidden=!(s>=0&&s<=e.over.clientWidth),(e.cursor.left??-1)<0&&e.setLegend({idx:Gn(e.data[0],t)},!1)}}redraw(){for(let t of this.list)t.redraw(!1,!0)}resize(){for(let t of this.list){let e=t.root.parentElement?.clientWidth??0;e>0&&e!==t.width&&t.setSize({width:e,height:Jp})}this.setTime(this.time)}remove(t){t.destroy(),this.lines.delete(t)}chart(t,e){let n=l=>()=>getComputedStyle(this.element).getPropertyValue(l),s={stroke:n("--text"),grid:{stroke:n("--grid"),width:1},ticks:{stroke:n("--grid"),width:1}},r=U("div",{class:"now"}),o=new ln({width:Math.max(200,t.clientWidth),height:Jp,padding:[6,null,null,null],cursor:{sync:{key:this.sync.key},drag:{x:!0,y:!1},points:{size:5}},scales:{x:{time:!1},y:{range:(l,c,h)=>vx(c,h)}},axes:[{...s,size:28},{...s,size:62,values:(l,c)=>c.map(h=>Kt(h,4))}],series:[{label:"t",value:(l,c)=>c==null?"\u2013":`${Kt(c,6)} s`},...e.map(gx)],hooks:{setScale:[()=>this.setTime(this.time)]}},Kp(e),t);o.over.append(r),this.lines.set(o,r);let a=0;return o.over.addEventListener("pointerdown",l=>a=l.clientX),o.over.addEventListener("click",l=>{Math.abs(l.clientX-a)<4&&this.seek(o.posToVal(l.offsetX,"x"))}),o}};function mx(i,t){let[e]=i.data,{min:n,max:s}=i.scales.x,r=n==null||s==null||n<=e[0]&&s>=e[e.length-1];i.setData(t,r),r||i.redraw()}function gx({label:i,color:t,width:e,isDashed:n,unit:s=""}){return{label:i,stroke:t,width:e??1.6,dash:n?[5,4]:void 0,spanGaps:!0,points:{show:!1},value:(r,o)=>o==null?"\u2013":o===0?"0":Kt(o,5)+s}}function Kp(i){let t=[...new Set(i.map(({times:o})=>o))],e=t.flatMap(o=>i.filter(a=>a.times===o)),n=t.map(o=>[Array.from(o),...i.filter(a=>a.times===o).map(({values:a})=>Array.from(a))]);if(n.length===0)return[[]];let[s,...r]=n.length===1?n[0]:ln.join(n);return[s,...i.map(o=>r[e.indexOf(o)])]}function Za(i){let t=0;for(let{values:e}of i)for(let n=0;n<e.length;++n)t=Math.max(t,Math.abs(e[n]));return t===0||!Number.isFinite(t)||t>=.001&&t<1e6?0:3*Math.floor(Math.log10(t)/3)}function Ja(i,t){return t===0?i:i.map(e=>({...e,values:Array.from(e.values,n=>n/10**t)}))}function Ka(i,t){let e=[t===0?"":jp(t),i].filter(Boolean).join(" ");return e&&` [${e}]`}function Wr(i,t){return[t===0?"":` \xB7 ${jp(t)}`,i&&` ${i}`].join("")}function jp(i){return"10"+String(i).replace(/./g,t=>"\u207B\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079"["-0123456789".indexOf(t)])}function vx(i,t){if(i==null||t==null||i===0&&t===0)return[0,1];let e=.06*(t-i)||.1*Math.abs(t);return[i===0?0:i-e,t+e]}function ki(i,t){let{look:e,mass:n,moments:s}=i.bodies[t],r=i.looks[e];if(r.length>0||n<=0)return r;let[o,a,l]=s,c=[a+l-o,l+o-a,o+a-l].map(u=>2.5*Math.max(0,u)/n),h=Math.max(Math.sqrt(Math.max(...c)),...Ch(i,t).map(u=>Math.hypot(...u)))||1;return[{type:"ellipsoid",radii:c.map(u=>Math.max(Math.sqrt(u),.05*h)),p:[0,0,0],q:[1,0,0,0],material:0,color:""}]}var Qp=new WeakMap;function Ch(i,t){let e=Qp.get(i);if(!e){e=new Map;for(let n of i.joints)for(let s of[0,1]){let r=e.get(n.bodies[s]);r?r.push(n.points[s]):e.set(n.bodies[s],[n.points[s]])}Qp.set(i,e)}return e.get(t)??[]}var Pd="170",ur={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},dr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},yx=0,tm=1,xx=2;var lg=1,_x=2,ns=3,zi=0,Cn=1,fi=2,Cs=0,ao=1,em=2,nm=3,im=4,Id=5,Qs=100,bx=101,Mx=102,wx=103,Sx=104,ic=200,sc=201,Ex=202,Ax=203,au=204,lu=205,Tx=206,Cx=207,Rx=208,Px=209,Ix=210,Lx=211,Dx=212,Ux=213,Nx=214,cu=0,hu=1,uu=2,uo=3,du=4,fu=5,pu=6,mu=7,cg=0,Fx=1,Ox=2,Rs=0,kx=1,Bx=2,zx=3,Vx=4,Hx=5,Gx=6,Wx=7;var hg=300,fo=301,po=302,gu=303,vu=304,rc=306,yu=1e3,nr=1001,xu=1002,ti=1003,Xx=1004;var ja=1005;var pi=1006,Rh=1007;var ir=1008;var rs=1009,ug=1010,dg=1011,aa=1012,Ld=1013,os=1014,Ti=1015,pa=1016,Dd=1017,Ud=1018,mo=1020,fg=35902,pg=1021,mg=1022,Qn=1023,gg=1024,vg=1025,lo=1026,go=1027,yg=1028,Nd=1029,xg=1030,Fd=1031;var Od=1033,El=33776,Al=33777,Tl=33778,Cl=33779,_u=35840,bu=35841,Mu=35842,wu=35843,Su=36196,Eu=37492,Au=37496,Tu=37808,Cu=37809,Ru=37810,Pu=37811,Iu=37812,Lu=37813,Du=37814,Uu=37815,Nu=37816,Fu=37817,Ou=37818,ku=37819,Bu=37820,zu=37821,Rl=36492,Vu=36494,Hu=36495,_g=36283,Gu=36284,Wu=36285,Xu=36286;var Pl=2300,qu=2301,Ph=2302,sm=2400,rm=2401,om=2402;var qx=3200,Yx=3201;var $x=0,Zx=1,Ts="",di="srgb",wo="srgb-linear",oc="linear",Ie="srgb";var Xr=7680;var am=519,Jx=512,Kx=513,jx=514,ac=515,Qx=516,t_=517,e_=518,n_=519,lm=35044,bg=35048;var Vi="300 es",is=2e3,Il=2001,as=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;let n=this._listeners;return n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;let s=this._listeners[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;let n=this._listeners[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},An=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],cm=1234567,na=Math.PI/180,la=180/Math.PI;function So(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(An[i&255]+An[i>>8&255]+An[i>>16&255]+An[i>>24&255]+"-"+An[t&255]+An[t>>8&255]+"-"+An[t>>16&15|64]+An[t>>24&255]+"-"+An[e&63|128]+An[e>>8&255]+"-"+An[e>>16&255]+An[e>>24&255]+An[n&255]+An[n>>8&255]+An[n>>16&255]+An[n>>24&255]).toLowerCase()}function hn(i,t,e){return Math.max(t,Math.min(e,i))}function kd(i,t){return(i%t+t)%t}function i_(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function s_(i,t,e){return i!==t?(e-i)/(t-i):0}function ia(i,t,e){return(1-e)*i+e*t}function r_(i,t,e,n){return ia(i,t,1-Math.exp(-e*n))}function o_(i,t=1){return t-Math.abs(kd(i,t*2)-t)}function a_(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function l_(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function c_(i,t){return i+Math.floor(Math.random()*(t-i+1))}function h_(i,t){return i+Math.random()*(t-i)}function u_(i){return i*(.5-Math.random())}function d_(i){i!==void 0&&(cm=i);let t=cm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function f_(i){return i*na}function p_(i){return i*la}function m_(i){return(i&i-1)===0&&i!==0}function g_(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function v_(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function y_(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),d=r((t-n)/2),u=o((t-n)/2),f=r((n-t)/2),g=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*d,l*u,a*c);break;case"YZY":i.set(l*u,a*h,l*d,a*c);break;case"ZXZ":i.set(l*d,l*u,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ro(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Nn(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Mg={DEG2RAD:na,RAD2DEG:la,generateUUID:So,clamp:hn,euclideanModulo:kd,mapLinear:i_,inverseLerp:s_,lerp:ia,damp:r_,pingpong:o_,smoothstep:a_,smootherstep:l_,randInt:c_,randFloat:h_,randFloatSpread:u_,seededRandom:d_,degToRad:f_,radToDeg:p_,isPowerOfTwo:m_,ceilPowerOfTwo:g_,floorPowerOfTwo:v_,setQuaternionFromProperEuler:y_,normalize:Nn,denormalize:ro},At=class i{constructor(t=0,e=0){i.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(hn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ie=class i{constructor(t,e,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],g=n[8],y=s[0],m=s[3],p=s[6],E=s[1],S=s[4],M=s[7],D=s[2],P=s[5],I=s[8];return r[0]=o*y+a*E+l*D,r[3]=o*m+a*S+l*P,r[6]=o*p+a*M+l*I,r[1]=c*y+h*E+d*D,r[4]=c*m+h*S+d*P,r[7]=c*p+h*M+d*I,r[2]=u*y+f*E+g*D,r[5]=u*m+f*S+g*P,r[8]=u*p+f*M+g*I,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,g=e*d+n*u+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=d*y,t[1]=(s*c-h*n)*y,t[2]=(a*n-s*o)*y,t[3]=u*y,t[4]=(h*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Ih.makeScale(t,e)),this}rotate(t){return this.premultiply(Ih.makeRotation(-t)),this}translate(t,e){return this.premultiply(Ih.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Ih=new ie;function wg(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Ll(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function x_(){let i=Ll("canvas");return i.style.display="block",i}var hm={};function ta(i){i in hm||(hm[i]=!0,console.warn(i))}function __(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}function b_(i){let t=i.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function M_(i){let t=i.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}var ve={enabled:!0,workingColorSpace:wo,spaces:{},convert:function(i,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Ie&&(i.r=ss(i.r),i.g=ss(i.g),i.b=ss(i.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(i.applyMatrix3(this.spaces[t].toXYZ),i.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Ie&&(i.r=co(i.r),i.g=co(i.g),i.b=co(i.b))),i},fromWorkingColorSpace:function(i,t){return this.convert(i,this.workingColorSpace,t)},toWorkingColorSpace:function(i,t){return this.convert(i,t,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===Ts?oc:this.spaces[i].transfer},getLuminanceCoefficients:function(i,t=this.workingColorSpace){return i.fromArray(this.spaces[t].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,t,e){return i.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function ss(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function co(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var um=[.64,.33,.3,.6,.15,.06],dm=[.2126,.7152,.0722],fm=[.3127,.329],pm=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),mm=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ve.define({[wo]:{primaries:um,whitePoint:fm,transfer:oc,toXYZ:pm,fromXYZ:mm,luminanceCoefficients:dm,workingColorSpaceConfig:{unpackColorSpace:di},outputColorSpaceConfig:{drawingBufferColorSpace:di}},[di]:{primaries:um,whitePoint:fm,transfer:Ie,toXYZ:pm,fromXYZ:mm,luminanceCoefficients:dm,outputColorSpaceConfig:{drawingBufferColorSpace:di}}});var qr,Yu=class{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{qr===void 0&&(qr=Ll("canvas")),qr.width=t.width,qr.height=t.height;let n=qr.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),e=qr}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Ll("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ss(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(ss(e[n]/255)*255):e[n]=ss(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},w_=0,Dl=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:w_++}),this.uuid=So(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Lh(s[o].image)):r.push(Lh(s[o]))}else r=Lh(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Lh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Yu.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var S_=0,kn=class i extends as{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=nr,s=nr,r=pi,o=ir,a=Qn,l=rs,c=i.DEFAULT_ANISOTROPY,h=Ts){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:S_++}),this.uuid=So(),this.name="",this.source=new Dl(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new At(0,0),this.repeat=new At(1,1),this.center=new At(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==hg)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case yu:t.x=t.x-Math.floor(t.x);break;case nr:t.x=t.x<0?0:1;break;case xu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case yu:t.y=t.y-Math.floor(t.y);break;case nr:t.y=t.y<0?0:1;break;case xu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};kn.DEFAULT_IMAGE=null;kn.DEFAULT_MAPPING=hg;kn.DEFAULT_ANISOTROPY=1;var Ye=class i{constructor(t=0,e=0,n=0,s=1){i.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],g=l[9],y=l[2],m=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(c+1)/2,M=(f+1)/2,D=(p+1)/2,P=(h+u)/4,I=(d+y)/4,F=(g+m)/4;return S>M&&S>D?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=P/n,r=I/n):M>D?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=P/s,r=F/s):D<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(D),n=I/r,s=F/r),this.set(n,s,r,e),this}let E=Math.sqrt((m-g)*(m-g)+(d-y)*(d-y)+(u-h)*(u-h));return Math.abs(E)<.001&&(E=1),this.x=(m-g)/E,this.y=(d-y)/E,this.z=(u-h)/E,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},$u=class extends as{constructor(t=1,e=1,n={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new Ye(0,0,t,e),this.scissorTest=!1,this.viewport=new Ye(0,0,t,e);let s={width:t,height:e,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:pi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);let r=new kn(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);r.flipY=!1,r.generateMipmaps=n.generateMipmaps,r.internalFormat=n.internalFormat,this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,s=t.textures.length;n<s;n++)this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;let e=Object.assign({},t.texture.image);return this.texture.source=new Dl(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},ei=class extends $u{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},Ul=class extends kn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ti,this.minFilter=ti,this.wrapR=nr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Zu=class extends kn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ti,this.minFilter=ti,this.wrapR=nr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Bn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d;return}if(a===1){t[e+0]=u,t[e+1]=f,t[e+2]=g,t[e+3]=y;return}if(d!==y||l!==u||c!==f||h!==g){let m=1-a,p=l*u+c*f+h*g+d*y,E=p>=0?1:-1,S=1-p*p;if(S>Number.EPSILON){let D=Math.sqrt(S),P=Math.atan2(D,p*E);m=Math.sin(m*P)/D,a=Math.sin(a*P)/D}let M=a*E;if(l=l*m+u*M,c=c*m+f*M,h=h*m+g*M,d=d*m+y*M,m===1-a){let D=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=D,c*=D,h*=D,d*=D}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[o],u=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+h*d+l*f-c*u,t[e+1]=l*g+h*u+c*d-a*f,t[e+2]=c*g+h*f+a*u-l*d,t[e+3]=h*g-a*d-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),d=a(r/2),u=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d-u*f*g;break;case"YXZ":this._x=u*h*d+c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d+u*f*g;break;case"ZXY":this._x=u*h*d-c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d-u*f*g;break;case"ZYX":this._x=u*h*d-c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d+u*f*g;break;case"YZX":this._x=u*h*d+c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d-u*f*g;break;case"XZY":this._x=u*h*d-c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d+u*f*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<Number.EPSILON?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(hn(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let f=1-e;return this._w=f*o+e*this._w,this._x=f*n+e*this._x,this._y=f*s+e*this._y,this._z=f*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),h=Math.atan2(c,a),d=Math.sin((1-e)*h)/c,u=Math.sin(e*h)/c;return this._w=o*d+this._w*u,this._x=n*d+this._x*u,this._y=s*d+this._y*u,this._z=r*d+this._z*u,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},N=class i{constructor(t=0,e=0,n=0){i.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(gm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(gm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),d=2*(r*n-o*e);return this.x=e+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Dh.copy(this).projectOnVector(t),this.sub(Dh)}reflect(t){return this.sub(Dh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(hn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Dh=new N,gm=new Bn,sr=class{constructor(t=new N(1/0,1/0,1/0),e=new N(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(wi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(wi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=wi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,wi):wi.fromBufferAttribute(r,o),wi.applyMatrix4(t.matrixWorld),this.expandByPoint(wi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Qa.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Qa.copy(n.boundingBox)),Qa.applyMatrix4(t.matrixWorld),this.union(Qa)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,wi),wi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Zo),tl.subVectors(this.max,Zo),Yr.subVectors(t.a,Zo),$r.subVectors(t.b,Zo),Zr.subVectors(t.c,Zo),bs.subVectors($r,Yr),Ms.subVectors(Zr,$r),qs.subVectors(Yr,Zr);let e=[0,-bs.z,bs.y,0,-Ms.z,Ms.y,0,-qs.z,qs.y,bs.z,0,-bs.x,Ms.z,0,-Ms.x,qs.z,0,-qs.x,-bs.y,bs.x,0,-Ms.y,Ms.x,0,-qs.y,qs.x,0];return!Uh(e,Yr,$r,Zr,tl)||(e=[1,0,0,0,1,0,0,0,1],!Uh(e,Yr,$r,Zr,tl))?!1:(el.crossVectors(bs,Ms),e=[el.x,el.y,el.z],Uh(e,Yr,$r,Zr,tl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,wi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(wi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ki[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ki[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ki[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ki[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ki[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ki[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ki[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ki[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ki),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}},Ki=[new N,new N,new N,new N,new N,new N,new N,new N],wi=new N,Qa=new sr,Yr=new N,$r=new N,Zr=new N,bs=new N,Ms=new N,qs=new N,Zo=new N,tl=new N,el=new N,Ys=new N;function Uh(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Ys.fromArray(i,r);let a=s.x*Math.abs(Ys.x)+s.y*Math.abs(Ys.y)+s.z*Math.abs(Ys.z),l=t.dot(Ys),c=e.dot(Ys),h=n.dot(Ys);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var E_=new sr,Jo=new N,Nh=new N,rr=class{constructor(t=new N,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):E_.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Jo.subVectors(t,this.center);let e=Jo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Jo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Nh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Jo.copy(t.center).add(Nh)),this.expandByPoint(Jo.copy(t.center).sub(Nh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}},ji=new N,Fh=new N,nl=new N,ws=new N,Oh=new N,il=new N,kh=new N,or=class{constructor(t=new N,e=new N(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ji)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ji.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ji.copy(this.origin).addScaledVector(this.direction,e),ji.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Fh.copy(t).add(e).multiplyScalar(.5),nl.copy(e).sub(t).normalize(),ws.copy(this.origin).sub(Fh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(nl),a=ws.dot(this.direction),l=-ws.dot(nl),c=ws.lengthSq(),h=Math.abs(1-o*o),d,u,f,g;if(h>0)if(d=o*l-a,u=o*a-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let y=1/h;d*=y,u*=y,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Fh).addScaledVector(nl,u),f}intersectSphere(t,e){ji.subVectors(t.center,this.origin);let n=ji.dot(this.direction),s=ji.dot(ji)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,ji)!==null}intersectTriangle(t,e,n,s,r){Oh.subVectors(e,t),il.subVectors(n,t),kh.crossVectors(Oh,il);let o=this.direction.dot(kh),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ws.subVectors(this.origin,t);let l=a*this.direction.dot(il.crossVectors(ws,il));if(l<0)return null;let c=a*this.direction.dot(Oh.cross(ws));if(c<0||l+c>o)return null;let h=-a*ws.dot(kh);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Xe=class i{constructor(t,e,n,s,r,o,a,l,c,h,d,u,f,g,y,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,d,u,f,g,y,m)}set(t,e,n,s,r,o,a,l,c,h,d,u,f,g,y,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=f,p[7]=g,p[11]=y,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,n=t.elements,s=1/Jr.setFromMatrixColumn(t,0).length(),r=1/Jr.setFromMatrixColumn(t,1).length(),o=1/Jr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,f=o*d,g=a*h,y=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=f+g*c,e[5]=u-y*c,e[9]=-a*l,e[2]=y-u*c,e[6]=g+f*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,f=l*d,g=c*h,y=c*d;e[0]=u+y*a,e[4]=g*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-g,e[6]=y+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,f=l*d,g=c*h,y=c*d;e[0]=u-y*a,e[4]=-o*d,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*h,e[9]=y-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,f=o*d,g=a*h,y=a*d;e[0]=l*h,e[4]=g*c-f,e[8]=u*c+y,e[1]=l*d,e[5]=y*c+u,e[9]=f*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,f=o*c,g=a*l,y=a*c;e[0]=l*h,e[4]=y-u*d,e[8]=g*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*d+g,e[10]=u-y*d}else if(t.order==="XZY"){let u=o*l,f=o*c,g=a*l,y=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+y,e[5]=o*h,e[9]=f*d-g,e[2]=g*d-f,e[6]=a*h,e[10]=y*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(A_,t,T_)}lookAt(t,e,n){let s=this.elements;return Kn.subVectors(t,e),Kn.lengthSq()===0&&(Kn.z=1),Kn.normalize(),Ss.crossVectors(n,Kn),Ss.lengthSq()===0&&(Math.abs(n.z)===1?Kn.x+=1e-4:Kn.z+=1e-4,Kn.normalize(),Ss.crossVectors(n,Kn)),Ss.normalize(),sl.crossVectors(Kn,Ss),s[0]=Ss.x,s[4]=sl.x,s[8]=Kn.x,s[1]=Ss.y,s[5]=sl.y,s[9]=Kn.y,s[2]=Ss.z,s[6]=sl.z,s[10]=Kn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],g=n[2],y=n[6],m=n[10],p=n[14],E=n[3],S=n[7],M=n[11],D=n[15],P=s[0],I=s[4],F=s[8],A=s[12],b=s[1],T=s[5],W=s[9],H=s[13],q=s[2],J=s[6],$=s[10],nt=s[14],Q=s[3],ht=s[7],ot=s[11],mt=s[15];return r[0]=o*P+a*b+l*q+c*Q,r[4]=o*I+a*T+l*J+c*ht,r[8]=o*F+a*W+l*$+c*ot,r[12]=o*A+a*H+l*nt+c*mt,r[1]=h*P+d*b+u*q+f*Q,r[5]=h*I+d*T+u*J+f*ht,r[9]=h*F+d*W+u*$+f*ot,r[13]=h*A+d*H+u*nt+f*mt,r[2]=g*P+y*b+m*q+p*Q,r[6]=g*I+y*T+m*J+p*ht,r[10]=g*F+y*W+m*$+p*ot,r[14]=g*A+y*H+m*nt+p*mt,r[3]=E*P+S*b+M*q+D*Q,r[7]=E*I+S*T+M*J+D*ht,r[11]=E*F+S*W+M*$+D*ot,r[15]=E*A+S*H+M*nt+D*mt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],f=t[14],g=t[3],y=t[7],m=t[11],p=t[15];return g*(+r*l*d-s*c*d-r*a*u+n*c*u+s*a*f-n*l*f)+y*(+e*l*f-e*c*u+r*o*u-s*o*f+s*c*h-r*l*h)+m*(+e*c*d-e*a*f-r*o*d+n*o*f+r*a*h-n*c*h)+p*(-s*a*h-e*l*d+e*a*u+s*o*d-n*o*u+n*l*h)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],f=t[11],g=t[12],y=t[13],m=t[14],p=t[15],E=d*m*c-y*u*c+y*l*f-a*m*f-d*l*p+a*u*p,S=g*u*c-h*m*c-g*l*f+o*m*f+h*l*p-o*u*p,M=h*y*c-g*d*c+g*a*f-o*y*f-h*a*p+o*d*p,D=g*d*l-h*y*l-g*a*u+o*y*u+h*a*m-o*d*m,P=e*E+n*S+s*M+r*D;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let I=1/P;return t[0]=E*I,t[1]=(y*u*r-d*m*r-y*s*f+n*m*f+d*s*p-n*u*p)*I,t[2]=(a*m*r-y*l*r+y*s*c-n*m*c-a*s*p+n*l*p)*I,t[3]=(d*l*r-a*u*r-d*s*c+n*u*c+a*s*f-n*l*f)*I,t[4]=S*I,t[5]=(h*m*r-g*u*r+g*s*f-e*m*f-h*s*p+e*u*p)*I,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*I,t[7]=(o*u*r-h*l*r+h*s*c-e*u*c-o*s*f+e*l*f)*I,t[8]=M*I,t[9]=(g*d*r-h*y*r-g*n*f+e*y*f+h*n*p-e*d*p)*I,t[10]=(o*y*r-g*a*r+g*n*c-e*y*c-o*n*p+e*a*p)*I,t[11]=(h*a*r-o*d*r-h*n*c+e*d*c+o*n*f-e*a*f)*I,t[12]=D*I,t[13]=(h*y*s-g*d*s+g*n*u-e*y*u-h*n*m+e*d*m)*I,t[14]=(g*a*s-o*y*s-g*n*l+e*y*l+o*n*m-e*a*m)*I,t[15]=(o*d*s-h*a*s+h*n*l-e*d*l-o*n*u+e*a*u)*I,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,g=r*d,y=o*h,m=o*d,p=a*d,E=l*c,S=l*h,M=l*d,D=n.x,P=n.y,I=n.z;return s[0]=(1-(y+p))*D,s[1]=(f+M)*D,s[2]=(g-S)*D,s[3]=0,s[4]=(f-M)*P,s[5]=(1-(u+p))*P,s[6]=(m+E)*P,s[7]=0,s[8]=(g+S)*I,s[9]=(m-E)*I,s[10]=(1-(u+y))*I,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements,r=Jr.set(s[0],s[1],s[2]).length(),o=Jr.set(s[4],s[5],s[6]).length(),a=Jr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],Si.copy(this);let c=1/r,h=1/o,d=1/a;return Si.elements[0]*=c,Si.elements[1]*=c,Si.elements[2]*=c,Si.elements[4]*=h,Si.elements[5]*=h,Si.elements[6]*=h,Si.elements[8]*=d,Si.elements[9]*=d,Si.elements[10]*=d,e.setFromRotationMatrix(Si),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=is){let l=this.elements,c=2*r/(e-t),h=2*r/(n-s),d=(e+t)/(e-t),u=(n+s)/(n-s),f,g;if(a===is)f=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===Il)f=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=h,l[9]=u,l[13]=0,l[2]=0,l[6]=0,l[10]=f,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=is){let l=this.elements,c=1/(e-t),h=1/(n-s),d=1/(o-r),u=(e+t)*c,f=(n+s)*h,g,y;if(a===is)g=(o+r)*d,y=-2*d;else if(a===Il)g=r*d,y=-1*d;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-u,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-f,l[2]=0,l[6]=0,l[10]=y,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Jr=new N,Si=new Xe,A_=new N(0,0,0),T_=new N(1,1,1),Ss=new N,sl=new N,Kn=new N,vm=new Xe,ym=new Bn,ls=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(hn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-hn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(hn(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-hn(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(hn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-hn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return vm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(vm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ym.setFromEuler(this),this.setFromQuaternion(ym,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ls.DEFAULT_ORDER="XYZ";var Nl=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},C_=0,xm=new N,Kr=new Bn,Qi=new Xe,rl=new N,Ko=new N,R_=new N,P_=new Bn,_m=new N(1,0,0),bm=new N(0,1,0),Mm=new N(0,0,1),wm={type:"added"},I_={type:"removed"},jr={type:"childadded",child:null},Bh={type:"childremoved",child:null},ni=class i extends as{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:C_++}),this.uuid=So(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new N,e=new ls,n=new Bn,s=new N(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Xe},normalMatrix:{value:new ie}}),this.matrix=new Xe,this.matrixWorld=new Xe,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Nl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Kr.setFromAxisAngle(t,e),this.quaternion.multiply(Kr),this}rotateOnWorldAxis(t,e){return Kr.setFromAxisAngle(t,e),this.quaternion.premultiply(Kr),this}rotateX(t){return this.rotateOnAxis(_m,t)}rotateY(t){return this.rotateOnAxis(bm,t)}rotateZ(t){return this.rotateOnAxis(Mm,t)}translateOnAxis(t,e){return xm.copy(t).applyQuaternion(this.quaternion),this.position.add(xm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(_m,t)}translateY(t){return this.translateOnAxis(bm,t)}translateZ(t){return this.translateOnAxis(Mm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Qi.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?rl.copy(t):rl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ko.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Qi.lookAt(Ko,rl,this.up):Qi.lookAt(rl,Ko,this.up),this.quaternion.setFromRotationMatrix(Qi),s&&(Qi.extractRotation(s.matrixWorld),Kr.setFromRotationMatrix(Qi),this.quaternion.premultiply(Kr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(wm),jr.child=t,this.dispatchEvent(jr),jr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(I_),Bh.child=t,this.dispatchEvent(Bh),Bh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Qi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Qi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Qi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(wm),jr.child=t,this.dispatchEvent(jr),jr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ko,t,R_),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ko,P_,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}};ni.DEFAULT_UP=new N(0,1,0);ni.DEFAULT_MATRIX_AUTO_UPDATE=!0;ni.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ei=new N,ts=new N,zh=new N,es=new N,Qr=new N,to=new N,Sm=new N,Vh=new N,Hh=new N,Gh=new N,Wh=new Ye,Xh=new Ye,qh=new Ye,tr=class i{constructor(t=new N,e=new N,n=new N){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ei.subVectors(t,e),s.cross(Ei);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ei.subVectors(s,e),ts.subVectors(n,e),zh.subVectors(t,e);let o=Ei.dot(Ei),a=Ei.dot(ts),l=Ei.dot(zh),c=ts.dot(ts),h=ts.dot(zh),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-f-g,g,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,es)===null?!1:es.x>=0&&es.y>=0&&es.x+es.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,es)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,es.x),l.addScaledVector(o,es.y),l.addScaledVector(a,es.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Wh.setScalar(0),Xh.setScalar(0),qh.setScalar(0),Wh.fromBufferAttribute(t,e),Xh.fromBufferAttribute(t,n),qh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Wh,r.x),o.addScaledVector(Xh,r.y),o.addScaledVector(qh,r.z),o}static isFrontFacing(t,e,n,s){return Ei.subVectors(n,e),ts.subVectors(t,e),Ei.cross(ts).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ei.subVectors(this.c,this.b),ts.subVectors(this.a,this.b),Ei.cross(ts).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Qr.subVectors(s,n),to.subVectors(r,n),Vh.subVectors(t,n);let l=Qr.dot(Vh),c=to.dot(Vh);if(l<=0&&c<=0)return e.copy(n);Hh.subVectors(t,s);let h=Qr.dot(Hh),d=to.dot(Hh);if(h>=0&&d<=h)return e.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0)return o=l/(l-h),e.copy(n).addScaledVector(Qr,o);Gh.subVectors(t,r);let f=Qr.dot(Gh),g=to.dot(Gh);if(g>=0&&f<=g)return e.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(to,a);let m=h*g-f*d;if(m<=0&&d-h>=0&&f-g>=0)return Sm.subVectors(r,s),a=(d-h)/(d-h+(f-g)),e.copy(s).addScaledVector(Sm,a);let p=1/(m+y+u);return o=y*p,a=u*p,e.copy(n).addScaledVector(Qr,o).addScaledVector(to,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Sg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Es={h:0,s:0,l:0},ol={h:0,s:0,l:0};function Yh(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=di){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.toWorkingColorSpace(this,e),this}setRGB(t,e,n,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=n,ve.toWorkingColorSpace(this,s),this}setHSL(t,e,n,s=ve.workingColorSpace){if(t=kd(t,1),e=hn(e,0,1),n=hn(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Yh(o,r,t+1/3),this.g=Yh(o,r,t),this.b=Yh(o,r,t-1/3)}return ve.toWorkingColorSpace(this,s),this}setStyle(t,e=di){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=di){let n=Sg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ss(t.r),this.g=ss(t.g),this.b=ss(t.b),this}copyLinearToSRGB(t){return this.r=co(t.r),this.g=co(t.g),this.b=co(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=di){return ve.fromWorkingColorSpace(Tn.copy(this),t),Math.round(hn(Tn.r*255,0,255))*65536+Math.round(hn(Tn.g*255,0,255))*256+Math.round(hn(Tn.b*255,0,255))}getHexString(t=di){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.fromWorkingColorSpace(Tn.copy(this),e);let n=Tn.r,s=Tn.g,r=Tn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ve.workingColorSpace){return ve.fromWorkingColorSpace(Tn.copy(this),e),t.r=Tn.r,t.g=Tn.g,t.b=Tn.b,t}getStyle(t=di){ve.fromWorkingColorSpace(Tn.copy(this),t);let e=Tn.r,n=Tn.g,s=Tn.b;return t!==di?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Es),this.setHSL(Es.h+t,Es.s+e,Es.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Es),t.getHSL(ol);let n=ia(Es.h,ol.h,e),s=ia(Es.s,ol.s,e),r=ia(Es.l,ol.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Tn=new he;he.NAMES=Sg;var L_=0,Ps=class extends as{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:L_++}),this.uuid=So(),this.name="",this.blending=ao,this.side=zi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=au,this.blendDst=lu,this.blendEquation=Qs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=am,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Xr,this.stencilZFail=Xr,this.stencilZPass=Xr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==ao&&(n.blending=this.blending),this.side!==zi&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==au&&(n.blendSrc=this.blendSrc),this.blendDst!==lu&&(n.blendDst=this.blendDst),this.blendEquation!==Qs&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==uo&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==am&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Xr&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Xr&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Xr&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}},Fl=class extends Ps{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ls,this.combine=cg,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var nn=new N,al=new At,Ve=class{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=lm,this.updateRanges=[],this.gpuType=Ti,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)al.fromBufferAttribute(this,e),al.applyMatrix3(t),this.setXY(e,al.x,al.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyMatrix3(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyMatrix4(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyNormalMatrix(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.transformDirection(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=ro(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Nn(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=ro(e,this.array)),e}setX(t,e){return this.normalized&&(e=Nn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=ro(e,this.array)),e}setY(t,e){return this.normalized&&(e=Nn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=ro(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Nn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=ro(e,this.array)),e}setW(t,e){return this.normalized&&(e=Nn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Nn(e,this.array),n=Nn(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Nn(e,this.array),n=Nn(n,this.array),s=Nn(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Nn(e,this.array),n=Nn(n,this.array),s=Nn(s,this.array),r=Nn(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==lm&&(t.usage=this.usage),t}};var Ol=class extends Ve{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var kl=class extends Ve{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ke=class extends Ve{constructor(t,e,n){super(new Float32Array(t),e,n)}},D_=0,ui=new Xe,$h=new ni,eo=new N,jn=new sr,jo=new sr,xn=new N,$e=class i extends as{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:D_++}),this.uuid=So(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(wg(t)?kl:Ol)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ie().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return ui.makeRotationFromQuaternion(t),this.applyMatrix4(ui),this}rotateX(t){return ui.makeRotationX(t),this.applyMatrix4(ui),this}rotateY(t){return ui.makeRotationY(t),this.applyMatrix4(ui),this}rotateZ(t){return ui.makeRotationZ(t),this.applyMatrix4(ui),this}translate(t,e,n){return ui.makeTranslation(t,e,n),this.applyMatrix4(ui),this}scale(t,e,n){return ui.makeScale(t,e,n),this.applyMatrix4(ui),this}lookAt(t){return $h.lookAt(t),$h.updateMatrix(),this.applyMatrix4($h.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(eo).negate(),this.translate(eo.x,eo.y,eo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ke(n,3))}else{for(let n=0,s=e.count;n<s;n++){let r=t[n];e.setXYZ(n,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new sr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new N(-1/0,-1/0,-1/0),new N(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];jn.setFromBufferAttribute(r),this.morphTargetsRelative?(xn.addVectors(this.boundingBox.min,jn.min),this.boundingBox.expandByPoint(xn),xn.addVectors(this.boundingBox.max,jn.max),this.boundingBox.expandByPoint(xn)):(this.boundingBox.expandByPoint(jn.min),this.boundingBox.expandByPoint(jn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new rr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new N,1/0);return}if(t){let n=this.boundingSphere.center;if(jn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];jo.setFromBufferAttribute(a),this.morphTargetsRelative?(xn.addVectors(jn.min,jo.min),jn.expandByPoint(xn),xn.addVectors(jn.max,jo.max),jn.expandByPoint(xn)):(jn.expandByPoint(jo.min),jn.expandByPoint(jo.max))}jn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)xn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(xn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)xn.fromBufferAttribute(a,c),l&&(eo.fromBufferAttribute(t,c),xn.add(eo)),s=Math.max(s,n.distanceToSquared(xn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Ve(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let F=0;F<n.count;F++)a[F]=new N,l[F]=new N;let c=new N,h=new N,d=new N,u=new At,f=new At,g=new At,y=new N,m=new N;function p(F,A,b){c.fromBufferAttribute(n,F),h.fromBufferAttribute(n,A),d.fromBufferAttribute(n,b),u.fromBufferAttribute(r,F),f.fromBufferAttribute(r,A),g.fromBufferAttribute(r,b),h.sub(c),d.sub(c),f.sub(u),g.sub(u);let T=1/(f.x*g.y-g.x*f.y);isFinite(T)&&(y.copy(h).multiplyScalar(g.y).addScaledVector(d,-f.y).multiplyScalar(T),m.copy(d).multiplyScalar(f.x).addScaledVector(h,-g.x).multiplyScalar(T),a[F].add(y),a[A].add(y),a[b].add(y),l[F].add(m),l[A].add(m),l[b].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let F=0,A=E.length;F<A;++F){let b=E[F],T=b.start,W=b.count;for(let H=T,q=T+W;H<q;H+=3)p(t.getX(H+0),t.getX(H+1),t.getX(H+2))}let S=new N,M=new N,D=new N,P=new N;function I(F){D.fromBufferAttribute(s,F),P.copy(D);let A=a[F];S.copy(A),S.sub(D.multiplyScalar(D.dot(A))).normalize(),M.crossVectors(P,A);let T=M.dot(l[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,T)}for(let F=0,A=E.length;F<A;++F){let b=E[F],T=b.start,W=b.count;for(let H=T,q=T+W;H<q;H+=3)I(t.getX(H+0)),I(t.getX(H+1)),I(t.getX(H+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Ve(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new N,r=new N,o=new N,a=new N,l=new N,c=new N,h=new N,d=new N;if(t)for(let u=0,f=t.count;u<f;u+=3){let g=t.getX(u+0),y=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)xn.fromBufferAttribute(t,e),xn.normalize(),t.setXYZ(e,xn.x,xn.y,xn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,g=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let p=0;p<h;p++)u[g++]=c[f++]}return new Ve(u,h,d)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=t(u,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone(e));let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Em=new Xe,$s=new or,ll=new rr,Am=new N,cl=new N,hl=new N,ul=new N,Zh=new N,dl=new N,Tm=new N,fl=new N,Mn=class extends ni{constructor(t=new $e,e=new Fl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){dl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(Zh.fromBufferAttribute(d,t),o?dl.addScaledVector(Zh,h):dl.addScaledVector(Zh.sub(e),h))}e.add(dl)}return e}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ll.copy(n.boundingSphere),ll.applyMatrix4(r),$s.copy(t.ray).recast(t.near),!(ll.containsPoint($s.origin)===!1&&($s.intersectSphere(ll,Am)===null||$s.origin.distanceToSquared(Am)>(t.far-t.near)**2))&&(Em.copy(r).invert(),$s.copy(t.ray).applyMatrix4(Em),!(n.boundingBox!==null&&$s.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,$s)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=u.length;g<y;g++){let m=u[g],p=o[m.materialIndex],E=Math.max(m.start,f.start),S=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let M=E,D=S;M<D;M+=3){let P=a.getX(M),I=a.getX(M+1),F=a.getX(M+2);s=pl(this,p,t,n,c,h,d,P,I,F),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let E=a.getX(m),S=a.getX(m+1),M=a.getX(m+2);s=pl(this,o,t,n,c,h,d,E,S,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=u.length;g<y;g++){let m=u[g],p=o[m.materialIndex],E=Math.max(m.start,f.start),S=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let M=E,D=S;M<D;M+=3){let P=M,I=M+1,F=M+2;s=pl(this,p,t,n,c,h,d,P,I,F),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let E=m,S=m+1,M=m+2;s=pl(this,o,t,n,c,h,d,E,S,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function U_(i,t,e,n,s,r,o,a){let l;if(t.side===Cn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===zi,a),l===null)return null;fl.copy(a),fl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(fl);return c<e.near||c>e.far?null:{distance:c,point:fl.clone(),object:i}}function pl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,cl),i.getVertexPosition(l,hl),i.getVertexPosition(c,ul);let h=U_(i,t,e,n,cl,hl,ul,Tm);if(h){let d=new N;tr.getBarycoord(Tm,cl,hl,ul,d),s&&(h.uv=tr.getInterpolatedAttribute(s,a,l,c,d,new At)),r&&(h.uv1=tr.getInterpolatedAttribute(r,a,l,c,d,new At)),o&&(h.normal=tr.getInterpolatedAttribute(o,a,l,c,d,new N),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new N,materialIndex:0};tr.getNormal(cl,hl,ul,u.normal),h.face=u,h.barycoord=d}return h}var ca=class i extends $e{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ke(c,3)),this.setAttribute("normal",new Ke(h,3)),this.setAttribute("uv",new Ke(d,2));function g(y,m,p,E,S,M,D,P,I,F,A){let b=M/I,T=D/F,W=M/2,H=D/2,q=P/2,J=I+1,$=F+1,nt=0,Q=0,ht=new N;for(let ot=0;ot<$;ot++){let mt=ot*T-H;for(let ft=0;ft<J;ft++){let Wt=ft*b-W;ht[y]=Wt*E,ht[m]=mt*S,ht[p]=q,c.push(ht.x,ht.y,ht.z),ht[y]=0,ht[m]=0,ht[p]=P>0?1:-1,h.push(ht.x,ht.y,ht.z),d.push(ft/I),d.push(1-ot/F),nt+=1}}for(let ot=0;ot<F;ot++)for(let mt=0;mt<I;mt++){let ft=u+mt+J*ot,Wt=u+mt+J*(ot+1),K=u+(mt+1)+J*(ot+1),ct=u+(mt+1)+J*ot;l.push(ft,Wt,ct),l.push(Wt,K,ct),Q+=6}a.addGroup(f,Q,A),f+=Q,u+=nt}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function vo(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function Fn(i){let t={};for(let e=0;e<i.length;e++){let n=vo(i[e]);for(let s in n)t[s]=n[s]}return t}function N_(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Eg(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var F_={clone:vo,merge:Fn},O_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,k_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,_n=class extends Ps{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=O_,this.fragmentShader=k_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=vo(t.uniforms),this.uniformsGroups=N_(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}},Bl=class extends ni{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Xe,this.projectionMatrix=new Xe,this.projectionMatrixInverse=new Xe,this.coordinateSystem=is}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},As=new N,Cm=new At,Rm=new At,On=class extends Bl{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=la*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(na*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return la*2*Math.atan(Math.tan(na*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){As.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(As.x,As.y).multiplyScalar(-t/As.z),As.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(As.x,As.y).multiplyScalar(-t/As.z)}getViewSize(t,e){return this.getViewBounds(t,Cm,Rm),e.subVectors(Rm,Cm)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(na*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},no=-90,io=1,Ju=class extends ni{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new On(no,io,t,e);s.layers=this.layers,this.add(s);let r=new On(no,io,t,e);r.layers=this.layers,this.add(r);let o=new On(no,io,t,e);o.layers=this.layers,this.add(o);let a=new On(no,io,t,e);a.layers=this.layers,this.add(a);let l=new On(no,io,t,e);l.layers=this.layers,this.add(l);let c=new On(no,io,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===is)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Il)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=y,t.setRenderTarget(n,5,s),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},zl=class extends kn{constructor(t,e,n,s,r,o,a,l,c,h){t=t!==void 0?t:[],e=e!==void 0?e:fo,super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Ku=class extends ei{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new zl(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:pi}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ca(5,5,5),r=new _n({name:"CubemapFromEquirect",uniforms:vo(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Cn,blending:Cs});r.uniforms.tEquirect.value=e;let o=new Mn(s,r),a=e.minFilter;return e.minFilter===ir&&(e.minFilter=pi),new Ju(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,n,s){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Jh=new N,B_=new N,z_=new ie,Ai=class{constructor(t=new N(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Jh.subVectors(n,e).cross(B_.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let n=t.delta(Jh),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||z_.getNormalMatrix(t),s=this.coplanarPoint(Jh).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},Zs=new rr,ml=new N,Vl=class{constructor(t=new Ai,e=new Ai,n=new Ai,s=new Ai,r=new Ai,o=new Ai){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=is){let n=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],h=s[5],d=s[6],u=s[7],f=s[8],g=s[9],y=s[10],m=s[11],p=s[12],E=s[13],S=s[14],M=s[15];if(n[0].setComponents(l-r,u-c,m-f,M-p).normalize(),n[1].setComponents(l+r,u+c,m+f,M+p).normalize(),n[2].setComponents(l+o,u+h,m+g,M+E).normalize(),n[3].setComponents(l-o,u-h,m-g,M-E).normalize(),n[4].setComponents(l-a,u-d,m-y,M-S).normalize(),e===is)n[5].setComponents(l+a,u+d,m+y,M+S).normalize();else if(e===Il)n[5].setComponents(a,d,y,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Zs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Zs.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Zs)}intersectsSprite(t){return Zs.center.set(0,0,0),Zs.radius=.7071067811865476,Zs.applyMatrix4(t.matrixWorld),this.intersectsSphere(Zs)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(ml.x=s.normal.x>0?t.max.x:t.min.x,ml.y=s.normal.y>0?t.max.y:t.min.y,ml.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ml)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};function Ag(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function V_(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,g)=>f.start-g.start);let u=0;for(let f=1;f<d.length;f++){let g=d[u],y=d[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++u,d[u]=y)}d.length=u+1;for(let f=0,g=d.length;f<g;f++){let y=d[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Is=class i extends $e{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,d=t/a,u=e/l,f=[],g=[],y=[],m=[];for(let p=0;p<h;p++){let E=p*u-o;for(let S=0;S<c;S++){let M=S*d-r;g.push(M,-E,0),y.push(0,0,1),m.push(S/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let E=0;E<a;E++){let S=E+c*p,M=E+c*(p+1),D=E+1+c*(p+1),P=E+1+c*p;f.push(S,M,P),f.push(M,D,P)}this.setIndex(f),this.setAttribute("position",new Ke(g,3)),this.setAttribute("normal",new Ke(y,3)),this.setAttribute("uv",new Ke(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},H_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,G_=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,W_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,X_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,q_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Y_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,$_=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Z_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,J_=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,K_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,j_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Q_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,tb=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,eb=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,nb=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,ib=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,sb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,rb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ob=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,ab=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,lb=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,cb=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,hb=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,ub=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,db=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,fb=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,pb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,mb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,gb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,vb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,yb="gl_FragColor = linearToOutputTexel( gl_FragColor );",xb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,_b=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,bb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Mb=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,wb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Sb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Eb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ab=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Tb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Cb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Rb=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Pb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Ib=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Lb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Db=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,Ub=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,Nb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Fb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ob=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,kb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Bb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,zb=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Vb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Hb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Gb=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Wb=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Xb=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qb=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Yb=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,$b=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Zb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Jb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Kb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,jb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Qb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,tM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,eM=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,nM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,iM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,sM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,rM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,oM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,aM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,lM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,cM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,hM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,uM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,dM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,fM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,pM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,mM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,gM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,vM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,yM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,xM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,_M=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,bM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,MM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,wM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,SM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,EM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,AM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,TM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,CM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,RM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,PM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,IM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,LM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,DM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,UM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,NM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,FM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,OM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,kM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,BM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,zM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,VM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,HM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,GM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,WM=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,XM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,qM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,YM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,$M=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,ZM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,JM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,KM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,jM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,QM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,tw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ew=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,nw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,ow=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,lw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,cw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,hw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,uw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,dw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,pw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,gw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,vw=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,xw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,_w=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,re={alphahash_fragment:H_,alphahash_pars_fragment:G_,alphamap_fragment:W_,alphamap_pars_fragment:X_,alphatest_fragment:q_,alphatest_pars_fragment:Y_,aomap_fragment:$_,aomap_pars_fragment:Z_,batching_pars_vertex:J_,batching_vertex:K_,begin_vertex:j_,beginnormal_vertex:Q_,bsdfs:tb,iridescence_fragment:eb,bumpmap_pars_fragment:nb,clipping_planes_fragment:ib,clipping_planes_pars_fragment:sb,clipping_planes_pars_vertex:rb,clipping_planes_vertex:ob,color_fragment:ab,color_pars_fragment:lb,color_pars_vertex:cb,color_vertex:hb,common:ub,cube_uv_reflection_fragment:db,defaultnormal_vertex:fb,displacementmap_pars_vertex:pb,displacementmap_vertex:mb,emissivemap_fragment:gb,emissivemap_pars_fragment:vb,colorspace_fragment:yb,colorspace_pars_fragment:xb,envmap_fragment:_b,envmap_common_pars_fragment:bb,envmap_pars_fragment:Mb,envmap_pars_vertex:wb,envmap_physical_pars_fragment:Ub,envmap_vertex:Sb,fog_vertex:Eb,fog_pars_vertex:Ab,fog_fragment:Tb,fog_pars_fragment:Cb,gradientmap_pars_fragment:Rb,lightmap_pars_fragment:Pb,lights_lambert_fragment:Ib,lights_lambert_pars_fragment:Lb,lights_pars_begin:Db,lights_toon_fragment:Nb,lights_toon_pars_fragment:Fb,lights_phong_fragment:Ob,lights_phong_pars_fragment:kb,lights_physical_fragment:Bb,lights_physical_pars_fragment:zb,lights_fragment_begin:Vb,lights_fragment_maps:Hb,lights_fragment_end:Gb,logdepthbuf_fragment:Wb,logdepthbuf_pars_fragment:Xb,logdepthbuf_pars_vertex:qb,logdepthbuf_vertex:Yb,map_fragment:$b,map_pars_fragment:Zb,map_particle_fragment:Jb,map_particle_pars_fragment:Kb,metalnessmap_fragment:jb,metalnessmap_pars_fragment:Qb,morphinstance_vertex:tM,morphcolor_vertex:eM,morphnormal_vertex:nM,morphtarget_pars_vertex:iM,morphtarget_vertex:sM,normal_fragment_begin:rM,normal_fragment_maps:oM,normal_pars_fragment:aM,normal_pars_vertex:lM,normal_vertex:cM,normalmap_pars_fragment:hM,clearcoat_normal_fragment_begin:uM,clearcoat_normal_fragment_maps:dM,clearcoat_pars_fragment:fM,iridescence_pars_fragment:pM,opaque_fragment:mM,packing:gM,premultiplied_alpha_fragment:vM,project_vertex:yM,dithering_fragment:xM,dithering_pars_fragment:_M,roughnessmap_fragment:bM,roughnessmap_pars_fragment:MM,shadowmap_pars_fragment:wM,shadowmap_pars_vertex:SM,shadowmap_vertex:EM,shadowmask_pars_fragment:AM,skinbase_vertex:TM,skinning_pars_vertex:CM,skinning_vertex:RM,skinnormal_vertex:PM,specularmap_fragment:IM,specularmap_pars_fragment:LM,tonemapping_fragment:DM,tonemapping_pars_fragment:UM,transmission_fragment:NM,transmission_pars_fragment:FM,uv_pars_fragment:OM,uv_pars_vertex:kM,uv_vertex:BM,worldpos_vertex:zM,background_vert:VM,background_frag:HM,backgroundCube_vert:GM,backgroundCube_frag:WM,cube_vert:XM,cube_frag:qM,depth_vert:YM,depth_frag:$M,distanceRGBA_vert:ZM,distanceRGBA_frag:JM,equirect_vert:KM,equirect_frag:jM,linedashed_vert:QM,linedashed_frag:tw,meshbasic_vert:ew,meshbasic_frag:nw,meshlambert_vert:iw,meshlambert_frag:sw,meshmatcap_vert:rw,meshmatcap_frag:ow,meshnormal_vert:aw,meshnormal_frag:lw,meshphong_vert:cw,meshphong_frag:hw,meshphysical_vert:uw,meshphysical_frag:dw,meshtoon_vert:fw,meshtoon_frag:pw,points_vert:mw,points_frag:gw,shadow_vert:vw,shadow_frag:yw,sprite_vert:xw,sprite_frag:_w},xt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new At(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new At(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},Bi={basic:{uniforms:Fn([xt.common,xt.specularmap,xt.envmap,xt.aomap,xt.lightmap,xt.fog]),vertexShader:re.meshbasic_vert,fragmentShader:re.meshbasic_frag},lambert:{uniforms:Fn([xt.common,xt.specularmap,xt.envmap,xt.aomap,xt.lightmap,xt.emissivemap,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.fog,xt.lights,{emissive:{value:new he(0)}}]),vertexShader:re.meshlambert_vert,fragmentShader:re.meshlambert_frag},phong:{uniforms:Fn([xt.common,xt.specularmap,xt.envmap,xt.aomap,xt.lightmap,xt.emissivemap,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.fog,xt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30}}]),vertexShader:re.meshphong_vert,fragmentShader:re.meshphong_frag},standard:{uniforms:Fn([xt.common,xt.envmap,xt.aomap,xt.lightmap,xt.emissivemap,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.roughnessmap,xt.metalnessmap,xt.fog,xt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:re.meshphysical_vert,fragmentShader:re.meshphysical_frag},toon:{uniforms:Fn([xt.common,xt.aomap,xt.lightmap,xt.emissivemap,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.gradientmap,xt.fog,xt.lights,{emissive:{value:new he(0)}}]),vertexShader:re.meshtoon_vert,fragmentShader:re.meshtoon_frag},matcap:{uniforms:Fn([xt.common,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.fog,{matcap:{value:null}}]),vertexShader:re.meshmatcap_vert,fragmentShader:re.meshmatcap_frag},points:{uniforms:Fn([xt.points,xt.fog]),vertexShader:re.points_vert,fragmentShader:re.points_frag},dashed:{uniforms:Fn([xt.common,xt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:re.linedashed_vert,fragmentShader:re.linedashed_frag},depth:{uniforms:Fn([xt.common,xt.displacementmap]),vertexShader:re.depth_vert,fragmentShader:re.depth_frag},normal:{uniforms:Fn([xt.common,xt.bumpmap,xt.normalmap,xt.displacementmap,{opacity:{value:1}}]),vertexShader:re.meshnormal_vert,fragmentShader:re.meshnormal_frag},sprite:{uniforms:Fn([xt.sprite,xt.fog]),vertexShader:re.sprite_vert,fragmentShader:re.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:re.background_vert,fragmentShader:re.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:re.backgroundCube_vert,fragmentShader:re.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:re.cube_vert,fragmentShader:re.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:re.equirect_vert,fragmentShader:re.equirect_frag},distanceRGBA:{uniforms:Fn([xt.common,xt.displacementmap,{referencePosition:{value:new N},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:re.distanceRGBA_vert,fragmentShader:re.distanceRGBA_frag},shadow:{uniforms:Fn([xt.lights,xt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:re.shadow_vert,fragmentShader:re.shadow_frag}};Bi.physical={uniforms:Fn([Bi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new At(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new At},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new At},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:re.meshphysical_vert,fragmentShader:re.meshphysical_frag};var gl={r:0,b:0,g:0},Js=new ls,bw=new Xe;function Mw(i,t,e,n,s,r,o){let a=new he(0),l=r===!0?0:1,c,h,d=null,u=0,f=null;function g(E){let S=E.isScene===!0?E.background:null;return S&&S.isTexture&&(S=(E.backgroundBlurriness>0?e:t).get(S)),S}function y(E){let S=!1,M=g(E);M===null?p(a,l):M&&M.isColor&&(p(M,1),S=!0);let D=i.xr.getEnvironmentBlendMode();D==="additive"?n.buffers.color.setClear(0,0,0,1,o):D==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||S)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(E,S){let M=g(S);M&&(M.isCubeTexture||M.mapping===rc)?(h===void 0&&(h=new Mn(new ca(1,1,1),new _n({name:"BackgroundCubeMaterial",uniforms:vo(Bi.backgroundCube.uniforms),vertexShader:Bi.backgroundCube.vertexShader,fragmentShader:Bi.backgroundCube.fragmentShader,side:Cn,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(D,P,I){this.matrixWorld.copyPosition(I.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Js.copy(S.backgroundRotation),Js.x*=-1,Js.y*=-1,Js.z*=-1,M.isCubeTexture&&M.isRenderTargetTexture===!1&&(Js.y*=-1,Js.z*=-1),h.material.uniforms.envMap.value=M,h.material.uniforms.flipEnvMap.value=M.isCubeTexture&&M.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(bw.makeRotationFromEuler(Js)),h.material.toneMapped=ve.getTransfer(M.colorSpace)!==Ie,(d!==M||u!==M.version||f!==i.toneMapping)&&(h.material.needsUpdate=!0,d=M,u=M.version,f=i.toneMapping),h.layers.enableAll(),E.unshift(h,h.geometry,h.material,0,0,null)):M&&M.isTexture&&(c===void 0&&(c=new Mn(new Is(2,2),new _n({name:"BackgroundMaterial",uniforms:vo(Bi.background.uniforms),vertexShader:Bi.background.vertexShader,fragmentShader:Bi.background.fragmentShader,side:zi,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=M,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=ve.getTransfer(M.colorSpace)!==Ie,M.matrixAutoUpdate===!0&&M.updateMatrix(),c.material.uniforms.uvTransform.value.copy(M.matrix),(d!==M||u!==M.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,d=M,u=M.version,f=i.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function p(E,S){E.getRGB(gl,Eg(i)),n.buffers.color.setClear(gl.r,gl.g,gl.b,S,o)}return{getClearColor:function(){return a},setClearColor:function(E,S=1){a.set(E),l=S,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(E){l=E,p(a,l)},render:y,addToRenderList:m}}function ww(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(b,T,W,H,q){let J=!1,$=d(H,W,T);r!==$&&(r=$,c(r.object)),J=f(b,H,W,q),J&&g(b,H,W,q),q!==null&&t.update(q,i.ELEMENT_ARRAY_BUFFER),(J||o)&&(o=!1,M(b,T,W,H),q!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(q).buffer))}function l(){return i.createVertexArray()}function c(b){return i.bindVertexArray(b)}function h(b){return i.deleteVertexArray(b)}function d(b,T,W){let H=W.wireframe===!0,q=n[b.id];q===void 0&&(q={},n[b.id]=q);let J=q[T.id];J===void 0&&(J={},q[T.id]=J);let $=J[H];return $===void 0&&($=u(l()),J[H]=$),$}function u(b){let T=[],W=[],H=[];for(let q=0;q<e;q++)T[q]=0,W[q]=0,H[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:T,enabledAttributes:W,attributeDivisors:H,object:b,attributes:{},index:null}}function f(b,T,W,H){let q=r.attributes,J=T.attributes,$=0,nt=W.getAttributes();for(let Q in nt)if(nt[Q].location>=0){let ot=q[Q],mt=J[Q];if(mt===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(mt=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(mt=b.instanceColor)),ot===void 0||ot.attribute!==mt||mt&&ot.data!==mt.data)return!0;$++}return r.attributesNum!==$||r.index!==H}function g(b,T,W,H){let q={},J=T.attributes,$=0,nt=W.getAttributes();for(let Q in nt)if(nt[Q].location>=0){let ot=J[Q];ot===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(ot=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(ot=b.instanceColor));let mt={};mt.attribute=ot,ot&&ot.data&&(mt.data=ot.data),q[Q]=mt,$++}r.attributes=q,r.attributesNum=$,r.index=H}function y(){let b=r.newAttributes;for(let T=0,W=b.length;T<W;T++)b[T]=0}function m(b){p(b,0)}function p(b,T){let W=r.newAttributes,H=r.enabledAttributes,q=r.attributeDivisors;W[b]=1,H[b]===0&&(i.enableVertexAttribArray(b),H[b]=1),q[b]!==T&&(i.vertexAttribDivisor(b,T),q[b]=T)}function E(){let b=r.newAttributes,T=r.enabledAttributes;for(let W=0,H=T.length;W<H;W++)T[W]!==b[W]&&(i.disableVertexAttribArray(W),T[W]=0)}function S(b,T,W,H,q,J,$){$===!0?i.vertexAttribIPointer(b,T,W,q,J):i.vertexAttribPointer(b,T,W,H,q,J)}function M(b,T,W,H){y();let q=H.attributes,J=W.getAttributes(),$=T.defaultAttributeValues;for(let nt in J){let Q=J[nt];if(Q.location>=0){let ht=q[nt];if(ht===void 0&&(nt==="instanceMatrix"&&b.instanceMatrix&&(ht=b.instanceMatrix),nt==="instanceColor"&&b.instanceColor&&(ht=b.instanceColor)),ht!==void 0){let ot=ht.normalized,mt=ht.itemSize,ft=t.get(ht);if(ft===void 0)continue;let Wt=ft.buffer,K=ft.type,ct=ft.bytesPerElement,Lt=K===i.INT||K===i.UNSIGNED_INT||ht.gpuType===Ld;if(ht.isInterleavedBufferAttribute){let ut=ht.data,Ut=ut.stride,Gt=ht.offset;if(ut.isInstancedInterleavedBuffer){for(let Vt=0;Vt<Q.locationSize;Vt++)p(Q.location+Vt,ut.meshPerAttribute);b.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=ut.meshPerAttribute*ut.count)}else for(let Vt=0;Vt<Q.locationSize;Vt++)m(Q.location+Vt);i.bindBuffer(i.ARRAY_BUFFER,Wt);for(let Vt=0;Vt<Q.locationSize;Vt++)S(Q.location+Vt,mt/Q.locationSize,K,ot,Ut*ct,(Gt+mt/Q.locationSize*Vt)*ct,Lt)}else{if(ht.isInstancedBufferAttribute){for(let ut=0;ut<Q.locationSize;ut++)p(Q.location+ut,ht.meshPerAttribute);b.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let ut=0;ut<Q.locationSize;ut++)m(Q.location+ut);i.bindBuffer(i.ARRAY_BUFFER,Wt);for(let ut=0;ut<Q.locationSize;ut++)S(Q.location+ut,mt/Q.locationSize,K,ot,mt*ct,mt/Q.locationSize*ut*ct,Lt)}}else if($!==void 0){let ot=$[nt];if(ot!==void 0)switch(ot.length){case 2:i.vertexAttrib2fv(Q.location,ot);break;case 3:i.vertexAttrib3fv(Q.location,ot);break;case 4:i.vertexAttrib4fv(Q.location,ot);break;default:i.vertexAttrib1fv(Q.location,ot)}}}}E()}function D(){F();for(let b in n){let T=n[b];for(let W in T){let H=T[W];for(let q in H)h(H[q].object),delete H[q];delete T[W]}delete n[b]}}function P(b){if(n[b.id]===void 0)return;let T=n[b.id];for(let W in T){let H=T[W];for(let q in H)h(H[q].object),delete H[q];delete T[W]}delete n[b.id]}function I(b){for(let T in n){let W=n[T];if(W[b.id]===void 0)continue;let H=W[b.id];for(let q in H)h(H[q].object),delete H[q];delete W[b.id]}}function F(){A(),o=!0,r!==s&&(r=s,c(r.object))}function A(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:A,dispose:D,releaseStatesOfGeometry:P,releaseStatesOfProgram:I,initAttributes:y,enableAttribute:m,disableUnusedAttributes:E}}function Sw(i,t,e){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),e.update(h,n,1)}function o(c,h,d){d!==0&&(i.drawArraysInstanced(n,c,h,d),e.update(h,n,d))}function a(c,h,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,d);let f=0;for(let g=0;g<d;g++)f+=h[g];e.update(f,n,1)}function l(c,h,d,u){if(d===0)return;let f=t.get("WEBGL_multi_draw");if(f===null)for(let g=0;g<c.length;g++)o(c[g],h[g],u[g]);else{f.multiDrawArraysInstancedWEBGL(n,c,0,h,0,u,0,d);let g=0;for(let y=0;y<d;y++)g+=h[y]*u[y];e.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Ew(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let I=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(I.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(I){return!(I!==Qn&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(I){let F=I===pa&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(I!==rs&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&I!==Ti&&!F)}function l(I){if(I==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";I="mediump"}return I==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.logarithmicDepthBuffer===!0,u=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),E=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),D=g>0,P=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reverseDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:E,maxVaryings:S,maxFragmentUniforms:M,vertexTextures:D,maxSamples:P}}function Aw(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Ai,a=new ie,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let g=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,p=i.get(d);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let E=r?0:n,S=E*4,M=p.clippingState||null;l.value=M,M=h(g,u,S,f);for(let D=0;D!==S;++D)M[D]=e[D];p.clippingState=M,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=E}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(d,u,f,g){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let p=f+y*4,E=u.matrixWorldInverse;a.getNormalMatrix(E),(m===null||m.length<p)&&(m=new Float32Array(p));for(let S=0,M=f;S!==y;++S,M+=4)o.copy(d[S]).applyMatrix4(E,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}function Tw(i){let t=new WeakMap;function e(o,a){return a===gu?o.mapping=fo:a===vu&&(o.mapping=po),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===gu||a===vu)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new Ku(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}var ha=class extends Bl{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},oo=4,Pm=[.125,.215,.35,.446,.526,.582],er=20,Kh=new ha,Im=new he,jh=null,Qh=0,tu=0,eu=!1,js=(1+Math.sqrt(5))/2,so=1/js,Lm=[new N(-js,so,0),new N(js,so,0),new N(-so,0,js),new N(so,0,js),new N(0,js,-so),new N(0,js,so),new N(-1,1,-1),new N(1,1,-1),new N(-1,1,1),new N(1,1,1)],Hl=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100){jh=this._renderer.getRenderTarget(),Qh=this._renderer.getActiveCubeFace(),tu=this._renderer.getActiveMipmapLevel(),eu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);let r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,n,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Nm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Um(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(jh,Qh,tu),this._renderer.xr.enabled=eu,t.scissorTest=!1,vl(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===fo||t.mapping===po?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),jh=this._renderer.getRenderTarget(),Qh=this._renderer.getActiveCubeFace(),tu=this._renderer.getActiveMipmapLevel(),eu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:pi,minFilter:pi,generateMipmaps:!1,type:pa,format:Qn,colorSpace:wo,depthBuffer:!1},s=Dm(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Dm(t,e,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=Cw(r)),this._blurMaterial=Rw(r,t,e)}return s}_compileMaterial(t){let e=new Mn(this._lodPlanes[0],t);this._renderer.compile(e,Kh)}_sceneToCubeUV(t,e,n,s){let a=new On(90,1,e,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,d=h.autoClear,u=h.toneMapping;h.getClearColor(Im),h.toneMapping=Rs,h.autoClear=!1;let f=new Fl({name:"PMREM.Background",side:Cn,depthWrite:!1,depthTest:!1}),g=new Mn(new ca,f),y=!1,m=t.background;m?m.isColor&&(f.color.copy(m),t.background=null,y=!0):(f.color.copy(Im),y=!0);for(let p=0;p<6;p++){let E=p%3;E===0?(a.up.set(0,l[p],0),a.lookAt(c[p],0,0)):E===1?(a.up.set(0,0,l[p]),a.lookAt(0,c[p],0)):(a.up.set(0,l[p],0),a.lookAt(0,0,c[p]));let S=this._cubeSize;vl(s,E*S,p>2?S:0,S,S),h.setRenderTarget(s),y&&h.render(g,a),h.render(t,a)}g.geometry.dispose(),g.material.dispose(),h.toneMapping=u,h.autoClear=d,t.background=m}_textureToCubeUV(t,e){let n=this._renderer,s=t.mapping===fo||t.mapping===po;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Nm()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Um());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Mn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;vl(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,Kh)}_applyPMREM(t){let e=this._renderer,n=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Lm[(s-r-1)%Lm.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,d=new Mn(this._lodPlanes[s],c),u=c.uniforms,f=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*er-1),y=r/g,m=isFinite(r)?1+Math.floor(h*y):er;m>er&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${er}`);let p=[],E=0;for(let I=0;I<er;++I){let F=I/y,A=Math.exp(-F*F/2);p.push(A),I===0?E+=A:I<m&&(E+=2*A)}for(let I=0;I<p.length;I++)p[I]=p[I]/E;u.envMap.value=t.texture,u.samples.value=m,u.weights.value=p,u.latitudinal.value=o==="latitudinal",a&&(u.poleAxis.value=a);let{_lodMax:S}=this;u.dTheta.value=g,u.mipInt.value=S-n;let M=this._sizeLods[s],D=3*M*(s>S-oo?s-S+oo:0),P=4*(this._cubeSize-M);vl(e,D,P,3*M,2*M),l.setRenderTarget(e),l.render(d,Kh)}};function Cw(i){let t=[],e=[],n=[],s=i,r=i-oo+1+Pm.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>i-oo?l=Pm[o-i+oo-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),h=-c,d=1+c,u=[h,h,d,h,d,d,h,h,d,d,h,d],f=6,g=6,y=3,m=2,p=1,E=new Float32Array(y*g*f),S=new Float32Array(m*g*f),M=new Float32Array(p*g*f);for(let P=0;P<f;P++){let I=P%3*2/3-1,F=P>2?0:-1,A=[I,F,0,I+2/3,F,0,I+2/3,F+1,0,I,F,0,I+2/3,F+1,0,I,F+1,0];E.set(A,y*g*P),S.set(u,m*g*P);let b=[P,P,P,P,P,P];M.set(b,p*g*P)}let D=new $e;D.setAttribute("position",new Ve(E,y)),D.setAttribute("uv",new Ve(S,m)),D.setAttribute("faceIndex",new Ve(M,p)),t.push(D),s>oo&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function Dm(i,t,e){let n=new ei(i,t,e);return n.texture.mapping=rc,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function vl(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function Rw(i,t,e){let n=new Float32Array(er),s=new N(0,1,0);return new _n({name:"SphericalGaussianBlur",defines:{n:er,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Bd(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:Cs,depthTest:!1,depthWrite:!1})}function Um(){return new _n({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Bd(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:Cs,depthTest:!1,depthWrite:!1})}function Nm(){return new _n({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Bd(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Cs,depthTest:!1,depthWrite:!1})}function Bd(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function Pw(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===gu||l===vu,h=l===fo||l===po;if(c||h){let d=t.get(a),u=d!==void 0?d.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==u)return e===null&&(e=new Hl(i)),d=c?e.fromEquirectangular(a,d):e.fromCubemap(a,d),d.texture.pmremVersion=a.pmremVersion,t.set(a,d),d.texture;if(d!==void 0)return d.texture;{let f=a.image;return c&&f&&f.height>0||h&&f&&s(f)?(e===null&&(e=new Hl(i)),d=c?e.fromEquirectangular(a):e.fromCubemap(a),d.texture.pmremVersion=a.pmremVersion,t.set(a,d),a.addEventListener("dispose",r),d.texture):null}}}return a}function s(a){let l=0,c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function Iw(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&ta("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function Lw(i,t,e,n){let s={},r=new WeakMap;function o(d){let u=d.target;u.index!==null&&t.remove(u.index);for(let g in u.attributes)t.remove(u.attributes[g]);for(let g in u.morphAttributes){let y=u.morphAttributes[g];for(let m=0,p=y.length;m<p;m++)t.remove(y[m])}u.removeEventListener("dispose",o),delete s[u.id];let f=r.get(u);f&&(t.remove(f),r.delete(u)),n.releaseStatesOfGeometry(u),u.isInstancedBufferGeometry===!0&&delete u._maxInstanceCount,e.memory.geometries--}function a(d,u){return s[u.id]===!0||(u.addEventListener("dispose",o),s[u.id]=!0,e.memory.geometries++),u}function l(d){let u=d.attributes;for(let g in u)t.update(u[g],i.ARRAY_BUFFER);let f=d.morphAttributes;for(let g in f){let y=f[g];for(let m=0,p=y.length;m<p;m++)t.update(y[m],i.ARRAY_BUFFER)}}function c(d){let u=[],f=d.index,g=d.attributes.position,y=0;if(f!==null){let E=f.array;y=f.version;for(let S=0,M=E.length;S<M;S+=3){let D=E[S+0],P=E[S+1],I=E[S+2];u.push(D,P,P,I,I,D)}}else if(g!==void 0){let E=g.array;y=g.version;for(let S=0,M=E.length/3-1;S<M;S+=3){let D=S+0,P=S+1,I=S+2;u.push(D,P,P,I,I,D)}}else return;let m=new(wg(u)?kl:Ol)(u,1);m.version=y;let p=r.get(d);p&&t.remove(p),r.set(d,m)}function h(d){let u=r.get(d);if(u){let f=d.index;f!==null&&u.version<f.version&&c(d)}else c(d);return r.get(d)}return{get:a,update:l,getWireframeAttribute:h}}function Dw(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),e.update(f,n,1)}function c(u,f,g){g!==0&&(i.drawElementsInstanced(n,f,r,u*o,g),e.update(f,n,g))}function h(u,f,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,g);let m=0;for(let p=0;p<g;p++)m+=f[p];e.update(m,n,1)}function d(u,f,g,y){if(g===0)return;let m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<u.length;p++)c(u[p]/o,f[p],y[p]);else{m.multiDrawElementsInstancedWEBGL(n,f,0,r,u,0,y,0,g);let p=0;for(let E=0;E<g;E++)p+=f[E]*y[E];e.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=d}function Uw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Nw(i,t,e){let n=new WeakMap,s=new Ye;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let A=function(){I.dispose(),n.delete(a),a.removeEventListener("dispose",A)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],E=a.morphAttributes.color||[],S=0;f===!0&&(S=1),g===!0&&(S=2),y===!0&&(S=3);let M=a.attributes.position.count*S,D=1;M>t.maxTextureSize&&(D=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let P=new Float32Array(M*D*4*d),I=new Ul(P,M,D,d);I.type=Ti,I.needsUpdate=!0;let F=S*4;for(let b=0;b<d;b++){let T=m[b],W=p[b],H=E[b],q=M*D*4*b;for(let J=0;J<T.count;J++){let $=J*F;f===!0&&(s.fromBufferAttribute(T,J),P[q+$+0]=s.x,P[q+$+1]=s.y,P[q+$+2]=s.z,P[q+$+3]=0),g===!0&&(s.fromBufferAttribute(W,J),P[q+$+4]=s.x,P[q+$+5]=s.y,P[q+$+6]=s.z,P[q+$+7]=0),y===!0&&(s.fromBufferAttribute(H,J),P[q+$+8]=s.x,P[q+$+9]=s.y,P[q+$+10]=s.z,P[q+$+11]=H.itemSize===4?s.w:1)}}u={count:d,texture:I,size:new At(M,D)},n.set(a,u),a.addEventListener("dispose",A)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function Fw(i,t,e,n){let s=new WeakMap;function r(l){let c=n.render.frame,h=l.geometry,d=t.get(l,h);if(s.get(d)!==c&&(t.update(d),s.set(d,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let u=l.skeleton;s.get(u)!==c&&(u.update(),s.set(u,c))}return d}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var yo=class extends kn{constructor(t,e,n,s,r,o,a,l,c,h=lo){if(h!==lo&&h!==go)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===lo&&(n=os),n===void 0&&h===go&&(n=mo),super(null,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:ti,this.minFilter=l!==void 0?l:ti,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},Tg=new kn,Fm=new yo(1,1),Cg=new Ul,Rg=new Zu,Pg=new zl,Om=[],km=[],Bm=new Float32Array(16),zm=new Float32Array(9),Vm=new Float32Array(4);function Eo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Om[s];if(r===void 0&&(r=new Float32Array(s),Om[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function un(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function dn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function lc(i,t){let e=km[t];e===void 0&&(e=new Int32Array(t),km[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function Ow(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function kw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(un(e,t))return;i.uniform2fv(this.addr,t),dn(e,t)}}function Bw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(un(e,t))return;i.uniform3fv(this.addr,t),dn(e,t)}}function zw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(un(e,t))return;i.uniform4fv(this.addr,t),dn(e,t)}}function Vw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(un(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),dn(e,t)}else{if(un(e,n))return;Vm.set(n),i.uniformMatrix2fv(this.addr,!1,Vm),dn(e,n)}}function Hw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(un(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),dn(e,t)}else{if(un(e,n))return;zm.set(n),i.uniformMatrix3fv(this.addr,!1,zm),dn(e,n)}}function Gw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(un(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),dn(e,t)}else{if(un(e,n))return;Bm.set(n),i.uniformMatrix4fv(this.addr,!1,Bm),dn(e,n)}}function Ww(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Xw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(un(e,t))return;i.uniform2iv(this.addr,t),dn(e,t)}}function qw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(un(e,t))return;i.uniform3iv(this.addr,t),dn(e,t)}}function Yw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(un(e,t))return;i.uniform4iv(this.addr,t),dn(e,t)}}function $w(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Zw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(un(e,t))return;i.uniform2uiv(this.addr,t),dn(e,t)}}function Jw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(un(e,t))return;i.uniform3uiv(this.addr,t),dn(e,t)}}function Kw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(un(e,t))return;i.uniform4uiv(this.addr,t),dn(e,t)}}function jw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(Fm.compareFunction=ac,r=Fm):r=Tg,e.setTexture2D(t||r,s)}function Qw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Rg,s)}function tS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||Pg,s)}function eS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Cg,s)}function nS(i){switch(i){case 5126:return Ow;case 35664:return kw;case 35665:return Bw;case 35666:return zw;case 35674:return Vw;case 35675:return Hw;case 35676:return Gw;case 5124:case 35670:return Ww;case 35667:case 35671:return Xw;case 35668:case 35672:return qw;case 35669:case 35673:return Yw;case 5125:return $w;case 36294:return Zw;case 36295:return Jw;case 36296:return Kw;case 35678:case 36198:case 36298:case 36306:case 35682:return jw;case 35679:case 36299:case 36307:return Qw;case 35680:case 36300:case 36308:case 36293:return tS;case 36289:case 36303:case 36311:case 36292:return eS}}function iS(i,t){i.uniform1fv(this.addr,t)}function sS(i,t){let e=Eo(t,this.size,2);i.uniform2fv(this.addr,e)}function rS(i,t){let e=Eo(t,this.size,3);i.uniform3fv(this.addr,e)}function oS(i,t){let e=Eo(t,this.size,4);i.uniform4fv(this.addr,e)}function aS(i,t){let e=Eo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function lS(i,t){let e=Eo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function cS(i,t){let e=Eo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function hS(i,t){i.uniform1iv(this.addr,t)}function uS(i,t){i.uniform2iv(this.addr,t)}function dS(i,t){i.uniform3iv(this.addr,t)}function fS(i,t){i.uniform4iv(this.addr,t)}function pS(i,t){i.uniform1uiv(this.addr,t)}function mS(i,t){i.uniform2uiv(this.addr,t)}function gS(i,t){i.uniform3uiv(this.addr,t)}function vS(i,t){i.uniform4uiv(this.addr,t)}function yS(i,t,e){let n=this.cache,s=t.length,r=lc(e,s);un(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Tg,r[o])}function xS(i,t,e){let n=this.cache,s=t.length,r=lc(e,s);un(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Rg,r[o])}function _S(i,t,e){let n=this.cache,s=t.length,r=lc(e,s);un(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Pg,r[o])}function bS(i,t,e){let n=this.cache,s=t.length,r=lc(e,s);un(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Cg,r[o])}function MS(i){switch(i){case 5126:return iS;case 35664:return sS;case 35665:return rS;case 35666:return oS;case 35674:return aS;case 35675:return lS;case 35676:return cS;case 5124:case 35670:return hS;case 35667:case 35671:return uS;case 35668:case 35672:return dS;case 35669:case 35673:return fS;case 5125:return pS;case 36294:return mS;case 36295:return gS;case 36296:return vS;case 35678:case 36198:case 36298:case 36306:case 35682:return yS;case 35679:case 36299:case 36307:return xS;case 35680:case 36300:case 36308:case 36293:return _S;case 36289:case 36303:case 36311:case 36292:return bS}}var ju=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=nS(e.type)}},Qu=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=MS(e.type)}},td=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},nu=/(\w+)(\])?(\[|\.)?/g;function Hm(i,t){i.seq.push(t),i.map[t.id]=t}function wS(i,t,e){let n=i.name,s=n.length;for(nu.lastIndex=0;;){let r=nu.exec(n),o=nu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Hm(e,c===void 0?new ju(a,i,t):new Qu(a,i,t));break}else{let d=e.map[a];d===void 0&&(d=new td(a),Hm(e,d)),e=d}}}var ho=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);wS(r,o,this)}}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Gm(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var SS=37297,ES=0;function AS(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Wm=new ie;function TS(i){ve._getMatrix(Wm,ve.workingColorSpace,i);let t=`mat3( ${Wm.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(i)){case oc:return[t,"LinearTransferOETF"];case Ie:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Xm(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),s=i.getShaderInfoLog(t).trim();if(n&&s==="")return"";let r=/ERROR: 0:(\d+)/.exec(s);if(r){let o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+AS(i.getShaderSource(t),o)}else return s}function CS(i,t){let e=TS(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function RS(i,t){let e;switch(t){case kx:e="Linear";break;case Bx:e="Reinhard";break;case zx:e="Cineon";break;case Vx:e="ACESFilmic";break;case Gx:e="AgX";break;case Wx:e="Neutral";break;case Hx:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var yl=new N;function PS(){ve.getLuminanceCoefficients(yl);let i=yl.x.toFixed(4),t=yl.y.toFixed(4),e=yl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function IS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ea).join(`
`)}function LS(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function DS(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function ea(i){return i!==""}function qm(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function Ym(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var US=/^[ \t]*#include +<([\w\d./]+)>/gm;function ed(i){return i.replace(US,FS)}var NS=new Map;function FS(i,t){let e=re[t];if(e===void 0){let n=NS.get(t);if(n!==void 0)e=re[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return ed(e)}var OS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function $m(i){return i.replace(OS,kS)}function kS(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Zm(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function BS(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===lg?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===_x?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===ns&&(t="SHADOWMAP_TYPE_VSM"),t}function zS(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case fo:case po:t="ENVMAP_TYPE_CUBE";break;case rc:t="ENVMAP_TYPE_CUBE_UV";break}return t}function VS(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case po:t="ENVMAP_MODE_REFRACTION";break}return t}function HS(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case cg:t="ENVMAP_BLENDING_MULTIPLY";break;case Fx:t="ENVMAP_BLENDING_MIX";break;case Ox:t="ENVMAP_BLENDING_ADD";break}return t}function GS(i){let t=i.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),7*16)),texelHeight:n,maxMip:e}}function WS(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=BS(e),c=zS(e),h=VS(e),d=HS(e),u=GS(e),f=IS(e),g=LS(r),y=s.createProgram(),m,p,E=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(ea).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(ea).join(`
`),p.length>0&&(p+=`
`)):(m=[Zm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ea).join(`
`),p=[Zm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",u?"#define CUBEUV_TEXEL_WIDTH "+u.texelWidth:"",u?"#define CUBEUV_TEXEL_HEIGHT "+u.texelHeight:"",u?"#define CUBEUV_MAX_MIP "+u.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Rs?"#define TONE_MAPPING":"",e.toneMapping!==Rs?re.tonemapping_pars_fragment:"",e.toneMapping!==Rs?RS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",re.colorspace_pars_fragment,CS("linearToOutputTexel",e.outputColorSpace),PS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ea).join(`
`)),o=ed(o),o=qm(o,e),o=Ym(o,e),a=ed(a),a=qm(a,e),a=Ym(a,e),o=$m(o),a=$m(a),e.isRawShaderMaterial!==!0&&(E=`#version 300 es
`,m=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===Vi?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Vi?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let S=E+m+o,M=E+p+a,D=Gm(s,s.VERTEX_SHADER,S),P=Gm(s,s.FRAGMENT_SHADER,M);s.attachShader(y,D),s.attachShader(y,P),e.index0AttributeName!==void 0?s.bindAttribLocation(y,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(y,0,"position"),s.linkProgram(y);function I(T){if(i.debug.checkShaderErrors){let W=s.getProgramInfoLog(y).trim(),H=s.getShaderInfoLog(D).trim(),q=s.getShaderInfoLog(P).trim(),J=!0,$=!0;if(s.getProgramParameter(y,s.LINK_STATUS)===!1)if(J=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,y,D,P);else{let nt=Xm(s,D,"vertex"),Q=Xm(s,P,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(y,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+W+`
`+nt+`
`+Q)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(H===""||q==="")&&($=!1);$&&(T.diagnostics={runnable:J,programLog:W,vertexShader:{log:H,prefix:m},fragmentShader:{log:q,prefix:p}})}s.deleteShader(D),s.deleteShader(P),F=new ho(s,y),A=DS(s,y)}let F;this.getUniforms=function(){return F===void 0&&I(this),F};let A;this.getAttributes=function(){return A===void 0&&I(this),A};let b=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(y,SS)),b},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(y),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=ES++,this.cacheKey=t,this.usedTimes=1,this.program=y,this.vertexShader=D,this.fragmentShader=P,this}var XS=0,nd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new id(t),e.set(t,n)),n}},id=class{constructor(t){this.id=XS++,this.code=t,this.usedTimes=0}};function qS(i,t,e,n,s,r,o){let a=new Nl,l=new nd,c=new Set,h=[],d=s.logarithmicDepthBuffer,u=s.vertexTextures,f=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function y(A){return c.add(A),A===0?"uv":`uv${A}`}function m(A,b,T,W,H){let q=W.fog,J=H.geometry,$=A.isMeshStandardMaterial?W.environment:null,nt=(A.isMeshStandardMaterial?e:t).get(A.envMap||$),Q=nt&&nt.mapping===rc?nt.image.height:null,ht=g[A.type];A.precision!==null&&(f=s.getMaxPrecision(A.precision),f!==A.precision&&console.warn("THREE.WebGLProgram.getParameters:",A.precision,"not supported, using",f,"instead."));let ot=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,mt=ot!==void 0?ot.length:0,ft=0;J.morphAttributes.position!==void 0&&(ft=1),J.morphAttributes.normal!==void 0&&(ft=2),J.morphAttributes.color!==void 0&&(ft=3);let Wt,K,ct,Lt;if(ht){let le=Bi[ht];Wt=le.vertexShader,K=le.fragmentShader}else Wt=A.vertexShader,K=A.fragmentShader,l.update(A),ct=l.getVertexShaderID(A),Lt=l.getFragmentShaderID(A);let ut=i.getRenderTarget(),Ut=i.state.buffers.depth.getReversed(),Gt=H.isInstancedMesh===!0,Vt=H.isBatchedMesh===!0,oe=!!A.map,ee=!!A.matcap,Te=!!nt,G=!!A.aoMap,rn=!!A.lightMap,se=!!A.bumpMap,Jt=!!A.normalMap,Nt=!!A.displacementMap,Me=!!A.emissiveMap,kt=!!A.metalnessMap,C=!!A.roughnessMap,x=A.anisotropy>0,z=A.clearcoat>0,it=A.dispersion>0,j=A.iridescence>0,et=A.sheen>0,It=A.transmission>0,gt=x&&!!A.anisotropyMap,_t=z&&!!A.clearcoatMap,qt=z&&!!A.clearcoatNormalMap,at=z&&!!A.clearcoatRoughnessMap,vt=j&&!!A.iridescenceMap,Bt=j&&!!A.iridescenceThicknessMap,Ht=et&&!!A.sheenColorMap,Mt=et&&!!A.sheenRoughnessMap,ne=!!A.specularMap,Yt=!!A.specularColorMap,_e=!!A.specularIntensityMap,O=It&&!!A.transmissionMap,yt=It&&!!A.thicknessMap,tt=!!A.gradientMap,rt=!!A.alphaMap,St=A.alphaTest>0,wt=!!A.alphaHash,jt=!!A.extensions,He=Rs;A.toneMapped&&(ut===null||ut.isXRRenderTarget===!0)&&(He=i.toneMapping);let Ct={shaderID:ht,shaderType:A.type,shaderName:A.name,vertexShader:Wt,fragmentShader:K,defines:A.defines,customVertexShaderID:ct,customFragmentShaderID:Lt,isRawShaderMaterial:A.isRawShaderMaterial===!0,glslVersion:A.glslVersion,precision:f,batching:Vt,batchingColor:Vt&&H._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&H.instanceColor!==null,instancingMorph:Gt&&H.morphTexture!==null,supportsVertexTextures:u,outputColorSpace:ut===null?i.outputColorSpace:ut.isXRRenderTarget===!0?ut.texture.colorSpace:wo,alphaToCoverage:!!A.alphaToCoverage,map:oe,matcap:ee,envMap:Te,envMapMode:Te&&nt.mapping,envMapCubeUVHeight:Q,aoMap:G,lightMap:rn,bumpMap:se,normalMap:Jt,displacementMap:u&&Nt,emissiveMap:Me,normalMapObjectSpace:Jt&&A.normalMapType===Zx,normalMapTangentSpace:Jt&&A.normalMapType===$x,metalnessMap:kt,roughnessMap:C,anisotropy:x,anisotropyMap:gt,clearcoat:z,clearcoatMap:_t,clearcoatNormalMap:qt,clearcoatRoughnessMap:at,dispersion:it,iridescence:j,iridescenceMap:vt,iridescenceThicknessMap:Bt,sheen:et,sheenColorMap:Ht,sheenRoughnessMap:Mt,specularMap:ne,specularColorMap:Yt,specularIntensityMap:_e,transmission:It,transmissionMap:O,thicknessMap:yt,gradientMap:tt,opaque:A.transparent===!1&&A.blending===ao&&A.alphaToCoverage===!1,alphaMap:rt,alphaTest:St,alphaHash:wt,combine:A.combine,mapUv:oe&&y(A.map.channel),aoMapUv:G&&y(A.aoMap.channel),lightMapUv:rn&&y(A.lightMap.channel),bumpMapUv:se&&y(A.bumpMap.channel),normalMapUv:Jt&&y(A.normalMap.channel),displacementMapUv:Nt&&y(A.displacementMap.channel),emissiveMapUv:Me&&y(A.emissiveMap.channel),metalnessMapUv:kt&&y(A.metalnessMap.channel),roughnessMapUv:C&&y(A.roughnessMap.channel),anisotropyMapUv:gt&&y(A.anisotropyMap.channel),clearcoatMapUv:_t&&y(A.clearcoatMap.channel),clearcoatNormalMapUv:qt&&y(A.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:at&&y(A.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&y(A.iridescenceMap.channel),iridescenceThicknessMapUv:Bt&&y(A.iridescenceThicknessMap.channel),sheenColorMapUv:Ht&&y(A.sheenColorMap.channel),sheenRoughnessMapUv:Mt&&y(A.sheenRoughnessMap.channel),specularMapUv:ne&&y(A.specularMap.channel),specularColorMapUv:Yt&&y(A.specularColorMap.channel),specularIntensityMapUv:_e&&y(A.specularIntensityMap.channel),transmissionMapUv:O&&y(A.transmissionMap.channel),thicknessMapUv:yt&&y(A.thicknessMap.channel),alphaMapUv:rt&&y(A.alphaMap.channel),vertexTangents:!!J.attributes.tangent&&(Jt||x),vertexColors:A.vertexColors,vertexAlphas:A.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,pointsUvs:H.isPoints===!0&&!!J.attributes.uv&&(oe||rt),fog:!!q,useFog:A.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:A.flatShading===!0,sizeAttenuation:A.sizeAttenuation===!0,logarithmicDepthBuffer:d,reverseDepthBuffer:Ut,skinning:H.isSkinnedMesh===!0,morphTargets:J.morphAttributes.position!==void 0,morphNormals:J.morphAttributes.normal!==void 0,morphColors:J.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:ft,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:A.dithering,shadowMapEnabled:i.shadowMap.enabled&&T.length>0,shadowMapType:i.shadowMap.type,toneMapping:He,decodeVideoTexture:oe&&A.map.isVideoTexture===!0&&ve.getTransfer(A.map.colorSpace)===Ie,decodeVideoTextureEmissive:Me&&A.emissiveMap.isVideoTexture===!0&&ve.getTransfer(A.emissiveMap.colorSpace)===Ie,premultipliedAlpha:A.premultipliedAlpha,doubleSided:A.side===fi,flipSided:A.side===Cn,useDepthPacking:A.depthPacking>=0,depthPacking:A.depthPacking||0,index0AttributeName:A.index0AttributeName,extensionClipCullDistance:jt&&A.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(jt&&A.extensions.multiDraw===!0||Vt)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:A.customProgramCacheKey()};return Ct.vertexUv1s=c.has(1),Ct.vertexUv2s=c.has(2),Ct.vertexUv3s=c.has(3),c.clear(),Ct}function p(A){let b=[];if(A.shaderID?b.push(A.shaderID):(b.push(A.customVertexShaderID),b.push(A.customFragmentShaderID)),A.defines!==void 0)for(let T in A.defines)b.push(T),b.push(A.defines[T]);return A.isRawShaderMaterial===!1&&(E(b,A),S(b,A),b.push(i.outputColorSpace)),b.push(A.customProgramCacheKey),b.join()}function E(A,b){A.push(b.precision),A.push(b.outputColorSpace),A.push(b.envMapMode),A.push(b.envMapCubeUVHeight),A.push(b.mapUv),A.push(b.alphaMapUv),A.push(b.lightMapUv),A.push(b.aoMapUv),A.push(b.bumpMapUv),A.push(b.normalMapUv),A.push(b.displacementMapUv),A.push(b.emissiveMapUv),A.push(b.metalnessMapUv),A.push(b.roughnessMapUv),A.push(b.anisotropyMapUv),A.push(b.clearcoatMapUv),A.push(b.clearcoatNormalMapUv),A.push(b.clearcoatRoughnessMapUv),A.push(b.iridescenceMapUv),A.push(b.iridescenceThicknessMapUv),A.push(b.sheenColorMapUv),A.push(b.sheenRoughnessMapUv),A.push(b.specularMapUv),A.push(b.specularColorMapUv),A.push(b.specularIntensityMapUv),A.push(b.transmissionMapUv),A.push(b.thicknessMapUv),A.push(b.combine),A.push(b.fogExp2),A.push(b.sizeAttenuation),A.push(b.morphTargetsCount),A.push(b.morphAttributeCount),A.push(b.numDirLights),A.push(b.numPointLights),A.push(b.numSpotLights),A.push(b.numSpotLightMaps),A.push(b.numHemiLights),A.push(b.numRectAreaLights),A.push(b.numDirLightShadows),A.push(b.numPointLightShadows),A.push(b.numSpotLightShadows),A.push(b.numSpotLightShadowsWithMaps),A.push(b.numLightProbes),A.push(b.shadowMapType),A.push(b.toneMapping),A.push(b.numClippingPlanes),A.push(b.numClipIntersection),A.push(b.depthPacking)}function S(A,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),A.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reverseDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),A.push(a.mask)}function M(A){let b=g[A.type],T;if(b){let W=Bi[b];T=F_.clone(W.uniforms)}else T=A.uniforms;return T}function D(A,b){let T;for(let W=0,H=h.length;W<H;W++){let q=h[W];if(q.cacheKey===b){T=q,++T.usedTimes;break}}return T===void 0&&(T=new WS(i,b,A,r),h.push(T)),T}function P(A){if(--A.usedTimes===0){let b=h.indexOf(A);h[b]=h[h.length-1],h.pop(),A.destroy()}}function I(A){l.remove(A)}function F(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:M,acquireProgram:D,releaseProgram:P,releaseShaderCache:I,programs:h,dispose:F}}function YS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function $S(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function Jm(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Km(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d,u,f,g,y,m){let p=i[t];return p===void 0?(p={id:d.id,object:d,geometry:u,material:f,groupOrder:g,renderOrder:d.renderOrder,z:y,group:m},i[t]=p):(p.id=d.id,p.object=d,p.geometry=u,p.material=f,p.groupOrder=g,p.renderOrder=d.renderOrder,p.z=y,p.group=m),t++,p}function a(d,u,f,g,y,m){let p=o(d,u,f,g,y,m);f.transmission>0?n.push(p):f.transparent===!0?s.push(p):e.push(p)}function l(d,u,f,g,y,m){let p=o(d,u,f,g,y,m);f.transmission>0?n.unshift(p):f.transparent===!0?s.unshift(p):e.unshift(p)}function c(d,u){e.length>1&&e.sort(d||$S),n.length>1&&n.sort(u||Jm),s.length>1&&s.sort(u||Jm)}function h(){for(let d=t,u=i.length;d<u;d++){let f=i[d];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function ZS(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new Km,i.set(n,[o])):s>=r.length?(o=new Km,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function JS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new N,color:new he};break;case"SpotLight":e={position:new N,direction:new N,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new N,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new N,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new N,halfWidth:new N,halfHeight:new N};break}return i[t.id]=e,e}}}function KS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new At};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new At};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new At,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var jS=0;function QS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function t1(i){let t=new JS,e=KS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new N);let s=new N,r=new Xe,o=new Xe;function a(c){let h=0,d=0,u=0;for(let A=0;A<9;A++)n.probe[A].set(0,0,0);let f=0,g=0,y=0,m=0,p=0,E=0,S=0,M=0,D=0,P=0,I=0;c.sort(QS);for(let A=0,b=c.length;A<b;A++){let T=c[A],W=T.color,H=T.intensity,q=T.distance,J=T.shadow&&T.shadow.map?T.shadow.map.texture:null;if(T.isAmbientLight)h+=W.r*H,d+=W.g*H,u+=W.b*H;else if(T.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(T.sh.coefficients[$],H);I++}else if(T.isDirectionalLight){let $=t.get(T);if($.color.copy(T.color).multiplyScalar(T.intensity),T.castShadow){let nt=T.shadow,Q=e.get(T);Q.shadowIntensity=nt.intensity,Q.shadowBias=nt.bias,Q.shadowNormalBias=nt.normalBias,Q.shadowRadius=nt.radius,Q.shadowMapSize=nt.mapSize,n.directionalShadow[f]=Q,n.directionalShadowMap[f]=J,n.directionalShadowMatrix[f]=T.shadow.matrix,E++}n.directional[f]=$,f++}else if(T.isSpotLight){let $=t.get(T);$.position.setFromMatrixPosition(T.matrixWorld),$.color.copy(W).multiplyScalar(H),$.distance=q,$.coneCos=Math.cos(T.angle),$.penumbraCos=Math.cos(T.angle*(1-T.penumbra)),$.decay=T.decay,n.spot[y]=$;let nt=T.shadow;if(T.map&&(n.spotLightMap[D]=T.map,D++,nt.updateMatrices(T),T.castShadow&&P++),n.spotLightMatrix[y]=nt.matrix,T.castShadow){let Q=e.get(T);Q.shadowIntensity=nt.intensity,Q.shadowBias=nt.bias,Q.shadowNormalBias=nt.normalBias,Q.shadowRadius=nt.radius,Q.shadowMapSize=nt.mapSize,n.spotShadow[y]=Q,n.spotShadowMap[y]=J,M++}y++}else if(T.isRectAreaLight){let $=t.get(T);$.color.copy(W).multiplyScalar(H),$.halfWidth.set(T.width*.5,0,0),$.halfHeight.set(0,T.height*.5,0),n.rectArea[m]=$,m++}else if(T.isPointLight){let $=t.get(T);if($.color.copy(T.color).multiplyScalar(T.intensity),$.distance=T.distance,$.decay=T.decay,T.castShadow){let nt=T.shadow,Q=e.get(T);Q.shadowIntensity=nt.intensity,Q.shadowBias=nt.bias,Q.shadowNormalBias=nt.normalBias,Q.shadowRadius=nt.radius,Q.shadowMapSize=nt.mapSize,Q.shadowCameraNear=nt.camera.near,Q.shadowCameraFar=nt.camera.far,n.pointShadow[g]=Q,n.pointShadowMap[g]=J,n.pointShadowMatrix[g]=T.shadow.matrix,S++}n.point[g]=$,g++}else if(T.isHemisphereLight){let $=t.get(T);$.skyColor.copy(T.color).multiplyScalar(H),$.groundColor.copy(T.groundColor).multiplyScalar(H),n.hemi[p]=$,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=xt.LTC_FLOAT_1,n.rectAreaLTC2=xt.LTC_FLOAT_2):(n.rectAreaLTC1=xt.LTC_HALF_1,n.rectAreaLTC2=xt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let F=n.hash;(F.directionalLength!==f||F.pointLength!==g||F.spotLength!==y||F.rectAreaLength!==m||F.hemiLength!==p||F.numDirectionalShadows!==E||F.numPointShadows!==S||F.numSpotShadows!==M||F.numSpotMaps!==D||F.numLightProbes!==I)&&(n.directional.length=f,n.spot.length=y,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=M,n.spotShadowMap.length=M,n.directionalShadowMatrix.length=E,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=M+D-P,n.spotLightMap.length=D,n.numSpotLightShadowsWithMaps=P,n.numLightProbes=I,F.directionalLength=f,F.pointLength=g,F.spotLength=y,F.rectAreaLength=m,F.hemiLength=p,F.numDirectionalShadows=E,F.numPointShadows=S,F.numSpotShadows=M,F.numSpotMaps=D,F.numLightProbes=I,n.version=jS++)}function l(c,h){let d=0,u=0,f=0,g=0,y=0,m=h.matrixWorldInverse;for(let p=0,E=c.length;p<E;p++){let S=c[p];if(S.isDirectionalLight){let M=n.directional[d];M.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),d++}else if(S.isSpotLight){let M=n.spot[f];M.position.setFromMatrixPosition(S.matrixWorld),M.position.applyMatrix4(m),M.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),f++}else if(S.isRectAreaLight){let M=n.rectArea[g];M.position.setFromMatrixPosition(S.matrixWorld),M.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),M.halfWidth.set(S.width*.5,0,0),M.halfHeight.set(0,S.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),g++}else if(S.isPointLight){let M=n.point[u];M.position.setFromMatrixPosition(S.matrixWorld),M.position.applyMatrix4(m),u++}else if(S.isHemisphereLight){let M=n.hemi[y];M.direction.setFromMatrixPosition(S.matrixWorld),M.direction.transformDirection(m),y++}}}return{setup:a,setupView:l,state:n}}function jm(i){let t=new t1(i),e=[],n=[];function s(h){c.camera=h,e.length=0,n.length=0}function r(h){e.push(h)}function o(h){n.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}let c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function e1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new jm(i),t.set(s,[a])):r>=o.length?(a=new jm(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var sd=class extends Ps{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=qx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},rd=class extends Ps{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}},n1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,i1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function s1(i,t,e){let n=new Vl,s=new At,r=new At,o=new Ye,a=new sd({depthPacking:Yx}),l=new rd,c={},h=e.maxTextureSize,d={[zi]:Cn,[Cn]:zi,[fi]:fi},u=new _n({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new At},radius:{value:4}},vertexShader:n1,fragmentShader:i1}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let g=new $e;g.setAttribute("position",new Ve(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Mn(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=lg;let p=this.type;this.render=function(P,I,F){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||P.length===0)return;let A=i.getRenderTarget(),b=i.getActiveCubeFace(),T=i.getActiveMipmapLevel(),W=i.state;W.setBlending(Cs),W.buffers.color.setClear(1,1,1,1),W.buffers.depth.setTest(!0),W.setScissorTest(!1);let H=p!==ns&&this.type===ns,q=p===ns&&this.type!==ns;for(let J=0,$=P.length;J<$;J++){let nt=P[J],Q=nt.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",nt,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);let ht=Q.getFrameExtents();if(s.multiply(ht),r.copy(Q.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ht.x),s.x=r.x*ht.x,Q.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ht.y),s.y=r.y*ht.y,Q.mapSize.y=r.y)),Q.map===null||H===!0||q===!0){let mt=this.type!==ns?{minFilter:ti,magFilter:ti}:{};Q.map!==null&&Q.map.dispose(),Q.map=new ei(s.x,s.y,mt),Q.map.texture.name=nt.name+".shadowMap",Q.camera.updateProjectionMatrix()}i.setRenderTarget(Q.map),i.clear();let ot=Q.getViewportCount();for(let mt=0;mt<ot;mt++){let ft=Q.getViewport(mt);o.set(r.x*ft.x,r.y*ft.y,r.x*ft.z,r.y*ft.w),W.viewport(o),Q.updateMatrices(nt,mt),n=Q.getFrustum(),M(I,F,Q.camera,nt,this.type)}Q.isPointLightShadow!==!0&&this.type===ns&&E(Q,F),Q.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(A,b,T)};function E(P,I){let F=t.update(y);u.defines.VSM_SAMPLES!==P.blurSamples&&(u.defines.VSM_SAMPLES=P.blurSamples,f.defines.VSM_SAMPLES=P.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),P.mapPass===null&&(P.mapPass=new ei(s.x,s.y)),u.uniforms.shadow_pass.value=P.map.texture,u.uniforms.resolution.value=P.mapSize,u.uniforms.radius.value=P.radius,i.setRenderTarget(P.mapPass),i.clear(),i.renderBufferDirect(I,null,F,u,y,null),f.uniforms.shadow_pass.value=P.mapPass.texture,f.uniforms.resolution.value=P.mapSize,f.uniforms.radius.value=P.radius,i.setRenderTarget(P.map),i.clear(),i.renderBufferDirect(I,null,F,f,y,null)}function S(P,I,F,A){let b=null,T=F.isPointLight===!0?P.customDistanceMaterial:P.customDepthMaterial;if(T!==void 0)b=T;else if(b=F.isPointLight===!0?l:a,i.localClippingEnabled&&I.clipShadows===!0&&Array.isArray(I.clippingPlanes)&&I.clippingPlanes.length!==0||I.displacementMap&&I.displacementScale!==0||I.alphaMap&&I.alphaTest>0||I.map&&I.alphaTest>0){let W=b.uuid,H=I.uuid,q=c[W];q===void 0&&(q={},c[W]=q);let J=q[H];J===void 0&&(J=b.clone(),q[H]=J,I.addEventListener("dispose",D)),b=J}if(b.visible=I.visible,b.wireframe=I.wireframe,A===ns?b.side=I.shadowSide!==null?I.shadowSide:I.side:b.side=I.shadowSide!==null?I.shadowSide:d[I.side],b.alphaMap=I.alphaMap,b.alphaTest=I.alphaTest,b.map=I.map,b.clipShadows=I.clipShadows,b.clippingPlanes=I.clippingPlanes,b.clipIntersection=I.clipIntersection,b.displacementMap=I.displacementMap,b.displacementScale=I.displacementScale,b.displacementBias=I.displacementBias,b.wireframeLinewidth=I.wireframeLinewidth,b.linewidth=I.linewidth,F.isPointLight===!0&&b.isMeshDistanceMaterial===!0){let W=i.properties.get(b);W.light=F}return b}function M(P,I,F,A,b){if(P.visible===!1)return;if(P.layers.test(I.layers)&&(P.isMesh||P.isLine||P.isPoints)&&(P.castShadow||P.receiveShadow&&b===ns)&&(!P.frustumCulled||n.intersectsObject(P))){P.modelViewMatrix.multiplyMatrices(F.matrixWorldInverse,P.matrixWorld);let H=t.update(P),q=P.material;if(Array.isArray(q)){let J=H.groups;for(let $=0,nt=J.length;$<nt;$++){let Q=J[$],ht=q[Q.materialIndex];if(ht&&ht.visible){let ot=S(P,ht,A,b);P.onBeforeShadow(i,P,I,F,H,ot,Q),i.renderBufferDirect(F,null,H,ot,P,Q),P.onAfterShadow(i,P,I,F,H,ot,Q)}}}else if(q.visible){let J=S(P,q,A,b);P.onBeforeShadow(i,P,I,F,H,J,null),i.renderBufferDirect(F,null,H,J,P,null),P.onAfterShadow(i,P,I,F,H,J,null)}}let W=P.children;for(let H=0,q=W.length;H<q;H++)M(W[H],I,F,A,b)}function D(P){P.target.removeEventListener("dispose",D);for(let F in c){let A=c[F],b=P.target.uuid;b in A&&(A[b].dispose(),delete A[b])}}}var r1={[cu]:hu,[uu]:pu,[du]:mu,[uo]:fu,[hu]:cu,[pu]:uu,[mu]:du,[fu]:uo};function o1(i,t){function e(){let O=!1,yt=new Ye,tt=null,rt=new Ye(0,0,0,0);return{setMask:function(St){tt!==St&&!O&&(i.colorMask(St,St,St,St),tt=St)},setLocked:function(St){O=St},setClear:function(St,wt,jt,He,Ct){Ct===!0&&(St*=He,wt*=He,jt*=He),yt.set(St,wt,jt,He),rt.equals(yt)===!1&&(i.clearColor(St,wt,jt,He),rt.copy(yt))},reset:function(){O=!1,tt=null,rt.set(-1,0,0,0)}}}function n(){let O=!1,yt=!1,tt=null,rt=null,St=null;return{setReversed:function(wt){if(yt!==wt){let jt=t.get("EXT_clip_control");yt?jt.clipControlEXT(jt.LOWER_LEFT_EXT,jt.ZERO_TO_ONE_EXT):jt.clipControlEXT(jt.LOWER_LEFT_EXT,jt.NEGATIVE_ONE_TO_ONE_EXT);let He=St;St=null,this.setClear(He)}yt=wt},getReversed:function(){return yt},setTest:function(wt){wt?ut(i.DEPTH_TEST):Ut(i.DEPTH_TEST)},setMask:function(wt){tt!==wt&&!O&&(i.depthMask(wt),tt=wt)},setFunc:function(wt){if(yt&&(wt=r1[wt]),rt!==wt){switch(wt){case cu:i.depthFunc(i.NEVER);break;case hu:i.depthFunc(i.ALWAYS);break;case uu:i.depthFunc(i.LESS);break;case uo:i.depthFunc(i.LEQUAL);break;case du:i.depthFunc(i.EQUAL);break;case fu:i.depthFunc(i.GEQUAL);break;case pu:i.depthFunc(i.GREATER);break;case mu:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}rt=wt}},setLocked:function(wt){O=wt},setClear:function(wt){St!==wt&&(yt&&(wt=1-wt),i.clearDepth(wt),St=wt)},reset:function(){O=!1,tt=null,rt=null,St=null,yt=!1}}}function s(){let O=!1,yt=null,tt=null,rt=null,St=null,wt=null,jt=null,He=null,Ct=null;return{setTest:function(le){O||(le?ut(i.STENCIL_TEST):Ut(i.STENCIL_TEST))},setMask:function(le){yt!==le&&!O&&(i.stencilMask(le),yt=le)},setFunc:function(le,Ce,pn){(tt!==le||rt!==Ce||St!==pn)&&(i.stencilFunc(le,Ce,pn),tt=le,rt=Ce,St=pn)},setOp:function(le,Ce,pn){(wt!==le||jt!==Ce||He!==pn)&&(i.stencilOp(le,Ce,pn),wt=le,jt=Ce,He=pn)},setLocked:function(le){O=le},setClear:function(le){Ct!==le&&(i.clearStencil(le),Ct=le)},reset:function(){O=!1,yt=null,tt=null,rt=null,St=null,wt=null,jt=null,He=null,Ct=null}}}let r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap,h={},d={},u=new WeakMap,f=[],g=null,y=!1,m=null,p=null,E=null,S=null,M=null,D=null,P=null,I=new he(0,0,0),F=0,A=!1,b=null,T=null,W=null,H=null,q=null,J=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),$=!1,nt=0,Q=i.getParameter(i.VERSION);Q.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec(Q)[1]),$=nt>=1):Q.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),$=nt>=2);let ht=null,ot={},mt=i.getParameter(i.SCISSOR_BOX),ft=i.getParameter(i.VIEWPORT),Wt=new Ye().fromArray(mt),K=new Ye().fromArray(ft);function ct(O,yt,tt,rt){let St=new Uint8Array(4),wt=i.createTexture();i.bindTexture(O,wt),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let jt=0;jt<tt;jt++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(yt,0,i.RGBA,1,1,rt,0,i.RGBA,i.UNSIGNED_BYTE,St):i.texImage2D(yt+jt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,St);return wt}let Lt={};Lt[i.TEXTURE_2D]=ct(i.TEXTURE_2D,i.TEXTURE_2D,1),Lt[i.TEXTURE_CUBE_MAP]=ct(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[i.TEXTURE_2D_ARRAY]=ct(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Lt[i.TEXTURE_3D]=ct(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ut(i.DEPTH_TEST),o.setFunc(uo),se(!1),Jt(tm),ut(i.CULL_FACE),G(Cs);function ut(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function Ut(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function Gt(O,yt){return d[O]!==yt?(i.bindFramebuffer(O,yt),d[O]=yt,O===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=yt),O===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=yt),!0):!1}function Vt(O,yt){let tt=f,rt=!1;if(O){tt=u.get(yt),tt===void 0&&(tt=[],u.set(yt,tt));let St=O.textures;if(tt.length!==St.length||tt[0]!==i.COLOR_ATTACHMENT0){for(let wt=0,jt=St.length;wt<jt;wt++)tt[wt]=i.COLOR_ATTACHMENT0+wt;tt.length=St.length,rt=!0}}else tt[0]!==i.BACK&&(tt[0]=i.BACK,rt=!0);rt&&i.drawBuffers(tt)}function oe(O){return g!==O?(i.useProgram(O),g=O,!0):!1}let ee={[Qs]:i.FUNC_ADD,[bx]:i.FUNC_SUBTRACT,[Mx]:i.FUNC_REVERSE_SUBTRACT};ee[wx]=i.MIN,ee[Sx]=i.MAX;let Te={[ic]:i.ZERO,[sc]:i.ONE,[Ex]:i.SRC_COLOR,[au]:i.SRC_ALPHA,[Ix]:i.SRC_ALPHA_SATURATE,[Rx]:i.DST_COLOR,[Tx]:i.DST_ALPHA,[Ax]:i.ONE_MINUS_SRC_COLOR,[lu]:i.ONE_MINUS_SRC_ALPHA,[Px]:i.ONE_MINUS_DST_COLOR,[Cx]:i.ONE_MINUS_DST_ALPHA,[Lx]:i.CONSTANT_COLOR,[Dx]:i.ONE_MINUS_CONSTANT_COLOR,[Ux]:i.CONSTANT_ALPHA,[Nx]:i.ONE_MINUS_CONSTANT_ALPHA};function G(O,yt,tt,rt,St,wt,jt,He,Ct,le){if(O===Cs){y===!0&&(Ut(i.BLEND),y=!1);return}if(y===!1&&(ut(i.BLEND),y=!0),O!==Id){if(O!==m||le!==A){if((p!==Qs||M!==Qs)&&(i.blendEquation(i.FUNC_ADD),p=Qs,M=Qs),le)switch(O){case ao:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case em:i.blendFunc(i.ONE,i.ONE);break;case nm:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case im:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}else switch(O){case ao:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case em:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case nm:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case im:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}E=null,S=null,D=null,P=null,I.set(0,0,0),F=0,m=O,A=le}return}St=St||yt,wt=wt||tt,jt=jt||rt,(yt!==p||St!==M)&&(i.blendEquationSeparate(ee[yt],ee[St]),p=yt,M=St),(tt!==E||rt!==S||wt!==D||jt!==P)&&(i.blendFuncSeparate(Te[tt],Te[rt],Te[wt],Te[jt]),E=tt,S=rt,D=wt,P=jt),(He.equals(I)===!1||Ct!==F)&&(i.blendColor(He.r,He.g,He.b,Ct),I.copy(He),F=Ct),m=O,A=!1}function rn(O,yt){O.side===fi?Ut(i.CULL_FACE):ut(i.CULL_FACE);let tt=O.side===Cn;yt&&(tt=!tt),se(tt),O.blending===ao&&O.transparent===!1?G(Cs):G(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let rt=O.stencilWrite;a.setTest(rt),rt&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),Me(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?ut(i.SAMPLE_ALPHA_TO_COVERAGE):Ut(i.SAMPLE_ALPHA_TO_COVERAGE)}function se(O){b!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),b=O)}function Jt(O){O!==yx?(ut(i.CULL_FACE),O!==T&&(O===tm?i.cullFace(i.BACK):O===xx?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ut(i.CULL_FACE),T=O}function Nt(O){O!==W&&($&&i.lineWidth(O),W=O)}function Me(O,yt,tt){O?(ut(i.POLYGON_OFFSET_FILL),(H!==yt||q!==tt)&&(i.polygonOffset(yt,tt),H=yt,q=tt)):Ut(i.POLYGON_OFFSET_FILL)}function kt(O){O?ut(i.SCISSOR_TEST):Ut(i.SCISSOR_TEST)}function C(O){O===void 0&&(O=i.TEXTURE0+J-1),ht!==O&&(i.activeTexture(O),ht=O)}function x(O,yt,tt){tt===void 0&&(ht===null?tt=i.TEXTURE0+J-1:tt=ht);let rt=ot[tt];rt===void 0&&(rt={type:void 0,texture:void 0},ot[tt]=rt),(rt.type!==O||rt.texture!==yt)&&(ht!==tt&&(i.activeTexture(tt),ht=tt),i.bindTexture(O,yt||Lt[O]),rt.type=O,rt.texture=yt)}function z(){let O=ot[ht];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function it(){try{i.compressedTexImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function j(){try{i.compressedTexImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function et(){try{i.texSubImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function It(){try{i.texSubImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function gt(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function _t(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function qt(){try{i.texStorage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function at(){try{i.texStorage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function vt(){try{i.texImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Bt(){try{i.texImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Ht(O){Wt.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),Wt.copy(O))}function Mt(O){K.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),K.copy(O))}function ne(O,yt){let tt=c.get(yt);tt===void 0&&(tt=new WeakMap,c.set(yt,tt));let rt=tt.get(O);rt===void 0&&(rt=i.getUniformBlockIndex(yt,O.name),tt.set(O,rt))}function Yt(O,yt){let rt=c.get(yt).get(O);l.get(yt)!==rt&&(i.uniformBlockBinding(yt,rt,O.__bindingPointIndex),l.set(yt,rt))}function _e(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ht=null,ot={},d={},u=new WeakMap,f=[],g=null,y=!1,m=null,p=null,E=null,S=null,M=null,D=null,P=null,I=new he(0,0,0),F=0,A=!1,b=null,T=null,W=null,H=null,q=null,Wt.set(0,0,i.canvas.width,i.canvas.height),K.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ut,disable:Ut,bindFramebuffer:Gt,drawBuffers:Vt,useProgram:oe,setBlending:G,setMaterial:rn,setFlipSided:se,setCullFace:Jt,setLineWidth:Nt,setPolygonOffset:Me,setScissorTest:kt,activeTexture:C,bindTexture:x,unbindTexture:z,compressedTexImage2D:it,compressedTexImage3D:j,texImage2D:vt,texImage3D:Bt,updateUBOMapping:ne,uniformBlockBinding:Yt,texStorage2D:qt,texStorage3D:at,texSubImage2D:et,texSubImage3D:It,compressedTexSubImage2D:gt,compressedTexSubImage3D:_t,scissor:Ht,viewport:Mt,reset:_e}}function Qm(i,t,e,n){let s=a1(n);switch(e){case pg:return i*t;case gg:return i*t;case vg:return i*t*2;case yg:return i*t/s.components*s.byteLength;case Nd:return i*t/s.components*s.byteLength;case xg:return i*t*2/s.components*s.byteLength;case Fd:return i*t*2/s.components*s.byteLength;case mg:return i*t*3/s.components*s.byteLength;case Qn:return i*t*4/s.components*s.byteLength;case Od:return i*t*4/s.components*s.byteLength;case El:case Al:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Tl:case Cl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case bu:case wu:return Math.max(i,16)*Math.max(t,8)/4;case _u:case Mu:return Math.max(i,8)*Math.max(t,8)/2;case Su:case Eu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Au:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Tu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Cu:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Ru:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Pu:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Iu:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Lu:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Du:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Uu:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Nu:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Fu:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ou:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case ku:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Bu:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case zu:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Rl:case Vu:case Hu:return Math.ceil(i/4)*Math.ceil(t/4)*16;case _g:case Gu:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Wu:case Xu:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function a1(i){switch(i){case rs:case ug:return{byteLength:1,components:1};case aa:case dg:case pa:return{byteLength:2,components:1};case Dd:case Ud:return{byteLength:2,components:4};case os:case Ld:case Ti:return{byteLength:4,components:1};case fg:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function l1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new At,h=new WeakMap,d,u=new WeakMap,f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(C,x){return f?new OffscreenCanvas(C,x):Ll("canvas")}function y(C,x,z){let it=1,j=kt(C);if((j.width>z||j.height>z)&&(it=z/Math.max(j.width,j.height)),it<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let et=Math.floor(it*j.width),It=Math.floor(it*j.height);d===void 0&&(d=g(et,It));let gt=x?g(et,It):d;return gt.width=et,gt.height=It,gt.getContext("2d").drawImage(C,0,0,et,It),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+et+"x"+It+")."),gt}else return"data"in C&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),C;return C}function m(C){return C.generateMipmaps}function p(C){i.generateMipmap(C)}function E(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(C,x,z,it,j=!1){if(C!==null){if(i[C]!==void 0)return i[C];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let et=x;if(x===i.RED&&(z===i.FLOAT&&(et=i.R32F),z===i.HALF_FLOAT&&(et=i.R16F),z===i.UNSIGNED_BYTE&&(et=i.R8)),x===i.RED_INTEGER&&(z===i.UNSIGNED_BYTE&&(et=i.R8UI),z===i.UNSIGNED_SHORT&&(et=i.R16UI),z===i.UNSIGNED_INT&&(et=i.R32UI),z===i.BYTE&&(et=i.R8I),z===i.SHORT&&(et=i.R16I),z===i.INT&&(et=i.R32I)),x===i.RG&&(z===i.FLOAT&&(et=i.RG32F),z===i.HALF_FLOAT&&(et=i.RG16F),z===i.UNSIGNED_BYTE&&(et=i.RG8)),x===i.RG_INTEGER&&(z===i.UNSIGNED_BYTE&&(et=i.RG8UI),z===i.UNSIGNED_SHORT&&(et=i.RG16UI),z===i.UNSIGNED_INT&&(et=i.RG32UI),z===i.BYTE&&(et=i.RG8I),z===i.SHORT&&(et=i.RG16I),z===i.INT&&(et=i.RG32I)),x===i.RGB_INTEGER&&(z===i.UNSIGNED_BYTE&&(et=i.RGB8UI),z===i.UNSIGNED_SHORT&&(et=i.RGB16UI),z===i.UNSIGNED_INT&&(et=i.RGB32UI),z===i.BYTE&&(et=i.RGB8I),z===i.SHORT&&(et=i.RGB16I),z===i.INT&&(et=i.RGB32I)),x===i.RGBA_INTEGER&&(z===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),z===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),z===i.UNSIGNED_INT&&(et=i.RGBA32UI),z===i.BYTE&&(et=i.RGBA8I),z===i.SHORT&&(et=i.RGBA16I),z===i.INT&&(et=i.RGBA32I)),x===i.RGB&&z===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),x===i.RGBA){let It=j?oc:ve.getTransfer(it);z===i.FLOAT&&(et=i.RGBA32F),z===i.HALF_FLOAT&&(et=i.RGBA16F),z===i.UNSIGNED_BYTE&&(et=It===Ie?i.SRGB8_ALPHA8:i.RGBA8),z===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),z===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function M(C,x){let z;return C?x===null||x===os||x===mo?z=i.DEPTH24_STENCIL8:x===Ti?z=i.DEPTH32F_STENCIL8:x===aa&&(z=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===os||x===mo?z=i.DEPTH_COMPONENT24:x===Ti?z=i.DEPTH_COMPONENT32F:x===aa&&(z=i.DEPTH_COMPONENT16),z}function D(C,x){return m(C)===!0||C.isFramebufferTexture&&C.minFilter!==ti&&C.minFilter!==pi?Math.log2(Math.max(x.width,x.height))+1:C.mipmaps!==void 0&&C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?x.mipmaps.length:1}function P(C){let x=C.target;x.removeEventListener("dispose",P),F(x),x.isVideoTexture&&h.delete(x)}function I(C){let x=C.target;x.removeEventListener("dispose",I),b(x)}function F(C){let x=n.get(C);if(x.__webglInit===void 0)return;let z=C.source,it=u.get(z);if(it){let j=it[x.__cacheKey];j.usedTimes--,j.usedTimes===0&&A(C),Object.keys(it).length===0&&u.delete(z)}n.remove(C)}function A(C){let x=n.get(C);i.deleteTexture(x.__webglTexture);let z=C.source,it=u.get(z);delete it[x.__cacheKey],o.memory.textures--}function b(C){let x=n.get(C);if(C.depthTexture&&(C.depthTexture.dispose(),n.remove(C.depthTexture)),C.isWebGLCubeRenderTarget)for(let it=0;it<6;it++){if(Array.isArray(x.__webglFramebuffer[it]))for(let j=0;j<x.__webglFramebuffer[it].length;j++)i.deleteFramebuffer(x.__webglFramebuffer[it][j]);else i.deleteFramebuffer(x.__webglFramebuffer[it]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[it])}else{if(Array.isArray(x.__webglFramebuffer))for(let it=0;it<x.__webglFramebuffer.length;it++)i.deleteFramebuffer(x.__webglFramebuffer[it]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let it=0;it<x.__webglColorRenderbuffer.length;it++)x.__webglColorRenderbuffer[it]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[it]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let z=C.textures;for(let it=0,j=z.length;it<j;it++){let et=n.get(z[it]);et.__webglTexture&&(i.deleteTexture(et.__webglTexture),o.memory.textures--),n.remove(z[it])}n.remove(C)}let T=0;function W(){T=0}function H(){let C=T;return C>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+C+" texture units while this GPU supports only "+s.maxTextures),T+=1,C}function q(C){let x=[];return x.push(C.wrapS),x.push(C.wrapT),x.push(C.wrapR||0),x.push(C.magFilter),x.push(C.minFilter),x.push(C.anisotropy),x.push(C.internalFormat),x.push(C.format),x.push(C.type),x.push(C.generateMipmaps),x.push(C.premultiplyAlpha),x.push(C.flipY),x.push(C.unpackAlignment),x.push(C.colorSpace),x.join()}function J(C,x){let z=n.get(C);if(C.isVideoTexture&&Nt(C),C.isRenderTargetTexture===!1&&C.version>0&&z.__version!==C.version){let it=C.image;if(it===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(it.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{K(z,C,x);return}}e.bindTexture(i.TEXTURE_2D,z.__webglTexture,i.TEXTURE0+x)}function $(C,x){let z=n.get(C);if(C.version>0&&z.__version!==C.version){K(z,C,x);return}e.bindTexture(i.TEXTURE_2D_ARRAY,z.__webglTexture,i.TEXTURE0+x)}function nt(C,x){let z=n.get(C);if(C.version>0&&z.__version!==C.version){K(z,C,x);return}e.bindTexture(i.TEXTURE_3D,z.__webglTexture,i.TEXTURE0+x)}function Q(C,x){let z=n.get(C);if(C.version>0&&z.__version!==C.version){ct(z,C,x);return}e.bindTexture(i.TEXTURE_CUBE_MAP,z.__webglTexture,i.TEXTURE0+x)}let ht={[yu]:i.REPEAT,[nr]:i.CLAMP_TO_EDGE,[xu]:i.MIRRORED_REPEAT},ot={[ti]:i.NEAREST,[Xx]:i.NEAREST_MIPMAP_NEAREST,[ja]:i.NEAREST_MIPMAP_LINEAR,[pi]:i.LINEAR,[Rh]:i.LINEAR_MIPMAP_NEAREST,[ir]:i.LINEAR_MIPMAP_LINEAR},mt={[Jx]:i.NEVER,[n_]:i.ALWAYS,[Kx]:i.LESS,[ac]:i.LEQUAL,[jx]:i.EQUAL,[e_]:i.GEQUAL,[Qx]:i.GREATER,[t_]:i.NOTEQUAL};function ft(C,x){if(x.type===Ti&&t.has("OES_texture_float_linear")===!1&&(x.magFilter===pi||x.magFilter===Rh||x.magFilter===ja||x.magFilter===ir||x.minFilter===pi||x.minFilter===Rh||x.minFilter===ja||x.minFilter===ir)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,ht[x.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,ht[x.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,ht[x.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,ot[x.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,ot[x.minFilter]),x.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,mt[x.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===ti||x.minFilter!==ja&&x.minFilter!==ir||x.type===Ti&&t.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let z=t.get("EXT_texture_filter_anisotropic");i.texParameterf(C,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function Wt(C,x){let z=!1;C.__webglInit===void 0&&(C.__webglInit=!0,x.addEventListener("dispose",P));let it=x.source,j=u.get(it);j===void 0&&(j={},u.set(it,j));let et=q(x);if(et!==C.__cacheKey){j[et]===void 0&&(j[et]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,z=!0),j[et].usedTimes++;let It=j[C.__cacheKey];It!==void 0&&(j[C.__cacheKey].usedTimes--,It.usedTimes===0&&A(x)),C.__cacheKey=et,C.__webglTexture=j[et].texture}return z}function K(C,x,z){let it=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(it=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(it=i.TEXTURE_3D);let j=Wt(C,x),et=x.source;e.bindTexture(it,C.__webglTexture,i.TEXTURE0+z);let It=n.get(et);if(et.version!==It.__version||j===!0){e.activeTexture(i.TEXTURE0+z);let gt=ve.getPrimaries(ve.workingColorSpace),_t=x.colorSpace===Ts?null:ve.getPrimaries(x.colorSpace),qt=x.colorSpace===Ts||gt===_t?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,qt);let at=y(x.image,!1,s.maxTextureSize);at=Me(x,at);let vt=r.convert(x.format,x.colorSpace),Bt=r.convert(x.type),Ht=S(x.internalFormat,vt,Bt,x.colorSpace,x.isVideoTexture);ft(it,x);let Mt,ne=x.mipmaps,Yt=x.isVideoTexture!==!0,_e=It.__version===void 0||j===!0,O=et.dataReady,yt=D(x,at);if(x.isDepthTexture)Ht=M(x.format===go,x.type),_e&&(Yt?e.texStorage2D(i.TEXTURE_2D,1,Ht,at.width,at.height):e.texImage2D(i.TEXTURE_2D,0,Ht,at.width,at.height,0,vt,Bt,null));else if(x.isDataTexture)if(ne.length>0){Yt&&_e&&e.texStorage2D(i.TEXTURE_2D,yt,Ht,ne[0].width,ne[0].height);for(let tt=0,rt=ne.length;tt<rt;tt++)Mt=ne[tt],Yt?O&&e.texSubImage2D(i.TEXTURE_2D,tt,0,0,Mt.width,Mt.height,vt,Bt,Mt.data):e.texImage2D(i.TEXTURE_2D,tt,Ht,Mt.width,Mt.height,0,vt,Bt,Mt.data);x.generateMipmaps=!1}else Yt?(_e&&e.texStorage2D(i.TEXTURE_2D,yt,Ht,at.width,at.height),O&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at.width,at.height,vt,Bt,at.data)):e.texImage2D(i.TEXTURE_2D,0,Ht,at.width,at.height,0,vt,Bt,at.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){Yt&&_e&&e.texStorage3D(i.TEXTURE_2D_ARRAY,yt,Ht,ne[0].width,ne[0].height,at.depth);for(let tt=0,rt=ne.length;tt<rt;tt++)if(Mt=ne[tt],x.format!==Qn)if(vt!==null)if(Yt){if(O)if(x.layerUpdates.size>0){let St=Qm(Mt.width,Mt.height,x.format,x.type);for(let wt of x.layerUpdates){let jt=Mt.data.subarray(wt*St/Mt.data.BYTES_PER_ELEMENT,(wt+1)*St/Mt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,tt,0,0,wt,Mt.width,Mt.height,1,vt,jt)}x.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,tt,0,0,0,Mt.width,Mt.height,at.depth,vt,Mt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,tt,Ht,Mt.width,Mt.height,at.depth,0,Mt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?O&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,tt,0,0,0,Mt.width,Mt.height,at.depth,vt,Bt,Mt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,tt,Ht,Mt.width,Mt.height,at.depth,0,vt,Bt,Mt.data)}else{Yt&&_e&&e.texStorage2D(i.TEXTURE_2D,yt,Ht,ne[0].width,ne[0].height);for(let tt=0,rt=ne.length;tt<rt;tt++)Mt=ne[tt],x.format!==Qn?vt!==null?Yt?O&&e.compressedTexSubImage2D(i.TEXTURE_2D,tt,0,0,Mt.width,Mt.height,vt,Mt.data):e.compressedTexImage2D(i.TEXTURE_2D,tt,Ht,Mt.width,Mt.height,0,Mt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?O&&e.texSubImage2D(i.TEXTURE_2D,tt,0,0,Mt.width,Mt.height,vt,Bt,Mt.data):e.texImage2D(i.TEXTURE_2D,tt,Ht,Mt.width,Mt.height,0,vt,Bt,Mt.data)}else if(x.isDataArrayTexture)if(Yt){if(_e&&e.texStorage3D(i.TEXTURE_2D_ARRAY,yt,Ht,at.width,at.height,at.depth),O)if(x.layerUpdates.size>0){let tt=Qm(at.width,at.height,x.format,x.type);for(let rt of x.layerUpdates){let St=at.data.subarray(rt*tt/at.data.BYTES_PER_ELEMENT,(rt+1)*tt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,rt,at.width,at.height,1,vt,Bt,St)}x.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,Bt,at.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ht,at.width,at.height,at.depth,0,vt,Bt,at.data);else if(x.isData3DTexture)Yt?(_e&&e.texStorage3D(i.TEXTURE_3D,yt,Ht,at.width,at.height,at.depth),O&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,Bt,at.data)):e.texImage3D(i.TEXTURE_3D,0,Ht,at.width,at.height,at.depth,0,vt,Bt,at.data);else if(x.isFramebufferTexture){if(_e)if(Yt)e.texStorage2D(i.TEXTURE_2D,yt,Ht,at.width,at.height);else{let tt=at.width,rt=at.height;for(let St=0;St<yt;St++)e.texImage2D(i.TEXTURE_2D,St,Ht,tt,rt,0,vt,Bt,null),tt>>=1,rt>>=1}}else if(ne.length>0){if(Yt&&_e){let tt=kt(ne[0]);e.texStorage2D(i.TEXTURE_2D,yt,Ht,tt.width,tt.height)}for(let tt=0,rt=ne.length;tt<rt;tt++)Mt=ne[tt],Yt?O&&e.texSubImage2D(i.TEXTURE_2D,tt,0,0,vt,Bt,Mt):e.texImage2D(i.TEXTURE_2D,tt,Ht,vt,Bt,Mt);x.generateMipmaps=!1}else if(Yt){if(_e){let tt=kt(at);e.texStorage2D(i.TEXTURE_2D,yt,Ht,tt.width,tt.height)}O&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,vt,Bt,at)}else e.texImage2D(i.TEXTURE_2D,0,Ht,vt,Bt,at);m(x)&&p(it),It.__version=et.version,x.onUpdate&&x.onUpdate(x)}C.__version=x.version}function ct(C,x,z){if(x.image.length!==6)return;let it=Wt(C,x),j=x.source;e.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+z);let et=n.get(j);if(j.version!==et.__version||it===!0){e.activeTexture(i.TEXTURE0+z);let It=ve.getPrimaries(ve.workingColorSpace),gt=x.colorSpace===Ts?null:ve.getPrimaries(x.colorSpace),_t=x.colorSpace===Ts||It===gt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,_t);let qt=x.isCompressedTexture||x.image[0].isCompressedTexture,at=x.image[0]&&x.image[0].isDataTexture,vt=[];for(let rt=0;rt<6;rt++)!qt&&!at?vt[rt]=y(x.image[rt],!0,s.maxCubemapSize):vt[rt]=at?x.image[rt].image:x.image[rt],vt[rt]=Me(x,vt[rt]);let Bt=vt[0],Ht=r.convert(x.format,x.colorSpace),Mt=r.convert(x.type),ne=S(x.internalFormat,Ht,Mt,x.colorSpace),Yt=x.isVideoTexture!==!0,_e=et.__version===void 0||it===!0,O=j.dataReady,yt=D(x,Bt);ft(i.TEXTURE_CUBE_MAP,x);let tt;if(qt){Yt&&_e&&e.texStorage2D(i.TEXTURE_CUBE_MAP,yt,ne,Bt.width,Bt.height);for(let rt=0;rt<6;rt++){tt=vt[rt].mipmaps;for(let St=0;St<tt.length;St++){let wt=tt[St];x.format!==Qn?Ht!==null?Yt?O&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,St,0,0,wt.width,wt.height,Ht,wt.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,St,ne,wt.width,wt.height,0,wt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,St,0,0,wt.width,wt.height,Ht,Mt,wt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,St,ne,wt.width,wt.height,0,Ht,Mt,wt.data)}}}else{if(tt=x.mipmaps,Yt&&_e){tt.length>0&&yt++;let rt=kt(vt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,yt,ne,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(at){Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,vt[rt].width,vt[rt].height,Ht,Mt,vt[rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ne,vt[rt].width,vt[rt].height,0,Ht,Mt,vt[rt].data);for(let St=0;St<tt.length;St++){let jt=tt[St].image[rt].image;Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,St+1,0,0,jt.width,jt.height,Ht,Mt,jt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,St+1,ne,jt.width,jt.height,0,Ht,Mt,jt.data)}}else{Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ht,Mt,vt[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ne,Ht,Mt,vt[rt]);for(let St=0;St<tt.length;St++){let wt=tt[St];Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,St+1,0,0,Ht,Mt,wt.image[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,St+1,ne,Ht,Mt,wt.image[rt])}}}m(x)&&p(i.TEXTURE_CUBE_MAP),et.__version=j.version,x.onUpdate&&x.onUpdate(x)}C.__version=x.version}function Lt(C,x,z,it,j,et){let It=r.convert(z.format,z.colorSpace),gt=r.convert(z.type),_t=S(z.internalFormat,It,gt,z.colorSpace),qt=n.get(x),at=n.get(z);if(at.__renderTarget=x,!qt.__hasExternalTextures){let vt=Math.max(1,x.width>>et),Bt=Math.max(1,x.height>>et);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?e.texImage3D(j,et,_t,vt,Bt,x.depth,0,It,gt,null):e.texImage2D(j,et,_t,vt,Bt,0,It,gt,null)}e.bindFramebuffer(i.FRAMEBUFFER,C),Jt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,it,j,at.__webglTexture,0,se(x)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,it,j,at.__webglTexture,et),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ut(C,x,z){if(i.bindRenderbuffer(i.RENDERBUFFER,C),x.depthBuffer){let it=x.depthTexture,j=it&&it.isDepthTexture?it.type:null,et=M(x.stencilBuffer,j),It=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,gt=se(x);Jt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,gt,et,x.width,x.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,gt,et,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,et,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,It,i.RENDERBUFFER,C)}else{let it=x.textures;for(let j=0;j<it.length;j++){let et=it[j],It=r.convert(et.format,et.colorSpace),gt=r.convert(et.type),_t=S(et.internalFormat,It,gt,et.colorSpace),qt=se(x);z&&Jt(x)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,qt,_t,x.width,x.height):Jt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,qt,_t,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,_t,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ut(C,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,C),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let it=n.get(x.depthTexture);it.__renderTarget=x,(!it.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),J(x.depthTexture,0);let j=it.__webglTexture,et=se(x);if(x.depthTexture.format===lo)Jt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0);else if(x.depthTexture.format===go)Jt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0);else throw new Error("Unknown depthTexture format")}function Gt(C){let x=n.get(C),z=C.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==C.depthTexture){let it=C.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),it){let j=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,it.removeEventListener("dispose",j)};it.addEventListener("dispose",j),x.__depthDisposeCallback=j}x.__boundDepthTexture=it}if(C.depthTexture&&!x.__autoAllocateDepthBuffer){if(z)throw new Error("target.depthTexture not supported in Cube render targets");Ut(x.__webglFramebuffer,C)}else if(z){x.__webglDepthbuffer=[];for(let it=0;it<6;it++)if(e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[it]),x.__webglDepthbuffer[it]===void 0)x.__webglDepthbuffer[it]=i.createRenderbuffer(),ut(x.__webglDepthbuffer[it],C,!1);else{let j=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,et=x.__webglDepthbuffer[it];i.bindRenderbuffer(i.RENDERBUFFER,et),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,et)}}else if(e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),ut(x.__webglDepthbuffer,C,!1);else{let it=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,j=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,j),i.framebufferRenderbuffer(i.FRAMEBUFFER,it,i.RENDERBUFFER,j)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Vt(C,x,z){let it=n.get(C);x!==void 0&&Lt(it.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),z!==void 0&&Gt(C)}function oe(C){let x=C.texture,z=n.get(C),it=n.get(x);C.addEventListener("dispose",I);let j=C.textures,et=C.isWebGLCubeRenderTarget===!0,It=j.length>1;if(It||(it.__webglTexture===void 0&&(it.__webglTexture=i.createTexture()),it.__version=x.version,o.memory.textures++),et){z.__webglFramebuffer=[];for(let gt=0;gt<6;gt++)if(x.mipmaps&&x.mipmaps.length>0){z.__webglFramebuffer[gt]=[];for(let _t=0;_t<x.mipmaps.length;_t++)z.__webglFramebuffer[gt][_t]=i.createFramebuffer()}else z.__webglFramebuffer[gt]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){z.__webglFramebuffer=[];for(let gt=0;gt<x.mipmaps.length;gt++)z.__webglFramebuffer[gt]=i.createFramebuffer()}else z.__webglFramebuffer=i.createFramebuffer();if(It)for(let gt=0,_t=j.length;gt<_t;gt++){let qt=n.get(j[gt]);qt.__webglTexture===void 0&&(qt.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&Jt(C)===!1){z.__webglMultisampledFramebuffer=i.createFramebuffer(),z.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let gt=0;gt<j.length;gt++){let _t=j[gt];z.__webglColorRenderbuffer[gt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,z.__webglColorRenderbuffer[gt]);let qt=r.convert(_t.format,_t.colorSpace),at=r.convert(_t.type),vt=S(_t.internalFormat,qt,at,_t.colorSpace,C.isXRRenderTarget===!0),Bt=se(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,Bt,vt,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,z.__webglColorRenderbuffer[gt])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(z.__webglDepthRenderbuffer=i.createRenderbuffer(),ut(z.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(et){e.bindTexture(i.TEXTURE_CUBE_MAP,it.__webglTexture),ft(i.TEXTURE_CUBE_MAP,x);for(let gt=0;gt<6;gt++)if(x.mipmaps&&x.mipmaps.length>0)for(let _t=0;_t<x.mipmaps.length;_t++)Lt(z.__webglFramebuffer[gt][_t],C,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,_t);else Lt(z.__webglFramebuffer[gt],C,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,0);m(x)&&p(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(It){for(let gt=0,_t=j.length;gt<_t;gt++){let qt=j[gt],at=n.get(qt);e.bindTexture(i.TEXTURE_2D,at.__webglTexture),ft(i.TEXTURE_2D,qt),Lt(z.__webglFramebuffer,C,qt,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,0),m(qt)&&p(i.TEXTURE_2D)}e.unbindTexture()}else{let gt=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(gt=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(gt,it.__webglTexture),ft(gt,x),x.mipmaps&&x.mipmaps.length>0)for(let _t=0;_t<x.mipmaps.length;_t++)Lt(z.__webglFramebuffer[_t],C,x,i.COLOR_ATTACHMENT0,gt,_t);else Lt(z.__webglFramebuffer,C,x,i.COLOR_ATTACHMENT0,gt,0);m(x)&&p(gt),e.unbindTexture()}C.depthBuffer&&Gt(C)}function ee(C){let x=C.textures;for(let z=0,it=x.length;z<it;z++){let j=x[z];if(m(j)){let et=E(C),It=n.get(j).__webglTexture;e.bindTexture(et,It),p(et),e.unbindTexture()}}}let Te=[],G=[];function rn(C){if(C.samples>0){if(Jt(C)===!1){let x=C.textures,z=C.width,it=C.height,j=i.COLOR_BUFFER_BIT,et=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,It=n.get(C),gt=x.length>1;if(gt)for(let _t=0;_t<x.length;_t++)e.bindFramebuffer(i.FRAMEBUFFER,It.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,It.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,It.__webglMultisampledFramebuffer),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,It.__webglFramebuffer);for(let _t=0;_t<x.length;_t++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),gt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,It.__webglColorRenderbuffer[_t]);let qt=n.get(x[_t]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,qt,0)}i.blitFramebuffer(0,0,z,it,0,0,z,it,j,i.NEAREST),l===!0&&(Te.length=0,G.length=0,Te.push(i.COLOR_ATTACHMENT0+_t),C.depthBuffer&&C.resolveDepthBuffer===!1&&(Te.push(et),G.push(et),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,G)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Te))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),gt)for(let _t=0;_t<x.length;_t++){e.bindFramebuffer(i.FRAMEBUFFER,It.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,It.__webglColorRenderbuffer[_t]);let qt=n.get(x[_t]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,It.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.TEXTURE_2D,qt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,It.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.resolveDepthBuffer===!1&&l){let x=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function se(C){return Math.min(s.maxSamples,C.samples)}function Jt(C){let x=n.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Nt(C){let x=o.render.frame;h.get(C)!==x&&(h.set(C,x),C.update())}function Me(C,x){let z=C.colorSpace,it=C.format,j=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||z!==wo&&z!==Ts&&(ve.getTransfer(z)===Ie?(it!==Qn||j!==rs)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",z)),x}function kt(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=H,this.resetTextureUnits=W,this.setTexture2D=J,this.setTexture2DArray=$,this.setTexture3D=nt,this.setTextureCube=Q,this.rebindTextures=Vt,this.setupRenderTarget=oe,this.updateRenderTargetMipmap=ee,this.updateMultisampleRenderTarget=rn,this.setupDepthRenderbuffer=Gt,this.setupFrameBufferTexture=Lt,this.useMultisampledRTT=Jt}function c1(i,t){function e(n,s=Ts){let r,o=ve.getTransfer(s);if(n===rs)return i.UNSIGNED_BYTE;if(n===Dd)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Ud)return i.UNSIGNED_SHORT_5_5_5_1;if(n===fg)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===ug)return i.BYTE;if(n===dg)return i.SHORT;if(n===aa)return i.UNSIGNED_SHORT;if(n===Ld)return i.INT;if(n===os)return i.UNSIGNED_INT;if(n===Ti)return i.FLOAT;if(n===pa)return i.HALF_FLOAT;if(n===pg)return i.ALPHA;if(n===mg)return i.RGB;if(n===Qn)return i.RGBA;if(n===gg)return i.LUMINANCE;if(n===vg)return i.LUMINANCE_ALPHA;if(n===lo)return i.DEPTH_COMPONENT;if(n===go)return i.DEPTH_STENCIL;if(n===yg)return i.RED;if(n===Nd)return i.RED_INTEGER;if(n===xg)return i.RG;if(n===Fd)return i.RG_INTEGER;if(n===Od)return i.RGBA_INTEGER;if(n===El||n===Al||n===Tl||n===Cl)if(o===Ie)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===El)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Tl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===El)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Al)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Tl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Cl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===_u||n===bu||n===Mu||n===wu)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===_u)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===bu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Mu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===wu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Su||n===Eu||n===Au)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Su||n===Eu)return o===Ie?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Au)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Tu||n===Cu||n===Ru||n===Pu||n===Iu||n===Lu||n===Du||n===Uu||n===Nu||n===Fu||n===Ou||n===ku||n===Bu||n===zu)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Tu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Cu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ru)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Pu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Iu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Lu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Du)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Uu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Nu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Fu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ou)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ku)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Bu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===zu)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Rl||n===Vu||n===Hu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Rl)return o===Ie?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Vu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Hu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===_g||n===Gu||n===Wu||n===Xu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Rl)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Gu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Wu)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Xu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===mo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var od=class extends On{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}},Wn=class extends ni{constructor(){super(),this.isGroup=!0,this.type="Group"}},h1={type:"move"},sa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Wn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Wn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new N,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new N),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Wn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new N,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new N),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,n),p=this._getHandJoint(c,y);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,g=.005;c.inputState.pinching&&u>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(h1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Wn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},u1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,d1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,ad=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,n){if(this.texture===null){let s=new kn,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=n.depthNear||e.depthFar!=n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new _n({vertexShader:u1,fragmentShader:d1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Mn(new Is(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ld=class extends as{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,g=null,y=new ad,m=e.getContextAttributes(),p=null,E=null,S=[],M=[],D=new At,P=null,I=new On;I.viewport=new Ye;let F=new On;F.viewport=new Ye;let A=[I,F],b=new od,T=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let ct=S[K];return ct===void 0&&(ct=new sa,S[K]=ct),ct.getTargetRaySpace()},this.getControllerGrip=function(K){let ct=S[K];return ct===void 0&&(ct=new sa,S[K]=ct),ct.getGripSpace()},this.getHand=function(K){let ct=S[K];return ct===void 0&&(ct=new sa,S[K]=ct),ct.getHandSpace()};function H(K){let ct=M.indexOf(K.inputSource);if(ct===-1)return;let Lt=S[ct];Lt!==void 0&&(Lt.update(K.inputSource,K.frame,c||o),Lt.dispatchEvent({type:K.type,data:K.inputSource}))}function q(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",J);for(let K=0;K<S.length;K++){let ct=M[K];ct!==null&&(M[K]=null,S[K].disconnect(ct))}T=null,W=null,y.reset(),t.setRenderTarget(p),f=null,u=null,d=null,s=null,E=null,Wt.stop(),n.isPresenting=!1,t.setPixelRatio(P),t.setSize(D.width,D.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(p=t.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",q),s.addEventListener("inputsourceschange",J),m.xrCompatible!==!0&&await e.makeXRCompatible(),P=t.getPixelRatio(),t.getSize(D),s.renderState.layers===void 0){let ct={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,ct),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),E=new ei(f.framebufferWidth,f.framebufferHeight,{format:Qn,type:rs,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let ct=null,Lt=null,ut=null;m.depth&&(ut=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,ct=m.stencil?go:lo,Lt=m.stencil?mo:os);let Ut={colorFormat:e.RGBA8,depthFormat:ut,scaleFactor:r};d=new XRWebGLBinding(s,e),u=d.createProjectionLayer(Ut),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),E=new ei(u.textureWidth,u.textureHeight,{format:Qn,type:rs,depthTexture:new yo(u.textureWidth,u.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,ct),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1})}E.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Wt.setContext(s),Wt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return y.getDepthTexture()};function J(K){for(let ct=0;ct<K.removed.length;ct++){let Lt=K.removed[ct],ut=M.indexOf(Lt);ut>=0&&(M[ut]=null,S[ut].disconnect(Lt))}for(let ct=0;ct<K.added.length;ct++){let Lt=K.added[ct],ut=M.indexOf(Lt);if(ut===-1){for(let Gt=0;Gt<S.length;Gt++)if(Gt>=M.length){M.push(Lt),ut=Gt;break}else if(M[Gt]===null){M[Gt]=Lt,ut=Gt;break}if(ut===-1)break}let Ut=S[ut];Ut&&Ut.connect(Lt)}}let $=new N,nt=new N;function Q(K,ct,Lt){$.setFromMatrixPosition(ct.matrixWorld),nt.setFromMatrixPosition(Lt.matrixWorld);let ut=$.distanceTo(nt),Ut=ct.projectionMatrix.elements,Gt=Lt.projectionMatrix.elements,Vt=Ut[14]/(Ut[10]-1),oe=Ut[14]/(Ut[10]+1),ee=(Ut[9]+1)/Ut[5],Te=(Ut[9]-1)/Ut[5],G=(Ut[8]-1)/Ut[0],rn=(Gt[8]+1)/Gt[0],se=Vt*G,Jt=Vt*rn,Nt=ut/(-G+rn),Me=Nt*-G;if(ct.matrixWorld.decompose(K.position,K.quaternion,K.scale),K.translateX(Me),K.translateZ(Nt),K.matrixWorld.compose(K.position,K.quaternion,K.scale),K.matrixWorldInverse.copy(K.matrixWorld).invert(),Ut[10]===-1)K.projectionMatrix.copy(ct.projectionMatrix),K.projectionMatrixInverse.copy(ct.projectionMatrixInverse);else{let kt=Vt+Nt,C=oe+Nt,x=se-Me,z=Jt+(ut-Me),it=ee*oe/C*kt,j=Te*oe/C*kt;K.projectionMatrix.makePerspective(x,z,it,j,kt,C),K.projectionMatrixInverse.copy(K.projectionMatrix).invert()}}function ht(K,ct){ct===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(ct.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let ct=K.near,Lt=K.far;y.texture!==null&&(y.depthNear>0&&(ct=y.depthNear),y.depthFar>0&&(Lt=y.depthFar)),b.near=F.near=I.near=ct,b.far=F.far=I.far=Lt,(T!==b.near||W!==b.far)&&(s.updateRenderState({depthNear:b.near,depthFar:b.far}),T=b.near,W=b.far),I.layers.mask=K.layers.mask|2,F.layers.mask=K.layers.mask|4,b.layers.mask=I.layers.mask|F.layers.mask;let ut=K.parent,Ut=b.cameras;ht(b,ut);for(let Gt=0;Gt<Ut.length;Gt++)ht(Ut[Gt],ut);Ut.length===2?Q(b,I,F):b.projectionMatrix.copy(I.projectionMatrix),ot(K,b,ut)};function ot(K,ct,Lt){Lt===null?K.matrix.copy(ct.matrixWorld):(K.matrix.copy(Lt.matrixWorld),K.matrix.invert(),K.matrix.multiply(ct.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(ct.projectionMatrix),K.projectionMatrixInverse.copy(ct.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=la*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return b},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(K){l=K,u!==null&&(u.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return y.texture!==null},this.getDepthSensingMesh=function(){return y.getMesh(b)};let mt=null;function ft(K,ct){if(h=ct.getViewerPose(c||o),g=ct,h!==null){let Lt=h.views;f!==null&&(t.setRenderTargetFramebuffer(E,f.framebuffer),t.setRenderTarget(E));let ut=!1;Lt.length!==b.cameras.length&&(b.cameras.length=0,ut=!0);for(let Gt=0;Gt<Lt.length;Gt++){let Vt=Lt[Gt],oe=null;if(f!==null)oe=f.getViewport(Vt);else{let Te=d.getViewSubImage(u,Vt);oe=Te.viewport,Gt===0&&(t.setRenderTargetTextures(E,Te.colorTexture,u.ignoreDepthValues?void 0:Te.depthStencilTexture),t.setRenderTarget(E))}let ee=A[Gt];ee===void 0&&(ee=new On,ee.layers.enable(Gt),ee.viewport=new Ye,A[Gt]=ee),ee.matrix.fromArray(Vt.transform.matrix),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.projectionMatrix.fromArray(Vt.projectionMatrix),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert(),ee.viewport.set(oe.x,oe.y,oe.width,oe.height),Gt===0&&(b.matrix.copy(ee.matrix),b.matrix.decompose(b.position,b.quaternion,b.scale)),ut===!0&&b.cameras.push(ee)}let Ut=s.enabledFeatures;if(Ut&&Ut.includes("depth-sensing")){let Gt=d.getDepthInformation(Lt[0]);Gt&&Gt.isValid&&Gt.texture&&y.init(t,Gt,s.renderState)}}for(let Lt=0;Lt<S.length;Lt++){let ut=M[Lt],Ut=S[Lt];ut!==null&&Ut!==void 0&&Ut.update(ut,ct,c||o)}mt&&mt(K,ct),ct.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ct}),g=null}let Wt=new Ag;Wt.setAnimationLoop(ft),this.setAnimationLoop=function(K){mt=K},this.dispose=function(){}}},Ks=new ls,f1=new Xe;function p1(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Eg(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,E,S,M){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),d(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p)):p.isMeshStandardMaterial?(r(m,p),u(m,p),p.isMeshPhysicalMaterial&&f(m,p,M)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),y(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,E,S):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Cn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Cn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let E=t.get(p),S=E.envMap,M=E.envMapRotation;S&&(m.envMap.value=S,Ks.copy(M),Ks.x*=-1,Ks.y*=-1,Ks.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(Ks.y*=-1,Ks.z*=-1),m.envMapRotation.value.setFromMatrix4(f1.makeRotationFromEuler(Ks)),m.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,E,S){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*E,m.scale.value=S*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function d(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function u(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,E){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Cn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=E.texture,m.transmissionSamplerSize.value.set(E.width,E.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function y(m,p){let E=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(E.matrixWorld),m.nearDistance.value=E.shadow.camera.near,m.farDistance.value=E.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function m1(i,t,e,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(E,S){let M=S.program;n.uniformBlockBinding(E,M)}function c(E,S){let M=s[E.id];M===void 0&&(g(E),M=h(E),s[E.id]=M,E.addEventListener("dispose",m));let D=S.program;n.updateUBOMapping(E,D);let P=t.render.frame;r[E.id]!==P&&(u(E),r[E.id]=P)}function h(E){let S=d();E.__bindingPointIndex=S;let M=i.createBuffer(),D=E.__size,P=E.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,D,P),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,M),M}function d(){for(let E=0;E<a;E++)if(o.indexOf(E)===-1)return o.push(E),E;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function u(E){let S=s[E.id],M=E.uniforms,D=E.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let P=0,I=M.length;P<I;P++){let F=Array.isArray(M[P])?M[P]:[M[P]];for(let A=0,b=F.length;A<b;A++){let T=F[A];if(f(T,P,A,D)===!0){let W=T.__offset,H=Array.isArray(T.value)?T.value:[T.value],q=0;for(let J=0;J<H.length;J++){let $=H[J],nt=y($);typeof $=="number"||typeof $=="boolean"?(T.__data[0]=$,i.bufferSubData(i.UNIFORM_BUFFER,W+q,T.__data)):$.isMatrix3?(T.__data[0]=$.elements[0],T.__data[1]=$.elements[1],T.__data[2]=$.elements[2],T.__data[3]=0,T.__data[4]=$.elements[3],T.__data[5]=$.elements[4],T.__data[6]=$.elements[5],T.__data[7]=0,T.__data[8]=$.elements[6],T.__data[9]=$.elements[7],T.__data[10]=$.elements[8],T.__data[11]=0):($.toArray(T.__data,q),q+=nt.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,W,T.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function f(E,S,M,D){let P=E.value,I=S+"_"+M;if(D[I]===void 0)return typeof P=="number"||typeof P=="boolean"?D[I]=P:D[I]=P.clone(),!0;{let F=D[I];if(typeof P=="number"||typeof P=="boolean"){if(F!==P)return D[I]=P,!0}else if(F.equals(P)===!1)return F.copy(P),!0}return!1}function g(E){let S=E.uniforms,M=0,D=16;for(let I=0,F=S.length;I<F;I++){let A=Array.isArray(S[I])?S[I]:[S[I]];for(let b=0,T=A.length;b<T;b++){let W=A[b],H=Array.isArray(W.value)?W.value:[W.value];for(let q=0,J=H.length;q<J;q++){let $=H[q],nt=y($),Q=M%D,ht=Q%nt.boundary,ot=Q+ht;M+=ht,ot!==0&&D-ot<nt.storage&&(M+=D-ot),W.__data=new Float32Array(nt.storage/Float32Array.BYTES_PER_ELEMENT),W.__offset=M,M+=nt.storage}}}let P=M%D;return P>0&&(M+=D-P),E.__size=M,E.__cache={},this}function y(E){let S={boundary:0,storage:0};return typeof E=="number"||typeof E=="boolean"?(S.boundary=4,S.storage=4):E.isVector2?(S.boundary=8,S.storage=8):E.isVector3||E.isColor?(S.boundary=16,S.storage=12):E.isVector4?(S.boundary=16,S.storage=16):E.isMatrix3?(S.boundary=48,S.storage=48):E.isMatrix4?(S.boundary=64,S.storage=64):E.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",E),S}function m(E){let S=E.target;S.removeEventListener("dispose",m);let M=o.indexOf(S.__bindingPointIndex);o.splice(M,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function p(){for(let E in s)i.deleteBuffer(s[E]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}var Gl=class{constructor(t={}){let{canvas:e=x_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reverseDepthBuffer:u=!1}=t;this.isWebGLRenderer=!0;let f;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=n.getContextAttributes().alpha}else f=o;let g=new Uint32Array(4),y=new Int32Array(4),m=null,p=null,E=[],S=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=di,this.toneMapping=Rs,this.toneMappingExposure=1;let M=this,D=!1,P=0,I=0,F=null,A=-1,b=null,T=new Ye,W=new Ye,H=null,q=new he(0),J=0,$=e.width,nt=e.height,Q=1,ht=null,ot=null,mt=new Ye(0,0,$,nt),ft=new Ye(0,0,$,nt),Wt=!1,K=new Vl,ct=!1,Lt=!1,ut=new Xe,Ut=new Xe,Gt=new N,Vt=new Ye,oe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ee=!1;function Te(){return F===null?Q:1}let G=n;function rn(w,k){return e.getContext(w,k)}try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Pd}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",St,!1),e.addEventListener("webglcontextcreationerror",wt,!1),G===null){let k="webgl2";if(G=rn(k,w),G===null)throw rn(k)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(w){throw console.error("THREE.WebGLRenderer: "+w.message),w}let se,Jt,Nt,Me,kt,C,x,z,it,j,et,It,gt,_t,qt,at,vt,Bt,Ht,Mt,ne,Yt,_e,O;function yt(){se=new Iw(G),se.init(),Yt=new c1(G,se),Jt=new Ew(G,se,t,Yt),Nt=new o1(G,se),Jt.reverseDepthBuffer&&u&&Nt.buffers.depth.setReversed(!0),Me=new Uw(G),kt=new YS,C=new l1(G,se,Nt,kt,Jt,Yt,Me),x=new Tw(M),z=new Pw(M),it=new V_(G),_e=new ww(G,it),j=new Lw(G,it,Me,_e),et=new Fw(G,j,it,Me),Ht=new Nw(G,Jt,C),at=new Aw(kt),It=new qS(M,x,z,se,Jt,_e,at),gt=new p1(M,kt),_t=new ZS,qt=new e1(se),Bt=new Mw(M,x,z,Nt,et,f,l),vt=new s1(M,et,Jt),O=new m1(G,Me,Jt,Nt),Mt=new Sw(G,se,Me),ne=new Dw(G,se,Me),Me.programs=It.programs,M.capabilities=Jt,M.extensions=se,M.properties=kt,M.renderLists=_t,M.shadowMap=vt,M.state=Nt,M.info=Me}yt();let tt=new ld(M,G);this.xr=tt,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let w=se.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=se.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(w){w!==void 0&&(Q=w,this.setSize($,nt,!1))},this.getSize=function(w){return w.set($,nt)},this.setSize=function(w,k,X=!0){if(tt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}$=w,nt=k,e.width=Math.floor(w*Q),e.height=Math.floor(k*Q),X===!0&&(e.style.width=w+"px",e.style.height=k+"px"),this.setViewport(0,0,w,k)},this.getDrawingBufferSize=function(w){return w.set($*Q,nt*Q).floor()},this.setDrawingBufferSize=function(w,k,X){$=w,nt=k,Q=X,e.width=Math.floor(w*X),e.height=Math.floor(k*X),this.setViewport(0,0,w,k)},this.getCurrentViewport=function(w){return w.copy(T)},this.getViewport=function(w){return w.copy(mt)},this.setViewport=function(w,k,X,Z){w.isVector4?mt.set(w.x,w.y,w.z,w.w):mt.set(w,k,X,Z),Nt.viewport(T.copy(mt).multiplyScalar(Q).round())},this.getScissor=function(w){return w.copy(ft)},this.setScissor=function(w,k,X,Z){w.isVector4?ft.set(w.x,w.y,w.z,w.w):ft.set(w,k,X,Z),Nt.scissor(W.copy(ft).multiplyScalar(Q).round())},this.getScissorTest=function(){return Wt},this.setScissorTest=function(w){Nt.setScissorTest(Wt=w)},this.setOpaqueSort=function(w){ht=w},this.setTransparentSort=function(w){ot=w},this.getClearColor=function(w){return w.copy(Bt.getClearColor())},this.setClearColor=function(){Bt.setClearColor.apply(Bt,arguments)},this.getClearAlpha=function(){return Bt.getClearAlpha()},this.setClearAlpha=function(){Bt.setClearAlpha.apply(Bt,arguments)},this.clear=function(w=!0,k=!0,X=!0){let Z=0;if(w){let V=!1;if(F!==null){let dt=F.texture.format;V=dt===Od||dt===Fd||dt===Nd}if(V){let dt=F.texture.type,bt=dt===rs||dt===os||dt===aa||dt===mo||dt===Dd||dt===Ud,Ft=Bt.getClearColor(),Dt=Bt.getClearAlpha(),Xt=Ft.r,$t=Ft.g,Ot=Ft.b;bt?(g[0]=Xt,g[1]=$t,g[2]=Ot,g[3]=Dt,G.clearBufferuiv(G.COLOR,0,g)):(y[0]=Xt,y[1]=$t,y[2]=Ot,y[3]=Dt,G.clearBufferiv(G.COLOR,0,y))}else Z|=G.COLOR_BUFFER_BIT}k&&(Z|=G.DEPTH_BUFFER_BIT),X&&(Z|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),G.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",St,!1),e.removeEventListener("webglcontextcreationerror",wt,!1),_t.dispose(),qt.dispose(),kt.dispose(),x.dispose(),z.dispose(),et.dispose(),_e.dispose(),O.dispose(),It.dispose(),tt.dispose(),tt.removeEventListener("sessionstart",Hi),tt.removeEventListener("sessionend",Gi),je.stop()};function rt(w){w.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),D=!0}function St(){console.log("THREE.WebGLRenderer: Context Restored."),D=!1;let w=Me.autoReset,k=vt.enabled,X=vt.autoUpdate,Z=vt.needsUpdate,V=vt.type;yt(),Me.autoReset=w,vt.enabled=k,vt.autoUpdate=X,vt.needsUpdate=Z,vt.type=V}function wt(w){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function jt(w){let k=w.target;k.removeEventListener("dispose",jt),He(k)}function He(w){Ct(w),kt.remove(w)}function Ct(w){let k=kt.get(w).programs;k!==void 0&&(k.forEach(function(X){It.releaseProgram(X)}),w.isShaderMaterial&&It.releaseShaderCache(w))}this.renderBufferDirect=function(w,k,X,Z,V,dt){k===null&&(k=oe);let bt=V.isMesh&&V.matrixWorld.determinant()<0,Ft=Us(w,k,X,Z,V);Nt.setMaterial(Z,bt);let Dt=X.index,Xt=1;if(Z.wireframe===!0){if(Dt=j.getWireframeAttribute(X),Dt===void 0)return;Xt=2}let $t=X.drawRange,Ot=X.attributes.position,ue=$t.start*Xt,we=($t.start+$t.count)*Xt;dt!==null&&(ue=Math.max(ue,dt.start*Xt),we=Math.min(we,(dt.start+dt.count)*Xt)),Dt!==null?(ue=Math.max(ue,0),we=Math.min(we,Dt.count)):Ot!=null&&(ue=Math.max(ue,0),we=Math.min(we,Ot.count));let Ae=we-ue;if(Ae<0||Ae===1/0)return;_e.setup(V,Z,Ft,X,Dt);let mn,me=Mt;if(Dt!==null&&(mn=it.get(Dt),me=ne,me.setIndex(mn)),V.isMesh)Z.wireframe===!0?(Nt.setLineWidth(Z.wireframeLinewidth*Te()),me.setMode(G.LINES)):me.setMode(G.TRIANGLES);else if(V.isLine){let Rt=Z.linewidth;Rt===void 0&&(Rt=1),Nt.setLineWidth(Rt*Te()),V.isLineSegments?me.setMode(G.LINES):V.isLineLoop?me.setMode(G.LINE_LOOP):me.setMode(G.LINE_STRIP)}else V.isPoints?me.setMode(G.POINTS):V.isSprite&&me.setMode(G.TRIANGLES);if(V.isBatchedMesh)if(V._multiDrawInstances!==null)me.renderMultiDrawInstances(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount,V._multiDrawInstances);else if(se.get("WEBGL_multi_draw"))me.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let Rt=V._multiDrawStarts,si=V._multiDrawCounts,ge=V._multiDrawCount,Pn=Dt?it.get(Dt).bytesPerElement:1,Xi=kt.get(Z).currentProgram.getUniforms();for(let In=0;In<ge;In++)Xi.setValue(G,"_gl_DrawID",In),me.render(Rt[In]/Pn,si[In])}else if(V.isInstancedMesh)me.renderInstances(ue,Ae,V.count);else if(X.isInstancedBufferGeometry){let Rt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,si=Math.min(X.instanceCount,Rt);me.renderInstances(ue,Ae,si)}else me.render(ue,Ae)};function le(w,k,X){w.transparent===!0&&w.side===fi&&w.forceSinglePass===!1?(w.side=Cn,w.needsUpdate=!0,yr(w,k,X),w.side=zi,w.needsUpdate=!0,yr(w,k,X),w.side=fi):yr(w,k,X)}this.compile=function(w,k,X=null){X===null&&(X=w),p=qt.get(X),p.init(k),S.push(p),X.traverseVisible(function(V){V.isLight&&V.layers.test(k.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),w!==X&&w.traverseVisible(function(V){V.isLight&&V.layers.test(k.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),p.setupLights();let Z=new Set;return w.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let dt=V.material;if(dt)if(Array.isArray(dt))for(let bt=0;bt<dt.length;bt++){let Ft=dt[bt];le(Ft,X,V),Z.add(Ft)}else le(dt,X,V),Z.add(dt)}),S.pop(),p=null,Z},this.compileAsync=function(w,k,X=null){let Z=this.compile(w,k,X);return new Promise(V=>{function dt(){if(Z.forEach(function(bt){kt.get(bt).currentProgram.isReady()&&Z.delete(bt)}),Z.size===0){V(w);return}setTimeout(dt,10)}se.get("KHR_parallel_shader_compile")!==null?dt():setTimeout(dt,10)})};let Ce=null;function pn(w){Ce&&Ce(w)}function Hi(){je.stop()}function Gi(){je.start()}let je=new Ag;je.setAnimationLoop(pn),typeof self<"u"&&je.setContext(self),this.setAnimationLoop=function(w){Ce=w,tt.setAnimationLoop(w),w===null?je.stop():je.start()},tt.addEventListener("sessionstart",Hi),tt.addEventListener("sessionend",Gi),this.render=function(w,k){if(k!==void 0&&k.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),tt.enabled===!0&&tt.isPresenting===!0&&(tt.cameraAutoUpdate===!0&&tt.updateCamera(k),k=tt.getCamera()),w.isScene===!0&&w.onBeforeRender(M,w,k,F),p=qt.get(w,S.length),p.init(k),S.push(p),Ut.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),K.setFromProjectionMatrix(Ut),Lt=this.localClippingEnabled,ct=at.init(this.clippingPlanes,Lt),m=_t.get(w,E.length),m.init(),E.push(m),tt.enabled===!0&&tt.isPresenting===!0){let dt=M.xr.getDepthSensingMesh();dt!==null&&Ii(dt,k,-1/0,M.sortObjects)}Ii(w,k,0,M.sortObjects),m.finish(),M.sortObjects===!0&&m.sort(ht,ot),ee=tt.enabled===!1||tt.isPresenting===!1||tt.hasDepthSensing()===!1,ee&&Bt.addToRenderList(m,w),this.info.render.frame++,ct===!0&&at.beginShadows();let X=p.state.shadowsArray;vt.render(X,w,k),ct===!0&&at.endShadows(),this.info.autoReset===!0&&this.info.reset();let Z=m.opaque,V=m.transmissive;if(p.setupLights(),k.isArrayCamera){let dt=k.cameras;if(V.length>0)for(let bt=0,Ft=dt.length;bt<Ft;bt++){let Dt=dt[bt];Uo(Z,V,w,Dt)}ee&&Bt.render(w);for(let bt=0,Ft=dt.length;bt<Ft;bt++){let Dt=dt[bt];Wi(m,w,Dt,Dt.viewport)}}else V.length>0&&Uo(Z,V,w,k),ee&&Bt.render(w),Wi(m,w,k);F!==null&&(C.updateMultisampleRenderTarget(F),C.updateRenderTargetMipmap(F)),w.isScene===!0&&w.onAfterRender(M,w,k),_e.resetDefaultState(),A=-1,b=null,S.pop(),S.length>0?(p=S[S.length-1],ct===!0&&at.setGlobalState(M.clippingPlanes,p.state.camera)):p=null,E.pop(),E.length>0?m=E[E.length-1]:m=null};function Ii(w,k,X,Z){if(w.visible===!1)return;if(w.layers.test(k.layers)){if(w.isGroup)X=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(k);else if(w.isLight)p.pushLight(w),w.castShadow&&p.pushShadow(w);else if(w.isSprite){if(!w.frustumCulled||K.intersectsSprite(w)){Z&&Vt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ut);let bt=et.update(w),Ft=w.material;Ft.visible&&m.push(w,bt,Ft,X,Vt.z,null)}}else if((w.isMesh||w.isLine||w.isPoints)&&(!w.frustumCulled||K.intersectsObject(w))){let bt=et.update(w),Ft=w.material;if(Z&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),Vt.copy(w.boundingSphere.center)):(bt.boundingSphere===null&&bt.computeBoundingSphere(),Vt.copy(bt.boundingSphere.center)),Vt.applyMatrix4(w.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ft)){let Dt=bt.groups;for(let Xt=0,$t=Dt.length;Xt<$t;Xt++){let Ot=Dt[Xt],ue=Ft[Ot.materialIndex];ue&&ue.visible&&m.push(w,bt,ue,X,Vt.z,Ot)}}else Ft.visible&&m.push(w,bt,Ft,X,Vt.z,null)}}let dt=w.children;for(let bt=0,Ft=dt.length;bt<Ft;bt++)Ii(dt[bt],k,X,Z)}function Wi(w,k,X,Z){let V=w.opaque,dt=w.transmissive,bt=w.transparent;p.setupLightsView(X),ct===!0&&at.setGlobalState(M.clippingPlanes,X),Z&&Nt.viewport(T.copy(Z)),V.length>0&&Ds(V,k,X),dt.length>0&&Ds(dt,k,X),bt.length>0&&Ds(bt,k,X),Nt.buffers.depth.setTest(!0),Nt.buffers.depth.setMask(!0),Nt.buffers.color.setMask(!0),Nt.setPolygonOffset(!1)}function Uo(w,k,X,Z){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[Z.id]===void 0&&(p.state.transmissionRenderTarget[Z.id]=new ei(1,1,{generateMipmaps:!0,type:se.has("EXT_color_buffer_half_float")||se.has("EXT_color_buffer_float")?pa:rs,minFilter:ir,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ve.workingColorSpace}));let dt=p.state.transmissionRenderTarget[Z.id],bt=Z.viewport||T;dt.setSize(bt.z,bt.w);let Ft=M.getRenderTarget();M.setRenderTarget(dt),M.getClearColor(q),J=M.getClearAlpha(),J<1&&M.setClearColor(16777215,.5),M.clear(),ee&&Bt.render(X);let Dt=M.toneMapping;M.toneMapping=Rs;let Xt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),p.setupLightsView(Z),ct===!0&&at.setGlobalState(M.clippingPlanes,Z),Ds(w,X,Z),C.updateMultisampleRenderTarget(dt),C.updateRenderTargetMipmap(dt),se.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let Ot=0,ue=k.length;Ot<ue;Ot++){let we=k[Ot],Ae=we.object,mn=we.geometry,me=we.material,Rt=we.group;if(me.side===fi&&Ae.layers.test(Z.layers)){let si=me.side;me.side=Cn,me.needsUpdate=!0,Sa(Ae,X,Z,mn,me,Rt),me.side=si,me.needsUpdate=!0,$t=!0}}$t===!0&&(C.updateMultisampleRenderTarget(dt),C.updateRenderTargetMipmap(dt))}M.setRenderTarget(Ft),M.setClearColor(q,J),Xt!==void 0&&(Z.viewport=Xt),M.toneMapping=Dt}function Ds(w,k,X){let Z=k.isScene===!0?k.overrideMaterial:null;for(let V=0,dt=w.length;V<dt;V++){let bt=w[V],Ft=bt.object,Dt=bt.geometry,Xt=Z===null?bt.material:Z,$t=bt.group;Ft.layers.test(X.layers)&&Sa(Ft,k,X,Dt,Xt,$t)}}function Sa(w,k,X,Z,V,dt){w.onBeforeRender(M,k,X,Z,V,dt),w.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),V.onBeforeRender(M,k,X,Z,w,dt),V.transparent===!0&&V.side===fi&&V.forceSinglePass===!1?(V.side=Cn,V.needsUpdate=!0,M.renderBufferDirect(X,k,Z,V,w,dt),V.side=zi,V.needsUpdate=!0,M.renderBufferDirect(X,k,Z,V,w,dt),V.side=fi):M.renderBufferDirect(X,k,Z,V,w,dt),w.onAfterRender(M,k,X,Z,V,dt)}function yr(w,k,X){k.isScene!==!0&&(k=oe);let Z=kt.get(w),V=p.state.lights,dt=p.state.shadowsArray,bt=V.state.version,Ft=It.getParameters(w,V.state,dt,k,X),Dt=It.getProgramCacheKey(Ft),Xt=Z.programs;Z.environment=w.isMeshStandardMaterial?k.environment:null,Z.fog=k.fog,Z.envMap=(w.isMeshStandardMaterial?z:x).get(w.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&w.envMap===null?k.environmentRotation:w.envMapRotation,Xt===void 0&&(w.addEventListener("dispose",jt),Xt=new Map,Z.programs=Xt);let $t=Xt.get(Dt);if($t!==void 0){if(Z.currentProgram===$t&&Z.lightsStateVersion===bt)return Ea(w,Ft),$t}else Ft.uniforms=It.getUniforms(w),w.onBeforeCompile(Ft,M),$t=It.acquireProgram(Ft,Dt),Xt.set(Dt,$t),Z.uniforms=Ft.uniforms;let Ot=Z.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ot.clippingPlanes=at.uniform),Ea(w,Ft),Z.needsLights=Di(w),Z.lightsStateVersion=bt,Z.needsLights&&(Ot.ambientLightColor.value=V.state.ambient,Ot.lightProbe.value=V.state.probe,Ot.directionalLights.value=V.state.directional,Ot.directionalLightShadows.value=V.state.directionalShadow,Ot.spotLights.value=V.state.spot,Ot.spotLightShadows.value=V.state.spotShadow,Ot.rectAreaLights.value=V.state.rectArea,Ot.ltc_1.value=V.state.rectAreaLTC1,Ot.ltc_2.value=V.state.rectAreaLTC2,Ot.pointLights.value=V.state.point,Ot.pointLightShadows.value=V.state.pointShadow,Ot.hemisphereLights.value=V.state.hemi,Ot.directionalShadowMap.value=V.state.directionalShadowMap,Ot.directionalShadowMatrix.value=V.state.directionalShadowMatrix,Ot.spotShadowMap.value=V.state.spotShadowMap,Ot.spotLightMatrix.value=V.state.spotLightMatrix,Ot.spotLightMap.value=V.state.spotLightMap,Ot.pointShadowMap.value=V.state.pointShadowMap,Ot.pointShadowMatrix.value=V.state.pointShadowMatrix),Z.currentProgram=$t,Z.uniformsList=null,$t}function Li(w){if(w.uniformsList===null){let k=w.currentProgram.getUniforms();w.uniformsList=ho.seqWithValue(k.seq,w.uniforms)}return w.uniformsList}function Ea(w,k){let X=kt.get(w);X.outputColorSpace=k.outputColorSpace,X.batching=k.batching,X.batchingColor=k.batchingColor,X.instancing=k.instancing,X.instancingColor=k.instancingColor,X.instancingMorph=k.instancingMorph,X.skinning=k.skinning,X.morphTargets=k.morphTargets,X.morphNormals=k.morphNormals,X.morphColors=k.morphColors,X.morphTargetsCount=k.morphTargetsCount,X.numClippingPlanes=k.numClippingPlanes,X.numIntersection=k.numClipIntersection,X.vertexAlphas=k.vertexAlphas,X.vertexTangents=k.vertexTangents,X.toneMapping=k.toneMapping}function Us(w,k,X,Z,V){k.isScene!==!0&&(k=oe),C.resetTextureUnits();let dt=k.fog,bt=Z.isMeshStandardMaterial?k.environment:null,Ft=F===null?M.outputColorSpace:F.isXRRenderTarget===!0?F.texture.colorSpace:wo,Dt=(Z.isMeshStandardMaterial?z:x).get(Z.envMap||bt),Xt=Z.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,$t=!!X.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ot=!!X.morphAttributes.position,ue=!!X.morphAttributes.normal,we=!!X.morphAttributes.color,Ae=Rs;Z.toneMapped&&(F===null||F.isXRRenderTarget===!0)&&(Ae=M.toneMapping);let mn=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,me=mn!==void 0?mn.length:0,Rt=kt.get(Z),si=p.state.lights;if(ct===!0&&(Lt===!0||w!==b)){let zn=w===b&&Z.id===A;at.setState(Z,w,zn)}let ge=!1;Z.version===Rt.__version?(Rt.needsLights&&Rt.lightsStateVersion!==si.state.version||Rt.outputColorSpace!==Ft||V.isBatchedMesh&&Rt.batching===!1||!V.isBatchedMesh&&Rt.batching===!0||V.isBatchedMesh&&Rt.batchingColor===!0&&V.colorTexture===null||V.isBatchedMesh&&Rt.batchingColor===!1&&V.colorTexture!==null||V.isInstancedMesh&&Rt.instancing===!1||!V.isInstancedMesh&&Rt.instancing===!0||V.isSkinnedMesh&&Rt.skinning===!1||!V.isSkinnedMesh&&Rt.skinning===!0||V.isInstancedMesh&&Rt.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Rt.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Rt.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Rt.instancingMorph===!1&&V.morphTexture!==null||Rt.envMap!==Dt||Z.fog===!0&&Rt.fog!==dt||Rt.numClippingPlanes!==void 0&&(Rt.numClippingPlanes!==at.numPlanes||Rt.numIntersection!==at.numIntersection)||Rt.vertexAlphas!==Xt||Rt.vertexTangents!==$t||Rt.morphTargets!==Ot||Rt.morphNormals!==ue||Rt.morphColors!==we||Rt.toneMapping!==Ae||Rt.morphTargetsCount!==me)&&(ge=!0):(ge=!0,Rt.__version=Z.version);let Pn=Rt.currentProgram;ge===!0&&(Pn=yr(Z,k,V));let Xi=!1,In=!1,Ns=!1,De=Pn.getUniforms(),qn=Rt.uniforms;if(Nt.useProgram(Pn.program)&&(Xi=!0,In=!0,Ns=!0),Z.id!==A&&(A=Z.id,In=!0),Xi||b!==w){Nt.buffers.depth.getReversed()?(ut.copy(w.projectionMatrix),b_(ut),M_(ut),De.setValue(G,"projectionMatrix",ut)):De.setValue(G,"projectionMatrix",w.projectionMatrix),De.setValue(G,"viewMatrix",w.matrixWorldInverse);let vi=De.map.cameraPosition;vi!==void 0&&vi.setValue(G,Gt.setFromMatrixPosition(w.matrixWorld)),Jt.logarithmicDepthBuffer&&De.setValue(G,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&De.setValue(G,"isOrthographic",w.isOrthographicCamera===!0),b!==w&&(b=w,In=!0,Ns=!0)}if(V.isSkinnedMesh){De.setOptional(G,V,"bindMatrix"),De.setOptional(G,V,"bindMatrixInverse");let zn=V.skeleton;zn&&(zn.boneTexture===null&&zn.computeBoneTexture(),De.setValue(G,"boneTexture",zn.boneTexture,C))}V.isBatchedMesh&&(De.setOptional(G,V,"batchingTexture"),De.setValue(G,"batchingTexture",V._matricesTexture,C),De.setOptional(G,V,"batchingIdTexture"),De.setValue(G,"batchingIdTexture",V._indirectTexture,C),De.setOptional(G,V,"batchingColorTexture"),V._colorsTexture!==null&&De.setValue(G,"batchingColorTexture",V._colorsTexture,C));let fs=X.morphAttributes;if((fs.position!==void 0||fs.normal!==void 0||fs.color!==void 0)&&Ht.update(V,X,Pn),(In||Rt.receiveShadow!==V.receiveShadow)&&(Rt.receiveShadow=V.receiveShadow,De.setValue(G,"receiveShadow",V.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(qn.envMap.value=Dt,qn.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&k.environment!==null&&(qn.envMapIntensity.value=k.environmentIntensity),In&&(De.setValue(G,"toneMappingExposure",M.toneMappingExposure),Rt.needsLights&&Aa(qn,Ns),dt&&Z.fog===!0&&gt.refreshFogUniforms(qn,dt),gt.refreshMaterialUniforms(qn,Z,Q,nt,p.state.transmissionRenderTarget[w.id]),ho.upload(G,Li(Rt),qn,C)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(ho.upload(G,Li(Rt),qn,C),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&De.setValue(G,"center",V.center),De.setValue(G,"modelViewMatrix",V.modelViewMatrix),De.setValue(G,"normalMatrix",V.normalMatrix),De.setValue(G,"modelMatrix",V.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){let zn=Z.uniformsGroups;for(let vi=0,ri=zn.length;vi<ri;vi++){let Fs=zn[vi];O.update(Fs,Pn),O.bind(Fs,Pn)}}return Pn}function Aa(w,k){w.ambientLightColor.needsUpdate=k,w.lightProbe.needsUpdate=k,w.directionalLights.needsUpdate=k,w.directionalLightShadows.needsUpdate=k,w.pointLights.needsUpdate=k,w.pointLightShadows.needsUpdate=k,w.spotLights.needsUpdate=k,w.spotLightShadows.needsUpdate=k,w.rectAreaLights.needsUpdate=k,w.hemisphereLights.needsUpdate=k}function Di(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return P},this.getActiveMipmapLevel=function(){return I},this.getRenderTarget=function(){return F},this.setRenderTargetTextures=function(w,k,X){kt.get(w.texture).__webglTexture=k,kt.get(w.depthTexture).__webglTexture=X;let Z=kt.get(w);Z.__hasExternalTextures=!0,Z.__autoAllocateDepthBuffer=X===void 0,Z.__autoAllocateDepthBuffer||se.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),Z.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(w,k){let X=kt.get(w);X.__webglFramebuffer=k,X.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(w,k=0,X=0){F=w,P=k,I=X;let Z=!0,V=null,dt=!1,bt=!1;if(w){let Dt=kt.get(w);if(Dt.__useDefaultFramebuffer!==void 0)Nt.bindFramebuffer(G.FRAMEBUFFER,null),Z=!1;else if(Dt.__webglFramebuffer===void 0)C.setupRenderTarget(w);else if(Dt.__hasExternalTextures)C.rebindTextures(w,kt.get(w.texture).__webglTexture,kt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Ot=w.depthTexture;if(Dt.__boundDepthTexture!==Ot){if(Ot!==null&&kt.has(Ot)&&(w.width!==Ot.image.width||w.height!==Ot.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");C.setupDepthRenderbuffer(w)}}let Xt=w.texture;(Xt.isData3DTexture||Xt.isDataArrayTexture||Xt.isCompressedArrayTexture)&&(bt=!0);let $t=kt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray($t[k])?V=$t[k][X]:V=$t[k],dt=!0):w.samples>0&&C.useMultisampledRTT(w)===!1?V=kt.get(w).__webglMultisampledFramebuffer:Array.isArray($t)?V=$t[X]:V=$t,T.copy(w.viewport),W.copy(w.scissor),H=w.scissorTest}else T.copy(mt).multiplyScalar(Q).floor(),W.copy(ft).multiplyScalar(Q).floor(),H=Wt;if(Nt.bindFramebuffer(G.FRAMEBUFFER,V)&&Z&&Nt.drawBuffers(w,V),Nt.viewport(T),Nt.scissor(W),Nt.setScissorTest(H),dt){let Dt=kt.get(w.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+k,Dt.__webglTexture,X)}else if(bt){let Dt=kt.get(w.texture),Xt=k||0;G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,Dt.__webglTexture,X||0,Xt)}A=-1},this.readRenderTargetPixels=function(w,k,X,Z,V,dt,bt){if(!(w&&w.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=kt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&bt!==void 0&&(Ft=Ft[bt]),Ft){Nt.bindFramebuffer(G.FRAMEBUFFER,Ft);try{let Dt=w.texture,Xt=Dt.format,$t=Dt.type;if(!Jt.textureFormatReadable(Xt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Jt.textureTypeReadable($t)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=w.width-Z&&X>=0&&X<=w.height-V&&G.readPixels(k,X,Z,V,Yt.convert(Xt),Yt.convert($t),dt)}finally{let Dt=F!==null?kt.get(F).__webglFramebuffer:null;Nt.bindFramebuffer(G.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(w,k,X,Z,V,dt,bt){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=kt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&bt!==void 0&&(Ft=Ft[bt]),Ft){let Dt=w.texture,Xt=Dt.format,$t=Dt.type;if(!Jt.textureFormatReadable(Xt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Jt.textureTypeReadable($t))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(k>=0&&k<=w.width-Z&&X>=0&&X<=w.height-V){Nt.bindFramebuffer(G.FRAMEBUFFER,Ft);let Ot=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,Ot),G.bufferData(G.PIXEL_PACK_BUFFER,dt.byteLength,G.STREAM_READ),G.readPixels(k,X,Z,V,Yt.convert(Xt),Yt.convert($t),0);let ue=F!==null?kt.get(F).__webglFramebuffer:null;Nt.bindFramebuffer(G.FRAMEBUFFER,ue);let we=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await __(G,we,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,Ot),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,dt),G.deleteBuffer(Ot),G.deleteSync(we),dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(w,k=null,X=0){w.isTexture!==!0&&(ta("WebGLRenderer: copyFramebufferToTexture function signature has changed."),k=arguments[0]||null,w=arguments[1]);let Z=Math.pow(2,-X),V=Math.floor(w.image.width*Z),dt=Math.floor(w.image.height*Z),bt=k!==null?k.x:0,Ft=k!==null?k.y:0;C.setTexture2D(w,0),G.copyTexSubImage2D(G.TEXTURE_2D,X,0,0,bt,Ft,V,dt),Nt.unbindTexture()},this.copyTextureToTexture=function(w,k,X=null,Z=null,V=0){w.isTexture!==!0&&(ta("WebGLRenderer: copyTextureToTexture function signature has changed."),Z=arguments[0]||null,w=arguments[1],k=arguments[2],V=arguments[3]||0,X=null);let dt,bt,Ft,Dt,Xt,$t,Ot,ue,we,Ae=w.isCompressedTexture?w.mipmaps[V]:w.image;X!==null?(dt=X.max.x-X.min.x,bt=X.max.y-X.min.y,Ft=X.isBox3?X.max.z-X.min.z:1,Dt=X.min.x,Xt=X.min.y,$t=X.isBox3?X.min.z:0):(dt=Ae.width,bt=Ae.height,Ft=Ae.depth||1,Dt=0,Xt=0,$t=0),Z!==null?(Ot=Z.x,ue=Z.y,we=Z.z):(Ot=0,ue=0,we=0);let mn=Yt.convert(k.format),me=Yt.convert(k.type),Rt;k.isData3DTexture?(C.setTexture3D(k,0),Rt=G.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(C.setTexture2DArray(k,0),Rt=G.TEXTURE_2D_ARRAY):(C.setTexture2D(k,0),Rt=G.TEXTURE_2D),G.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,k.flipY),G.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),G.pixelStorei(G.UNPACK_ALIGNMENT,k.unpackAlignment);let si=G.getParameter(G.UNPACK_ROW_LENGTH),ge=G.getParameter(G.UNPACK_IMAGE_HEIGHT),Pn=G.getParameter(G.UNPACK_SKIP_PIXELS),Xi=G.getParameter(G.UNPACK_SKIP_ROWS),In=G.getParameter(G.UNPACK_SKIP_IMAGES);G.pixelStorei(G.UNPACK_ROW_LENGTH,Ae.width),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Ae.height),G.pixelStorei(G.UNPACK_SKIP_PIXELS,Dt),G.pixelStorei(G.UNPACK_SKIP_ROWS,Xt),G.pixelStorei(G.UNPACK_SKIP_IMAGES,$t);let Ns=w.isDataArrayTexture||w.isData3DTexture,De=k.isDataArrayTexture||k.isData3DTexture;if(w.isRenderTargetTexture||w.isDepthTexture){let qn=kt.get(w),fs=kt.get(k),zn=kt.get(qn.__renderTarget),vi=kt.get(fs.__renderTarget);Nt.bindFramebuffer(G.READ_FRAMEBUFFER,zn.__webglFramebuffer),Nt.bindFramebuffer(G.DRAW_FRAMEBUFFER,vi.__webglFramebuffer);for(let ri=0;ri<Ft;ri++)Ns&&G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,kt.get(w).__webglTexture,V,$t+ri),w.isDepthTexture?(De&&G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,kt.get(k).__webglTexture,V,we+ri),G.blitFramebuffer(Dt,Xt,dt,bt,Ot,ue,dt,bt,G.DEPTH_BUFFER_BIT,G.NEAREST)):De?G.copyTexSubImage3D(Rt,V,Ot,ue,we+ri,Dt,Xt,dt,bt):G.copyTexSubImage2D(Rt,V,Ot,ue,we+ri,Dt,Xt,dt,bt);Nt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Nt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else De?w.isDataTexture||w.isData3DTexture?G.texSubImage3D(Rt,V,Ot,ue,we,dt,bt,Ft,mn,me,Ae.data):k.isCompressedArrayTexture?G.compressedTexSubImage3D(Rt,V,Ot,ue,we,dt,bt,Ft,mn,Ae.data):G.texSubImage3D(Rt,V,Ot,ue,we,dt,bt,Ft,mn,me,Ae):w.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,V,Ot,ue,dt,bt,mn,me,Ae.data):w.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,V,Ot,ue,Ae.width,Ae.height,mn,Ae.data):G.texSubImage2D(G.TEXTURE_2D,V,Ot,ue,dt,bt,mn,me,Ae);G.pixelStorei(G.UNPACK_ROW_LENGTH,si),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,ge),G.pixelStorei(G.UNPACK_SKIP_PIXELS,Pn),G.pixelStorei(G.UNPACK_SKIP_ROWS,Xi),G.pixelStorei(G.UNPACK_SKIP_IMAGES,In),V===0&&k.generateMipmaps&&G.generateMipmap(Rt),Nt.unbindTexture()},this.copyTextureToTexture3D=function(w,k,X=null,Z=null,V=0){return w.isTexture!==!0&&(ta("WebGLRenderer: copyTextureToTexture3D function signature has changed."),X=arguments[0]||null,Z=arguments[1]||null,w=arguments[2],k=arguments[3],V=arguments[4]||0),ta('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(w,k,X,Z,V)},this.initRenderTarget=function(w){kt.get(w).__webglFramebuffer===void 0&&C.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?C.setTextureCube(w,0):w.isData3DTexture?C.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?C.setTexture2DArray(w,0):C.setTexture2D(w,0),Nt.unbindTexture()},this.resetState=function(){P=0,I=0,F=null,Nt.reset(),_e.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return is}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorspace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var xo=class extends ni{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ls,this.environmentIntensity=1,this.environmentRotation=new ls,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};var Wl=class extends kn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=ti,h=ti,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ar=class extends Ve{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}};var ua=class extends Ps{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Xl=new N,ql=new N,tg=new Xe,Qo=new or,xl=new rr,iu=new N,eg=new N,cd=class extends ni{constructor(t=new $e,e=new ua){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Xl.fromBufferAttribute(e,s-1),ql.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Xl.distanceTo(ql);t.setAttribute("lineDistance",new Ke(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),xl.copy(n.boundingSphere),xl.applyMatrix4(s),xl.radius+=r,t.ray.intersectsSphere(xl)===!1)return;tg.copy(s).invert(),Qo.copy(t.ray).applyMatrix4(tg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let p=h.getX(y),E=h.getX(y+1),S=_l(this,t,Qo,l,p,E);S&&e.push(S)}if(this.isLineLoop){let y=h.getX(g-1),m=h.getX(f),p=_l(this,t,Qo,l,y,m);p&&e.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let p=_l(this,t,Qo,l,y,y+1);p&&e.push(p)}if(this.isLineLoop){let y=_l(this,t,Qo,l,g-1,f);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function _l(i,t,e,n,s,r){let o=i.geometry.attributes.position;if(Xl.fromBufferAttribute(o,s),ql.fromBufferAttribute(o,r),e.distanceSqToSegment(Xl,ql,iu,eg)>n)return;iu.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(iu);if(!(l<t.near||l>t.far))return{distance:l,point:eg.clone().applyMatrix4(i.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:i}}var ng=new N,ig=new N,Yl=class extends cd{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)ng.fromBufferAttribute(e,s),ig.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+ng.distanceTo(ig);t.setAttribute("lineDistance",new Ke(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var hd=class extends Ps{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new he(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},sg=new Xe,ud=new or,bl=new rr,Ml=new N,$l=class extends ni{constructor(t=new $e,e=new hd){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),bl.copy(n.boundingSphere),bl.applyMatrix4(s),bl.radius+=r,t.ray.intersectsSphere(bl)===!1)return;sg.copy(s).invert(),ud.copy(t.ray).applyMatrix4(sg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,d=n.attributes.position;if(c!==null){let u=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=u,y=f;g<y;g++){let m=c.getX(g);Ml.fromBufferAttribute(d,m),rg(Ml,m,l,s,t,e,this)}}else{let u=Math.max(0,o.start),f=Math.min(d.count,o.start+o.count);for(let g=u,y=f;g<y;g++)Ml.fromBufferAttribute(d,g),rg(Ml,g,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function rg(i,t,e,n,s,r,o){let a=ud.distanceSqToPoint(i);if(a<e){let l=new N;ud.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var mi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200}getPoint(){return console.warn("THREE.Curve: .getPoint() not implemented."),null}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],u=n[s+1]-h,f=(o-h)/u;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new At:new N);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e){let n=new N,s=[],r=[],o=[],a=new N,l=new Xe;for(let f=0;f<=t;f++){let g=f/t;s[f]=this.getTangentAt(g,new N)}r[0]=new N,o[0]=new N;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),d=Math.abs(s[0].y),u=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),d<=c&&(c=d,n.set(0,1,0)),u<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(hn(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,g))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(hn(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let g=1;g<=t;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],f*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}toJSON(){let t={metadata:{version:4.6,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}},da=class extends mi{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new At){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),d=Math.sin(this.aRotation),u=l-this.aX,f=c-this.aY;l=u*h-f*d+this.aX,c=u*d+f*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},dd=class extends da{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function zd(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,d){let u=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+d)+(l-a)/d;u*=h,f*=h,s(o,a,u,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var wl=new N,su=new zd,ru=new zd,ou=new zd,fd=class extends mi{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new N){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(wl.subVectors(s[0],s[1]).add(s[0]),c=wl);let d=s[a%r],u=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(wl.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=wl),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(d),f),y=Math.pow(d.distanceToSquared(u),f),m=Math.pow(u.distanceToSquared(h),f);y<1e-4&&(y=1),g<1e-4&&(g=y),m<1e-4&&(m=y),su.initNonuniformCatmullRom(c.x,d.x,u.x,h.x,g,y,m),ru.initNonuniformCatmullRom(c.y,d.y,u.y,h.y,g,y,m),ou.initNonuniformCatmullRom(c.z,d.z,u.z,h.z,g,y,m)}else this.curveType==="catmullrom"&&(su.initCatmullRom(c.x,d.x,u.x,h.x,this.tension),ru.initCatmullRom(c.y,d.y,u.y,h.y,this.tension),ou.initCatmullRom(c.z,d.z,u.z,h.z,this.tension));return n.set(su.calc(l),ru.calc(l),ou.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new N().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function og(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function g1(i,t){let e=1-i;return e*e*t}function v1(i,t){return 2*(1-i)*i*t}function y1(i,t){return i*i*t}function ra(i,t,e,n){return g1(i,t)+v1(i,e)+y1(i,n)}function x1(i,t){let e=1-i;return e*e*e*t}function _1(i,t){let e=1-i;return 3*e*e*i*t}function b1(i,t){return 3*(1-i)*i*i*t}function M1(i,t){return i*i*i*t}function oa(i,t,e,n,s){return x1(i,t)+_1(i,e)+b1(i,n)+M1(i,s)}var Zl=class extends mi{constructor(t=new At,e=new At,n=new At,s=new At){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new At){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(oa(t,s.x,r.x,o.x,a.x),oa(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},pd=class extends mi{constructor(t=new N,e=new N,n=new N,s=new N){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new N){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(oa(t,s.x,r.x,o.x,a.x),oa(t,s.y,r.y,o.y,a.y),oa(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Jl=class extends mi{constructor(t=new At,e=new At){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new At){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new At){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},md=class extends mi{constructor(t=new N,e=new N){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new N){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new N){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Kl=class extends mi{constructor(t=new At,e=new At,n=new At){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new At){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ra(t,s.x,r.x,o.x),ra(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},gd=class extends mi{constructor(t=new N,e=new N,n=new N){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new N){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ra(t,s.x,r.x,o.x),ra(t,s.y,r.y,o.y),ra(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},jl=class extends mi{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new At){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],d=s[o>s.length-3?s.length-1:o+2];return n.set(og(a,l.x,c.x,h.x,d.x),og(a,l.y,c.y,h.y,d.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new At().fromArray(s))}return this}},ag=Object.freeze({__proto__:null,ArcCurve:dd,CatmullRomCurve3:fd,CubicBezierCurve:Zl,CubicBezierCurve3:pd,EllipseCurve:da,LineCurve:Jl,LineCurve3:md,QuadraticBezierCurve:Kl,QuadraticBezierCurve3:gd,SplineCurve:jl}),vd=class extends mi{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new ag[n](e,t))}return this}getPoint(t,e){let n=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(e.push(h),n=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(new ag[s.type]().fromJSON(s))}return this}},yd=class extends vd{constructor(t){super(),this.type="Path",this.currentPoint=new At,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let n=new Jl(this.currentPoint.clone(),new At(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){let r=new Kl(this.currentPoint.clone(),new At(t,e),new At(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){let a=new Zl(this.currentPoint.clone(),new At(t,e),new At(n,s),new At(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),n=new jl(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){let c=new da(t,e,n,s,r,o,a,l);if(this.curves.length>0){let d=c.getPoint(0);d.equals(this.currentPoint)||this.lineTo(d.x,d.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},xd=class i extends $e{constructor(t=[new At(0,-.5),new At(.5,0),new At(0,.5)],e=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:n,phiLength:s},e=Math.floor(e),s=hn(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/e,d=new N,u=new At,f=new N,g=new N,y=new N,m=0,p=0;for(let E=0;E<=t.length-1;E++)switch(E){case 0:m=t[E+1].x-t[E].x,p=t[E+1].y-t[E].y,f.x=p*1,f.y=-m,f.z=p*0,y.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:l.push(y.x,y.y,y.z);break;default:m=t[E+1].x-t[E].x,p=t[E+1].y-t[E].y,f.x=p*1,f.y=-m,f.z=p*0,g.copy(f),f.x+=y.x,f.y+=y.y,f.z+=y.z,f.normalize(),l.push(f.x,f.y,f.z),y.copy(g)}for(let E=0;E<=e;E++){let S=n+E*h*s,M=Math.sin(S),D=Math.cos(S);for(let P=0;P<=t.length-1;P++){d.x=t[P].x*M,d.y=t[P].y,d.z=t[P].x*D,o.push(d.x,d.y,d.z),u.x=E/e,u.y=P/(t.length-1),a.push(u.x,u.y);let I=l[3*P+0]*M,F=l[3*P+1],A=l[3*P+0]*D;c.push(I,F,A)}}for(let E=0;E<e;E++)for(let S=0;S<t.length-1;S++){let M=S+E*t.length,D=M,P=M+t.length,I=M+t.length+1,F=M+1;r.push(D,P,F),r.push(I,F,P)}this.setIndex(r),this.setAttribute("position",new Ke(o,3)),this.setAttribute("uv",new Ke(a,2)),this.setAttribute("normal",new Ke(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.points,t.segments,t.phiStart,t.phiLength)}},Ql=class i extends xd{constructor(t=1,e=1,n=4,s=8){let r=new yd;r.absarc(0,-e/2,t,Math.PI*1.5,0),r.absarc(0,e/2,t,0,Math.PI*.5),super(r.getPoints(n),s),this.type="CapsuleGeometry",this.parameters={radius:t,length:e,capSegments:n,radialSegments:s}}static fromJSON(t){return new i(t.radius,t.length,t.capSegments,t.radialSegments)}};var lr=class i extends $e{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],f=[],g=0,y=[],m=n/2,p=0;E(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new Ke(d,3)),this.setAttribute("normal",new Ke(u,3)),this.setAttribute("uv",new Ke(f,2));function E(){let M=new N,D=new N,P=0,I=(e-t)/n;for(let F=0;F<=r;F++){let A=[],b=F/r,T=b*(e-t)+t;for(let W=0;W<=s;W++){let H=W/s,q=H*l+a,J=Math.sin(q),$=Math.cos(q);D.x=T*J,D.y=-b*n+m,D.z=T*$,d.push(D.x,D.y,D.z),M.set(J,I,$).normalize(),u.push(M.x,M.y,M.z),f.push(H,1-b),A.push(g++)}y.push(A)}for(let F=0;F<s;F++)for(let A=0;A<r;A++){let b=y[A][F],T=y[A+1][F],W=y[A+1][F+1],H=y[A][F+1];(t>0||A!==0)&&(h.push(b,T,H),P+=3),(e>0||A!==r-1)&&(h.push(T,W,H),P+=3)}c.addGroup(p,P,0),p+=P}function S(M){let D=g,P=new At,I=new N,F=0,A=M===!0?t:e,b=M===!0?1:-1;for(let W=1;W<=s;W++)d.push(0,m*b,0),u.push(0,b,0),f.push(.5,.5),g++;let T=g;for(let W=0;W<=s;W++){let q=W/s*l+a,J=Math.cos(q),$=Math.sin(q);I.x=A*$,I.y=m*b,I.z=A*J,d.push(I.x,I.y,I.z),u.push(0,b,0),P.x=J*.5+.5,P.y=$*.5*b+.5,f.push(P.x,P.y),g++}for(let W=0;W<s;W++){let H=D+W,q=T+W;M===!0?h.push(q,q+1,H):h.push(q+1,q,H),F+=3}c.addGroup(p,F,M===!0?1:2),p+=F}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},_o=class i extends lr{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var tc=class i extends $e{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new N,u=new N,f=[],g=[],y=[],m=[];for(let p=0;p<=n;p++){let E=[],S=p/n,M=0;p===0&&o===0?M=.5/e:p===n&&l===Math.PI&&(M=-.5/e);for(let D=0;D<=e;D++){let P=D/e;d.x=-t*Math.cos(s+P*r)*Math.sin(o+S*a),d.y=t*Math.cos(o+S*a),d.z=t*Math.sin(s+P*r)*Math.sin(o+S*a),g.push(d.x,d.y,d.z),u.copy(d).normalize(),y.push(u.x,u.y,u.z),m.push(P+M,1-S),E.push(c++)}h.push(E)}for(let p=0;p<n;p++)for(let E=0;E<e;E++){let S=h[p][E+1],M=h[p][E],D=h[p+1][E],P=h[p+1][E+1];(p!==0||o>0)&&f.push(S,M,P),(p!==n-1||l<Math.PI)&&f.push(M,D,P)}this.setIndex(f),this.setAttribute("position",new Ke(g,3)),this.setAttribute("normal",new Ke(y,3)),this.setAttribute("uv",new Ke(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function Sl(i,t,e){return!i||!e&&i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function w1(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var bo=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},_d=class extends bo{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:sm,endingEnd:sm}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case rm:r=t,a=2*e-n;break;case om:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case rm:o=t,l=2*n-e;break;case om:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,g=(n-e)/(s-e),y=g*g,m=y*g,p=-u*m+2*u*y-u*g,E=(1+u)*m+(-1.5-2*u)*y+(-.5+u)*g+1,S=(-1-f)*m+(1.5+f)*y+.5*g,M=f*m-f*y;for(let D=0;D!==a;++D)r[D]=p*o[h+D]+E*o[c+D]+S*o[l+D]+M*o[d+D];return r}},bd=class extends bo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},Md=class extends bo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Ci=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Sl(e,this.TimeBufferType),this.values=Sl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Sl(t.times,Array),values:Sl(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s)}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Md(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new bd(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new _d(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case Pl:e=this.InterpolantFactoryMethodDiscrete;break;case qu:e=this.InterpolantFactoryMethodLinear;break;case Ph:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Pl;case this.InterpolantFactoryMethodLinear:return qu;case this.InterpolantFactoryMethodSmooth:return Ph}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&w1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Ph,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*n,u=d-n,f=d+n;for(let g=0;g!==n;++g){let y=e[d+g];if(y!==e[u+g]||y!==e[f+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)e[u+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};Ci.prototype.TimeBufferType=Float32Array;Ci.prototype.ValueBufferType=Float32Array;Ci.prototype.DefaultInterpolation=qu;var cr=class extends Ci{constructor(t,e,n){super(t,e,n)}};cr.prototype.ValueTypeName="bool";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Pl;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var wd=class extends Ci{};wd.prototype.ValueTypeName="color";var Sd=class extends Ci{};Sd.prototype.ValueTypeName="number";var Ed=class extends bo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Bn.slerpFlat(r,0,o,c-a,o,c,l);return r}},ec=class extends Ci{InterpolantFactoryMethodLinear(t){return new Ed(this.times,this.values,this.getValueSize(),t)}};ec.prototype.ValueTypeName="quaternion";ec.prototype.InterpolantFactoryMethodSmooth=void 0;var hr=class extends Ci{constructor(t,e,n){super(t,e,n)}};hr.prototype.ValueTypeName="string";hr.prototype.ValueBufferType=Array;hr.prototype.DefaultInterpolation=Pl;hr.prototype.InterpolantFactoryMethodLinear=void 0;hr.prototype.InterpolantFactoryMethodSmooth=void 0;var Ad=class extends Ci{};Ad.prototype.ValueTypeName="vector";var Td=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],g=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null}}},S1=new Td,Cd=class{constructor(t){this.manager=t!==void 0?t:S1,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}};Cd.DEFAULT_MATERIAL_NAME="__DEFAULT";var Mo=class extends $e{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Vd="\\[\\]\\.:\\/",E1=new RegExp("["+Vd+"]","g"),Hd="[^"+Vd+"]",A1="[^"+Vd.replace("\\.","")+"]",T1=/((?:WC+[\/:])*)/.source.replace("WC",Hd),C1=/(WCOD+)?/.source.replace("WCOD",A1),R1=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Hd),P1=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Hd),I1=new RegExp("^"+T1+C1+R1+P1+"$"),L1=["material","materials","bones","map"],Rd=class{constructor(t,e,n){let s=n||We.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},We=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(E1,"")}static parseTrackName(t){let e=I1.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);L1.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.needsUpdate!==void 0?a=this.Versioning.NeedsUpdate:t.matrixWorldNeedsUpdate!==void 0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};We.Composite=Rd;We.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};We.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};We.prototype.GetterByBindingType=[We.prototype._getValue_direct,We.prototype._getValue_array,We.prototype._getValue_arrayElement,We.prototype._getValue_toArray];We.prototype.SetterByBindingTypeAndVersioning=[[We.prototype._setValue_direct,We.prototype._setValue_direct_setNeedsUpdate,We.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[We.prototype._setValue_array,We.prototype._setValue_array_setNeedsUpdate,We.prototype._setValue_array_setMatrixWorldNeedsUpdate],[We.prototype._setValue_arrayElement,We.prototype._setValue_arrayElement_setNeedsUpdate,We.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[We.prototype._setValue_fromArray,We.prototype._setValue_fromArray_setNeedsUpdate,We.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var CA=new Float32Array(1);var fa=class{constructor(t=1,e=0,n=0){return this.radius=t,this.phi=e,this.theta=n,this}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Math.max(1e-6,Math.min(Math.PI-1e-6,this.phi)),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(hn(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var nc=class extends as{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(){}disconnect(){}dispose(){}update(){}};typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Pd}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Pd);function Lg(i,t=!1){let e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new $e,c=0;for(let h=0;h<i.length;++h){let d=i[h],u=0;if(e!==(d.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let f in d.attributes){if(!n.has(f))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+f+'" attribute exists among all geometries, or in none of them.'),null;r[f]===void 0&&(r[f]=[]),r[f].push(d.attributes[f]),u++}if(u!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==d.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let f in d.morphAttributes){if(!s.has(f))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;o[f]===void 0&&(o[f]=[]),o[f].push(d.morphAttributes[f])}if(t){let f;if(e)f=d.index.count;else if(d.attributes.position!==void 0)f=d.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,f,h),c+=f}}if(e){let h=0,d=[];for(let u=0;u<i.length;++u){let f=i[u].index;for(let g=0;g<f.count;++g)d.push(f.getX(g)+h);h+=i[u].attributes.position.count}l.setIndex(d)}for(let h in r){let d=Ig(r[h]);if(!d)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,d)}for(let h in o){let d=o[h][0].length;if(d===0)break;l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let u=0;u<d;++u){let f=[];for(let y=0;y<o[h].length;++y)f.push(o[h][y][u]);let g=Ig(f);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(g)}}return l}function Ig(i){let t,e,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new Ve(o,e,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let d=l/e;for(let u=0,f=h.count;u<f;u++)for(let g=0;g<e;g++){let y=h.getComponent(u,g);a.setComponent(u+d,g,y)}}else o.set(h.array,l);l+=h.count*e}return s!==void 0&&(a.gpuType=s),a}var ma=`
vec3 turn(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }`,Dg=`
uniform mat4 uShadowMatrix; uniform highp sampler2DShadow uShadowMap; uniform float uShadows; uniform float uTexel;
float lightAt(vec3 world, vec3 normal) {
  if (uShadows < 0.5) return 1.0;
  vec3 at = (uShadowMatrix * vec4(world + 2.0 * uTexel * normal, 1.0)).xyz;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
  if (uShadows < 1.5) return texture(uShadowMap, at);
  vec2 size = vec2(textureSize(uShadowMap, 0));
  float sum = 0.0;
  for (int i = 0; i < 16; ++i) {
    vec2 off = 2.6 * (vec2(i & 3, i >> 2) - 1.5);
    sum += texture(uShadowMap, vec3(at.xy + off / size, at.z));
  }
  return sum / 16.0;
}`,Ug=`
uniform vec3 uUp; uniform vec3 uLight;
${Dg}
vec3 shade(vec3 color, vec3 normal, vec3 toEye, vec3 world, float kind) {
  float sky = 0.5 + 0.5 * dot(normal, uUp);
  float direct = max(dot(normal, uLight), 0.0);
  float light = direct > 0.0 ? lightAt(world, normal) : 0.0;
  float facing = max(dot(normal, toEye), 0.0);
  float gloss = pow(max(dot(normal, normalize(uLight + toEye)), 0.0), kind == 1.0 ? 90.0 : 36.0) * light;
  vec3 diffuse = color * (0.34 + 0.26 * sky + 0.10 * facing + 0.46 * direct * light);
  if (kind == 1.0) {
    vec3 mirrored = reflect(-toEye, normal);
    float horizon = smoothstep(-0.25, 0.35, dot(mirrored, uUp));
    diffuse = mix(diffuse, color * mix(0.55, 1.2, horizon) * (0.8 + 0.2 * light), 0.55);
  }
  float strength = kind == 1.0 ? 0.55 : kind == 3.0 ? 0.03 : kind == 2.0 ? 0.07 : kind == 4.0 ? 0.02 : kind == 5.0 ? 0.5 : 0.14;
  return diffuse + strength * gloss;
}`,Ng=`
float hash(vec3 p) {
  p = fract(p * 0.3183099 + 0.1);
  p *= 17.0;
  return fract(p.x * p.y * p.z * (p.x + p.y + p.z));
}
float noise(vec3 x) {
  vec3 i = floor(x), f = fract(x);
  f = f * f * (3.0 - 2.0 * f);
  vec2 d = vec2(0.0, 1.0);
  return mix(mix(mix(hash(i), hash(i + d.yxx), f.x), mix(hash(i + d.xyx), hash(i + d.yyx), f.x), f.y),
             mix(mix(hash(i + d.xxy), hash(i + d.yxy), f.x), mix(hash(i + d.xyy), hash(i + d.yyy), f.x), f.y), f.z);
}
vec3 surface(vec3 color, float kind, vec3 place, float body) {
  float fine = length(fwidth(place));
  if (kind == 2.0) {
    vec3 p = place + vec3(0.37, 1.61, 0.0) + 0.13 * mod(body, 7.0);
    float ring = 5.0 * length(p.xy + 0.12 * vec2(noise(3.0 * p), noise(3.0 * p + 9.0)));
    float grain = 0.5 + 0.5 * sin(6.2831853 * ring);
    return color * (1.0 - 0.17 * grain * (1.0 - smoothstep(0.03, 0.12, fine)));
  }
  if (kind == 4.0) {
    float speckle = 0.6 * noise(7.0 * place + body) + 0.4 * noise(19.0 * place);
    return color * (1.0 + 0.28 * (speckle - 0.5) * (1.0 - smoothstep(0.05, 0.2, fine)));
  }
  return color;
}`,Fg=`
uniform float uPick;
uniform float uGhost;
uniform vec4 uTint;
uniform vec3 uSelected;
uniform vec3 uWarning;
out vec4 fragment;
vec3 heat(float t) {
  vec3 cold = vec3(0.16, 0.20, 0.42), warm = vec3(0.80, 0.28, 0.36), hot = vec3(0.99, 0.88, 0.42);
  return t < 0.5 ? mix(cold, warm, 2.0 * t) : mix(warm, hot, 2.0 * t - 1.0);
}
vec4 finish(vec3 color, vec3 normal, vec3 toEye, vec3 world, float body, float mark, float kind, float edge) {
  if (uPick > 0.5) {
    if (mark > 2.5 && mark < 3.5 || uPick > 1.5 && body < 0.0) discard;
    float number = body < 0.0 ? -body : body + 1.0;
    return vec4(mod(number, 256.0), mod(floor(number / 256.0), 256.0), floor(number / 65536.0), 255.0) / 255.0;
  }
  if (mark > 3.5) { color = heat(mark - 4.0); kind = 0.0; }
  vec3 base = mix(color, uTint.rgb, uTint.a);
  vec3 lit = shade(base, normal, toEye, world, kind) * (1.0 - 0.22 * edge);
  float rim = 1.0 - max(dot(normal, toEye), 0.0);
  if (uGhost > 0.5) return vec4(mix(lit, uTint.rgb, 0.6), max(0.20, max(0.85 * edge, smoothstep(0.35, 0.85, rim))));
  if (mark > 2.5 && mark < 3.5) return vec4(mix(lit, vec3(1.0), 0.25), max(0.26, 0.8 * edge));
  if (mark > 1.5 && mark < 2.5) lit = mix(lit, uWarning, 0.55);
  else if (mark > 0.5 && mark < 1.5) lit = mix(lit, uSelected, 0.25 + 0.75 * max(edge, smoothstep(0.45, 0.75, rim)));
  return vec4(lit, 1.0);
}`,Ao=2048,To=`
in float shapeIndex;
uniform highp sampler2D uPose; uniform highp sampler2D uLook;
flat out vec3 vColor; flat out vec3 vMark;
vec3 iPosition; vec4 iOrientation; vec3 iScale;
void readShape() {
  int at = 2 * int(shapeIndex + 0.5);
  ivec2 first = ivec2(at % ${Ao}, at / ${Ao}), second = first + ivec2(1, 0);
  vec4 place = texelFetch(uPose, first, 0), size = texelFetch(uLook, first, 0);
  iPosition = place.xyz; iOrientation = texelFetch(uPose, second, 0); iScale = size.xyz;
  vec4 color = texelFetch(uLook, second, 0);
  vColor = color.rgb; vMark = vec3(size.w, place.w, color.a);
}`,Og=`${To}${ma}
out vec3 vNormal; out vec3 vWorld; out vec3 vOwn; out vec3 vPlace;
uniform float uSize;
void main() {
  readShape();
  vNormal = turn(iOrientation, normalize(normal / iScale));
  vOwn = position;
  vPlace = position * iScale / (uSize * max(iScale.x, max(iScale.y, iScale.z)));
  vWorld = iPosition + turn(iOrientation, position * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`,kg=`${To}${ma}
out vec3 vNormal; out vec3 vWorld; out vec3 vOwn; out vec3 vPlace;
void main() {
  readShape();
  vec3 eye = turn(vec4(-iOrientation.xyz, iOrientation.w), cameraPosition - iPosition);
  vOwn = position * vec3(eye.x < 0.0 ? -1.0 : 1.0, eye.y < 0.0 ? -1.0 : 1.0, eye.z < 0.0 ? -1.0 : 1.0);
  vPlace = vOwn * iScale / max(iScale.x, max(iScale.y, iScale.z));
  vNormal = vec3(0.0);
  vWorld = iPosition + turn(iOrientation, vOwn * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`,Bg=`
flat in vec3 vColor; flat in vec3 vMark; in vec3 vNormal; in vec3 vWorld; in vec3 vOwn; in vec3 vPlace;
${Ug}${Ng}${Fg}
uniform float uIsRound; uniform float uIsFlat;
/** 1 within a pixel of the edge between two faces of a box. */
float edgeOfBox() {
  vec3 off = 1.0 - abs(vOwn);
  float nearest = max(min(off.x, off.y), min(max(off.x, off.y), off.z));
  float pixels = fwidth(nearest);
  return (1.0 - smoothstep(0.6, 1.5, nearest / max(pixels, 1e-6))) * (1.0 - smoothstep(0.08, 0.3, pixels));
}
void main() {
  vec3 toEye = normalize(cameraPosition - vWorld);
  vec3 normal = normalize(uIsFlat > 0.5 ? cross(dFdx(vWorld), dFdy(vWorld)) : vNormal);
  if (dot(normal, toEye) < 0.0 && uIsFlat > 0.5) normal = -normal;
  vec3 color = surface(vColor, vMark.z, vPlace, vMark.x) * (uIsRound > 0.5 && vOwn.x * vOwn.y > 0.0 ? 0.84 : 1.0);
  fragment = finish(color, normal, toEye, vWorld, vMark.x, vMark.y, vMark.z, uIsFlat > 0.5 ? edgeOfBox() : 0.0);
}`,zg=`${To}
out vec3 vRay; flat out vec3 vCenter; flat out vec4 vTurn; flat out float vRadius;
void main() {
  readShape();
  vTurn = iOrientation; vRadius = iScale.x;
  vCenter = (viewMatrix * vec4(iPosition, 1.0)).xyz;
  float d2 = dot(vCenter, vCenter);
  float reach = 1.03 * vRadius * sqrt(d2 / max(d2 - vRadius * vRadius, 1e-6 * d2));
  vec3 z = -vCenter / sqrt(d2);
  vec3 x = normalize(cross(abs(z.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0), z));
  vRay = vCenter + reach * (position.x * x + position.y * cross(z, x));
  gl_Position = projectionMatrix * vec4(vRay, 1.0);
}`,Vg=`
flat in vec3 vColor; flat in vec3 vMark; in vec3 vRay; flat in vec3 vCenter; flat in vec4 vTurn; flat in float vRadius;
uniform mat4 projectionMatrix;
${ma}${Ug}${Ng}${Fg}
void main() {
  vec3 ray = normalize(vRay);
  float along = dot(ray, vCenter);
  // How far the ray passes from the middle, in radii, and over how much of that a pixel spreads.
  float passes = sqrt(max(dot(vCenter, vCenter) - along * along, 0.0)) / vRadius;
  float pixel = max(fwidth(passes), 1e-6);
  float cover = clamp((1.0 - passes) / pixel + 0.5, 0.0, 1.0);
  if (cover <= (uPick > 0.5 ? 0.5 : 0.0)) discard;
  vec3 hit = (along - vRadius * sqrt(max(1.0 - passes * passes, 0.0))) * ray;
  mat3 toWorld = transpose(mat3(viewMatrix));
  vec3 normal = normalize(toWorld * ((hit - vCenter) / vRadius));
  vec3 own = turn(vec4(-vTurn.xyz, vTurn.w), normal);
  vec3 color = surface(vColor, vMark.z, own, vMark.x) * (own.x * own.y * own.z > 0.0 ? 1.0 : 0.82);
  vec3 world = toWorld * hit + cameraPosition;
  fragment = finish(color, normal, -(toWorld * ray), world, vMark.x, vMark.y, vMark.z, 0.0);
  if (uPick < 0.5) fragment.a *= cover;
  vec4 clip = projectionMatrix * vec4(hit, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
}`,Hg=`${To}${ma}
void main() {
  readShape();
  vec3 world = iPosition + turn(iOrientation, position * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
  if (vMark.y > 2.5 && vMark.y < 3.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`,Gg=`${To}${ma}
uniform vec3 uLight;
void main() {
  readShape();
  vec3 light = turn(vec4(-iOrientation.xyz, iOrientation.w), uLight);
  vec3 own = position * vec3(light.x < 0.0 ? 1.0 : -1.0, light.y < 0.0 ? 1.0 : -1.0, light.z < 0.0 ? 1.0 : -1.0);
  gl_Position = projectionMatrix * viewMatrix * vec4(iPosition + turn(iOrientation, own * iScale), 1.0);
  if (vMark.y > 2.5 && vMark.y < 3.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`,Wg=`${To}
uniform vec3 uLight;
out vec2 vAcross;
void main() {
  readShape();
  vAcross = position.xy;
  vec3 x = normalize(cross(abs(uLight.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0), uLight));
  vec3 world = iPosition + iScale.x * (position.x * x + position.y * cross(uLight, x));
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
  if (vMark.y > 2.5 && vMark.y < 3.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`,Xg=`
out vec4 fragment;
void main() { fragment = vec4(1.0); }`,qg=`
in vec2 vAcross; out vec4 fragment;
void main() {
  if (dot(vAcross, vAcross) > 1.0) discard;
  fragment = vec4(1.0);
}`,Yg=`
out vec2 vPlace; out vec3 vWorld;
void main() {
  vPlace = position.xy;
  vWorld = (modelMatrix * vec4(position, 1.0)).xyz;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,$g=`
in vec2 vPlace; in vec3 vWorld; out vec4 fragment;
${Dg}
uniform vec3 uColor; uniform vec3 uLine; uniform float uCell; uniform float uReach; uniform vec2 uShift;
float lines(vec2 place, float cell) {
  vec2 at = place / cell;
  vec2 width = fwidth(at);
  vec2 off = abs(fract(at - 0.5) - 0.5) / max(width, 1e-6);
  vec2 seen = (1.0 - min(off, 1.0)) * (1.0 - smoothstep(0.2, 0.6, width));
  return max(seen.x, seen.y);
}
void main() {
  vec2 place = vPlace + uShift;
  float line = max(0.35 * lines(place, uCell), 0.8 * lines(place, 10.0 * uCell));
  float fade = 1.0 - smoothstep(0.35, 1.0, length(vPlace) / uReach);
  float light = mix(0.66, 1.0, lightAt(vWorld, vec3(0.0)));
  fragment = vec4(mix(uColor, uLine, line) * light, 0.96 * fade);
}`,Zg=`
uniform float uBias;
vec4 nearer(vec3 world) {
  vec4 clip = projectionMatrix * viewMatrix * vec4(world, 1.0);
  vec4 eye = viewMatrix * vec4(world, 1.0);
  eye.xyz *= max(1.0 - min(uBias, 1e30) / max(length(eye.xyz), 1e-9), 0.02);
  vec4 moved = projectionMatrix * eye;
  return vec4(clip.xy, moved.z / moved.w * clip.w, clip.w);
}`,Jg=`${Zg}
in float part; in vec3 iStart; in vec3 iVector; in vec3 iColor;
uniform float uPixel;
out vec3 vColor;
void main() {
  float size = length(iVector);
  vec3 z = size > 0.0 ? iVector / size : vec3(0, 0, 1);
  vec3 x = normalize(cross(abs(z.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0), z));
  vec3 y = cross(z, x);
  float pixel = uPixel * max(-(viewMatrix * vec4(iStart, 1.0)).z, 1e-6);
  float head = min(11.0 * pixel, 0.5 * size);
  float width = part > 0.5 ? 4.2 * head / 11.0 : min(1.3 * pixel, 0.1 * size);
  float along = part > 0.5 ? size - head + position.z * head : position.z * (size - 0.8 * head);
  vec3 world = iStart + along * z + width * (position.x * x + position.y * y);
  vColor = iColor * (0.75 + 0.25 * position.x);
  gl_Position = nearer(world);
}`,Kg=`
in vec3 vColor; out vec4 fragment;
void main() { fragment = vec4(vColor, 1.0); }`,jg=`${Zg}
in vec3 color;
out vec3 vColor;
uniform float uRatio; uniform float uPixel; uniform float uDot; uniform float uMost;
void main() {
  vColor = color;
  float away = max(-(viewMatrix * vec4(position, 1.0)).z, 1e-6);
  gl_PointSize = uRatio * clamp(uDot / (uPixel * away), min(3.0, uMost), uMost);
  gl_Position = nearer(position);
}`,Qg=`
in vec3 vColor; out vec4 fragment;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  if (r > 1.0) discard;
  fragment = vec4(r > 0.68 ? vec3(0.05) : vColor, 1.0);
}`;var cs=class{constructor(){this.array=new Float32Array(3*64);this.size=0}push(t,e,n){if(this.size+3>this.array.length){let s=new Float32Array(2*this.array.length);s.set(this.array),this.array=s}this.array[this.size++]=t,this.array[this.size++]=e,this.array[this.size++]=n}},cc=class{constructor(t,e){this.geometry=new Mo;this.start=new cs;this.vector=new cs;this.color=new cs;let n=new lr(1,1,1,6,1,!0).rotateX(Math.PI/2).translate(0,0,.5),s=new _o(1,1,10).rotateX(Math.PI/2).translate(0,0,.5),r=Lg([n,s]),o=n.getAttribute("position").count,a=Float32Array.from({length:r.getAttribute("position").count},(c,h)=>h<o?0:1);this.geometry.index=r.index,this.geometry.setAttribute("position",r.getAttribute("position")),this.geometry.setAttribute("part",new Ve(a,1));let l=new _n({glslVersion:Vi,vertexShader:Jg,fragmentShader:Kg,uniforms:{uPixel:t,uBias:{value:e}},depthWrite:!1,transparent:!0});this.mesh=new Mn(this.geometry,l),this.mesh.frustumCulled=!1,this.mesh.renderOrder=10,this.mesh.layers.enable(0)}clear(){this.start.size=this.vector.size=this.color.size=0}add(t,e,n){this.start.push(t[0],t[1],t[2]),this.vector.push(e[0],e[1],e[2]),this.color.push(...n)}commit(){fr(this.geometry,"iStart",this.start,!0),fr(this.geometry,"iVector",this.vector,!0),fr(this.geometry,"iColor",this.color,!0),this.geometry.instanceCount=this.start.size/3,this.mesh.visible=this.start.size>0}},ga=class{constructor({size:t,most:e,bias:n},s,r){this.geometry=new $e;this.place=new cs;this.color=new cs;let o=new _n({glslVersion:Vi,vertexShader:jg,fragmentShader:Qg,uniforms:{uRatio:r,uPixel:s,uDot:{value:t},uMost:{value:e},uBias:{value:n}},depthWrite:!1,transparent:!0});this.points=new $l(this.geometry,o),this.points.frustumCulled=!1,this.points.renderOrder=11}clear(){this.place.size=this.color.size=0}add(t,e){this.place.push(t[0],t[1],t[2]),this.color.push(...e)}commit(){fr(this.geometry,"position",this.place,!1),fr(this.geometry,"color",this.color,!1),this.geometry.setDrawRange(0,this.place.size/3),this.points.visible=this.place.size>0}},pr=class{constructor(){this.geometry=new $e;this.place=new cs;this.color=new cs;this.lines=new Yl(this.geometry,new ua({vertexColors:!0,toneMapped:!1})),this.lines.frustumCulled=!1,this.lines.renderOrder=5}clear(){this.place.size=this.color.size=0}add(t,e,n){this.place.push(t[0],t[1],t[2]),this.place.push(e[0],e[1],e[2]),this.color.push(...n),this.color.push(...n)}commit(){fr(this.geometry,"position",this.place,!1),fr(this.geometry,"color",this.color,!1),this.geometry.setDrawRange(0,this.place.size/3),this.lines.visible=this.place.size>0}};function fr(i,t,e,n){let s=i.getAttribute(t);if(s?.array===e.array){s.needsUpdate=!0;return}let r=n?new ar(e.array,3):new Ve(e.array,3);r.setUsage(bg),i.setAttribute(t,r)}var i0={contacts:!0,velocities:!1,frames:!1,inertia:!1,joints:!0,trails:!1,penetration:!0,ghost:!0,shadows:!0,heat:!1,chosen:new Set,arrowScale:1},sn=Object.fromEntries(Object.entries(Pe).map(([i,t])=>[i,wn(t)])),s0=36;function r0(i,t){let e=i.chosen.has("contacts")?i.contacts:t.mostContacts<=s0;return e===i.contacts?!1:(i.contacts=e,!0)}function Gd(i,{header:t,mostContacts:e}){let{bodies:n,contact_tolerance:s}=t,r=o=>n[o].radius||1/0;return i.filter(({bodyA:o,bodyB:a,gap:l})=>l<-s&&(e<=s0||l<-.05*Math.min(r(o),r(a))))}var t0=120,D1=400,hc=class{constructor(t,e,n,s){this.source=t;this.radius=e;this.trails=new pr;this.links=new pr;this.largestForce=0;this.header=t.header;let r=U1(this.header)||.05*e;this.arrows=new cc(n,2.2*r),this.dots=new ga({size:.16*r,most:7,bias:.4*r},n,s),this.ring=new ga({size:.6*r,most:15,bias:1/0},n,s),this.sizes=this.header.bodies.map((o,a)=>o.radius||Math.max(0,...ki(this.header,a).flatMap(({radii:l})=>l??[]))),this.largestSpeed=n0(t.frames.velocity),this.largestImpulse=e0(t)}update(t,e,n,s,r,o){let a=[this.arrows,this.ring,this.dots,this.trails,this.links];for(let l of a)l.clear();s.contacts&&this.addContacts(n,s.arrowScale),s.velocities&&this.addVelocities(e,s.arrowScale),s.frames&&this.addFrames(e,r),s.inertia&&this.addInertia(e,r),s.joints&&this.addJoints(e),s.trails&&this.addTrails(t,r),o&&this.addEvent(o,s.arrowScale),this.addSprings(e),s.penetration&&this.addDeepest(Gd(n,this.source));for(let l of a)l.commit()}addContacts(t,e){for(let{force:s}of t)this.largestForce=Math.max(this.largestForce,Math.hypot(...s));let n=this.largestForce>0?.3*e*this.radius/this.largestForce:0;for(let{point:s,normal:r,force:o,mode:a}of t){this.dots.add(s,sn[a]);let l=o[0]*r[0]+o[1]*r[1]+o[2]*r[2];if(l<=0)continue;this.arrows.add(s,r.map(h=>h*l*n),sn.normal);let c=o.map((h,d)=>(h-l*r[d])*n);Math.hypot(...c)>.001*this.radius*e&&this.arrows.add(s,c,sn[a])}}addDeepest(t){let e;for(let n of t)n.gap<(e?.gap??0)&&(e=n);e&&this.ring.add(e.point,sn.penetration)}addVelocities(t,e){if(this.source.kind==="live"&&(this.largestSpeed=Math.max(this.largestSpeed,n0(t.velocity))),this.largestSpeed===0)return;let n=.3*e*this.radius/this.largestSpeed;for(let s of this.source.moving){let r=Fe(t.velocity,s,n);Math.hypot(...r)>.001*this.radius&&this.arrows.add(Fe(t.position,s),r,sn.velocity)}}addFrames(t,e){for(let n of this.chosen(e)){let{frame:s}=this.header.bodies[n],r=1.2*Math.min(this.sizes[n]||this.radius,this.radius),o=ii(t,n),a=Rn(Fe(t.position,n),ye(o,s.p)),[l,c,h,d]=s.q;[sn.x,sn.y,sn.z].forEach((u,f)=>{let g=[0,0,0];g[f]=r,this.arrows.add(a,ye(o,ye([l,c,h,d],g)),u)})}}addInertia(t,e){for(let n of this.chosen(e)){let{moments:s,mass:r}=this.header.bodies[n];if(r<=0)continue;let o=Math.sqrt(Math.max(...s)),a=ii(t,n),l=Fe(t.position,n);[sn.x,sn.y,sn.z].forEach((c,h)=>{let d=[0,0,0];d[h]=1.35*(this.sizes[n]||this.radius)*Math.sqrt(s[h])/o;let u=ye(a,d);this.arrows.add(l,u,c),this.arrows.add(l,u.map(f=>-f),c)})}}addJoints(t){for(let{type:e,bodies:n,points:s,axes:r}of this.header.joints){let o=n.map((c,h)=>this.placeOn(c,s[h],t));e==="distance"&&this.links.add(o[0],o[1],sn.impulse);let a=n.map((c,h)=>this.canMove(c)?Math.hypot(...s[h]):0);n.forEach((c,h)=>{a[h]>0&&this.links.add(Fe(t.position,c),o[h],sn.impulse)}),e!=="fixed"&&o.slice(0,e==="distance"?2:1).forEach(c=>this.dots.add(c,sn.impulse));let l=Math.min(.2*this.radius,Math.max(...a)||1/0);r.forEach((c,h)=>{if(c===null)return;let d=n[h]<0?c:ye(ii(t,n[h]),c);this.arrows.add(o[h],d.map(u=>l*u),sn.impulse)})}}addTrails(t,e){let{frames:n,frameTimes:s}=this.source,r=n.moving.length,o=Gn(s,t),a=Math.max(0,o-D1),l=Math.max(1,Math.floor(Math.min(r,t0)*(o-a)/4e4));n.moving.forEach((c,h)=>{if(e>=0&&n.moving.includes(e)?c!==e:h>=t0)return;let d=u=>n.position.subarray(3*(u*r+h),3*(u*r+h)+3);for(let u=o;u>a;u-=l){let f=.25+.75*(u-a)/(o-a);this.trails.add(d(Math.max(a,u-l)),d(u),sn.normal.map(g=>g*f))}})}addEvent(t,e){if(t.kind!=="impact")return;this.source.kind==="live"&&(this.largestImpulse=e0(this.source));let n=t.point.map((a,l)=>a-this.header.origin[l]),s=this.largestImpulse>0?.4*e*this.radius/this.largestImpulse:0,r=.1*this.radius/(Math.hypot(...t.impulse)||1),o=t.impulse.map(a=>a*Math.max(s,r));this.arrows.add(n,o,sn.impulse),this.arrows.add(n,o.map(a=>-a),sn.impulse),this.dots.add(n,sn.impulse)}addSprings(t){for(let{bodies:e,points:n}of this.header.springs){let[s,r]=e.map((o,a)=>this.placeOn(o,n[a],t));this.links.add(s,r,sn.velocity)}}placeOn(t,e,n){return t<0?e.map((s,r)=>s-this.header.origin[r]):Rn(Fe(n.position,t),ye(ii(n,t),e))}canMove(t){return t>=0&&this.header.bodies[t].motion!=="static"}chosen(t){return t>=0?[t]:this.source.moving.slice(0,500)}};function Fe(i,t,e=1){return[i[3*t]*e,i[3*t+1]*e,i[3*t+2]*e]}function ii(i,t){let e=i.orientation;return[e[4*t+3],e[4*t],e[4*t+1],e[4*t+2]]}function Rn(i,t){return[i[0]+t[0],i[1]+t[1],i[2]+t[2]]}function ye([i,t,e,n],s){let r=2*(e*s[2]-n*s[1]),o=2*(n*s[0]-t*s[2]),a=2*(t*s[1]-e*s[0]);return[s[0]+i*r+e*a-n*o,s[1]+i*o+n*r-t*a,s[2]+i*a+t*o-e*r]}function U1({bodies:i}){let t=i.flatMap(({motion:e,radius:n})=>e==="static"||!n||!Number.isFinite(n)?[]:[n]).sort((e,n)=>e-n);return t[t.length>>1]??0}function o0(i,t){let e=new Float32Array(i);for(let{bodyA:s,bodyB:r,force:o,normal:a}of t){let l=Math.max(0,o[0]*a[0]+o[1]*a[1]+o[2]*a[2]);e[s]+=l,e[r]+=l}let n=e.filter(s=>s>0).sort();return{forces:e,hottest:n[Math.floor(.98*(n.length-1))]??0}}function e0({events:i}){return i.reduce((t,e)=>Math.max(t,Math.hypot(...e.impulse)),0)}function n0(i){let t=0;for(let e=0;e<i.length;e+=3)t=Math.max(t,Math.hypot(i[e],i[e+1],i[e+2]));return t}var gi=(i,t)=>i.series.get(t)??new Float64Array;function Wd(i){let[t,e,n]=["kinetic","potential","elastic"].map(s=>gi(i,s));return t.map((s,r)=>s+e[r]+n[r])}var N1=i=>Array.from(i.values).some(t=>t!==0),hs=[{title:"Energy",unit:"J",curves:i=>{let[t,e,n,s]=["kinetic","potential","elastic","work"].map(r=>gi(i,r));return[{label:"kinetic",color:te.skyBlue,values:t},{label:"potential",color:te.orange,values:e},...[{label:"elastic",color:te.purple,values:n},{label:"work",color:te.yellow,values:s}].filter(N1),{label:"total",color:te.green,values:Wd(i)}]}},{title:"Momentum",unit:"kg m/s; kg m\xB2/s",curves:i=>[{label:"linear",color:te.skyBlue,unit:"kg m/s",values:gi(i,"momentum")},{label:"angular",color:te.orange,unit:"kg m\xB2/s",values:gi(i,"angular_momentum")}]},{title:"Deepest penetration",unit:"m",curves:i=>[{label:"depth",color:te.vermilion,values:gi(i,"penetration")}]},{title:"Solver effort an interval",unit:"",curves:i=>[{label:"steps",color:te.skyBlue,values:gi(i,"steps")},{label:"impacts",color:te.vermilion,values:gi(i,"impacts")},{label:"iterations",color:te.purple,values:gi(i,"iterations")}]}],mr={position:{unit:"m",labels:["x","y","z"]},velocity:{unit:"m/s",labels:["x","y","z"]},"angular velocity":{unit:"rad/s",labels:["x","y","z"]},"kinetic energy":{unit:"J",labels:["translation","rotation"]}};function uc(i,t,e){let n=i.frames.moving.indexOf(t),{labels:s}=mr[e],r=i.frameTimes.length,o=s.map(()=>new Array(r));if(n<0)return o.map(d=>d.fill(0));let a=i.frames.moving.length,{mass:l,moments:c}=i.header.bodies[t],h=new Float32Array(4);for(let d=0;d<r;++d){let u=d*a+n,f;e==="position"?f=Fe(i.frames.position,u).map((g,y)=>g+i.header.origin[y]):e==="velocity"?f=Fe(i.frames.velocity,u):e==="angular velocity"?f=Fe(i.frames.spin,u):(i.frames.orientation(d,n,h,0),f=a0(l,c,Fe(i.frames.velocity,u),Fe(i.frames.spin,u),[h[3],h[0],h[1],h[2]])),f.forEach((g,y)=>o[y][d]=g)}return o}function a0(i,t,e,n,s){let r=ye([s[0],-s[1],-s[2],-s[3]],[n[0],n[1],n[2]]);return[.5*i*(e[0]**2+e[1]**2+e[2]**2),.5*(t[0]*r[0]**2+t[1]*r[1]**2+t[2]*r[2]**2)]}var Co=class{constructor(t,e){this.source=t;this.element=U("div",{class:"plots"});this.units=hs.map(()=>U("small"));this.body=-1;this.all=new Gr(this.element,e),this.quantity=U("select",{"aria-label":"Quantity of the body",onchange:()=>this.showBody(this.body)},...Object.keys(mr).map(n=>U("option",{value:n},n))),this.bodyBox=U("section",{class:"plot"}),hs.forEach((n,s)=>{let r=U("section",{class:"plot"},U("h2",{},n.title,this.units[s]));this.element.append(r),this.all.add(r,this.curvesOf(s))}),this.element.append(this.bodyBox),this.showBody(-1)}get charts(){return this.all.list}refresh(){hs.forEach((t,e)=>this.all.replace(e,this.curvesOf(e)))}refreshBody(){this.charts.length>hs.length&&this.all.replace(hs.length,this.bodyCurvesOf())}showBody(t){this.body=t,this.all.keep(hs.length);let e=this.source.header.bodies[t]?.name,{unit:n}=mr[this.quantity.value];if(this.bodyBox.replaceChildren(U("h2",{},e??"Chosen body",U("small",{text:e?` [${n}]`:""}),e?this.quantity:void 0)),!e||!this.source.frames.moving.includes(t)){this.bodyBox.append(U("p",{class:"hint",text:e?"This body stands still.":"Click a body in the scene to plot its motion."}));return}this.all.add(this.bodyBox,this.bodyCurvesOf()),this.all.resize()}setTime(t){this.all.setTime(t)}redraw(){this.all.redraw()}curvesOf(t){let{times:e}=this.source,n=hs[t].curves(this.source).map(r=>({...r,times:e})),s=Za(n);return this.units[t].textContent=Ka(hs[t].unit,s),Ja(n,s).map(r=>({...r,unit:Wr(r.unit??hs[t].unit,s)}))}bodyCurvesOf(){let t=[te.vermilion,te.green,te.skyBlue],{labels:e,unit:n}=mr[this.quantity.value],s=this.source.frameTimes;return uc(this.source,this.body,this.quantity.value).map((r,o)=>({label:e[o],color:t[o],times:s,values:r,unit:Wr(n,0)}))}};function l0(i,t,e){let{mass:n,moments:s}=i.header.bodies[t],r=e.orientation;return a0(n,s,Fe(e.velocity,t),Fe(e.spin,t),[r[4*t+3],r[4*t],r[4*t+1],r[4*t+2]])}var c0=[{title:"Total energy",unit:"J",values:Wd},{title:"Kinetic energy",unit:"J",values:i=>gi(i,"kinetic")},{title:"Momentum",unit:"kg m/s",values:i=>gi(i,"momentum")},{title:"Deepest penetration",unit:"m",values:i=>gi(i,"penetration")}],va=class{constructor(t,e,n){this.sources=t;this.chosen=e;this.boxes=U("div",{class:"plots"});this.legend=U("span",{class:"legend"});this.bodyBox=U("section",{class:"plot"});this.body="";this.isQuantityChosen=!1;this.all=new Gr(this.boxes,n),this.names=Ir(t),this.short=Ua(this.names),this.wantsAll=U("input",{type:"checkbox",id:"all-runs",onchange:()=>this.show()}),this.quantity=U("select",{"aria-label":"Quantity of the body",onchange:()=>{this.isQuantityChosen=!0,this.showBodyPlot()}},...Object.entries(mr).flatMap(([s,{labels:r}])=>r.map((o,a)=>U("option",{value:`${s}/${a}`},`${s} ${o}`)))),this.element=U("div",{class:"compare-plots"},U("div",{class:"plots-head"},U("label",{},this.wantsAll,"all runs"),this.legend),this.boxes),this.show()}get charts(){return this.all.list}setRuns(t){this.chosen=t,this.show()}showBody(t){let e=this.sources[this.chosen.a];this.body=e.header.bodies[t]?.name??"",this.body&&!this.isQuantityChosen&&(this.quantity.value=`position/${F1(uc(e,t,"position"))}`),this.showBodyPlot()}setTime(t){this.all.setTime(t)}redraw(){this.all.redraw()}shownRuns(){let{a:t,b:e}=this.chosen;return this.sources.map((n,s)=>s).filter(n=>this.wantsAll.checked||n===t||n===e)}curvesOf(t,e){let n=Math.min(1,3.5/Math.max(1,t.length-1));return t.map((s,r)=>({label:this.short[s],color:Sn(s),times:this.sources[s].times,values:e(s),width:1.6+n*(t.length-1-r),isDashed:s===this.chosen.b}))}show(){let t=this.shownRuns();this.legend.replaceChildren(...t.map(e=>{let n=e===this.chosen.a?" (A)":e===this.chosen.b?" (B, dashed)":"";return U("span",{},U("span",{class:"dot",style:`background:${Sn(e)}`}),this.names[e]+n)})),this.all.keep(0),this.boxes.replaceChildren();for(let e of c0){let n=this.curvesOf(t,o=>e.values(this.sources[o])),s=Za(n),r=U("section",{class:"plot"},U("h2",{},e.title,U("small",{text:Ka(e.unit,s)})));this.boxes.append(r),this.all.add(r,Ja(n,s).map(o=>({...o,unit:Wr(e.unit,s)})))}this.boxes.append(this.bodyBox),this.showBodyPlot()}twin(t){return this.sources[t].header.bodies.findIndex(({name:e})=>e===this.body)}showBodyPlot(){this.all.keep(c0.length);let[t,e]=this.quantity.value.split("/"),{unit:n}=mr[t],s=this.body===""?[]:[U("small",{text:` [${n}]`}),this.quantity];this.bodyBox.replaceChildren(U("h2",{},this.body||"Chosen body",...s));let r=this.shownRuns().filter(a=>this.sources[a].frames.moving.includes(this.twin(a))),o=this.curvesOf(r,a=>uc(this.sources[a],this.twin(a),t)[Number(e)]);o.length===0?this.bodyBox.append(U("p",{class:"hint",text:this.body?"This body stands still.":"Click a body in the scene to plot its motion."})):this.all.add(this.bodyBox,o.map(a=>({...a,unit:Wr(n,0)}))),this.all.resize()}};function F1(i){let t=i.map(e=>e.reduce((n,s)=>Math.max(n,s),-1/0)-e.reduce((n,s)=>Math.min(n,s),1/0));return t.indexOf(Math.max(...t))}function ya(i,t,e){let n=t.moving.length,s=t.moving.map((d,u)=>{let f=new Float32Array(4);return t.orientation(0,u,f,0),k1(i,e,d,[f[3],f[0],f[1],f[2]])}),o=s.map(d=>Math.hypot(...d)).sort((d,u)=>d-u)[n>>1]??0,a=h0(t,s,0,1),l=Math.max(1,Math.floor(t.count/400)),c=h0(t,s,0,t.count,l),h=Math.max(60*o,3*a.radius);return n>0&&c.radius>0?c.radius<=h?O1(c,i,e):{center:a.center,half:[h/2,h/2,h/2],radius:h}:B1(i)}function O1(i,t,e){let n=2.5*i.radius,s=i.center.map((o,a)=>o-i.half[a]),r=i.center.map((o,a)=>o+i.half[a]);return t.bodies.forEach(({motion:o,start:a},l)=>{if(o!=="static")return;let c=u0(t,e,l,a.q);if(Math.hypot(...c.lower,...c.upper)===0)return;let h=a.p.map((f,g)=>f-t.origin[g]),d=s.map((f,g)=>Math.min(f,h[g]+c.lower[g])),u=r.map((f,g)=>Math.max(f,h[g]+c.upper[g]));Math.hypot(...u.map((f,g)=>f-d[g]))/2<=n&&([s,r]=[d,u])}),d0(s,r)}function k1(i,t,e,n){let{lower:s,upper:r}=u0(i,t,e,n),o=s.map((a,l)=>Math.max(-a,r[l]));for(let a of Ch(i,e))ye(n,a).forEach((l,c)=>o[c]=Math.max(o[c],Math.abs(l)));return o}function u0(i,t,e,n){let s=[0,0,0],r=[0,0,0],o=(a,l)=>a.forEach((c,h)=>{s[h]=Math.min(s[h],c-l[h]),r[h]=Math.max(r[h],c+l[h])});for(let a of ki(i,e)){if(a.type==="plane")continue;let l=a.radius??0,c=a.half_length??0,h=a.half_extents??a.radii??[l,l,a.type==="capsule"?l+c:c];if(a.mesh!==void 0){let{vertices:u}=t[a.mesh];for(let f=0;f<u.length;f+=3)o(ye(n,Rn(a.p,ye(a.q,[u[f],u[f+1],u[f+2]]))),[0,0,0]);continue}let d=[0,1,2].map(u=>ye(n,ye(a.q,[0,1,2].map(f=>f===u?h[f]:0))));o(ye(n,a.p),[0,1,2].map(u=>a.type==="sphere"?l:Math.abs(d[0][u])+Math.abs(d[1][u])+Math.abs(d[2][u])))}return{lower:s,upper:r}}function h0(i,t,e,n,s=1){let r=[1/0,1/0,1/0],o=[-1/0,-1/0,-1/0],a=i.moving.length;for(let l=e;l<n;l+=s)for(let c=0;c<a;++c)for(let h=0;h<3;++h){let d=i.position[3*(l*a+c)+h];r[h]=Math.min(r[h],d-t[c][h]),o[h]=Math.max(o[h],d+t[c][h])}return d0(r,o)}function d0(i,t){return{center:i.map((e,n)=>(e+t[n])/2),half:i.map((e,n)=>(t[n]-e)/2),radius:Math.hypot(...t.map((e,n)=>e-i[n]))/2}}function B1(i){let t=i.bodies.map(n=>Math.hypot(...n.start.p.map((s,r)=>s-i.origin[r]))+(n.radius??0)),e=Math.max(0,...t.filter(Number.isFinite))||1;return{center:[0,0,0],half:[e,e,e],radius:e}}var f0=[["F","follow the chosen body with the camera"],["R","look at the whole scene again"],["Esc","choose no body, close this help"],["/","find a body by name"],["C","contact points and forces"],["V","velocities"],["X","body frames"],["I","axes of inertia"],["J","joints and their axes (where there are joints)"],["T","trails"],["P","overlapping bodies"],["H","shadows"],["M","forces as a heat map: how hard each body is pressed"],["S","save a picture"],["D","dark or light"],["?","this help"]],p0=[["Space","play, pause"],["\u2190 \u2192","one frame back, on (with Shift: ten)"],["Home End","first, last frame"],["[ ]","previous, next impact"],["\u2212 +","slower, faster"],["L","loop"],...f0,["Shift P","go to the deepest penetration"],["G","ghost of run B (where there is one)"]],m0=[["Space","run, pause"],["\u2190 \u2192","one output interval back, on"],["Home","back to t = 0"],["[ ]","show the previous, next impact"],...f0];var Xd=200,Ro=class{constructor(t,e,n,s,r){this.source=t;this.shown=e;this.actions=s;this.found=U("ul",{class:"found","aria-label":"Bodies",tabindex:0});this.heat=U("p",{class:"heat-scale",hidden:!0});this.selected=-1;this.numbers=U("div",{class:"numbers",id:"numbers"});this.event=U("div",{class:"event",id:"event",role:"status"});this.audit=U("div");this.precision=U("p",{class:"hint"});this.boxes=new Map;this.search=U("input",{type:"search",id:"search",placeholder:"Find a body by name (/)","aria-label":"Find a body by name",oninput:()=>this.list(),onkeydown:a=>this.searchKey(a)});let o=[...r?[["Control",r]]:[],["Body",U("div",{class:"bodies"},this.search,this.found,this.numbers)],["Show",this.showTab(n)],...r?[]:[["Audit",this.audit]]];this.element=U("aside",{class:"panel","aria-label":"Bodies, view and audit"},this.event,V1(o),...o.map(([,a])=>a)),this.setSource(t)}setSource(t){this.source=t;let{position_error:e,orientation_error:n}=t.header;this.precision.textContent=`Positions are stored to ${Kt(e,2)} m, orientations to ${Kt(n,2)} rad. Between two frames a body follows a smooth curve through both, over an impact two curves that meet there.`,this.audit.replaceChildren(H1(t.header,this.actions)),this.list()}updateShown(){for(let[t,e]of this.boxes)e.checked=!!this.shown[t]}showEvent(t){if(this.event.hidden=t===void 0,!t)return;let e=n=>this.source.header.bodies[n]?.name??"";this.event.replaceChildren(U("h2",{},U("span",{class:"dot",style:`background:${Pe.impulse}`}),`${t.kind} at ${Kt(t.time,10)} s`),U("p",{},g0(t.bodyA,e(t.bodyA),this.actions)," \u2194 ",g0(t.bodyB,e(t.bodyB),this.actions)),qd([["impulse",`${Kt(Math.hypot(...t.impulse),6)} N s`],[`on ${e(t.bodyB)}`,`[${Yi(t.impulse,5)}] N s`],["at",`[${Yi(t.point,5)}] m`]]))}showBody(t,e,n,s){if(this.choose(t),t<0){this.numbers.replaceChildren(U("p",{class:"hint",text:"Click a body in the scene, or choose one here, to see its numbers."}));return}let{header:r}=this.source,o=r.bodies[t],a=ii(e,t),l=Rn(Fe(e.position,t),r.origin),c=Fe(e.velocity,t),h=Fe(e.spin,t),[d,u]=l0(this.source,t,e),f=r.gravity,g=p=>Math.abs(p)<r.position_error?0:p,y=[["position",`[${Yi(Rn(l,ye(a,o.frame.p)).map(g))}] m`],["centre of mass",`[${Yi(l.map(g))}] m`],["orientation",`[${Yi(z1(a,o.frame.q))}]`],["velocity",`[${Yi(c)}] m/s`],["speed",`${Kt(Math.hypot(...c))} m/s`],["angular velocity",`[${Yi(h)}] rad/s`]],m=n.filter(({bodyA:p,bodyB:E})=>p===t||E===t);if(o.mass>0){let p=o.mass*Math.hypot(...f);p>0&&y.push(["weight",`${Kt(p)} N`],["held by",this.holders(t,m)]),y.push(["mass",`${Kt(o.mass)} kg`],["principal moments",`[${Yi(o.moments)}] kg m\xB2`],["kinetic energy",`${Kt(d+u)} J (turning ${Kt(u)})`],["height energy",`${Kt(-o.mass*(f[0]*l[0]+f[1]*l[1]+f[2]*l[2]))} J`])}y.push(["contacts",String(m.length)]),this.numbers.replaceChildren(U("h2",{},o.name,U("small",{text:` ${o.motion}`}),U("button",{type:"button",class:s===t?"on":"",title:"The camera goes along (F)",onclick:()=>this.actions.follow(t)},"follow")),qd(y),this.contactTable(t,m))}holders(t,e){let{gravity:n,bodies:s,joints:r,springs:o}=this.source.header,a=Math.hypot(...n),l=new Map,c=!0;for(let{bodyA:u,bodyB:f,force:g,mode:y}of e){c&&(c=y!=="unknown");let m=g.reduce((E,S,M)=>E-S*n[M]/a,0)*(f===t?1:-1),{name:p}=s[u===t?f:u];l.set(p,(l.get(p)??0)+m)}let h=.001*s[t].mass*a,d=[...l].filter(([,u])=>u>h).sort((u,f)=>f[1]-u[1]).map(([u,f])=>`${u} ${Kt(f)} N`);return d.push(...r.filter(u=>u.bodies.includes(t)).map(({name:u,type:f})=>u||f)),o.some(u=>u.bodies.includes(t))&&d.push("a spring"),d.length===0?e.length>0&&!c?"contacts (forces not known)":"nothing: it falls or flies":d.slice(0,6).join(", ")+(d.length>6?` and ${d.length-6} more`:"")}contactTable(t,e){if(e.length===0)return"";let n=e.slice(0,50).map(({bodyA:r,bodyB:o,force:a,normal:l,mode:c,gap:h})=>{let d=r===t?o:r,u=a[0]*l[0]+a[1]*l[1]+a[2]*l[2],f=Math.hypot(...a.map((y,m)=>y-u*l[m])),g=c!=="unknown";return U("tr",{},U("td",{},this.source.header.bodies[d].name),U("td",{},c),U("td",{},g?Kt(u,4):"\u2013"),U("td",{},g?Kt(f,3):"\u2013"),U("td",{},Kt(h,2)))}),s=["with","mode","normal [N]","friction [N]","gap [m]"].map(r=>U("th",{scope:"col",text:r}));return U("table",{class:"contacts"},U("tr",{},...s),...n)}list(){let t=this.search.value.trim().toLowerCase(),{bodies:e}=this.source.header,n=e.flatMap((s,r)=>s.name.toLowerCase().includes(t)?[r]:[]);this.found.replaceChildren(...n.slice(0,Xd).map(s=>U("li",{"data-body":s},U("button",{type:"button","aria-pressed":String(s===this.selected),onclick:()=>this.actions.select(s)},e[s].name,U("small",{text:` ${e[s].motion}`}))))),n.length===0&&this.found.append(U("li",{class:"hint",text:"no body has this in its name"})),n.length>Xd&&this.found.append(U("li",{class:"hint",text:`and ${n.length-Xd} more`}))}searchKey(t){let e=this.found.querySelector("button");!e||t.key!=="Enter"&&t.key!=="ArrowDown"||(t.preventDefault(),t.key==="Enter"?e.click():e.focus())}choose(t){if(t!==this.selected){this.selected=t;for(let e of this.found.querySelectorAll("li[data-body]")){let n=Number(e.dataset.body)===t;e.firstElementChild?.setAttribute("aria-pressed",String(n)),n&&requestAnimationFrame(()=>{let{scrollTop:s,clientHeight:r}=this.found;(e.offsetTop<s||e.offsetTop+e.offsetHeight>s+r)&&(this.found.scrollTop=e.offsetTop)})}}}showHeat(t){this.heat.hidden=t===void 0,t!==void 0&&this.heat.replaceChildren("0",U("span",{class:"heat"}),`${Kt(t)} N pressed on a body`)}showTab(t){let{header:e}=this.source,s=[["contacts","Contact points and forces (C)",[Pe.normal,Pe.stick,Pe.slide],!0],["velocities","Velocities (V)",[Pe.velocity],!0],["frames","Body frames (X)",[Pe.x,Pe.y,Pe.z],!0],["inertia","Axes of inertia (I)",[Pe.x,Pe.y,Pe.z],!0],["joints","Joints and their axes (J)",[Pe.impulse],e.joints.length>0],["trails","Trails (T)",[Pe.normal],!0],["penetration","Overlapping bodies (P)",[Pe.penetration],!0],["ghost","Run B as a ghost (G)",[],t],["heat","Forces as a heat map (M)",["#29336b","#cc475c","#fce06b"],!0],["shadows","Shadows (H)",[],!0]].filter(([,,,a])=>a).map(([a,l,c])=>{let h=U("input",{type:"checkbox",id:`show-${a}`,onchange:()=>{this.shown[a]=h.checked,this.shown.chosen.add(a),this.actions.changed()}});return this.boxes.set(a,h),U("label",{},h,...c.map(d=>U("span",{class:"dot",style:`background:${d}`})),l)}),r=U("input",{type:"range",min:-2,max:2,step:.1,value:0,"aria-label":"Length of arrows",oninput:()=>{this.shown.arrowScale=2**Number(r.value),this.actions.changed()}}),o=(a,l)=>U("span",{},U("span",{class:"dot",style:`background:${l}`}),a);return U("div",{class:"show"},...s,this.heat,U("label",{},"Length of arrows ",r),U("p",{class:"legend"},o("normal force",Pe.normal),o("friction, sticks",Pe.stick),o("friction, slides",Pe.slide),o("no force",Pe.open),o("impulse",Pe.impulse)),this.precision)}};function z1(i,t){let[e,n,s,r]=i,[o,a,l,c]=t;return[e*o-n*a-s*l-r*c,e*a+n*o+s*c-r*l,e*l-n*c+s*o+r*a,e*c+n*l-s*a+r*o]}function g0(i,t,e){return U("button",{type:"button",class:"link",onclick:()=>e.select(i)},t||"\u2013")}function qd(i){return U("table",{},...i.map(([t,e])=>U("tr",{},U("th",{scope:"row",text:t}),U("td",{},e))))}function V1(i){let t=i.map(([s],r)=>U("button",{type:"button",role:"tab",id:`tab-${r}`,"aria-controls":`tab-content-${r}`,onclick:()=>e(r)},s)),e=s=>i.forEach(([,r],o)=>{r.hidden=o!==s,t[o].setAttribute("aria-selected",String(o===s)),t[o].tabIndex=o===s?0:-1});return i.forEach(([,s],r)=>{s.classList.add("tab");for(let[o,a]of Object.entries({role:"tabpanel",id:`tab-content-${r}`,"aria-labelledby":`tab-${r}`}))s.setAttribute(o,a)}),e(0),U("div",{class:"tabs",role:"tablist","aria-label":"Panel",onkeydown:s=>{let r={ArrowLeft:-1,ArrowRight:1}[s.key];if(r===void 0)return;s.preventDefault(),s.stopPropagation();let o=(t.indexOf(s.target)+r+i.length)%i.length;e(o),t[o].focus()}},...t)}function H1({audit:i},t){let e=Da(i).map(({name:n,value:s})=>[n,G1(n,s,t)]);return U("div",{},U("p",{class:zo(i)?"sound":"broken",text:zo(i)?"\u2713 audit passed":"\u2717 audit violated"}),...Rr(i).map(n=>U("p",{class:"warning",text:n})),qd(e))}function G1(i,t,e){return i!=="penetration: time"||typeof t!="number"?Bs(t):U("button",{type:"button",class:"link",title:"Go there",onclick:()=>e.showDeepest()},`${Bs(t)} s`)}var gr=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10],dc=class{constructor(t,e){this.begin=t;this.end=e;this.isPlaying=!1;this.isLooping=!0;this.speed=1;this.time=t}advance(t){if(!this.isPlaying||this.end<=this.begin)return!1;let e=this.time+t*this.speed;return e<this.end?this.time=e:this.isLooping?this.time=this.begin+(e-this.begin)%(this.end-this.begin):(this.time=this.end,this.isPlaying=!1),!0}seek(t){this.time=Math.min(Math.max(t,this.begin),this.end)}toggle(){this.isPlaying=!this.isPlaying,this.isPlaying&&this.time>=this.end&&(this.time=this.begin)}changeSpeed(t){let e=gr.indexOf(this.speed)+t;this.speed=gr[Math.min(Math.max(e,0),gr.length-1)]}};function v0(i,t,e){let n=Gn(i,t),s=i[n]<t,r=n+e+(s&&e<0?1:0);return i[Math.min(Math.max(r,0),i.length-1)]}var W1=1e-4;function y0(i,t){let e=new Map(t.frames.moving.map((a,l)=>[t.header.bodies[a].name,l])),n=i.frames.moving.flatMap((a,l)=>{let c=e.get(i.header.bodies[a].name);return c===void 0?[]:[{body:a,inA:l,inB:c}]}),s=W1*i.header.extent,[r,o]=[i.frames.moving.length,t.frames.moving.length];for(let a=0,l=0;a<i.times.length;++a){for(;l<t.times.length&&t.times[l]<i.times[a]*(1-1e-9)-1e-12;)++l;if(l===t.times.length)return;if(t.times[l]>i.times[a]*(1+1e-9)+1e-12)continue;let c;for(let{body:h,inA:d,inB:u}of n){let f=3*(a*r+d),g=3*(l*o+u),y=[0,1,2].map(p=>i.frames.position[f+p]+i.header.origin[p]-t.frames.position[g+p]-t.header.origin[p]),m=Math.hypot(...y);m>Math.max(s,c?.distance??0)&&(c={time:i.times[a],body:i.header.bodies[h].name,distance:m})}if(c)return c}}function x0(i){let t=i.findIndex((e,n)=>n>0&&y0(i[0],e)!==void 0);return t>0?t:1}function _0(i,t){let e=d=>new Set((d??"").split(/,\s+/).filter(Boolean)),[n,s]=[e(i.header.label),e(t.header.label)],r=[...s].filter(d=>!n.has(d)),o=[...n].filter(d=>!s.has(d)),a=Kc([i.header.audit,t.header.audit]).filter(({isSetting:d,differs:u})=>d&&u[1]),l=r.length>0?`${r.join(", ")} instead of ${o.join(", ")||"what the scene says"}`:a.length>0?a.map(({name:d,values:u})=>`${d} ${u[1]} instead of ${u[0]}`).join(", "):"nothing that the audits tell",c=y0(i,t),h=c?`The paths part at ${Kt(c.time,4)} s: ${c.body} is ${Kt(c.distance,2)} m away.`:"No body goes another way, to what the page stores.";return`B differs from A by ${l}. ${h}`}function Yd(i){let t=i.filter(a=>a>0&&Number.isFinite(a)),e=1e-9,n=t.length>0?Math.floor(Math.log10(Math.min(...t))+e):-1,s=Math.max(n+1,t.length>0?Math.ceil(Math.log10(Math.max(...t))-e)+0:0),r=Math.ceil((s-n)/8),o=[];for(let a=n;a<=s;a+=r)o.push(a);return{low:n,high:s,ticks:o}}function $d({low:i,high:t},e){return(Math.log10(e)-i)/(t-i)}function b0(i,t){return i.points.filter(e=>e.error>0&&t(e)>0)}function M0({references:i}){let t=i.map(({error:e})=>e??0).filter(e=>e>0);return t.length>0?Math.max(...t):void 0}var X1="http://www.w3.org/2000/svg",qe={width:420,height:260,left:66,right:12,top:10,bottom:44},q1=[{title:"Error over CPU time",name:"CPU time [s]",x:({cpu_time:i})=>i},{title:"Error over step",name:"step [s]",x:({step:i})=>i}];function S0(i){let{references:t,curves:e}=i,n=e.map(({label:o},a)=>U("span",{},U("span",{class:"dot",style:`background:${Sn(a)}`}),o||"all runs")),s=e.flatMap(({points:o})=>o).filter(({error:o})=>o===0).length,r=s>0?`${s} ${s===1?"run has":"runs have"} no error and no place on a logarithmic axis.`:"";return e.some(({points:o})=>o.some(({error:a})=>a!==null&&a>0))?U("section",{class:"precision"},U("h2",{},"Work and precision",U("small",{text:` errors against: ${t.map(({name:o})=>o).join("; ")}`})),U("span",{class:"legend"},...n),U("div",{class:"plots"},...q1.map(o=>U("section",{class:"plot"},U("h2",{text:o.title}),Y1(i,o)))),r?U("p",{class:"hint",text:r}):void 0):U("section",{class:"precision"},U("p",{class:"hint",text:"No run differs from the reference: there is no error to plot over work."}))}function Ri(i,t,...e){let n=document.createElementNS(X1,i);for(let[s,r]of Object.entries(t))n.setAttribute(s,String(r));return n.append(...e),n}function Y1(i,{title:t,name:e,x:n}){let s=i.curves.map(d=>b0(d,n)),r=M0(i),o=Yd(s.flat().map(n)),a=Yd([...s.flat().map(({error:d})=>d),...r===void 0?[]:[r]]),l=d=>qe.left+$d(o,d)*(qe.width-qe.left-qe.right),c=d=>qe.height-qe.bottom-$d(a,d)*(qe.height-qe.top-qe.bottom),h=Ri("svg",{viewBox:`0 0 ${qe.width} ${qe.height}`,role:"img","aria-label":`${t}, logarithmic axes`});return h.append(...$1(o,a,e,l,c)),r!==void 0&&h.append(Ri("line",{class:"own",x1:qe.left,x2:qe.width-qe.right,y1:c(r),y2:c(r)},w0(`the reference's own error, ${Kt(r,3)} m`))),s.forEach((d,u)=>{h.append(Ri("polyline",{points:d.map(f=>`${l(n(f))},${c(f.error)}`).join(" "),stroke:Sn(u)}));for(let f of d)h.append(Ri("circle",{cx:l(n(f)),cy:c(f.error),r:4,fill:Sn(u)},w0(Z1(f))))}),h}function $1(i,t,e,n,s){let r=qe.height-qe.bottom,o=qe.width-qe.right;return[...i.ticks.flatMap(a=>[Ri("line",{x1:n(10**a),x2:n(10**a),y1:qe.top,y2:r}),Ri("text",{x:n(10**a),y:r+15,"text-anchor":"middle"},`1e${a}`)]),...t.ticks.flatMap(a=>[Ri("line",{x1:qe.left,x2:o,y1:s(10**a),y2:s(10**a)}),Ri("text",{x:qe.left-6,y:s(10**a)+4,"text-anchor":"end"},`1e${a}`)]),Ri("text",{x:(qe.left+o)/2,y:qe.height-8,"text-anchor":"middle"},e),Ri("text",{x:0,y:0,"text-anchor":"middle",transform:`translate(14 ${(qe.top+r)/2}) rotate(-90)`},"error [m]")]}function w0(i){return Ri("title",{},i)}function Z1({label:i,step:t,cpu_time:e,error:n,order:s}){let r=s===null?"":`, observed order ${Kt(s,3)}`;return`${i}: error ${Kt(n,3)} m, step ${Kt(t,3)} s, CPU time ${Kt(e,3)} s${r}`}function J1(i,t){return t.a!==t.b?t:t.a!==i.a?{a:t.a,b:i.a}:i.b<0?i:{a:i.b,b:i.a}}var fc=class{constructor(t,e,n){this.sources=t;this.chosen=e;this.changed=n;this.why=U("p",{class:"hint why",id:"why",role:"status"});let r=Ir(t).map((l,c)=>U("option",{value:c},l));this.rows=["A","B"].map((l,c)=>({select:U("select",{id:`run-${l.toLowerCase()}`,"aria-label":c===0?"Run A, drawn solid":"Run B, drawn as a ghost",onchange:()=>this.read()},...c===0?[]:[U("option",{value:-1},"none")],...r.map(h=>h.cloneNode(!0))),dot:U("span",{class:"dot"}),end:U("small")}));let[o,a]=this.rows;this.element=U("div",{class:"runs",role:"group","aria-label":"Runs that are looked at"},U("label",{},U("b",{text:"A"}),o.dot,o.select,o.end),Se("\u21C4","Swap A and B",()=>this.chosen.b>=0&&this.set({a:this.chosen.b,b:this.chosen.a})),U("label",{title:"Drawn as a ghost (G)"},U("b",{text:"B"}),a.dot,a.select,a.end),this.why),this.show()}read(){let[t,e]=this.rows.map(({select:n})=>Number(n.value));this.set(J1(this.chosen,{a:t,b:e}))}set(t){this.chosen=t,this.show(),this.changed(t)}show(){let[t,e]=[this.sources[this.chosen.a],this.sources[this.chosen.b]];this.why.textContent=e?Pr(_0(t,e)):"";let n=Math.max(...this.sources.map(({times:s})=>s[s.length-1]));this.rows.forEach(({select:s,dot:r,end:o},a)=>{let l=a===0?this.chosen.a:this.chosen.b;s.value=String(l),r.style.background=l<0?"transparent":Sn(l);let c=this.sources[l],h=c?c.times[c.times.length-1]:n,d=c?.header.stopped?"stopped at":"until";o.textContent=h<n*(1-1e-12)?`${d} ${Kt(h,6)} s`:"",o.title=c?.header.stopped??""})}};var xa=class{constructor(t,e){this.canvas=t;this.done=e}static get isPossible(){return typeof MediaRecorder<"u"&&"captureStream"in HTMLCanvasElement.prototype}get isRunning(){return this.recorder?.state==="recording"}begin(){let t=["video/mp4;codecs=avc1","video/webm;codecs=vp9","video/webm"].find(s=>MediaRecorder.isTypeSupported(s)),e=new MediaRecorder(this.canvas.captureStream(30),{mimeType:t,videoBitsPerSecond:8e6}),n=[];e.ondataavailable=({data:s})=>n.push(s),e.onstop=()=>this.done(new Blob(n,{type:e.mimeType}),e.mimeType.startsWith("video/mp4")?"mp4":"webm"),e.start(1e3),this.recorder=e}end(){this.isRunning&&this.recorder?.stop()}};var E0={type:"change"},Jd={type:"start"},T0={type:"end"},pc=new or,A0=new Ai,K1=Math.cos(70*Mg.DEG2RAD),fn=new N,Xn=2*Math.PI,Le={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Zd=1e-6,mc=class extends nc{constructor(t,e=null){super(t,e),this.state=Le.NONE,this.enabled=!0,this.target=new N,this.cursor=new N,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ur.ROTATE,MIDDLE:ur.DOLLY,RIGHT:ur.PAN},this.touches={ONE:dr.ROTATE,TWO:dr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new N,this._lastQuaternion=new Bn,this._lastTargetPosition=new N,this._quat=new Bn().setFromUnitVectors(t.up,new N(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new fa,this._sphericalDelta=new fa,this._scale=1,this._panOffset=new N,this._rotateStart=new At,this._rotateEnd=new At,this._rotateDelta=new At,this._panStart=new At,this._panEnd=new At,this._panDelta=new At,this._dollyStart=new At,this._dollyEnd=new At,this._dollyDelta=new At,this._dollyDirection=new N,this._mouse=new At,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Q1.bind(this),this._onPointerDown=j1.bind(this),this._onPointerUp=tE.bind(this),this._onContextMenu=aE.bind(this),this._onMouseWheel=iE.bind(this),this._onKeyDown=sE.bind(this),this._onTouchStart=rE.bind(this),this._onTouchMove=oE.bind(this),this._onMouseDown=eE.bind(this),this._onMouseMove=nE.bind(this),this._interceptControlDown=lE.bind(this),this._interceptControlUp=cE.bind(this),this.domElement!==null&&this.connect(),this.update()}connect(){this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(E0),this.update(),this.state=Le.NONE}update(t=null){let e=this.object.position;fn.copy(e).sub(this.target),fn.applyQuaternion(this._quat),this._spherical.setFromVector3(fn),this.autoRotate&&this.state===Le.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Xn:n>Math.PI&&(n-=Xn),s<-Math.PI?s+=Xn:s>Math.PI&&(s-=Xn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(fn.setFromSpherical(this._spherical),fn.applyQuaternion(this._quatInverse),e.copy(this.target).add(fn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=fn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new N(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new N(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=fn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(pc.origin.copy(this.object.position),pc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(pc.direction))<K1?this.object.lookAt(this.target):(A0.setFromNormalAndCoplanarPoint(this.object.up,this.target),pc.intersectPlane(A0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Zd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Zd||this._lastTargetPosition.distanceToSquared(this.target)>Zd?(this.dispatchEvent(E0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Xn/60*this.autoRotateSpeed*t:Xn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){fn.setFromMatrixColumn(e,0),fn.multiplyScalar(-t),this._panOffset.add(fn)}_panUp(t,e){this.screenSpacePanning===!0?fn.setFromMatrixColumn(e,1):(fn.setFromMatrixColumn(e,0),fn.crossVectors(this.object.up,fn)),fn.multiplyScalar(t),this._panOffset.add(fn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;fn.copy(s).sub(this.target);let r=fn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Xn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Xn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateUp(Xn*this.rotateSpeed/this.domElement.clientHeight):this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateUp(-Xn*this.rotateSpeed/this.domElement.clientHeight):this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateLeft(Xn*this.rotateSpeed/this.domElement.clientHeight):this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateLeft(-Xn*this.rotateSpeed/this.domElement.clientHeight):this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Xn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Xn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new At,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function j1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function Q1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function tE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(T0),this.state=Le.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function eE(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case ur.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Le.DOLLY;break;case ur.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Le.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Le.ROTATE}break;case ur.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Le.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Le.PAN}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(Jd)}function nE(i){switch(this.state){case Le.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Le.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Le.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function iE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Le.NONE||(i.preventDefault(),this.dispatchEvent(Jd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(T0))}function sE(i){this.enabled===!1||this.enablePan===!1||this._handleKeyDown(i)}function rE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case dr.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Le.TOUCH_ROTATE;break;case dr.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Le.TOUCH_PAN;break;default:this.state=Le.NONE}break;case 2:switch(this.touches.TWO){case dr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Le.TOUCH_DOLLY_PAN;break;case dr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Le.TOUCH_DOLLY_ROTATE;break;default:this.state=Le.NONE}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(Jd)}function oE(i){switch(this._trackPointer(i),this.state){case Le.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Le.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Le.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Le.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Le.NONE}}function aE(i){this.enabled!==!1&&i.preventDefault()}function lE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function cE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Kd(i){i.traverse(t=>{let{geometry:e,material:n}=t;e?.dispose();for(let s of[n??[]].flat()){for(let{value:r}of Object.values(s.uniforms??{}))r instanceof kn&&r.dispose();s.dispose()}})}function C0(i){let t=4294967295;for(let e=0;e<i.length;++e)t=hE[(t^i[e])&255]^t>>>8;return(t^4294967295)>>>0}var hE=Uint32Array.from({length:256},(i,t)=>{let e=t;for(let n=0;n<8;++n)e=e&1?3988292384^e>>>1:e>>>1;return e>>>0});var ae=class extends Error{};async function gc(i){let t=uE(i);if(t.length!==i.size)throw new ae(`the ${i.kind} block is cut: ${t.length} of ${i.size} bytes are there`);if(C0(t).toString(16).padStart(8,"0")!==i.crc)throw new ae(`the ${i.kind} block is damaged: its checksum is not ${i.crc}`);let e=await dE(t,i.kind);if(e.length!==i.rawSize)throw new ae(`the ${i.kind} block has ${e.length} bytes instead of ${i.rawSize}`);return e}function P0(i){return[...i.querySelectorAll("script.rigor-data")].map(t=>({run:Number(t.dataset.run??0),kind:t.dataset.kind??"unnamed",rawSize:Number(t.dataset.raw??-1),size:Number(t.dataset.size??-1),crc:t.dataset.crc??"",text:t.textContent??""}))}var R0=[0,13,60];function uE({text:i,size:t,kind:e}){let n=new Uint8Array(Math.max(0,Math.min(t,14*i.length>>3))),s=0,r=0,o=0,a=l=>{r=(r<<7|l)&32767,!((o+=7)<8)&&(o-=8,s<n.length&&(n[s++]=r>>o))};for(let l=0;l<i.length;++l){let c=i.charCodeAt(l);if(c<128)a(c);else if(c<128*(1+R0.length))a(R0[(c>>7)-1]),a(c&127);else if(l<i.length-1)throw new ae(`the ${e} block is damaged: it holds characters that are none of its own`)}return n.subarray(0,s)}async function dE(i,t){if(typeof DecompressionStream>"u")throw new ae("this browser cannot decompress data (DecompressionStream); a newer one can");try{let e=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}catch{throw new ae(`the ${t} block is damaged: it cannot be decompressed`)}}var Pi=class{constructor(t){this.bytes=t;this.at=0;this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}get left(){return this.bytes.length-this.at}u32(){return this.view.getUint32(this.take(4),!0)}f32(){return this.view.getFloat32(this.take(4),!0)}f64(){return this.view.getFloat64(this.take(8),!0)}varint(){let t=this.bytes,e=t[this.at++];if(e<128)return e&1?-(e+1)/2:e/2;let n=e&127,s=128;do{if(this.at>=t.length)throw new ae("a block ends inside a number");e=t[this.at++],n+=(e&127)*s,s*=128}while(e>=128);return n%2?-(n+1)/2:n/2}column(t,e,n,s,r,o=2){let a=0,l=0,c=0;for(let h=0,d=s;h<t;++h,d+=r){let u=this.varint()+a;h>1&&o>1&&(u+=a-l),h>2&&o>2&&(u+=a-2*l+c),n[d]=u*e,c=l,l=a,a=u}this.checkEnd()}checkEnd(){if(this.at>this.bytes.length)throw new ae("a block ends before its last number")}exactColumn(t){let e=Array.from({length:8},()=>this.take(t)),n=new DataView(new ArrayBuffer(8*t)),s=0n,r=0n;for(let o=0;o<t;++o){let a=0n;for(let h of e)a=a<<8n|BigInt(this.bytes[h+o]);let l=a&1n?-(a>>1n)-1n:a>>1n,c=BigInt.asUintN(64,l+(o<2?s:2n*s-r));n.setBigUint64(8*o,c),r=s,s=c}return Float64Array.from({length:t},(o,a)=>n.getFloat64(8*a))}take(t){if(this.left<t)throw new ae("a block ends before its last number");return this.at+=t,this.at-t}};function vr(i){return{position:new Float32Array(3*i),orientation:new Float32Array(4*i),velocity:new Float32Array(3*i),spin:new Float32Array(3*i)}}var vc=class{constructor(t){this.header=t;this.count=0;this.moving=t.bodies.flatMap((n,s)=>n.motion==="static"?[]:[s]),this.places=new Int32Array(t.bodies.length).fill(-1),this.moving.forEach((n,s)=>this.places[n]=s);let e=this.moving.length*t.frames;this.position=new Float32Array(3*e),this.velocity=new Float32Array(3*e),this.spin=new Float32Array(3*e),this.components=new Int16Array(3*e),this.largest=new Uint8Array(e)}addChunk(t){let e=new Pi(t),n={speed:e.f64(),spin:e.f64(),travel:e.f64(),turn:e.f64()},s=[e.u32(),e.u32()],r=e.u32(),o=e.u32(),a=this.moving.length;if(o!==a||this.count+r>this.header.frames)throw new ae("a frames block does not belong to this run");let l=this.count*a,c=u=>{let f=new Float64Array(3*a*r);for(let g=0;g<3*a;++g)e.column(r,1,f,g,3*a,u);return f},h=c(s[0]),d=c(s[1]);for(let u=0;u<h.length;++u)this.velocity[3*l+u]=h[u]*n.speed,this.spin[3*l+u]=d[u]*n.spin;this.addPositions(e,r,h,n.travel);for(let u=0;u<a;++u)this.addOrientations(e,r,u,d,n.turn);this.count+=r}addPositions(t,e,n,s){let r=this.moving.length,o=3*this.count*r;for(let a=0;a<3*r;++a){let l=0;for(let c=0,h=a;c<e;++c,h+=3*r)c>0&&(l+=Math.floor((s*(n[h]+n[h-3*r])+32768)/65536)),l+=t.varint(),this.position[o+h]=l*this.header.position_step}t.checkEnd()}addOrientations(t,e,n,s,r){let o=this.moving.length,a=this.header.orientation_parts,l=this.count*o+n;t.column(e,1,this.largest,l,o,1);let c=[0,1,2].map(()=>Float64Array.from({length:e},()=>t.varint()));t.checkEnd();let h=new Float64Array(4),d=[0,0,0],u=[0,0,0];for(let f=0;f<e;++f){let g=l+f*o;if(f>0){for(let y=0;y<3;++y)d[y]=(s[3*(f*o+n)+y]+s[3*((f-1)*o+n)+y])*r;I0(this.largest[g-o],this.components,3*(g-o),h,0,a),fE(h,d),pE(h,this.largest[g],a,u)}for(let y=0;y<3;++y)this.components[3*g+y]=c[y][f]+u[y]}}place(t,e){let n=this.places[e];return n<0||t>=this.count?-1:3*(t*this.moving.length+n)}orientation(t,e,n,s){let r=t*this.moving.length+e;I0(this.largest[r],this.components,3*r,n,s,this.header.orientation_parts)}};function I0(i,t,e,n,s,r=32767){let o=Math.SQRT1_2/r,a=1;for(let l=0,c=0;l<4;++l){if(l===i)continue;let h=t[e+c++]*o;n[s+(l+3&3)]=h,a-=h*h}n[s+(i+3&3)]=Math.sqrt(Math.max(0,a))}function fE(i,t){let e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2];if(!(e<4))return;let n=1-e/2*(1-e/12*(1-e/30)),s=1-e/6*(1-e/20*(1-e/42)),r=s*t[0],o=s*t[1],a=s*t[2],[l,c,h,d]=i;i[3]=n*d-r*l-o*c-a*h,i[0]=n*l+r*d+o*h-a*c,i[1]=n*c-r*h+o*d+a*l,i[2]=n*h+r*c-o*l+a*d}function pE(i,t,e,n){let s=i[t+3&3]<0?-1:1,r=e*Math.SQRT2;for(let o=0,a=0;o<4;++o)o!==t&&(n[a++]=Math.floor(s*i[o+3&3]*r+.5))}var yc=class{constructor(t,e,n,s,r){this.center=e;this.offset=r;this.group=new Wn;this.planes=[];let o=10**Math.floor(Math.log10(n/6));t.bodies.forEach((a,l)=>{for(let c of t.looks[a.look]){if(c.type!=="plane")continue;let h=new _n({glslVersion:Vi,vertexShader:Yg,fragmentShader:$g,transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1,uniforms:{...s,uColor:{value:new he},uLine:{value:new he},uCell:{value:o},uReach:{value:4*n},uShift:{value:[0,0]}}}),d=new Mn(new Is(8*n,8*n),h);d.renderOrder=-1,this.planes.push({body:l,shape:c,mesh:d}),this.group.add(d)}})}setColors(t,e){for(let{mesh:n}of this.planes)n.material.uniforms.uColor.value.setStyle(t,""),n.material.uniforms.uLine.value.setStyle(e,"")}update(t){for(let{body:e,shape:n,mesh:s}of this.planes){let r=new Bn().fromArray(t.orientation,4*e),o=new N().fromArray(t.position,3*e).add(new N(...this.offset)),[a,l,c,h]=n.q;o.add(new N(...n.p).applyQuaternion(r)),r.multiply(new Bn(l,c,h,a));let d=new N(...n.normal??[0,0,1]),u=new Bn().setFromUnitVectors(new N(0,0,1),d),f=o.clone().add(d.clone().multiplyScalar(n.offset??0).applyQuaternion(r));r.multiply(u);let g=this.center.clone().sub(f).applyQuaternion(r.clone().invert());s.quaternion.copy(r),s.position.copy(new N(g.x,g.y,0).applyQuaternion(r).add(f)),s.material.uniforms.uShift.value=[g.x,g.y]}}};function _a(i){let t=i.radius??1,e=i.half_length??1;switch(i.type){case"sphere":return{key:"sphere",scale:[t,t,t]};case"box":return{key:"box",scale:i.half_extents??[1,1,1]};case"ellipsoid":return{key:"ellipsoid",scale:i.radii??[1,1,1]};case"cylinder":case"cone":return{key:i.type,scale:[t,t,e]};case"capsule":return{key:`capsule ${e/t}`,scale:[t,t,t]};case"plane":return{key:"plane",scale:[1,1,1]};case"convex":case"mesh":return{key:`mesh ${i.mesh}`,scale:[1,1,1]}}}function xc(i,t){let[e,n]=i.split(" ");switch(e){case"sphere":return new Is(2,2);case"box":return mE();case"ellipsoid":return new tc(1,32,20).rotateX(Math.PI/2);case"cylinder":return new lr(1,1,2,40).rotateX(Math.PI/2);case"cone":return new _o(1,2,40).rotateX(Math.PI/2);case"capsule":return new Ql(1,2*Number(n),8,24).rotateX(Math.PI/2);default:return gE(t[Number(n)])}}function mE(){let i=new $e,t=[[1,1,1],[-1,1,1],[-1,-1,1],[1,-1,1],[1,-1,-1],[1,1,-1],[-1,1,-1]];return i.setAttribute("position",new Ve(new Float32Array(t.flat()),3)),i.setIndex([0,1,2,0,2,3,0,3,4,0,4,5,0,5,6,0,6,1]),i}function gE(i){let t=new Float32Array(3*i.triangles.length);i.triangles.forEach((n,s)=>t.set(i.vertices.subarray(3*n,3*n+3),3*s));let e=new $e;return e.setAttribute("position",new Ve(t,3)),e.computeVertexNormals(),e}var us={plain:0,metal:1,wood:2,rubber:3,stone:4,glossy:5},vE=[{words:/brass|gold|bronze/i,kind:us.metal,color:"#c7a04a"},{words:/copper/i,kind:us.metal,color:"#bf7a4e"},{words:/steel|iron|metal|alumin|chrome|titan|lead|tungsten/i,kind:us.metal,color:"#a9b3bd"},{words:/wood|oak|pine|beech|maple|birch|walnut|timber|plywood|table/i,kind:us.wood,color:"#c18d57"},{words:/rubber|tyre|tire|felt|leather/i,kind:us.rubber,color:"#5d636c"},{words:/stone|rock|granite|marble|concrete|brick|slate|ground|earth|clay|sand/i,kind:us.stone,color:"#a8a196"},{words:/ice|glass|crystal/i,kind:us.glossy,color:"#a6cfe2"},{words:/plastic|ivory|celluloid|bone|ceramic|porcelain|billiard/i,kind:us.glossy,color:"#d9d3c4"}],yE=12,L0=["#5f8fb8","#d19a5b","#6fa78a","#b185ad"],D0={static:wn("#9aa3ad"),kinematic:wn("#7d8fa3")},_c=class{constructor(t){this.header=t;this.placeOf=new Map;t.bodies.forEach(({motion:e},n)=>e==="dynamic"&&this.placeOf.set(n,this.placeOf.size)),this.isCrowd=this.placeOf.size>yE}of(t,e){let n=vE.find(({words:a})=>a.test(this.header.materials[e.material]?.name??"")),s=n?.kind??us.plain;if(e.color)return{kind:s,color:wn(e.color)};let{motion:r,look:o}=this.header.bodies[t];return r!=="dynamic"?{kind:s,color:n?xE(wn(n.color),D0[r],.55):D0[r]}:n?{kind:s,color:N0(wn(n.color),U0(t)*[1,.86,1.1][o%3])}:this.isCrowd?{kind:s,color:N0(wn(L0[o%L0.length]),U0(t))}:{kind:s,color:wn(Zc[(this.placeOf.get(t)??0)%Zc.length])}}};function U0(i){return .86+.24*(i*.61803398875%1)}function N0(i,t){return i.map(e=>Math.min(1,e*t))}function xE(i,t,e){return i.map((n,s)=>n+e*(t[s]-n))}var bc=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],F0=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],Po=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2];function Mc(i,t,e){let n=1/0;for(let s of t){let[r,o,a,l]=s.q,c=[r,-o,-a,-l],h={from:ye(c,bc(i.from,s.p)),direction:ye(c,i.direction)};n=Math.min(n,bE(h,s,e))}return Number.isFinite(n)?n:void 0}var O0=new WeakMap;function _E(i,t){let e=O0.get(t)??new Map;O0.set(t,e);let n=e.get(i)??xc(i,t);return e.set(i,n),n}function bE(i,t,e){let{key:n,scale:s}=_a(t);if(n==="plane")return 1/0;if(n==="sphere")return ME(i,s[0]);if(n==="box")return wE(i,s);let r=_E(n,e),o=r.getAttribute("position"),a=r.index,l=d=>{let u=a?a.getX(d):d;return[o.getX(u)*s[0],o.getY(u)*s[1],o.getZ(u)*s[2]]},c=1/0,h=a?a.count:o.count;for(let d=0;d<h;d+=3)c=Math.min(c,SE(i,l(d),l(d+1),l(d+2)));return r.dispose(),c}function ME({from:i,direction:t},e){let n=Po(i,t),s=n*n-Po(i,i)+e*e,r=-n-Math.sqrt(s);return r>0?r:1/0}function wE({from:i,direction:t},e){let n=0,s=1/0;for(let r=0;r<3;++r){let o=(-e[r]-i[r])/t[r],a=(e[r]-i[r])/t[r];Number.isNaN(o)||Number.isNaN(a)||(n=Math.max(n,Math.min(o,a)),s=Math.min(s,Math.max(o,a)))}return n>0&&n<=s?n:1/0}function SE({from:i,direction:t},e,n,s){let r=bc(n,e),o=bc(s,e),a=F0(t,o),l=Po(r,a),c=bc(i,e),h=F0(c,r),d=Po(c,a)/l,u=Po(t,h)/l,f=Po(o,h)/l;return d>=0&&u>=0&&d+u<=1&&f>0?f:1/0}var k0=6e3,EE=32,jd=(i,t)=>`${i} ${t}`,wc=class{constructor(t){this.source=t;let{header:e,moving:n,times:s}=t,r=e.bodies.flatMap(({motion:l},c)=>l==="static"?ki(e,c).map((h,d)=>({body:c,index:d,shape:h})):[]);this.obstacles=r.filter(({shape:l})=>l.type!=="plane").slice(0,k0/8),this.planes=r.filter(({shape:l})=>l.type==="plane");let o=Math.max(8,Math.min(EE,Math.floor(k0/Math.max(1,this.obstacles.length)))),a=Math.max(1,Math.ceil(n.length/o));this.targets=n.filter((l,c)=>c%a===0),this.samples=[0,.35,.7,1].map(l=>{let c=vr(e.bodies.length);return t.sample(s[0]+l*(s[s.length-1]-s[0]),c),c}),this.start=this.samples[0]}hiding(t,e){let n=Math.max(1,.06*this.targets.length),s=this.obstacles.filter(r=>this.targets.reduce((o,a)=>o+(this.hides(r,t,this.targetOf(a,e,t))?1:0),0)>=n);return new Set(s.map(({body:r,index:o})=>jd(r,o)))}blocked(t){if(this.planes.some(s=>this.isBehind(s,t)))return 1;let e=this.targets.filter((s,r)=>r%Math.max(1,Math.ceil(this.targets.length/10))===0),n=0;for(let s of this.samples)for(let r of e){let o=this.targetOf(r,s,t);this.obstacles.some(a=>this.hides(a,t,o))&&++n}return n/Math.max(1,e.length*this.samples.length)}get isOpen(){return this.obstacles.length===0}targetOf(t,e,n){let s=Fe(e.position,t),r=n.map((l,c)=>l-s[c]),o=Math.hypot(...r)||1,a=.7*(this.source.header.bodies[t].radius??0);return s.map((l,c)=>l+r[c]*Math.min(a,.5*o)/o)}hides({body:t,shape:e},n,s){let r=s.map((y,m)=>y-n[m]),o=Math.hypot(...r),a=Fe(this.start.position,t),[l,c,h,d]=ii(this.start,t),u=y=>ye([l,-c,-h,-d],y),f={from:u(n.map((y,m)=>y-a[m])),direction:u(r.map(y=>y/o))},g=Mc(f,[e],this.source.meshes);return g!==void 0&&g<.999*o}isBehind({body:t,shape:e},n){let s=ii(this.start,t),r=ye(s,ye(e.q,e.normal??[0,0,1])),o=ye(s,e.p).map((a,l)=>a+this.start.position[3*t+l]+r[l]*(e.offset??0));return r.reduce((a,l,c)=>a+l*(n[c]-o[c]),0)<0}};var AE=2e6,ba=class{constructor(t,e,n,s){this.header=t;this.options=s;this.group=new Wn;this.shadows=new Wn;this.batches=[];let r=wn(s.tint??Pe.ghost);this.uniforms={...n,uPick:{value:0},uGhost:{value:s.isGhost?1:0},uTint:{value:new Ye(...r,s.isGhost?.85:0)},uSelected:{value:new N(...wn(Pe.selected))},uWarning:{value:new N(...wn(Pe.penetration))}};let o=new Map;t.bodies.forEach((l,c)=>{ki(t,c).forEach((h,d)=>{let{key:u}=_a(h);if(u==="plane")return;let f=o.get(u)??[];o.set(u,f),f.push({body:c,index:d,shape:h})})});let a=new _c(t);for(let[l,c]of o)this.addBatch(l,c,a,e)}update(t){for(let e of this.batches){let n=e.pose.image.data;e.items.forEach((s,r)=>LE(t,s,this.options.offset,8*r,n)),e.pose.needsUpdate=!0}}mark({selected:t,overlapping:e,glass:n,heat:s}){for(let r of this.batches){let o=r.pose.image.data;r.items.forEach(({body:a,index:l},c)=>{let h=s?s[a]:-1;o[8*c+3]=a===t?1:e.has(a)?2:n.size>0&&n.has(jd(a,l))?3:h>=0?4+h:0}),r.pose.needsUpdate=!0}}setPicking(t){this.uniforms.uPick.value={none:0,all:1,moving:2}[t]}addBatch(t,e,n,s){let r=t==="sphere",o=t==="box",a=B0(e.length),l={uPose:{value:a},uLook:{value:this.lookTable(e,n)}},c=xc(t,s),h=/^mesh/.test(t)?TE(c):1,d=CE(c,e.length),u=new _n({glslVersion:Vi,vertexShader:r?zg:o?kg:Og,fragmentShader:r?Vg:Bg,uniforms:{...this.uniforms,...l,uIsRound:{value:IE(t)?1:0},uIsFlat:{value:o?1:0},uSize:{value:h}},side:o?fi:zi,transparent:this.options.isGhost,polygonOffset:this.options.isGhost,polygonOffsetFactor:1,polygonOffsetUnits:2,alphaToCoverage:!this.options.isGhost,...this.options.isGhost?{}:{blending:Id,blendSrc:sc,blendDst:ic,blendSrcAlpha:ic,blendDstAlpha:sc}});this.group.add(z0(d,u)),this.options.isGhost||this.shadows.add(z0(d,this.shadowMaterial(r,o,l))),this.batches.push({items:e,pose:a})}lookTable(t,e){let n=B0(t.length),s=n.image.data;return t.forEach(({body:r,shape:o},a)=>{s.set(_a(o).scale,8*a),s[8*a+3]=this.header.bodies[r].motion==="static"?-1-r:r;let{color:l,kind:c}=e.of(r,o);s.set([...l,c],8*a+4)}),n}shadowMaterial(t,e,n){return new _n({glslVersion:Vi,vertexShader:t?Wg:e?Gg:Hg,fragmentShader:t?qg:Xg,uniforms:{uLight:this.uniforms.uLight,...n},side:t||e?fi:Cn,colorWrite:!1})}};function TE(i){return i.computeBoundingSphere(),(i.boundingSphere?.radius??0)||1}function B0(i){let t=Math.max(1,Math.ceil(2*i/Ao)),e=new Wl(new Float32Array(4*Ao*t),Ao,t,Qn,Ti);return e.needsUpdate=!0,e}function CE(i,t){return i.getAttribute("position").count*t<=AE?RE(i,t):PE(i,t)}function z0(i,t){let e=new Mn(i,t);return e.frustumCulled=!1,e}function RE(i,t){let e=new $e,n=i.getAttribute("position").count;for(let r of["position","normal"]){let o=i.getAttribute(r);if(!o)continue;let a=new Float32Array(3*n*t);for(let l=0;l<t;++l)a.set(o.array,3*n*l);e.setAttribute(r,new Ve(a,3))}let s=i.index?.array??Uint32Array.from({length:n},(r,o)=>o);return e.setIndex(new Ve(Uint32Array.from({length:s.length*t},(r,o)=>s[o%s.length]+n*Math.floor(o/s.length)),1)),e.setAttribute("shapeIndex",new Ve(Float32Array.from({length:n*t},(r,o)=>Math.floor(o/n)),1)),e}function PE(i,t){let e=new Mo;e.index=i.index;for(let n of["position","normal"]){let s=i.getAttribute(n);s&&e.setAttribute(n,s)}return e.setAttribute("shapeIndex",new ar(Float32Array.from({length:t},(n,s)=>s),1)),e.instanceCount=t,e}function IE(i){return/^(cylinder|cone|capsule|ellipsoid)/.test(i)}function LE(i,{body:t,shape:e},n,s,r){let o=i.orientation,a=o[4*t],l=o[4*t+1],c=o[4*t+2],h=o[4*t+3],[d,u,f]=e.p,g=2*(l*f-c*u),y=2*(c*d-a*f),m=2*(a*u-l*d);r[s]=i.position[3*t]+n[0]+d+h*g+l*m-c*y,r[s+1]=i.position[3*t+1]+n[1]+u+h*y+c*g-a*m,r[s+2]=i.position[3*t+2]+n[2]+f+h*m+a*y-l*g;let[p,E,S,M]=e.q;r[s+4]=h*E+a*p+l*M-c*S,r[s+5]=h*S-a*M+l*p+c*E,r[s+6]=h*M+a*S-l*E+c*p,r[s+7]=h*p-a*E-l*S-c*M}var Qd={none:1,coarse:512,hard:1024,soft:2048},Sc=class{constructor(t){this.scene=new xo;this.camera=new ha;this.light=new N;this.matrix=new Xe;this.quality="soft";this.reach=1;let e=Math.abs(t.z)>.7?new N(-.45,-.35,0):new N(-.4,.3,.35);this.light.copy(t).add(e.projectOnPlane(t)).normalize(),this.target=V0(Qd.soft),this.uniforms={uUp:{value:t},uLight:{value:this.light},uShadowMatrix:{value:this.matrix},uShadowMap:{value:this.target.depthTexture},uShadows:{value:2},uTexel:{value:0}}}setQuality(t){t!==this.quality&&(this.quality=t,this.uniforms.uShadows.value={none:0,coarse:1,hard:1,soft:2}[t],this.target.dispose(),this.target=V0(Qd[t]),this.uniforms.uShadowMap.value=this.target.depthTexture,this.aim())}fit(t){let e=new N(...t.center);this.reach=1.25*t.radius,this.camera.position.copy(e).addScaledVector(this.light,5*this.reach),this.camera.up.set(0,0,1).addScaledVector(this.light,-this.light.z),this.camera.up.length()<.1&&this.camera.up.set(0,1,0),this.camera.lookAt(e),this.aim()}draw(t){if(this.quality==="none")return;let e=t.getRenderTarget();t.setRenderTarget(this.target),t.setClearColor(16777215,1),t.clear(),t.render(this.scene,this.camera),t.setRenderTarget(e)}aim(){let{camera:t,reach:e}=this;[t.left,t.right,t.bottom,t.top,t.near,t.far]=[-e,e,-e,e,.5*e,12*e],t.updateProjectionMatrix(),t.updateMatrixWorld(),this.matrix.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1).multiply(t.projectionMatrix).multiply(t.matrixWorldInverse),this.uniforms.uTexel.value=2*e/Qd[this.quality]}};function V0(i){let t=new yo(i,i,os);return t.compareFunction=ac,t.minFilter=t.magFilter=pi,new ei(i,i,{depthTexture:t})}var Ec=[{ratio:1,shadows:"soft"},{ratio:1,shadows:"hard"},{ratio:.75,shadows:"hard"},{ratio:.5,shadows:"coarse"},{ratio:.5,shadows:"none"}],H0=120,Ac=class{constructor(t,e,n,s,r){this.source=e;this.ghost=n;this.extent=s;this.ghostColor=r;this.followed=-1;this.onChange=()=>{};this.scene=new xo;this.camera=new On(40,0,.01,1e3);this.content=new Wn;this.line=new pr;this.pixel={value:.001};this.ratio={value:1};this.followedAt=new N;this.glass=new Set;this.glassAt=-1/0;this.slowness=0;this.quality=0;this.hottest=0;this.renderer=new Gl({antialias:!0,powerPreference:"high-performance"}),this.renderer.outputColorSpace="srgb-linear",this.canvas=this.renderer.domElement,this.canvas.setAttribute("role","img"),this.canvas.setAttribute("aria-label","The scene. Drag to turn, scroll to come closer, click a body to see its numbers."),t.append(this.canvas);let o=new N(...e.header.gravity);this.up=o.length()>0?o.clone().normalize().negate():new N(0,0,1),this.camera.up.copy(this.up),this.controls=new mc(this.camera,this.canvas),this.controls.addEventListener("change",()=>this.onChange()),this.sun=new Sc(this.up),this.scene.add(this.line.lines),this.build(e.times[0])}setRuns(t,e,n,s,r){let o=new N(...this.source.header.origin).sub(new N(...t.header.origin));this.camera.position.add(o),this.controls.target.add(o),this.controls.update(),this.followed=-1,this.source=t,this.ghost=e,this.extent=n,this.ghostColor=r,this.content.removeFromParent(),Kd(this.content),this.sun.scene.clear(),Kd(this.shapes.shadows),this.build(s)}build(t){let{source:e,ghost:n,extent:s}=this,{header:r}=e;if(this.content=new Wn,this.scene.add(this.content),this.motion=vr(r.bodies.length),this.sun.fit(s),this.sight=new wc(e),this.glassAt=-1/0,this.shapes=new ba(r,e.meshes,this.sun.uniforms,{isGhost:!1,offset:[0,0,0]}),this.sun.scene.add(this.shapes.shadows),this.ground=new yc(r,new N(...s.center),s.radius,this.sun.uniforms,[0,0,0]),this.marks=new hc(e,s.radius,this.pixel,this.ratio),this.content.add(this.ground.group,this.shapes.group),this.content.add(this.marks.trails.lines,this.marks.links.lines,this.marks.arrows.mesh,this.marks.ring.points,this.marks.dots.points),this.ghostShapes=void 0,n){let o=n.header.origin.map((a,l)=>a-r.origin[l]);this.ghostMotion=vr(n.header.bodies.length),this.ghostShapes=new ba(n.header,n.meshes,this.sun.uniforms,{isGhost:!0,offset:o,tint:this.ghostColor}),this.content.add(this.ghostShapes.group)}e.sample(t,this.motion),this.ground.update(this.motion),this.theme&&this.setTheme(...this.theme)}fit(){let{direction:t,distance:e}=this.bestView();this.controls.target.set(...this.extent.center),this.camera.position.copy(this.controls.target).addScaledVector(t,e),this.camera.near=e/500,this.camera.far=e*60,this.camera.updateProjectionMatrix(),this.controls.minDistance=e/200,this.controls.maxDistance=e*20,this.controls.update()}bestView(){let t=(Math.abs(this.up.z)>.7?new N(.35,-1,0):new N(.35,.2,1)).projectOnPlane(this.up).normalize(),e=new N(...this.extent.center),n=[0,1,-1,2,-2,3,-3,4].flatMap(o=>[.42,.8,1.5].map(a=>{let l=t.clone().applyAxisAngle(this.up,o*Math.PI/4).addScaledVector(this.up,a).normalize(),c=this.distanceToSeeAll(l);return{direction:l,distance:c,cost:.07*Math.abs(o)+.2*(a-.42),eye:e.clone().addScaledVector(l,c).toArray()}})),s=Math.min(...n.map(({distance:o})=>o)),r=n.map(({distance:o,cost:a,eye:l})=>a+.5*(o/s-1)+2*this.sight.blocked(l));return n[r.indexOf(Math.min(...r))]}distanceToSeeAll(t){let e=Math.tan(this.camera.fov*Math.PI/360),n=new N().crossVectors(this.up,t).normalize(),s=new N().crossVectors(t,n),r=0;for(let o=0;o<8;++o){let a=new N(...this.extent.half.map((h,d)=>o&1<<d?h:-h)),l=Math.abs(a.dot(n))/this.camera.aspect,c=Math.abs(a.dot(s));r=Math.max(r,Math.max(l,c)/e+a.dot(t))}return 1.12*r}setTheme(t,e,n){this.theme=[t,e,n],this.scene.background=new he().setStyle(t,""),this.ground.setColors(e,n)}resize(t,e){let n=this.camera.aspect===0,s=Math.min(window.devicePixelRatio,2)*Ec[this.quality].ratio;this.ratio.value=s,this.renderer.setPixelRatio(s),this.renderer.setSize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),n&&this.fit(),this.pixel.value=2*Math.tan(this.camera.fov*Math.PI/360)/e}draw(t,e,n,s,r){this.source.sample(t,this.motion),this.shapes.update(this.motion),this.ground.update(this.motion),this.follow();let o=e.contacts||e.penetration||e.heat?this.source.contactsAt(t):[],l=(e.penetration?Gd(o,this.source):[]).flatMap(({bodyA:c,bodyB:h})=>[c,h]);this.shapes.mark({selected:n,overlapping:new Set([...l,...r]),glass:this.glassNow(),heat:e.heat?this.heatOf(o):void 0}),this.sun.setQuality(e.shadows?Ec[this.quality].shadows:"none"),this.marks.update(t,this.motion,o,e,n,s),this.ghostShapes&&this.ghost&&this.ghostMotion&&(this.ghostShapes.group.visible=e.ghost,e.ghost&&(this.ghost.sample(t,this.ghostMotion),this.ghostShapes.update(this.ghostMotion))),this.sun.draw(this.renderer),this.renderer.render(this.scene,this.camera)}glassNow(){let t=performance.now();return this.sight.isOpen?this.glass:t-this.glassAt<H0?(this.glassTimer??(this.glassTimer=setTimeout(()=>(this.glassTimer=void 0,this.onChange()),H0)),this.glass):(this.glassAt=t,this.glass=this.sight.hiding(this.camera.position.toArray(),this.motion),this.glass)}heatOf(t){let{bodies:e}=this.source.header,{forces:n,hottest:s}=o0(e.length,t);return this.hottest=s,n.map((r,o)=>e[o].motion!=="dynamic"?-1:s>0?Math.min(.999,Math.sqrt(r/s)):0)}pick(t,e,n="all"){let s=this.renderer.getSize(new At),r=new ei(1,1),o=this.scene.background,a=[this.ground.group,this.marks.trails.lines,this.marks.links.lines,this.marks.arrows.mesh,this.marks.ring.points,this.marks.dots.points,this.ghostShapes?.group],l=a.map(h=>h?.visible);a.forEach(h=>h&&(h.visible=!1)),this.shapes.setPicking(n),this.scene.background=null,this.camera.setViewOffset(s.x,s.y,t,e,1,1),this.renderer.setRenderTarget(r),this.renderer.setClearColor(0,0),this.renderer.clear(),this.renderer.render(this.scene,this.camera);let c=new Uint8Array(4);return this.renderer.readRenderTargetPixels(r,0,0,1,1,c),this.renderer.setRenderTarget(null),this.camera.clearViewOffset(),this.shapes.setPicking("none"),this.scene.background=o,a.forEach((h,d)=>h&&(h.visible=l[d]??!0)),r.dispose(),c[0]+256*c[1]+65536*c[2]-1}rayAt(t,e){let n=this.renderer.getSize(new At),s=new N(2*t/n.x-1,1-2*e/n.y,.5).unproject(this.camera),r=this.camera.position;return{from:r.toArray(),direction:s.sub(r).normalize().toArray(),forward:this.camera.getWorldDirection(new N).toArray()}}set canTurn(t){this.controls.enabled=t}showLine(t){this.line.clear(),t&&this.line.add(t[0],t[1],wn(Pe.impulse)),this.line.commit()}startFollowing(t){if(this.followed=t,t<0)return;this.followedAt.fromArray(this.motion.position,3*t);let e=this.followedAt.clone().sub(this.controls.target);this.controls.target.add(e),this.camera.position.add(e),this.controls.update()}noteFrameTime(t){return this.slowness=t>1/30?this.slowness+Math.min(6,30*t):Math.max(0,this.slowness-2),this.slowness<18||this.quality===Ec.length-1?!1:(this.slowness=0,++this.quality,!0)}get resolution(){return Ec[this.quality].ratio}follow(){if(this.followed<0)return;let t=new N().fromArray(this.motion.position,3*this.followed),e=t.clone().sub(this.followedAt);this.controls.target.add(e),this.camera.position.add(e),this.followedAt.copy(t),this.camera.lookAt(this.controls.target)}};var DE={c:"contacts",v:"velocities",x:"frames",i:"inertia",j:"joints",t:"trails",p:"penetration",g:"ghost",h:"shadows",m:"heat"},Io=class{constructor(t,e,n,s,r=Sn(1)){this.source=t;this.ghost=e;this.selected=-1;this.shown={...i0,chosen:new Set};this.stage=U("div",{class:"stage"});this.flagged=[];this.isDirty=!0;this.lastNumbers=0;this.view=this.makeView(n,r),this.help=UE(s)}begin(){this.panel.updateShown(),this.panel.showEvent(void 0),new ResizeObserver(()=>this.resize()).observe(this.stage),window.addEventListener("keydown",t=>this.press(t)),window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.applyTheme()),this.resize(),this.applyTheme(),requestAnimationFrame(t=>this.frame(t))}select(t){this.selected=t,this.plots.showBody(t),t<0&&this.view?.startFollowing(-1),this.invalidate()}follow(t){this.view?.startFollowing(this.view.followed===t?-1:t),this.invalidate()}positionOf(t){return this.view?Fe(this.view.motion.position,t).map((e,n)=>e+this.source.header.origin[n]):[]}drawScene(){r0(this.shown,this.source)&&this.panel.updateShown(),this.view?.draw(this.time,this.shown,this.selected,this.event,this.flagged),this.panel.showHeat(this.shown.heat?this.view?.hottest:void 0)}invalidate(){this.isDirty=!0}setEvent(t){this.event!==t&&(this.event=t,this.panel.showEvent(t))}resize(){this.view?.resize(Math.max(1,this.stage.clientWidth),Math.max(1,this.stage.clientHeight)),this.invalidate()}tools(){return U("span",{class:"tools"},Se("\u2302","Look at the whole scene again (R)",()=>this.home()),Se("\u2913","Save a picture (S)",()=>this.savePicture()),this.filmButton(),Se("\u25D0","Dark or light (D)",()=>this.changeTheme()),Se("?","Keyboard help (?)",()=>this.help.showModal()))}makeView(t,e){try{let n=new Ac(this.stage,this.source,this.ghost,t,e);n.onChange=()=>this.isDirty=!0;let s=[0,0];return n.canvas.addEventListener("pointerdown",r=>s=[r.clientX,r.clientY]),n.canvas.addEventListener("click",r=>{Math.hypot(r.clientX-s[0],r.clientY-s[1])>4||this.select(n.pick(r.offsetX,r.offsetY))}),n}catch{this.stage.append(U("p",{class:"hint",text:"This browser gives no WebGL 2, so the scene cannot be drawn; all the rest of the page is here."}));return}}home(){this.view?.startFollowing(-1),this.view?.fit(),this.invalidate()}filmButton(){if(!this.view||!xa.isPossible)return;let t=Se("\u25CF","Record a film of the scene",()=>(e.isRunning?e.end():e.begin(),n())),e=new xa(this.view.canvas,(s,r)=>{Tc(`${this.source.header.scene}.${r}`,s),n()}),n=()=>{t.classList.toggle("on",e.isRunning),t.setAttribute("aria-pressed",String(e.isRunning)),t.textContent=e.isRunning?"\u25A0":"\u25CF",this.invalidate()};return t}changeTheme(){let t=getComputedStyle(this.element).getPropertyValue("--is-dark").trim()==="1";document.documentElement.dataset.theme=t?"light":"dark",this.applyTheme()}applyTheme(){let t=getComputedStyle(this.element),e=n=>t.getPropertyValue(n).trim();this.view?.setTheme(e("--stage"),e("--ground"),e("--ground-line")),this.plots.redraw(),this.redrawTicks(),this.invalidate()}savePicture(){this.drawScene(),this.view?.canvas.toBlob(t=>t&&Tc(`${this.source.header.scene}-${$i(this.time,1e-4)}s.png`,t))}press(t){let e=t.target;if(t.ctrlKey||t.metaKey||t.altKey||(t.key===" "||t.key==="Enter")&&e.matches("button:focus-visible, summary, input, a"))return;if(e.matches("input:not([type=checkbox]), select")){t.key==="Escape"&&e.blur();return}let n={f:()=>this.selected>=0&&this.follow(this.selected),r:()=>this.home(),s:()=>this.savePicture(),d:()=>this.changeTheme(),"/":()=>this.panel.search.focus(),"?":()=>this.help.open?this.help.close():this.help.showModal(),Escape:()=>this.help.open?this.help.close():this.select(-1),...this.keys(t)},s=DE[t.key],r=s?()=>this.flip(s):n[t.key];r&&(t.preventDefault(),r(),this.invalidate())}flip(t){this.shown[t]=!this.shown[t],this.shown.chosen.add(t),this.panel.updateShown()}};function Tc(i,t){let e=U("a",{href:URL.createObjectURL(t),download:i});e.click(),URL.revokeObjectURL(e.href)}function UE(i){let t=U("dialog",{class:"help","aria-label":"Keyboard help"},U("h2",{text:"Keys"}),U("table",{},...i.map(([e,n])=>U("tr",{},U("th",{scope:"row"},...e.split(" ").map(s=>U("kbd",{text:s}))),U("td",{text:n})))),U("p",{text:"Mouse: drag turns, right drag shifts, wheel comes closer, a click chooses a body. Time line: a click on a tick shows that impact."}),Se("Close","Close",()=>t.close()));return t}var Lo=class{constructor(t){this.run=t;this.kind="recorded";this.impacts=new Map;let e=new Map(t.frames.moving.map((n,s)=>[n,s]));for(let n of t.events){if(n.kind!=="impact")continue;let s=Gn(t.times,n.time),r=this.impacts.get(s)??new Map;this.impacts.set(s,r);for(let o of[n.bodyA,n.bodyB]){let a=e.get(o);a!==void 0&&r.set(a,[r.get(a)?.[0]??n.time,n.time])}}}get header(){return this.run.header}get meshes(){return this.run.meshes}get times(){return this.run.times}get series(){return this.run.series}get events(){return this.run.events}get moving(){return this.run.frames.moving}get frames(){return this.run.frames}get frameTimes(){return this.run.times}get mostContacts(){return this.run.contacts.most}contactsAt(t){return this.run.contacts.at(Gn(this.run.times,t))}sample(t,e){let{times:n,frames:s,header:r}=this.run,o=Gn(n,t),a=Math.min(o+1,n.length-1),l=n[a]-n[o],c=l>0?Math.min(Math.max(t-n[o],0),l):0,h=this.impacts.get(o),d=s.moving.length;r.bodies.forEach((u,f)=>{u.motion==="static"&&NE(u.start.p,u.start.q,r.origin,f,e)});for(let u=0;u<d;++u){let f=s.moving[u],g=c>0&&c<l?h?.get(u):void 0,y=3*(o*d+u),m=3*(a*d+u);for(let p=0;p<3;++p){let E=s.position[y+p],S=s.position[m+p],M=s.velocity[y+p],D=s.velocity[m+p];e.position[3*f+p]=g?OE(E,M,S,D,l,c,g[0]-n[o],g[1]-n[o]):c>0?FE(E,M,S,D,l,c):E;let P=g?c<g[1]-n[o]:c<l,I=g?P?0:1:l>0?c/l:0;e.velocity[3*f+p]=M+I*(D-M),e.spin[3*f+p]=s.spin[y+p]+I*(s.spin[m+p]-s.spin[y+p])}s.orientation(o,u,e.orientation,4*f),c>0&&(s.orientation(a,u,G0,0),kE(e.orientation,4*f,G0,c/l))}}},G0=new Float32Array(4);function NE(i,t,e,n,s){for(let r=0;r<3;++r)s.position[3*n+r]=i[r]-e[r],s.orientation[4*n+r]=t[r+1];s.orientation[4*n+3]=t[0]}function FE(i,t,e,n,s,r){let o=r/s,a=1-o;return a*a*((1+2*o)*i+r*t)+o*o*((1+2*a)*e-(s-r)*n)}function OE(i,t,e,n,s,r,o,a){let l=i+t*o,c=e-n*(s-a),h=o===a?(l+c)/2:l,d=o===a?h:c;return r<=o?W0(i,t,h,o,r):r>=a?W0(e,-n,d,s-a,s-r):h+(d-h)*(r-o)/(a-o)}function W0(i,t,e,n,s){return n>0?i+t*s+(e-i-t*n)*(s/n)**2:e}function kE(i,t,e,n){let s=0;for(let a=0;a<4;++a)s+=i[t+a]*e[a];let r=s<0?-1:1,o=0;for(let a=0;a<4;++a)i[t+a]+=n*(r*e[a]-i[t+a]),o+=i[t+a]**2;o=1/Math.sqrt(o);for(let a=0;a<4;++a)i[t+a]*=o}var BE=5,Do=class{constructor(t,e,n,s){this.range=t;this.resolution=n;this.actions=s;this.ticks=U("canvas");this.handle=U("div",{class:"handle"});this.events=[];this.impactTimes=new Float64Array;this.impacts=[];this.element=U("div",{class:"line",id:"scrubber",role:"slider",tabindex:0,"aria-label":"Time","aria-valuemin":t.begin,"aria-valuemax":t.end},this.ticks,this.handle),this.element.addEventListener("pointerdown",r=>this.press(r)),this.element.addEventListener("pointermove",r=>{this.element.hasPointerCapture(r.pointerId)?s.seek(this.timeAt(r.clientX)):this.element.title=this.hint(r.clientX)}),this.setEvents(e),new ResizeObserver(()=>this.drawTicks()).observe(this.element)}setEvents(t){this.events=t,this.impacts=t.flatMap((e,n)=>e.kind==="impact"?[n]:[]),this.impactTimes=Float64Array.from(this.impacts,e=>t[e].time),this.element.setAttribute("aria-valuemax",String(this.range.end)),this.drawTicks()}get hasImpacts(){return this.impacts.length>0}update(t,e=this.resolution){this.handle.style.left=`${100*this.placeOf(t)}%`,this.element.setAttribute("aria-valuenow",t.toFixed(6)),this.element.setAttribute("aria-valuetext",`${$i(t,e)} seconds`)}impactFrom(t,e){let n=1e-9*Math.max(1,Math.abs(t)),s=this.impactTimes;if(s.length===0)return;let r=Gn(s,t+n);return e===1?r=s[r]>t+n?r:r+1:r=Gn(s,t-n),r<s.length&&(e===1||s[r]<t-n)?this.impacts[r]:void 0}drawTicks(){let t=this.element.clientWidth,e=this.element.clientHeight;if(t===0)return;let n=window.devicePixelRatio||1;this.ticks.width=t*n,this.ticks.height=e*n;let s=this.ticks.getContext("2d");if(!s)return;s.scale(n,n);let r=getComputedStyle(this.element),o={impact:r.getPropertyValue("--impact"),other:r.getPropertyValue("--quiet")},a=new Set;for(let l of this.events){let c=Math.round(this.placeOf(l.time)*t),h=l.kind==="impact",d=`${c} ${h}`;a.has(d)||(a.add(d),s.fillStyle=h?o.impact:o.other,s.fillRect(c-.5,h?4:e-8,1,h?e-14:6))}}placeOf(t){let{begin:e,end:n}=this.range;return n>e?(t-e)/(n-e):0}timeAt(t){let e=this.element.getBoundingClientRect(),n=Math.min(1,Math.max(0,(t-e.left)/e.width));return this.range.begin+n*(this.range.end-this.range.begin)}tickAt(t){let e=Zp(this.impactTimes,this.timeAt(t));if(e<0)return;let n=this.element.getBoundingClientRect();return Math.abs(n.left+this.placeOf(this.impactTimes[e])*n.width-t)<=BE?this.impacts[e]:void 0}hint(t){let e=this.tickAt(t);return e===void 0?`${$i(this.timeAt(t),this.resolution)} s`:`impact at ${Kt(this.events[e].time,8)} s`}press(t){this.element.focus();let e=this.tickAt(t.clientX);if(e!==void 0){this.actions.showEvent(e);return}this.element.setPointerCapture(t.pointerId),this.actions.seek(this.timeAt(t.clientX))}};var Cc=class{constructor(t,e,n,s){this.playback=t;this.resolution=n;this.line=new Do(t,e,n,s),this.play=Se("\u25B6","Play or pause (space)",()=>s.toggle()),this.play.id="play",this.loop=Se("\u27F3","Loop (L)",()=>{t.isLooping=!t.isLooping,this.update()}),this.speed=U("select",{title:"Speed (\u2212 and +)","aria-label":"Speed",onchange:()=>t.speed=Number(this.speed.value)},...gr.map(r=>U("option",{value:r},La(r)))),this.clock=U("span",{class:"clock"}),this.impactButtons=[Se("\u21E4 impact","Previous impact ([)",()=>s.nextImpact(-1)),Se("impact \u21E5","Next impact (])",()=>s.nextImpact(1))],this.element=U("div",{class:"transport"},U("div",{class:"buttons"},Se("|\u25C2","First frame (Home)",()=>s.seek(t.begin)),Se("\u2039","One frame back (\u2190)",()=>s.step(-1)),this.play,Se("\u203A","One frame on (\u2192)",()=>s.step(1)),Se("\u25B8|","Last frame (End)",()=>s.seek(t.end)),this.loop,this.speed,...this.impactButtons,this.clock),this.line.element),this.setEvents(e)}setEvents(t){this.line.setEvents(t);for(let e of this.impactButtons)e.hidden=!this.line.hasImpacts}update(){let{playback:t}=this;this.play.textContent=t.isPlaying?"\u275A\u275A":"\u25B6",this.loop.classList.toggle("on",t.isLooping),this.loop.setAttribute("aria-pressed",String(t.isLooping)),this.speed.value=String(t.speed);let e=this.resolution*Math.min(1,t.speed);this.clock.textContent=`${$i(t.time,e)} / ${Kt(t.end)} s`,this.line.update(t.time,e)}};var zE=100,Rc=class extends Io{constructor(e){let n=e.runs.map(d=>new Lo(d)),s={a:0,b:n.length>1?x0(n):-1},[r,o]=[n[0],n[s.b]];super(r,o,ya(r.header,r.frames,r.meshes),p0,Sn(Math.max(0,s.b)));this.lastFrame=0;this.sources=n;let a=n.map(d=>d.times);this.playback=new dc(Math.min(...a.map(d=>d[0])),Math.max(...a.map(d=>d[d.length-1]))),this.transport=new Cc(this.playback,r.events,r.header.output_interval,{toggle:()=>this.toggle(),step:d=>this.step(d),seek:d=>this.seek(d),showEvent:d=>this.showEvent(d),nextImpact:d=>this.nextImpact(d)}),this.panel=new Ro(r,this.shown,o!==void 0,{select:d=>this.select(d),follow:d=>this.follow(d),changed:()=>this.invalidate(),showDeepest:()=>this.showDeepest()});let l=n.length>1,c=d=>this.seek(d);this.plots=l?new va(n,s,c):new Co(r,c),document.addEventListener("visibilitychange",()=>this.lastFrame=performance.now());let h=l?new fc(n,s,d=>this.showRuns(d)).element:void 0;this.element=U("main",{class:l?"app comparison":"app"},this.head(),h,...e.problems.map(d=>U("p",{class:"problem",role:"alert",text:d})),U("div",{class:"middle"},this.stage,this.panel.element),this.transport.element,this.plots.element,e.precision?S0(e.precision):void 0,l?Ef(n):void 0,this.help)}toggle(){this.playback.toggle(),this.setEvent(void 0),this.invalidate()}seek(e){this.setEvent(void 0),this.flagged=[],this.playback.seek(e),this.invalidate()}step(e){this.playback.isPlaying=!1,this.seek(v0(this.source.times,this.playback.time,e))}showEvent(e){let n=this.source.events[e];this.playback.isPlaying=!1,this.playback.seek(n.time),this.setEvent(n),this.invalidate()}nextImpact(e){let n=this.transport.line.impactFrom(this.playback.time,e);n!==void 0&&this.showEvent(n)}showRuns({a:e,b:n}){let s=a=>a<0?-1:this.sources[e].header.bodies.findIndex(({name:l})=>l===this.source.header.bodies[a].name),r=s(this.selected),o=s(this.view?.followed??-1);this.source=this.sources[e],this.ghost=this.sources[n],this.setEvent(void 0),this.flagged=[],this.view?.setRuns(this.source,this.ghost,ya(this.source.header,this.source.frames,this.source.meshes),this.playback.time,Sn(n)),this.panel.setSource(this.source),this.transport.setEvents(this.source.events),this.plots instanceof va&&this.plots.setRuns({a:e,b:n}),this.select(r),o>=0&&this.follow(o)}head(){let{header:e}=this.source,n=e.audit.method,s=n?.solver==="substep"?[n.scheme,n.solver]:[n?.scheme,n?.integrator,n?.impact],r=this.sources.length>1?`${this.sources.length} runs`:s.filter(Boolean).join(" \xB7 ");return U("header",{},U("h1",{text:e.scene}),U("span",{class:"about",text:`${r} \xB7 ${e.bodies.length} ${e.bodies.length===1?"body":"bodies"} \xB7 ${this.source.times.length} frames`}),this.tools())}get time(){return this.playback.time}frame(e){requestAnimationFrame(s=>this.frame(s));let n=(e-this.lastFrame)/1e3;this.lastFrame=e,this.playback.advance(n)&&(this.isDirty=!0,this.view?.noteFrameTime(n)&&this.resize()),this.isDirty&&(this.isDirty=!1,this.draw(e))}draw(e){let{time:n,isPlaying:s}=this.playback;this.drawScene(),this.transport.update(),!(s&&e-this.lastNumbers<zE)&&(this.lastNumbers=e,this.plots.setTime(n),this.view&&this.panel.showBody(this.selected,this.view.motion,this.selected<0?[]:this.source.contactsAt(n),this.view.followed))}invalidate(){super.invalidate(),this.lastNumbers=0}redrawTicks(){this.transport.line.drawTicks()}showDeepest(){let{audit:e,bodies:n}=this.source.header,s=e.penetration;s?.time!=null&&(this.playback.isPlaying=!1,this.seek(s.time),this.flagged=(s.bodies??[]).map(r=>n.findIndex(o=>o.name===r)))}keys(e){let n=e.shiftKey?10:1;return{" ":()=>this.toggle(),ArrowLeft:()=>this.step(-n),ArrowRight:()=>this.step(n),Home:()=>this.seek(this.playback.begin),End:()=>this.seek(this.playback.end),"[":()=>this.nextImpact(-1),"]":()=>this.nextImpact(1),"-":()=>this.playback.changeSpeed(-1),"+":()=>this.playback.changeSpeed(1),"=":()=>this.playback.changeSpeed(1),l:()=>this.playback.isLooping=!this.playback.isLooping,P:()=>this.showDeepest()}}};function X0(i,t){let e=t.center.map((s,r)=>s-t.half[r]),n=t.center.map((s,r)=>s+t.half[r]);for(let s of i.bodies.filter(({motion:r})=>r==="static"))for(let r of i.looks[s.look]){if(r.type!=="plane")continue;let o=r.normal??[0,0,1],a=ye(s.start.q,ye(r.q,o)),l=Rn(Rn(s.start.p,ye(s.start.q,r.p)),a.map(d=>d*(r.offset??0))),c=a.reduce((d,u,f)=>d+u*(t.center[f]+i.origin[f]-l[f]),0);if(!(c>0)||c>60*t.radius)continue;let h=t.center.map((d,u)=>d-c*a[u]);e=e.map((d,u)=>Math.min(d,h[u])),n=n.map((d,u)=>Math.max(d,h[u]))}return{center:e.map((s,r)=>(s+n[r])/2),half:e.map((s,r)=>(n[r]-s)/2),radius:Math.hypot(...e.map((s,r)=>n[r]-s))/2}}var VE=50,Pc=class{constructor(t,e){this.send=e;this.element=U("div",{class:"control"});this.errors=U("div",{class:"errors",role:"alert"});this.fileNote=U("p",{class:"hint",id:"file"});this.settings=U("div");this.setters=[];this.isBuilt=!1;let n=Math.hypot(...t.gravity);this.down=n>0?t.gravity.map(s=>s/n):[0,0,-1],this.follow=U("input",{type:"checkbox",id:"follow",onchange:()=>e({do:"follow",value:this.follow.checked})}),this.element.append(this.errors,this.settings,U("h2",{text:"Scene file"}),this.fileNote,U("label",{},this.follow,"Read it again when it changes"),Se("Read it now","Read the scene file again, from t = 0",()=>e({do:"reload"})))}showErrors(t){this.errors.replaceChildren(...t.map(e=>U("p",{class:"warning",text:e})))}update(t){this.isBuilt||this.build(t);for(let a of this.setters)a(t);let{name:e,follow:n,changed:s,messages:r}=t.file;this.follow.checked=n;let o=r.map(a=>U("span",{class:"warning",text:a}));this.fileNote.replaceChildren(e,s?" has changed":"",...o.flatMap(a=>[U("br"),a]))}build(t){this.isBuilt=!0;let e=Ma("Gravity","m/s\xB2","gravity",[0,30,.01],n=>this.send({do:"gravity",value:this.down.map(s=>s*n)}));this.setters.push(n=>e.set(Math.hypot(...n.gravity))),this.settings.append(U("h2",{text:"World"}),e.element,this.stepField()),t.axes.length>0&&this.settings.append(U("h2",{text:"Joints"}),...t.axes.flatMap((n,s)=>this.axisFields(n,s))),this.settings.append(U("h2",{text:"Materials"})),t.surfaces.slice(0,VE).forEach(({material:n},s)=>{let r=Ma(`${n}: friction`,"",`friction-${s}`,[0,2,.01],a=>this.send({do:"surface",material:n,friction:a})),o=Ma(`${n}: restitution`,"",`restitution-${s}`,[0,1,.01],a=>this.send({do:"surface",material:n,restitution:a}));this.setters.push(a=>{r.set(a.surfaces[s].friction),o.set(a.surfaces[s].restitution)}),this.settings.append(r.element,o.element)}),this.settings.append(U("p",{class:"hint",text:"Pairs of materials that the scene gives values of their own keep them."}),U("h2",{text:"Method"})),t.method.forEach((n,s)=>{let r=U("select",{id:`method-${n.key}`,disabled:n.values.length<2,onchange:()=>this.send({do:"method",key:n.key,value:r.value})},...n.values.map(o=>U("option",{value:o},o)));this.setters.push(o=>r.value=o.method[s]?.value??""),this.settings.append(U("label",{},U("span",{class:"name",text:n.key}),r))})}axisFields({joint:t,coordinate:e,name:n,unit:s,rest:r},o){let a=e>0?`${n} (${e+1})`:n,l=s==="rad"?10:2,c=Ma(`${a}: motor`,`${s}/s`,`motor-${o}`,[-l,l,l/200],f=>this.send({do:"motor",joint:t,coordinate:e,velocity:f})),h=U("input",{type:"checkbox",id:`motor-on-${o}`,"aria-label":`${a}: motor on`,onchange:()=>this.send({do:"motor",joint:t,coordinate:e,velocity:h.checked?Number(c.input.value):void 0})});if(c.element.prepend(h),this.setters.push(({axes:f})=>{h.checked=f[o].motor!==null,f[o].motor!==null&&c.set(f[o].motor??0)}),c.set(0),r===null)return[c.element];let d=s==="rad"?3.14:1,u=Ma(`${a}: spring rests at`,s,`rest-${o}`,[-d,d,d/157],f=>this.send({do:"rest",joint:t,coordinate:e,value:f}));return this.setters.push(({axes:f})=>u.set(f[o].rest??0)),[c.element,u.element]}stepField(){let t=U("input",{type:"text",inputmode:"decimal",id:"target-step",onchange:()=>this.send({do:"target_step",value:Number(t.value)})});return this.setters.push(e=>{document.activeElement!==t&&(t.value=String(e.target_step))}),U("label",{},U("span",{class:"name",text:"Target step [s]"}),t)}};function Ma(i,t,e,[n,s,r],o){let a=!1,l=U("output",{}),c=u=>l.textContent=`${Kt(u,4)} ${t}`,h=U("input",{type:"range",id:e,min:n,max:s,step:r,"aria-label":i,oninput:()=>{c(Number(h.value)),o(Number(h.value))},onpointerdown:()=>a=!0,onpointerup:()=>a=!1,onpointercancel:()=>a=!1}),d=u=>{a||(u>Number(h.max)&&(h.max=String(u)),u<Number(h.min)&&(h.min=String(u)),h.value=String(u),c(u))};return{element:U("label",{class:"slider"},U("span",{class:"name",text:i}),h,l),input:h,set:d}}var HE=["open","stick","slide","unknown"],Ic=class{constructor(t,e){this.header=t;this.frames=e;this.chunks=[];this.count=0;this.most=0}addChunk(t){let e=new Lc(new Pi(t));for(let n=0;n<e.frames;++n)this.most=Math.max(this.most,e.starts[n+1]-e.starts[n]);this.chunks.push({first:this.count,bytes:t}),this.count+=e.frames}at(t){let e=this.chunks.length-1;for(;e>0&&this.chunks[e].first>t;)--e;if(e<0)return[];if(this.latest?.frame===t)return this.latest.contacts;this.unpacked?.chunk!==e&&(this.unpacked={chunk:e,contacts:new tf(this.chunks[e],this.header,this.frames)});let n=t-this.chunks[e].first,s=n<this.unpacked.contacts.frames?this.unpacked.contacts.at(n):[];return this.latest={frame:t,contacts:s},s}},Ls=11,GE=2,WE=8,Lc=class{constructor(t){this.starts=[0];this.bodyA=[];this.bodyB=[];this.from=[];this.steps={force:t.f64(),gap:t.f64(),place:t.f64(),normal:t.f64()},this.isSmooth=t.u32()>1;let e=t.u32(),n=Array.from({length:e},()=>t.varint()),s=this.readKept(t,n),o=n.map(a=>{let l=0;return Array.from({length:a},()=>l+=t.varint())}).map(a=>a.map(l=>[l,l+t.varint()]));for(let a=0;a<e;++a)this.merge(s[a],o[a]);t.checkEnd()}get frames(){return this.starts.length-1}readKept(t,e){let n=0;return e.map(s=>{let r=[];for(let o=0,a=!0;o<n;a=!a){let l=o+t.varint();if(l<o||l>n)throw new ae("a contacts block does not fit itself");for(;o<l;++o)a&&r.push(o)}return n=r.length+s,r})}merge(t,e){let n=this.starts.length>1?this.starts[this.starts.length-2]:0,s=0,r=()=>{let o=n+t[s++];this.push(this.bodyA[o],this.bodyB[o],o)};for(let[o,a]of e){let l=c=>this.bodyA[c]<o||this.bodyA[c]===o&&this.bodyB[c]<=a;for(;s<t.length&&l(n+t[s]);)r();this.push(o,a,-1)}for(;s<t.length;)r();this.starts.push(this.bodyA.length)}push(t,e,n){this.bodyA.push(t),this.bodyB.push(e),this.from.push(n)}},tf=class{constructor(t,e,n){this.chunk=t;this.header=e;this.motion=n;let s=new Pi(t.bytes);this.list=new Lc(s);let r=this.list.from.length;this.numbers=new Float64Array(Ls*r);for(let o=0;o<Ls;++o)for(let a=0;a<r;++a)this.numbers[Ls*a+o]=s.varint();s.checkEnd(),this.unfold()}get frames(){return this.list.frames}at(t){let{starts:e}=this.list;return Array.from({length:e[t+1]-e[t]},(n,s)=>this.contact(e[t]+s,this.chunk.first+t))}unfold(){let{numbers:t}=this,{from:e,isSmooth:n}=this.list;for(let s=0;s<e.length;++s){if(e[s]<0)continue;let r=Ls*s,o=Ls*e[s];for(let l=0;l<Ls;++l)t[r+l]+=t[o+l];if(!n||e[e[s]]<0)continue;let a=Ls*e[e[s]];for(let l=GE;l<WE;++l)t[r+l]+=t[o+l]-t[a+l]}}contact(t,e){let{numbers:n}=this,{steps:s,bodyA:r,bodyB:o,isSmooth:a}=this.list,l=Ls*t,c=this.middle(r[t],o[t],e),h=a?wa:this.direction(r[t],o[t],e),d=(u,f,g)=>g.map((y,m)=>(y+n[l+u+m])*f);return{bodyA:r[t],bodyB:o[t],mode:HE[n[l]]??"unknown",gap:n[l+1]*s.gap,point:d(2,s.place,c),normal:d(5,s.normal,h),force:d(8,s.force,wa)}}middle(t,e,n){let s=[t,e].map(o=>this.motion.place(n,o)).filter(o=>o>=0);if(s.length===0)return wa;let r=s.length*this.list.steps.place/this.header.position_step;return[0,1,2].map(o=>Math.floor(s.reduce((a,l)=>a+this.whole(l+o),0)/r+.5))}direction(t,e,n){let[s,r]=[t,e].map(c=>this.motion.place(n,c));if(s<0||r<0)return wa;let o=[0,1,2].map(c=>this.whole(r+c)-this.whole(s+c)),a=o[0]*o[0]+o[1]*o[1]+o[2]*o[2];if(a===0)return wa;let l=Math.sqrt(a)*this.list.steps.normal;return o.map(c=>Math.floor(c/l+.5))}whole(t){return Math.round(this.motion.position[t]/this.header.position_step)}},wa=[0,0,0];var ef=["impact","rest","separation","slip_to_stick"];async function q0(i,t,e){if(i.length===0)throw new ae("this page holds no data blocks");let n=[];i.length<t&&n.push(`the page is cut: ${i.length} of ${t} data blocks are there`);let s=[],r=[...new Set(i.map(o=>o.run))];for(let o of r){let a=i.filter(c=>c.run===o),l=[];try{s.push(await qE(a,l,c=>e((s.length+c)/r.length)))}catch(c){if(!(c instanceof ae))throw c;l.push(c.message)}n.push(...l.map(c=>r.length>1?`run ${o+1}: ${c}`:c))}if(s.length===0)throw new ae(n.join("; "));return{runs:s,precision:await XE(i,n),problems:n}}async function XE(i,t){let e=i.find(({kind:n})=>n==="precision");if(e)try{return JSON.parse(new TextDecoder().decode(await gc(e)))}catch(n){if(!(n instanceof ae))throw n;t.push(`${n.message}; the plots of work and precision are left out`);return}}async function qE(i,t,e){let n=async l=>{let c=i.find(h=>h.kind===l);if(!c)throw new ae(`the ${l} block is missing`);return gc(c)},s=YE(await n("header")),r=new vc(s),o={header:s,meshes:JE(await n("meshes"),s),series:new Map,times:new Float64Array,events:[],frames:r,contacts:new Ic(s,r)},a=new Pi(await n("series"));if(o.events=await $E(s,t,n),await ZE(i,o,t,e),o.frames.count===0)throw new ae([...t.splice(0),"no frame could be read"].join("; "));for(let{name:l}of s.series)o.series.set(l,a.exactColumn(s.frames).slice(0,o.frames.count));return o.times=o.series.get("time")??new Float64Array,o}function YE(i){let t=JSON.parse(new TextDecoder().decode(i));if(t.format!==2)throw new ae(`the data have format ${t.format}; this viewer knows format 2`);return t}async function $E(i,t,e){try{return KE(new Pi(await e("events")),i)}catch(n){if(!(n instanceof ae))throw n;return t.push(`${n.message}; no events are shown`),[]}}async function ZE(i,t,e,n){let s=i.filter(r=>r.kind==="frames"||r.kind==="contacts");try{for(let r=0;r<s.length;++r){let o=await gc(s[r]);s[r].kind==="frames"?t.frames.addChunk(o):t.contacts.addChunk(o),n((r+1)/s.length)}}catch(r){if(!(r instanceof ae))throw r;e.push(r.message)}t.frames.count<t.header.frames&&e.push(`the first ${t.frames.count} of ${t.header.frames} frames are shown`)}function JE(i,t){let e=new Pi(i);return t.meshes.map(n=>({vertices:Float32Array.from({length:3*n.vertices},()=>e.f32()),triangles:Uint32Array.from({length:3*n.triangles},()=>e.u32())}))}function KE(i,t){let e=t.events,n=i.f64(),s=i.f64(),r=new Float64Array(e);i.column(e,n,r,0,1);let o=f=>Float64Array.from({length:f},()=>i.varint()),a=o(3*e),l=o(3*e),c=o(3*e),{origin:h,position_step:d}=t;return Array.from({length:e},(f,g)=>({kind:ef[c[3*g+2]]??"impact",time:r[g],bodyA:c[3*g],bodyB:c[3*g+1],point:h.map((y,m)=>y+a[3*g+m]*d),impulse:[0,1,2].map(y=>l[3*g+y]*s)})).sort((f,g)=>f.time-g.time)}var ds=13,Y0=13,jE=["open","stick","slide","unknown"];function $0(i){let t=JSON.parse(i);if(t.type!=="status"&&t.type!=="error")throw new ae("the server sent a text of an unknown kind");return t}function Z0(i,t){let e=new DataView(i),n=i.byteLength>=8?e.getUint32(0,!0):0;if(n===1)return tA(i,e);if(n===2){let s=e.getUint32(4,!0);if(8+s>i.byteLength)throw new ae("a file from the server is cut");return{name:new TextDecoder().decode(new Uint8Array(i,8,s)),bytes:new Uint8Array(i,8+s)}}if(n===3)return QE(i,e,t);throw new ae("the server sent bytes of an unknown kind")}function QE(i,t,e){if(i.byteLength<28)throw new ae("a history is cut");let[r,o,a,l]=[4,8,12,16].map(u=>t.getUint32(u,!0)),c=28+8*o*a;if(i.byteLength!==c+44*l)throw new ae("a history has not the length that it tells");let h=Array.from({length:o},(u,f)=>Float64Array.from({length:a},(g,y)=>t.getFloat64(28+8*(y*o+f),!0))),d=Array.from({length:l},(u,f)=>{let g=c+44*f,y=m=>[0,4,8].map(p=>t.getFloat32(g+m+p,!0));return{time:t.getFloat64(g,!0),kind:ef[t.getUint32(g+8,!0)]??"impact",bodyA:t.getInt32(g+12,!0),bodyB:t.getInt32(g+16,!0),point:y(20).map((m,p)=>m+e[p]),impulse:y(32)}});return{generation:r,columns:h,events:d.sort((u,f)=>u.time-f.time),eventCount:t.getFloat64(20,!0)}}function tA(i,t){if(i.byteLength<28)throw new ae("a frame is cut");let[n,s,r,o]=[4,8,12,16].map(h=>t.getUint32(h,!0)),a=28+8*o,l=a+4*ds*s;if(i.byteLength!==l+4*Y0*r)throw new ae("a frame has not the length that it tells");let c=h=>t.getFloat32(h,!0);return{generation:n,time:t.getFloat64(20,!0),series:Float64Array.from({length:o},(h,d)=>t.getFloat64(28+8*d,!0)),bodies:Float32Array.from({length:ds*s},(h,d)=>c(a+4*d)),contacts:Array.from({length:r},(h,d)=>{let u=l+4*Y0*d,f=g=>[c(u+g),c(u+g+4),c(u+g+8)];return{bodyA:t.getUint32(u,!0),bodyB:t.getUint32(u+4,!0),mode:jE[t.getUint32(u+8,!0)]??"unknown",gap:c(u+12),point:f(16),normal:f(28),force:f(40)}})}}var eA=1e3,Dc=class{constructor(t,e){this.origin=t;this.listener=e;this.connect()}send(t){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(t)),!0)}connect(){let t=new WebSocket(`ws://${location.host}/live${location.search}`);this.socket=t,t.binaryType="arraybuffer",t.addEventListener("open",()=>this.listener.connected(!0)),t.addEventListener("message",e=>this.take(e.data)),t.addEventListener("close",()=>{this.listener.connected(!1),window.setTimeout(()=>this.connect(),eA)})}take(t){try{if(typeof t=="string"){let n=$0(t);n.type==="status"?this.listener.status(n):this.listener.errors(n.messages);return}let e=Z0(t,this.origin);"name"in e?this.listener.file(e):"columns"in e?this.listener.history(e):this.listener.frame(e)}catch(e){if(!(e instanceof ae))throw e;this.listener.errors([e.message])}}};var nA=4e6,iA=1024,sA=16,Uc=class{constructor(t){this.moving=t;this.count=0;this.spacing=0;let e=t.length,n=Math.min(iA,Math.max(sA,Math.floor(nA/(ds*Math.max(1,e)))));this.rowTimes=new Float64Array(n),this.position=new Float32Array(3*e*n),this.velocity=new Float32Array(3*e*n),this.spin=new Float32Array(3*e*n),this.turns=new Float32Array(4*e*n)}get times(){return this.rowTimes.subarray(0,this.count)}add(t,e){this.count>0&&t<this.rowTimes[this.count-1]&&(this.count=0,this.spacing=0);let n=this.count-1,s=n>=0&&(t===this.rowTimes[n]||n>=1&&this.rowTimes[n]-this.rowTimes[n-1]<this.spacing);!s&&this.count===this.rowTimes.length&&this.halve(),s||++this.count,this.set(this.count-1,t,e)}orientation(t,e,n,s){let r=4*(t*this.moving.length+e);for(let o=0;o<4;++o)n[s+o]=this.turns[r+o]}set(t,e,n){this.rowTimes[t]=e;for(let s=0;s<this.moving.length;++s){let r=t*this.moving.length+s,o=n.subarray(ds*s,ds*(s+1));this.position.set(o.subarray(0,3),3*r),this.turns.set(o.subarray(3,7),4*r),this.velocity.set(o.subarray(7,10),3*r),this.spin.set(o.subarray(10,13),3*r)}}halve(){let t=this.moving.length,e=this.rowTimes[this.count-1]-this.rowTimes[0];this.count=Math.ceil(this.count/2);for(let n=1;n<this.count;++n){this.rowTimes[n]=this.rowTimes[2*n];for(let s of[this.position,this.velocity,this.spin])s.copyWithin(3*t*n,6*t*n,6*t*n+3*t);this.turns.copyWithin(4*t*n,8*t*n,8*t*n+4*t)}this.spacing=e/this.count}};var Nc=class{constructor(t){this.kind="live";this.events=[];this.eventCount=0;this.header=t.header,this.meshes=t.meshes,this.moving=t.frames.moving,this.newest=vr(t.header.bodies.length);let e=new Lo(t);e.sample(t.times[0],this.newest),this.contacts=e.contactsAt(t.times[0]),this.mostContacts=this.contacts.length,this.time=t.times[0],this.times=t.times,this.series=t.series,this.frames=new Uc(this.moving),this.frames.add(this.time,Float32Array.from(this.moving.flatMap(n=>this.numbersOf(n))))}get frameTimes(){return this.frames.times}take(t){let{position:e,orientation:n,velocity:s,spin:r}=this.newest;this.moving.forEach((o,a)=>{let l=t.bodies.subarray(ds*a,ds*(a+1));e.set(l.subarray(0,3),3*o),n.set(l.subarray(3,7),4*o),s.set(l.subarray(7,10),3*o),r.set(l.subarray(10,13),3*o)}),this.contacts=t.contacts,this.mostContacts=Math.max(this.mostContacts,t.contacts.length),this.time=t.time,this.frames.add(t.time,t.bodies),this.onFrame?.()}remember({columns:t,events:e,eventCount:n}){this.series=new Map(this.header.series.map(({name:s},r)=>[s,t[r]??new Float64Array])),this.times=this.series.get("time")??new Float64Array,this.events=e,this.eventCount=n,this.onHistory?.()}sample(t,e){e.position.set(this.newest.position),e.orientation.set(this.newest.orientation),e.velocity.set(this.newest.velocity),e.spin.set(this.newest.spin)}contactsAt(){return this.contacts}numbersOf(t){let{position:e,orientation:n,velocity:s,spin:r}=this.newest,o=a=>[...a.subarray(3*t,3*t+3)];return[...o(e),...n.subarray(4*t,4*t+4),...o(s),...o(r)]}};var rA=4,Fc=(i,t)=>[i[0]*t,i[1]*t,i[2]*t],sf=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],nf=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2];function oA(i,t){return Rn(i.from,Fc(i.direction,nf(sf(t,i.from),i.direction)))}function aA(i,t,e){let n=nf(i.direction,e),s=nf(sf(t,i.from),e)/n;return Number.isFinite(s)&&s>0?Rn(i.from,Fc(i.direction,s)):void 0}function J0(i,t,e){let[n,s,r,o]=ii(i,t);return ye([n,-s,-r,-o],sf(e,Fe(i.position,t)))}var Oc=class{constructor(t,e,n,s,r){this.stage=t;this.view=e;this.source=n;this.send=s;this.select=r;this.tool="grab";this.hitSpeed=2;this.isTold=!0;t.addEventListener("pointerdown",o=>this.press(o),{capture:!0}),t.addEventListener("pointermove",o=>this.move(o)),t.addEventListener("pointerup",()=>{this.pressed&&this.select(this.pressed.grip.body),this.release()}),t.addEventListener("pointercancel",()=>this.release())}update(){let t=this.grip;if(!t)return;let{motion:e}=this.view,n=Rn(Fe(e.position,t.body),ye(ii(e,t.body),t.point));this.view.showLine([n,t.target]),!this.isTold&&(this.isTold=!0,this.send({do:"pull",body:t.body,point:t.point,target:Rn(t.target,this.source.header.origin)}))}press(t){if(t.button!==0)return;let e=t.shiftKey?"grab":t.altKey?"hit":this.tool;if(e==="turn")return;let[n,s]=this.placeOf(t),r=this.view.pick(n,s,"moving");if(r<0||this.source.header.bodies[r].motion!=="dynamic")return;let o=this.view.rayAt(n,s),a=this.surfacePoint(o,r),l=J0(this.view.motion,r,a);if(this.view.canTurn=!1,e==="hit"){this.send({do:"push",body:r,point:l,impulse:Fc(o.direction,this.source.header.bodies[r].mass*this.hitSpeed)});return}this.pressed={grip:{body:r,point:l,target:a,normal:o.forward},x:t.clientX,y:t.clientY},this.stage.setPointerCapture(t.pointerId)}move(t){let{pressed:e}=this;if(e&&Math.hypot(t.clientX-e.x,t.clientY-e.y)>rA&&(this.grip=e.grip,this.pressed=void 0),!this.grip)return;let n=aA(this.view.rayAt(...this.placeOf(t)),this.grip.target,this.grip.normal);n&&(this.grip.target=n,this.isTold=!1)}release(){this.view.canTurn=!0,this.pressed=void 0,this.grip&&(this.grip=void 0,this.view.showLine(void 0),this.send({do:"release"}))}surfacePoint(t,e){let{motion:n}=this.view,[s,r,o,a]=ii(n,e),l={from:J0(n,e,t.from),direction:ye([s,-r,-o,-a],t.direction)},c=Mc(l,ki(this.source.header,e),this.source.meshes);return c===void 0?oA(t,Fe(n.position,e)):Rn(t.from,Fc(t.direction,c))}placeOf(t){let e=this.view.canvas.getBoundingClientRect();return[t.clientX-e.left,t.clientY-e.top]}};var lA=100,kc=class extends Io{constructor(e,n){super(new Nc(e),void 0,X0(e.header,ya(e.header,e.frames,e.meshes)),m0);this.generation=n;this.lost=U("p",{class:"problem",role:"alert",text:"No connection to the simulation: it was ended, or another page took its place."});this.stopped=U("p",{class:"problem",role:"alert"});this.runButton=Se("\u25B6","Run or pause (space)",()=>this.toggle());this.backButton=Se("\u2039","One output interval back (\u2190)",()=>this.send({do:"back"}));this.clock=U("span",{class:"clock"});this.range={begin:0,end:0};let{source:s}=this;this.range.end=s.time,this.control=new Pc(e.header,r=>this.send(r)),this.panel=new Ro(s,this.shown,!1,{select:r=>this.select(r),follow:r=>this.follow(r),changed:()=>this.invalidate(),showDeepest:()=>{}},this.control.element),this.plots=new Co(s,()=>this.showEvent(void 0)),this.line=new Do(this.range,s.events,e.header.output_interval,{seek:()=>this.showEvent(void 0),showEvent:r=>this.showEvent(r)}),this.runButton.id="run",this.speed=U("select",{title:"Simulated seconds a second","aria-label":"Speed",onchange:()=>this.send({do:"speed",value:Number(this.speed.value)})},...[...gr,100,1e3].map(r=>U("option",{value:r},La(r)))),this.view&&(this.tools3d=new Oc(this.stage,this.view,s,r=>this.send(r),r=>this.select(r))),this.stopped.hidden=!0,this.element=U("main",{class:"app live"},this.head(),this.lost,this.stopped,U("div",{class:"middle"},this.stage,this.panel.element),this.bar(),this.plots.element,this.help),s.onFrame=()=>this.invalidate(),s.onHistory=()=>this.takeHistory(),this.link=new Dc(e.header.origin,{status:r=>this.showStatus(r),frame:r=>r.generation===this.generation&&s.take(r),history:r=>r.generation===this.generation&&s.remember(r),file:({name:r,bytes:o})=>Tc(r,new Blob([o])),errors:r=>this.control.showErrors(r),connected:r=>this.lost.hidden=r})}send(e){this.control.showErrors(this.link.send(e)?[]:["The simulation cannot be reached; nothing was changed."])}toggle(){this.send({do:this.status?.running?"pause":"run"})}showEvent(e){this.setEvent(e===void 0?void 0:this.source.events[e]),this.invalidate()}get time(){return this.source.time}redrawTicks(){this.line.drawTicks()}nextImpact(e){let n=this.line.impactFrom(this.event?.time??this.source.time,e);n!==void 0&&this.showEvent(n)}takeHistory(){let{times:e}=this.source;this.event&&this.event.time>e[e.length-1]&&this.setEvent(void 0),this.range.end=e[e.length-1]??0,this.line.setEvents(this.source.events),this.plots.refresh(),this.invalidate()}showStatus(e){if(e.generation!==this.generation)return window.location.reload();this.status=e,this.control.update(e),this.runButton.textContent=e.running?"\u275A\u275A":"\u25B6",this.backButton.disabled=e.earlier===0,document.activeElement!==this.speed&&(this.speed.value=String(e.speed)),this.stopped.hidden=e.stopped==="",this.stopped.textContent=Pr(`${e.stopped}. Change something or reset.`),this.invalidate()}head(){let{header:e}=this.source;return U("header",{},U("h1",{text:e.scene}),U("span",{class:"about",text:`live \xB7 ${e.bodies.length} ${e.bodies.length===1?"body":"bodies"}`}),this.tools())}bar(){let e=U("input",{type:"range",min:.1,max:20,step:.1,value:2,title:"Speed that a hit gives [m/s]","aria-label":"Speed that a hit gives",oninput:()=>this.tools3d&&(this.tools3d.hitSpeed=Number(e.value))}),n=new Map,s=r=>{this.tools3d&&(this.tools3d.tool=r);for(let[o,a]of n)a.classList.toggle("on",o===r),a.setAttribute("aria-pressed",String(o===r))};return n.set("grab",Se("Grab","Drag pulls a body, and turns the camera beside bodies",()=>s("grab"))),n.set("turn",Se("Turn","Drag turns the camera (with Shift it pulls a body)",()=>s("turn"))),n.set("hit",Se("Hit","A click hits a body along the line of sight (Alt and click)",()=>s("hit"))),s("grab"),U("div",{class:"transport"},U("div",{class:"buttons"},Se("|\u25C2","Back to t = 0 (Home)",()=>this.send({do:"reset"})),this.backButton,this.runButton,Se("\u203A","One output interval on (\u2192)",()=>this.send({do:"step"})),this.speed,...n.values(),e,Se("Save state","Keep a checkpoint for rigor run --resume",()=>this.send({do:"save"})),Se("Export page","Keep what was recorded since t = 0 as a page of its own",()=>this.send({do:"export"})),this.clock),this.line.element)}frame(e){if(requestAnimationFrame(o=>this.frame(o)),!this.isDirty)return;if(this.isDirty=!1,this.drawScene(),this.tools3d?.update(),e-this.lastNumbers<lA){this.isDirty=!0;return}this.lastNumbers=e;let{source:n}=this,s=this.status?.running?` \xB7 ${Kt(this.status.rate,2)}\xD7`:"";this.clock.textContent=`${$i(n.time,n.header.output_interval)} s${s}`;let r=Math.min(this.event?.time??n.time,this.range.end);this.line.update(r),this.plots.refreshBody(),this.plots.setTime(r),this.view&&this.panel.showBody(this.selected,this.view.motion,this.selected<0?[]:n.contactsAt(),this.view.followed)}keys(){return{" ":()=>this.toggle(),ArrowLeft:()=>this.send({do:"back"}),ArrowRight:()=>this.send({do:"step"}),Home:()=>this.send({do:"reset"}),"[":()=>this.nextImpact(-1),"]":()=>this.nextImpact(1)}}};var K0='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var j0=`:root {
  --is-dark: 0; --page: #f6f7f9; --box: #ffffff; --text: #1c2430; --quiet: #566170; --edge: #d5dae1; --grid: #e3e7ec;
  --accent: #0072b2; --impact: #cc5fa0; --stage: #e9edf2; --ground: #f4f6f8; --ground-line: #b4bdc8; --warn: #a33f00; --on-warn: #ffffff; --sound: #00694c;
  color-scheme: light;
}
@media (prefers-color-scheme: dark) { :root:not([data-theme="light"]) {
  --is-dark: 1; --page: #14181e; --box: #1c222a; --text: #e4e9ef; --quiet: #9aa6b4; --edge: #323b46; --grid: #2b333d;
  --accent: #56b4e9; --impact: #cc79a7; --stage: #171c23; --ground: #232a33; --ground-line: #46525f; --warn: #e69f00; --on-warn: #14181e; --sound: #35c69c;
  color-scheme: dark;
} }
:root[data-theme="dark"] {
  --is-dark: 1; --page: #14181e; --box: #1c222a; --text: #e4e9ef; --quiet: #9aa6b4; --edge: #323b46; --grid: #2b333d;
  --accent: #56b4e9; --impact: #cc79a7; --stage: #171c23; --ground: #232a33; --ground-line: #46525f; --warn: #e69f00; --on-warn: #14181e; --sound: #35c69c;
  color-scheme: dark;
}
* { box-sizing: border-box; }
[hidden] { display: none !important; }
body { margin: 0; background: var(--page); color: var(--text); font: 14px/1.4 system-ui, sans-serif; }
h1, h2, p { margin: 0; }
h2 { font-size: 13px; }
small, .hint, .about { color: var(--quiet); font-weight: normal; font-size: 12px; }
button, select, input[type="search"] {
  font: inherit; color: inherit; background: var(--box); border: 1px solid var(--edge); border-radius: 5px; padding: 3px 8px; min-height: 30px;
}
button { cursor: pointer; }
button:hover { border-color: var(--accent); }
button.on { border-color: var(--accent); color: var(--accent); }
button.link { border: 0; background: none; color: var(--accent); padding: 0; min-height: 0; text-align: left; }
::placeholder { color: var(--quiet); opacity: 1; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
.dot { display: inline-block; width: 10px; height: 10px; border-radius: 50%; margin-right: 4px; }

.app { display: flex; flex-direction: column; min-height: 100vh; }
.app > header { display: flex; align-items: baseline; gap: 4px 12px; padding: 6px 12px; flex-wrap: wrap; }
.app > header h1 { font-size: 16px; overflow-wrap: anywhere; }
.tools { margin-left: auto; display: flex; gap: 4px; }
.problem { background: var(--warn); color: var(--on-warn); padding: 6px 12px; }
.middle { display: flex; height: max(300px, calc(100vh - 350px)); border-top: 1px solid var(--edge); border-bottom: 1px solid var(--edge); }
.stage { flex: 1; min-width: 0; position: relative; background: var(--stage); overflow: hidden; }
.stage canvas { display: block; touch-action: none; outline: none; }
.stage .hint { padding: 24px; }

.panel { width: 340px; overflow: auto; display: flex; flex-direction: column; background: var(--box); border-left: 1px solid var(--edge); }
.event { padding: 8px 12px; border-bottom: 1px solid var(--edge); }
.tabs { display: flex; position: sticky; top: 0; z-index: 1; background: var(--box); border-bottom: 1px solid var(--edge); }
.tabs button { flex: 1; border: 0; border-radius: 0; border-bottom: 2px solid transparent; background: none; min-height: 36px; }
.tabs button[aria-selected="true"] { border-color: var(--accent); color: var(--accent); }
.tab { padding: 8px 12px; }
.tab.bodies { flex: 1; min-height: 0; display: flex; flex-direction: column; }
.panel input[type="search"] { width: 100%; }
.found { position: relative; list-style: none; margin: 6px 0; padding: 0; flex: 1 1 40px; min-height: 78px; overflow: auto; }
.numbers { flex: 0 1 auto; min-height: 0; overflow: auto; }
.found button { border: 0; background: none; width: 100%; text-align: left; min-height: 24px; padding: 1px 6px; overflow-wrap: anywhere; }
.found button:hover { background: var(--grid); }
.found button[aria-pressed="true"] { background: var(--grid); box-shadow: inset 3px 0 var(--accent); }
.numbers h2 { display: flex; align-items: baseline; gap: 6px; overflow-wrap: anywhere; }
.numbers h2 button { margin-left: auto; min-height: 24px; padding: 0 8px; }
.panel table { border-collapse: collapse; width: 100%; font-size: 12px; font-variant-numeric: tabular-nums; }
.panel th { text-align: left; font-weight: normal; color: var(--quiet); padding: 2px 8px 2px 0; vertical-align: top; }
.panel td { padding: 2px 0; overflow-wrap: anywhere; }
.contacts td, .contacts th { padding-right: 6px; }
.show label { display: flex; align-items: center; gap: 4px; min-height: 28px; }
.show input[type="range"] { flex: 1; }
.legend { display: flex; flex-wrap: wrap; gap: 2px 12px; font-size: 12px; padding: 6px 0; }
.sound { color: var(--sound); font-weight: 600; }
.broken, .warning { color: var(--warn); }
.broken { font-weight: 600; }

.transport { padding: 6px 12px; background: var(--box); border-bottom: 1px solid var(--edge); }
.buttons { display: flex; gap: 4px; flex-wrap: wrap; align-items: center; }
.buttons button { min-width: 34px; }
#play { min-width: 44px; }
.clock { margin-left: auto; font-variant-numeric: tabular-nums; white-space: nowrap; }
.line { position: relative; height: 30px; margin: 4px 7px 0; cursor: pointer; touch-action: none; background: linear-gradient(var(--grid), var(--grid)) center / 100% 4px no-repeat; }
.line canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
.handle { position: absolute; top: 3px; bottom: 3px; width: 4px; margin-left: -2px; border-radius: 2px; background: var(--accent); }
.handle::after { content: ""; position: absolute; left: -5px; top: 5px; width: 14px; height: 14px; border-radius: 50%; background: var(--accent); }

.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(230px, 100%), 1fr)); gap: 8px; padding: 8px 12px; }
.plot { min-width: 0; min-height: 190px; background: var(--box); border: 1px solid var(--edge); border-radius: 6px; padding: 6px; overflow: hidden; }
.plot h2 { display: flex; align-items: baseline; gap: 4px; min-height: 24px; }
.plot h2 select { margin-left: auto; min-height: 22px; padding: 0 4px; font-size: 12px; font-weight: normal; }
.plot .hint { padding: 24px 8px; }
.uplot, .u-legend { font: 12px/1.3 system-ui, sans-serif !important; }
/* The time is told beside the time line. */
.u-legend .u-series:first-child { display: none; }
.u-legend .u-series { margin: 0 4px; padding: 0; }
.u-legend th, .u-legend td { padding: 0 2px !important; }
.u-legend { color: var(--text); font-variant-numeric: tabular-nums; }
.u-cursor-x { border-right: 1px dashed var(--quiet) !important; }
.now { position: absolute; top: 0; bottom: 0; left: 0; width: 1px; background: var(--accent); pointer-events: none; }

.comparison .middle { height: max(300px, calc(100vh - 434px)); }
.runs { display: flex; flex-wrap: wrap; align-items: center; gap: 4px 10px; padding: 2px 12px 6px; }
.runs label { display: flex; align-items: center; gap: 4px; min-width: 0; }
.runs select { min-width: 0; max-width: 100%; text-overflow: ellipsis; }
.runs .dot, .audits th .dot { flex: none; border: 1px solid var(--edge); }
.plots-head { display: flex; flex-wrap: wrap; align-items: center; gap: 0 16px; padding: 4px 12px 0; }
.plots-head .legend { overflow-wrap: anywhere; }
.compare-plots .u-label { display: inline-block; max-width: 15em; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.precision { margin: 4px 12px; padding: 6px 10px; background: var(--box); border: 1px solid var(--edge); border-radius: 6px; min-width: 0; }
.precision .plots { padding: 0; grid-template-columns: repeat(auto-fit, minmax(min(360px, 100%), 1fr)); }
.precision svg { display: block; width: 100%; max-width: 640px; height: auto; }
.precision svg line { stroke: var(--grid); }
.precision svg line.own { stroke: var(--quiet); stroke-dasharray: 5 4; }
.precision svg polyline { fill: none; stroke-width: 1.6; }
.precision svg text { fill: var(--text); font: 12px/1.3 system-ui, sans-serif; }
.audits { margin: 4px 12px 12px; padding: 6px 10px; background: var(--box); border: 1px solid var(--edge); border-radius: 6px; min-width: 0; }
.audits h2 { padding: 2px 0; }
.audits .wide { overflow-x: auto; }
.audits table { border-collapse: collapse; font-size: 12px; font-variant-numeric: tabular-nums; }
.plot h2 select { min-width: 0; }
.audits th[scope="row"] { position: sticky; left: 0; background: var(--box); }
.audits th { text-align: left; font-weight: normal; padding: 2px 14px 2px 0; white-space: nowrap; }
.audits thead th { font-weight: 600; max-width: 24em; overflow: hidden; text-overflow: ellipsis; }
.audits td { padding: 2px 14px 2px 0; vertical-align: top; min-width: 8em; }
.audits tr.same th, .audits tr.same td { color: var(--quiet); }
.audits td.differs { color: var(--accent); font-weight: 600; }
.audits .only tr.same { display: none; }
.audits tbody.folded tr.setting.same { display: none; }
.audits tr.group th { padding-top: 8px; font-weight: 600; color: var(--text); }
.why { flex-basis: 100%; }
.audits td p { max-width: 26em; }

.message { max-width: 560px; margin: 15vh auto; padding: 24px; display: grid; gap: 12px; overflow-wrap: anywhere; }
.message h1 { font-size: 20px; }
.help { background: var(--box); color: var(--text); border: 1px solid var(--edge); border-radius: 8px; max-width: min(560px, 94vw); }
.help::backdrop { background: rgb(0 0 0 / 50%); }
.help th { text-align: left; padding-right: 16px; white-space: nowrap; }
.help td, .help th { padding-top: 3px; font-size: 13px; }
.help p { margin: 10px 0; font-size: 13px; }
kbd { font: 12px ui-monospace, monospace; border: 1px solid var(--edge); border-bottom-width: 2px; border-radius: 4px; padding: 0 5px; margin-right: 4px; }

@media (max-width: 760px) {
  .middle { display: contents; }
  .stage { order: 1; }
  .transport { order: 2; }
  .panel { order: 3; }
  .plots, .compare-plots, .help { order: 4; }
  .precision { order: 5; margin: 4px 8px; }
  .audits { order: 5; margin: 4px 8px 12px; }
  .runs, .plots-head { padding-left: 8px; padding-right: 8px; }
  .stage { flex: none; height: 46vh; min-height: 260px; }
  .panel { width: auto; height: 340px; border-left: 0; border-top: 1px solid var(--edge); }
  .app > header, .transport, .plots { padding-left: 8px; padding-right: 8px; }
  .about { flex-basis: 100%; order: 3; }
  .buttons button, .buttons select { min-width: 0; padding: 3px 7px; min-height: 36px; }
}

.control h2 { margin-top: 10px; }
.control label { display: flex; align-items: center; gap: 6px; min-height: 30px; }
.control .name { flex: 0 0 42%; overflow-wrap: anywhere; }
.control input[type="range"], .control input[type="text"], .control select { flex: 1; min-width: 0; }
.control output { flex: 0 0 78px; text-align: right; font-variant-numeric: tabular-nums; }
.control input[type="text"] { font: inherit; color: inherit; background: var(--box); border: 1px solid var(--edge); border-radius: 5px; padding: 3px 8px; }
.buttons input[type="range"] { width: 80px; }
.heat { width: 120px; height: 12px; border-radius: 3px; background: linear-gradient(90deg, #29336b, #cc475c, #fce06b); display: inline-block; }
.heat-scale { display: flex; align-items: center; gap: 6px; font-size: 12px; }
.help h2 { font-size: 16px; }
`;function Q0(){let i=new CSSStyleSheet;i.replaceSync(K0+j0),document.adoptedStyleSheets=[i]}async function uA(){Q0();let i=U("progress",{max:1,value:0}),t=U("main",{class:"message",id:"message",role:"status"},U("p",{text:"Reading the simulation \u2026"}),i);document.body.append(t);try{let e=Number(document.querySelector('meta[name="rigor-blocks"]')?.content??0),n=await q0(P0(document),e,o=>i.value=o);t.remove();let s=document.querySelector('meta[name="rigor-live"]'),r=s?new kc(n.runs[0],Number(s.content)):new Rc(n);document.body.append(r.element),r.begin(),Object.assign(window,{rigor:r})}catch(e){e instanceof ae||console.error(e),t.replaceChildren(U("h1",{text:"This page cannot be shown"}),U("p",{text:e instanceof Error?`${e.message}.`:String(e)}),U("p",{text:"The file was probably cut or changed on its way. Write it again with: rigor run SCENE -o page.html"})),document.body.append(t)}}document.addEventListener("DOMContentLoaded",()=>void uA());})();
