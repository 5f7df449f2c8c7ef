/*! Rigor viewer, Apache-2.0. Contains three.js 0.170.0 (MIT, Copyright 2010-2024 three.js authors)
and uPlot 1.6.31 (MIT, Copyright (c) 2022 Leon Sorokin); the full notices are in NOTICE. */
"use strict";(()=>{function he(i,t=5){if(!Number.isFinite(i))return"\u2013";if(i===0)return"0";let e=Math.abs(i);return(e>=1e5||e<.001?i.toExponential(t-1):i.toPrecision(t)).replace(/(\.\d*?)0+(e|$)/,"$1$2").replace(/\.(e|$)/,"$1").replace("e+","e").replace(/-/g,"\u2212")}function Xi(i,t=4){return Array.from(i,e=>he(e,t)).join(", ")}function qi(i,t){let e=Math.min(9,Math.max(2,Math.ceil(-Math.log10(t||1))));return i.toFixed(e)}function _a(i){return i<.5?`1/${Math.round(1/i)}\xD7`:`${i}\xD7`}function ba(i){let t=(e,n)=>Object.entries(n).flatMap(([s,r])=>{if(e===""&&(s==="bodies"||s==="warnings"))return[];let o=e?`${e}: ${s.replace(/_/g," ")}`:s.replace(/_/g," ");return r!==null&&typeof r=="object"&&!Array.isArray(r)?t(o,r):[{name:o,value:r}]});return t("",i)}function Ar(i){return i.warnings??[]}function Po(i){return!Ar(i).some(t=>t.startsWith("violated"))}function Io(i){return i==null?"\u2013":typeof i!="number"?Array.isArray(i)?i.join(" \u2194 "):String(i):Number.isInteger(i)?String(i):he(i,8)}var D0=/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028\u2029\u202a-\u202e\u2066-\u2069]/g;function Ma(i){return i.replace(D0,t=>`\\u${t.charCodeAt(0).toString(16).padStart(4,"0")}`)}function F(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===void 0||r===!1||(s.startsWith("on")?n.addEventListener(s.slice(2),r):s==="style"?n.style.cssText=String(r):s==="text"?n.textContent=Ma(String(r)):n.setAttribute(s,r===!0?"":String(r)));for(let s of e)s!==void 0&&n.append(typeof s=="string"?Ma(s):s);return n}function Ce(i,t,e){return F("button",{type:"button",title:t,"aria-label":t,onclick:e},i)}var Qt={orange:"#e69f00",skyBlue:"#56b4e9",green:"#009e73",yellow:"#f0e442",blue:"#0072b2",vermilion:"#d55e00",purple:"#cc79a7",grey:"#8c8c8c"},nf=[Qt.skyBlue,Qt.orange,Qt.green,Qt.purple,Qt.yellow,Qt.blue,Qt.vermilion],Re={stick:Qt.green,slide:Qt.vermilion,open:Qt.grey,unknown:Qt.grey,normal:Qt.skyBlue,velocity:Qt.yellow,impulse:Qt.purple,penetration:Qt.vermilion,x:Qt.vermilion,y:Qt.green,z:Qt.blue,selected:Qt.orange,ghost:Qt.skyBlue},Lc=[Qt.skyBlue,Qt.orange,Qt.green,Qt.purple,Qt.vermilion,Qt.blue,Qt.yellow,Qt.grey];function Yi(i){let t=/^#([0-9a-f])([0-9a-f])([0-9a-f])$/i.exec(i),n=(t?t.slice(1).map(s=>s+s):/^#(..)(..)(..)$/.exec(i)?.slice(1))?.map(s=>parseInt(s,16)/255)??[];return n.length===3&&n.every(Number.isFinite)?n:[.55,.55,.55]}function sf(i,t){return i==="static"?"#9aa3ad":i==="kinematic"?"#7d8fa3":nf[t%nf.length]}function U0(i,t){return t.a!==t.b?t:t.a!==i.a?{a:t.a,b:i.a}:i.b<0?i:{a:i.b,b:i.a}}function Lo(i){return i.map(({header:t},e)=>t.label??`run ${e+1}`)}function Sa(i){let t=/[^\s,=]+=/g,e=n=>(n.match(t)??[]).join();return i.every(n=>e(n)===e(i[0]))?i.map(n=>n.replace(t,"")):i}function Bn(i){return Lc[i%Lc.length]}var wa=class{constructor(t,e,n){this.sources=t;this.chosen=e;this.changed=n;let r=Lo(t).map((l,c)=>F("option",{value:c},l));this.rows=["A","B"].map((l,c)=>({select:F("select",{id:`run-${l.toLowerCase()}`,"aria-label":c===0?"Run A, drawn solid":"Run B, drawn as a ghost",onchange:()=>this.read()},...c===0?[]:[F("option",{value:-1},"none")],...r.map(h=>h.cloneNode(!0))),dot:F("span",{class:"dot"}),end:F("small")}));let[o,a]=this.rows;this.element=F("div",{class:"runs",role:"group","aria-label":"Runs that are looked at"},F("label",{},F("b",{text:"A"}),o.dot,o.select,o.end),Ce("\u21C4","Swap A and B",()=>this.chosen.b>=0&&this.set({a:this.chosen.b,b:this.chosen.a})),F("label",{title:"Drawn as a ghost (G)"},F("b",{text:"B"}),a.dot,a.select,a.end)),this.show()}read(){let[t,e]=this.rows.map(({select:n})=>Number(n.value));this.set(U0(this.chosen,{a:t,b:e}))}set(t){this.chosen=t,this.show(),this.changed(t)}show(){let t=Math.max(...this.sources.map(({times:e})=>e[e.length-1]));this.rows.forEach(({select:e,dot:n,end:s},r)=>{let o=r===0?this.chosen.a:this.chosen.b;e.value=String(o),n.style.background=o<0?"transparent":Bn(o);let a=this.sources[o],l=a?a.times[a.times.length-1]:t,c=a?.header.stopped?"stopped at":"until";s.textContent=l<t*(1-1e-12)?`${c} ${he(l,6)} s`:"",s.title=a?.header.stopped??""})}};function N0(i){let t=i.map(n=>new Map(ba(n).map(({name:s,value:r})=>[s,r])));return[...new Set(t.flatMap(n=>[...n.keys()]))].map(n=>{let s=t.map(r=>r.get(n));return{name:n,values:s.map(Io),differs:s.map(r=>JSON.stringify(r)!==JSON.stringify(s[0]))}})}function F0({header:i}){return i.stopped?F("td",{class:"broken"},F("p",{text:`\u2717 stopped: ${i.stopped}`})):Po(i.audit)?F("td",{class:"sound",text:"\u2713 audit passed"}):F("td",{class:"broken",text:"\u2717 audit violated"})}function rf(i){let t=Lo(i),e=Sa(t),n=i.map(({header:d})=>d.audit),s=F("tr",{},F("td"),...e.map((d,u)=>F("th",{scope:"col",title:t[u]},F("span",{class:"dot",style:`background:${Bn(u)}`}),d))),r=F("tr",{},F("th",{scope:"row",text:"ended"}),...i.map(F0)),o=N0(n).map(({name:d,values:u,differs:f})=>{let g=f.includes(!0);return F("tr",{class:g?void 0:"same"},F("th",{scope:"row",text:g?`\u2260 ${d}`:d}),...u.map((y,m)=>F("td",{class:f[m]?"differs":void 0,text:y})))}),a=n.some(d=>Ar(d).length>0),l=F("tr",{},F("th",{scope:"row",text:"warnings"}),...n.map(d=>F("td",{},...Ar(d).map(u=>F("p",{class:"warning",text:u}))))),c=F("table",{},F("thead",{},s),F("tbody",{},r,...o,a?l:void 0)),h=F("input",{type:"checkbox",id:"only-differences",onchange:()=>c.classList.toggle("only",h.checked)});return F("section",{class:"audits"},F("h3",{},"Audits",F("small",{text:" \u2260: not the same in all runs; marked: other than in the first"})),F("label",{},h,"only what differs"),F("div",{class:"wide",tabindex:0,role:"region","aria-label":"Audits side by side"},c))}var cn="u-",O0="uplot",k0=cn+"hz",B0=cn+"vt",z0=cn+"title",V0=cn+"wrap",H0=cn+"under",G0=cn+"over",W0=cn+"axis",ks=cn+"off",X0=cn+"select",q0=cn+"cursor-x",Y0=cn+"cursor-y",$0=cn+"cursor-pt",Z0=cn+"legend",J0=cn+"live",K0=cn+"inline",j0=cn+"series",Q0=cn+"marker",of=cn+"label",tv=cn+"value",No="width",Fo="height",Do="top",af="bottom",Tr="left",Dc="right",Zc="#000",lf=Zc+"0",cf="mousemove",hf="mousedown",Uc="mouseup",uf="mouseenter",df="mouseleave",ff="dblclick",ev="resize",nv="scroll",pf="change",Ra="dppxchange",Jc="--",Nr=typeof window<"u",Bc=Nr?document:null,Rr=Nr?window:null,iv=Nr?navigator:null,_e,Ea;function zc(){let i=devicePixelRatio;_e!=i&&(_e=i,Ea&&Hc(pf,Ea,zc),Ea=matchMedia(`(min-resolution: ${_e-.001}dppx) and (max-resolution: ${_e+.001}dppx)`),Bs(pf,Ea,zc),Rr.dispatchEvent(new CustomEvent(Ra)))}function Yn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Vc(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Be(i,t,e){i.style[t]=e+"px"}function gi(i,t,e,n){let s=Bc.createElement(i);return t!=null&&Yn(s,t),e?.insertBefore(s,n),s}function ri(i,t){return gi("div",i,t)}var mf=new WeakMap;function Di(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=mf.get(i);r!=o&&(i.style.transform=r,mf.set(i,r),t<0||e<0||t>n||e>s?Yn(i,ks):Vc(i,ks))}var gf=new WeakMap;function vf(i,t,e){let n=t+e,s=gf.get(i);n!=s&&(gf.set(i,n),i.style.background=t,i.style.borderColor=e)}var yf=new WeakMap;function xf(i,t,e,n){let s=t+""+e,r=yf.get(i);s!=r&&(yf.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Kc={passive:!0},sv={...Kc,capture:!0};function Bs(i,t,e,n){t.addEventListener(i,e,n?sv:Kc)}function Hc(i,t,e,n){t.removeEventListener(i,e,Kc)}Nr&&zc();function vi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:$n((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Pr(i,t,e,n){for(let s=n==1?t:e;s>=t&&s<=e;s+=n)if(i[s]!=null)return s;return-1}function rv(i,t,e,n){let s=de,r=-de;if(n==1)s=i[t],r=i[e];else if(n==-1)s=i[e],r=i[t];else for(let o=t;o<=e;o++){let a=i[o];a!=null&&(a<s&&(s=a),a>r&&(r=a))}return[s,r]}function ov(i,t,e){let n=de,s=-de;for(let r=t;r<=e;r++){let o=i[r];o!=null&&o>0&&(o<n&&(n=o),o>s&&(s=o))}return[n,s]}function La(i,t,e,n){let s=Mf(i),r=Mf(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?$i:Yf,a=s==1?$n:oi,l=r==1?oi:$n,c=a(o(an(i))),h=l(o(an(t))),d=Ir(e,c),u=Ir(e,h);return e==10&&(c<0&&(d=Ue(d,-c)),h<0&&(u=Ue(u,-h))),n||e==2?(i=d*s,t=u*r):(i=Jf(i,d),t=Da(t,u)),[i,t]}function jc(i,t,e,n){let s=La(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Qc=.1,_f={mode:3,pad:Qc},ko={pad:0,soft:null,mode:0},av={min:ko,max:ko};function Pa(i,t,e,n){return Ua(e)?bf(i,t,e):(ko.pad=e,ko.soft=n?0:null,ko.mode=n?3:0,bf(i,t,av))}function ye(i,t){return i??t}function lv(i,t,e){for(t=ye(t,0),e=ye(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function bf(i,t,e){let n=e.min,s=e.max,r=ye(n.pad,0),o=ye(s.pad,0),a=ye(n.hard,-de),l=ye(s.hard,de),c=ye(n.soft,de),h=ye(s.soft,-de),d=ye(n.mode,0),u=ye(s.mode,0),f=t-i,g=$i(f),y=wn(an(i),an(t)),m=$i(y),p=an(m-g);(f<1e-24||p>10)&&(f=0,(i==0||t==0)&&(f=1e-24,d==2&&c!=de&&(r=0),u==2&&h!=-de&&(o=0)));let S=f||y||1e3,w=$i(S),x=Ir(10,$n(w)),D=S*(f==0?i==0?.1:1:r),C=Ue(Jf(i-D,x/10),24),R=i>=c&&(d==1||d==3&&C<=c||d==2&&C>=c)?c:de,U=wn(a,C<R&&i>=R?R:ai(R,C)),E=S*(f==0?t==0?.1:1:o),b=Ue(Da(t+E,x/10),24),T=t<=h&&(u==1||u==3&&b>=h||u==2&&b<=h)?h:-de,H=ai(l,b>T&&t<=T?T:wn(T,b));return U==H&&U==0&&(H=100),[U,H]}var cv=new Intl.NumberFormat(Nr?iv.language:"en-US"),th=i=>cv.format(i),Zn=Math,Ca=Zn.PI,an=Zn.abs,$n=Zn.floor,on=Zn.round,oi=Zn.ceil,ai=Zn.min,wn=Zn.max,Ir=Zn.pow,Mf=Zn.sign,$i=Zn.log10,Yf=Zn.log2,hv=(i,t=1)=>Zn.sinh(i)*t,Nc=(i,t=1)=>Zn.asinh(i/t),de=1/0;function wf(i){return($i((i^i>>31)-(i>>31))|0)+1}function Gc(i,t,e){return ai(wn(i,t),e)}function ue(i){return typeof i=="function"?i:()=>i}var uv=()=>{},$f=i=>i,Zf=(i,t)=>t,dv=i=>null,Sf=i=>!0,Ef=(i,t)=>i==t,fv=/\.\d*?(?=9{6,}|0{6,})/gm,zs=i=>{if(jf(i)||gs.has(i))return i;let t=`${i}`,e=t.match(fv);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${zs(s)}e${r}`}return Ue(i,n)};function Fs(i,t){return zs(Ue(zs(i/t))*t)}function Da(i,t){return zs(oi(zs(i/t))*t)}function Jf(i,t){return zs($n(zs(i/t))*t)}function Ue(i,t=0){if(jf(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return on(n)/e}var gs=new Map;function Kf(i){return((""+i).split(".")[1]||"").length}function zo(i,t,e,n){let s=[],r=n.map(Kf);for(let o=t;o<e;o++){let a=an(o),l=Ue(Ir(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=i==10?h:Ue(h,d);s.push(u),gs.set(u,d)}}return s}var Bo={},eh=[],Lr=[null,null],ms=Array.isArray,jf=Number.isInteger,pv=i=>i===void 0;function Af(i){return typeof i=="string"}function Ua(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function mv(i){return i!=null&&typeof i=="object"}var gv=Object.getPrototypeOf(Uint8Array),Qf="__proto__";function Dr(i,t=Ua){let e;if(ms(i)){let n=i.find(s=>s!=null);if(ms(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Dr(i[s],t)}else e=i.slice()}else if(i instanceof gv)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Qf&&(e[n]=Dr(i[n],t))}else e=i;return e}function en(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Qf&&(Ua(i[s])?en(i[s],Dr(n[s])):i[s]=Dr(n[s]))}return i}var vv=0,yv=1,xv=2;function _v(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function bv(i,t){if(Sv(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Ev(o[0])||(o=wv(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=t?t[o][c]:yv,f=[];for(let g=0;g<h.length;g++){let y=h[g],m=r.get(l[g]);y===null?u!=vv&&(d[m]=y,u==xv&&f.push(m)):d[m]=y}_v(d,f,s),n.push(d)}}return n}var Mv=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function wv(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function Sv(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Ev(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=wn(1,$n((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var tp=["January","February","March","April","May","June","July","August","September","October","November","December"],ep=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function np(i){return i.slice(0,3)}var Av=ep.map(np),Tv=tp.map(np),Cv={MMMM:tp,MMM:Tv,WWWW:ep,WWW:Av};function Uo(i){return(i<10?"0":"")+i}function Rv(i){return(i<10?"00":i<100?"0":"")+i}var Pv={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Uo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Uo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Uo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Uo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Uo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Rv(i.getMilliseconds())};function nh(i,t){t=t||Cv;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Pv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Iv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Lv(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Iv?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var ip=i=>i%1==0,Ia=[1,2,2.5,5],Dv=zo(10,-32,0,Ia),sp=zo(10,0,32,Ia),Uv=sp.filter(ip),Os=Dv.concat(sp),ih=`
`,rp="{YYYY}",Tf=ih+rp,op="{M}/{D}",Oo=ih+op,Aa=Oo+"/{YY}",ap="{aa}",Nv="{h}:{mm}",Cr=Nv+ap,Cf=ih+Cr,Rf=":{ss}",we=null;function lp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?zo(10,0,3,Ia).filter(ip):zo(10,-3,0,Ia)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,rp,we,we,we,we,we,we,1],[s*28,"{MMM}",Tf,we,we,we,we,we,1],[s,op,Tf,we,we,we,we,we,1],[n,"{h}"+ap,Aa,we,Oo,we,we,we,1],[e,Cr,Aa,we,Oo,we,we,we,1],[t,Rf,Aa+" "+Cr,we,Oo+" "+Cr,we,Cf,we,1],[i,Rf+".{fff}",Aa+" "+Cr,we,Oo+" "+Cr,we,Cf,we,1]];function h(d){return(u,f,g,y,m,p)=>{let S=[],w=m>=o,x=m>=r&&m<o,D=d(g),C=Ue(D*i,3),R=Fc(D.getFullYear(),w?0:D.getMonth(),x||w?1:D.getDate()),U=Ue(R*i,3);if(x||w){let E=x?m/r:0,b=w?m/o:0,T=C==U?C:Ue(Fc(R.getFullYear()+b,R.getMonth()+E,1)*i,3),H=new Date(on(T/i)),G=H.getFullYear(),q=H.getMonth();for(let J=0;T<=y;J++){let $=Fc(G+b*J,q+E*J,1),nt=$-d(Ue($*i,3));T=Ue((+$+nt)*i,3),T<=y&&S.push(T)}}else{let E=m>=s?s:m,b=$n(g)-$n(C),T=U+b+Da(C-U,E);S.push(T);let H=d(T),G=H.getHours()+H.getMinutes()/e+H.getSeconds()/n,q=m/n,J=u.axes[f]._space,$=p/J;for(;T=Ue(T+m,i==1?0:3),!(T>y);)if(q>1){let nt=$n(Ue(G+q,6))%24,ot=d(T).getHours()-nt;ot>1&&(ot=-1),T-=ot*n,G=(G+q)%24;let mt=S[S.length-1];Ue((T-mt)/m,3)*$>=.7&&S.push(T)}else S.push(T)}return S}}return[l,c,h]}var[Fv,Ov,kv]=lp(1),[Bv,zv,Vv]=lp(.001);zo(2,-53,53,[1]);function Pf(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function If(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,d,u,f;return n.map(g=>{let y=i(g),m=y.getFullYear(),p=y.getMonth(),S=y.getDate(),w=y.getHours(),x=y.getMinutes(),D=y.getSeconds(),C=m!=l&&a[2]||p!=c&&a[3]||S!=h&&a[4]||w!=d&&a[5]||x!=u&&a[6]||D!=f&&a[7]||a[1];return l=m,c=p,h=S,d=w,u=x,f=D,C(y)})}}function Hv(i,t){let e=nh(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Fc(i,t,e){return new Date(i,t,e)}function Lf(i,t){return t(i)}var Gv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Df(i,t){return(e,n,s,r)=>r==null?Jc:t(i(n))}function Wv(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Xv(i,t){return i.series[t].fill(i,t)}var qv={show:!0,live:!0,isolate:!1,mount:uv,markers:{show:!0,width:2,stroke:Wv,fill:Xv,dash:"solid"},idx:null,idxs:null,values:[]};function Yv(i,t){let e=i.cursor.points,n=ri(),s=e.size(i,t);Be(n,No,s),Be(n,Fo,s);let r=s/-2;Be(n,"marginLeft",r),Be(n,"marginTop",r);let o=e.width(i,t,s);return o&&Be(n,"borderWidth",o),n}function $v(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Zv(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Jv(i,t){return i.series[t].points.size}var Oc=[0,0];function Kv(i,t,e){return Oc[0]=t,Oc[1]=e,Oc}function Ta(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function kc(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var jv={show:!0,x:!0,y:!0,lock:!1,move:Kv,points:{one:!1,show:Yv,size:Jv,width:0,stroke:Zv,fill:$v},bind:{mousedown:Ta,mouseup:Ta,click:Ta,dblclick:Ta,mousemove:kc,mouseleave:kc,mouseenter:kc},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},cp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},sh=en({},cp,{filter:Zf}),hp=en({},sh,{size:10}),up=en({},cp,{show:!1}),rh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',dp="bold "+rh,fp=1.5,Uf={show:!0,scale:"x",stroke:Zc,space:50,gap:5,size:50,labelGap:0,labelSize:30,labelFont:dp,side:2,grid:sh,ticks:hp,border:up,font:rh,lineGap:fp,rotate:0},Qv="Value",ty="Time",Nf={show:!0,scale:"x",auto:!1,sorted:1,min:de,max:-de,idxs:[]};function ey(i,t,e,n,s){return t.map(r=>r==null?"":th(r))}function ny(i,t,e,n,s,r,o){let a=[],l=gs.get(s)||0;e=o?e:Ue(Da(e,s),l);for(let c=e;c<=n;c=Ue(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Wc(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?$i:Yf,h=$n(c(e));s=Ir(l,h),l==10&&(s=Os[vi(s,Os)]);let d=e,u=s*l;l==10&&(u=Os[vi(u,Os)]);do a.push(d),d=d+s,l==10&&!gs.has(d)&&(d=Ue(d,gs.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Os[vi(u,Os)]));while(d<=n);return a}function iy(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Wc(i,t,wn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Wc(i,t,wn(l,-n),-e,s):[l]).reverse().map(u=>-u).concat(h,c)}var pp=/./,sy=/[12357]/,ry=/[125]/,Ff=/1/,Xc=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function oy(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?pp:l(7,o)-h>=c?sy:l(5,o)-h>=c?ry:Ff;if(d==Ff){let u=an(l(1,o)-h);if(u<c)return Xc(t.slice().reverse(),a.distr,d,oi(c/u)).reverse()}return Xc(t,a.distr,d,1)}function ay(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=an(l(1,o)-l(2,o));return c<a?Xc(t.slice().reverse(),3,pp,oi(a/c)).reverse():t}function ly(i,t,e,n){return n==null?Jc:t==null?"":th(t)}var Of={show:!0,scale:"y",stroke:Zc,space:30,gap:5,size:50,labelGap:0,labelSize:30,labelFont:dp,side:3,grid:sh,ticks:hp,border:up,font:rh,lineGap:fp,rotate:0};function cy(i,t){let e=3+(i||1)*2;return Ue(e*t,3)}function hy(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=an(o-r),l=i.series[t],c=a/(l.points.space*_e);return n[1]-n[0]<=c}var kf={scale:null,auto:!0,sorted:0,min:de,max:-de},mp=(i,t,e,n,s)=>s,Bf={show:!0,auto:!0,sorted:0,gaps:mp,alpha:1,facets:[en({},kf,{scale:"x"}),en({},kf,{scale:"y"})]},zf={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:mp,alpha:1,points:{show:hy,filter:null},values:null,min:de,max:-de,idxs:[],path:null,clip:null};function uy(i,t,e,n,s){return e/10}var gp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},dy=en({},gp,{time:!1,ori:1}),Vf={};function vp(i,t){let e=Vf[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Vf[i]=e)),e}var Ur=1,qc=2;function Vs(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,g=a.width,y=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?e(s,l,c,h,d,m,p,u,f,g,y,Fa,Fr,ka,xp,bp):e(s,l,c,h,d,p,m,f,u,y,g,Oa,Or,lh,_p,Mp)}function oh(i,t){let e=0,n=0,s=ye(i.bands,eh);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function fy(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Zi(i,t,e,n,s,r){return Vs(i,t,(o,a,l,c,h,d,u,f,g,y,m)=>{let p=o.pxRound,S=c.dir*(c.ori==0?1:-1),w=c.ori==0?Fr:Or,x,D;S==1?(x=e,D=n):(x=n,D=e);let C=p(d(a[x],c,y,f)),R=p(u(l[x],h,m,g)),U=p(d(a[D],c,y,f)),E=p(u(r==1?h.max:h.min,h,m,g)),b=new Path2D(s);return w(b,U,E),w(b,C,E),w(b,C,R),b})}function Na(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?ka:lh,l=e;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&a(o,l,n,f,n+r),l=u[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function py(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function ah(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let f=r(i[d]),g=u==d?f:r(i[u]),y=d-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let p=u+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&a.push([f,g])}return a}function Hf(i){return i==0?$f:i==1?on:t=>Fs(t,i)}function yp(i){let t=i==0?Fa:Oa,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=ai(c,a/2,l/2),h=ai(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var Fa=(i,t,e)=>{i.moveTo(t,e)},Oa=(i,t,e)=>{i.moveTo(e,t)},Fr=(i,t,e)=>{i.lineTo(t,e)},Or=(i,t,e)=>{i.lineTo(e,t)},ka=yp(0),lh=yp(1),xp=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},_p=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},bp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Mp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function wp(i){return(t,e,n,s,r)=>Vs(t,e,(o,a,l,c,h,d,u,f,g,y,m)=>{let{pxRound:p,points:S}=o,w,x;c.ori==0?(w=Fa,x=xp):(w=Oa,x=_p);let D=Ue(S.width*_e,3),C=(S.size-S.width)/2*_e,R=Ue(C*2,3),U=new Path2D,E=new Path2D,{left:b,top:T,width:H,height:G}=t.bbox;ka(E,b-R,T-R,H+R*2,G+R*2);let q=J=>{if(l[J]!=null){let $=p(d(a[J],c,y,f)),nt=p(u(l[J],h,m,g));w(U,$+C,nt),x(U,$,nt,C,0,Ca*2)}};if(r)r.forEach(q);else for(let J=n;J<=s;J++)q(J);return{stroke:D>0?U:null,fill:U,clip:E,flags:Ur|qc}})}function Sp(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var my=Sp(Fr),gy=Sp(Or);function Ep(i){let t=ye(i?.alignGaps,0);return(e,n,s,r)=>Vs(e,n,(o,a,l,c,h,d,u,f,g,y,m)=>{let p=o.pxRound,S=ft=>p(d(ft,c,y,f)),w=ft=>p(u(ft,h,m,g)),x,D;c.ori==0?(x=Fr,D=my):(x=Or,D=gy);let C=c.dir*(c.ori==0?1:-1),R={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ur},U=R.stroke,E=de,b=-de,T,H,G,q=S(a[C==1?s:r]),J=Pr(l,s,r,1*C),$=Pr(l,s,r,-1*C),nt=S(a[J]),Q=S(a[$]),ht=!1;for(let ft=C==1?s:r;ft>=s&&ft<=r;ft+=C){let Wt=S(a[ft]),K=l[ft];Wt==q?K!=null?(H=w(K),E==de&&(x(U,Wt,H),T=H),E=ai(H,E),b=wn(H,b)):K===null&&(ht=!0):(E!=de&&(D(U,q,E,b,T,H),G=q),K!=null?(H=w(K),x(U,Wt,H),E=b=T=H):(E=de,b=-de,K===null&&(ht=!0)),q=Wt)}E!=de&&E!=b&&G!=q&&D(U,q,E,b,T,H);let[ot,mt]=oh(e,n);if(o.fill!=null||ot!=0){let ft=R.fill=new Path2D(U),Wt=o.fillTo(e,n,o.min,o.max,ot),K=w(Wt);x(ft,Q,K),x(ft,nt,K)}if(!o.spanGaps){let ft=[];ht&&ft.push(...ah(a,l,s,r,C,S,t)),R.gaps=ft=o.gaps(e,n,s,r,ft),R.clip=Na(ft,c.ori,f,g,y,m)}return mt!=0&&(R.band=mt==2?[Zi(e,n,s,r,U,-1),Zi(e,n,s,r,U,1)]:Zi(e,n,s,r,U,mt)),R})}function vy(i){let t=ye(i.align,1),e=ye(i.ascDesc,!1),n=ye(i.alignGaps,0),s=ye(i.extend,!1);return(r,o,a,l)=>Vs(r,o,(c,h,d,u,f,g,y,m,p,S,w)=>{let x=c.pxRound,{left:D,width:C}=r.bbox,R=ot=>x(g(ot,u,S,m)),U=ot=>x(y(ot,f,w,p)),E=u.ori==0?Fr:Or,b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ur},T=b.stroke,H=u.dir*(u.ori==0?1:-1);a=Pr(d,a,l,1),l=Pr(d,a,l,-1);let G=U(d[H==1?a:l]),q=R(h[H==1?a:l]),J=q,$=q;s&&t==-1&&($=D,E(T,$,G)),E(T,q,G);for(let ot=H==1?a:l;ot>=a&&ot<=l;ot+=H){let mt=d[ot];if(mt==null)continue;let ft=R(h[ot]),Wt=U(mt);t==1?E(T,ft,G):E(T,J,Wt),E(T,ft,Wt),G=Wt,J=ft}let nt=J;s&&t==1&&(nt=D+C,E(T,nt,G));let[Q,ht]=oh(r,o);if(c.fill!=null||Q!=0){let ot=b.fill=new Path2D(T),mt=c.fillTo(r,o,c.min,c.max,Q),ft=U(mt);E(ot,nt,ft),E(ot,$,ft)}if(!c.spanGaps){let ot=[];ot.push(...ah(h,d,a,l,H,R,n));let mt=c.width*_e/2,ft=e||t==1?mt:-mt,Wt=e||t==-1?-mt:mt;ot.forEach(K=>{K[0]+=ft,K[1]+=Wt}),b.gaps=ot=c.gaps(r,o,a,l,ot),b.clip=Na(ot,u.ori,m,p,S,w)}return ht!=0&&(b.band=ht==2?[Zi(r,o,a,l,T,-1),Zi(r,o,a,l,T,1)]:Zi(r,o,a,l,T,ht)),b})}function Gf(i,t,e,n,s,r,o=de){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=an(i[l]-i[a]);h<c&&(c=h,o=an(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function yy(i){i=i||Bo;let t=ye(i.size,[.6,de,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ue(s),o=1-t[0],a=ye(t[1],de),l=ye(t[2],1),c=ye(i.disp,Bo),h=ye(i.each,f=>{}),{fill:d,stroke:u}=c;return(f,g,y,m)=>Vs(f,g,(p,S,w,x,D,C,R,U,E,b,T)=>{let H=p.pxRound,G=e,q=n*_e,J=a*_e,$=l*_e,nt,Q;x.ori==0?[nt,Q]=r(f,g):[Q,nt]=r(f,g);let ht=x.dir*(x.ori==0?1:-1),ot=x.ori==0?ka:lh,mt=x.ori==0?h:(j,et,It,gt,bt,qt,at)=>{h(j,et,It,bt,gt,at,qt)},ft=ye(f.bands,eh).find(j=>j.series[0]==g),Wt=ft!=null?ft.dir:0,K=p.fillTo(f,g,p.min,p.max,Wt),ct=H(R(K,D,T,E)),Lt,ut,Ut,Gt=b,Vt=H(p.width*_e),re=!1,te=null,Ee=null,W=null,rn=null;d!=null&&(Vt==0||u!=null)&&(re=!0,te=d.values(f,g,y,m),Ee=new Map,new Set(te).forEach(j=>{j!=null&&Ee.set(j,new Path2D)}),Vt>0&&(W=u.values(f,g,y,m),rn=new Map,new Set(W).forEach(j=>{j!=null&&rn.set(j,new Path2D)})));let{x0:ie,size:Jt}=c;if(ie!=null&&Jt!=null){G=1,S=ie.values(f,g,y,m),ie.unit==2&&(S=S.map(It=>f.posToVal(U+It*b,x.key,!0)));let j=Jt.values(f,g,y,m);Jt.unit==2?ut=j[0]*b:ut=C(j[0],x,b,U)-C(0,x,b,U),Gt=Gf(S,w,C,x,b,U,Gt),Ut=Gt-ut+q}else Gt=Gf(S,w,C,x,b,U,Gt),Ut=Gt*o+q,ut=Gt-Ut;Ut<1&&(Ut=0),Vt>=ut/2&&(Vt=0),Ut<5&&(H=$f);let Nt=Ut>0,be=Gt-Ut-(Nt?Vt:0);ut=H(Gc(be,$,J)),Lt=(G==0?ut/2:G==ht?0:ut)-G*ht*((G==0?q/2:0)+(Nt?Vt/2:0));let kt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=re?null:new Path2D,_=null;if(ft!=null)_=f.data[ft.series[1]];else{let{y0:j,y1:et}=c;j!=null&&et!=null&&(w=et.values(f,g,y,m),_=j.values(f,g,y,m))}let z=nt*ut,it=Q*ut;for(let j=ht==1?y:m;j>=y&&j<=m;j+=ht){let et=w[j];if(et==null)continue;if(_!=null){let Ht=_[j]??0;if(et-Ht==0)continue;ct=R(Ht,D,T,E)}let It=x.distr!=2||c!=null?S[j]:j,gt=C(It,x,b,U),bt=R(ye(et,K),D,T,E),qt=H(gt-Lt),at=H(wn(bt,ct)),vt=H(ai(bt,ct)),Bt=at-vt;if(et!=null){let Ht=et<0?it:z,wt=et<0?z:it;re?(Vt>0&&W[j]!=null&&ot(rn.get(W[j]),qt,vt+$n(Vt/2),ut,wn(0,Bt-Vt),Ht,wt),te[j]!=null&&ot(Ee.get(te[j]),qt,vt+$n(Vt/2),ut,wn(0,Bt-Vt),Ht,wt)):ot(P,qt,vt+$n(Vt/2),ut,wn(0,Bt-Vt),Ht,wt),mt(f,g,j,qt-Vt/2,vt,ut+Vt,Bt)}}return Vt>0?kt.stroke=re?rn:P:re||(kt._fill=p.width==0?p._fill:p._stroke??p._fill,kt.width=0),kt.fill=re?Ee:P,kt})}function xy(i,t){let e=ye(t?.alignGaps,0);return(n,s,r,o)=>Vs(n,s,(a,l,c,h,d,u,f,g,y,m,p)=>{let S=a.pxRound,w=nt=>S(u(nt,h,m,g)),x=nt=>S(f(nt,d,p,y)),D,C,R;h.ori==0?(D=Fa,R=Fr,C=bp):(D=Oa,R=Or,C=Mp);let U=h.dir*(h.ori==0?1:-1);r=Pr(c,r,o,1),o=Pr(c,r,o,-1);let E=w(l[U==1?r:o]),b=E,T=[],H=[];for(let nt=U==1?r:o;nt>=r&&nt<=o;nt+=U)if(c[nt]!=null){let ht=l[nt],ot=w(ht);T.push(b=ot),H.push(x(c[nt]))}let G={stroke:i(T,H,D,R,C,S),fill:null,clip:null,band:null,gaps:null,flags:Ur},q=G.stroke,[J,$]=oh(n,s);if(a.fill!=null||J!=0){let nt=G.fill=new Path2D(q),Q=a.fillTo(n,s,a.min,a.max,J),ht=x(Q);R(nt,b,ht),R(nt,E,ht)}if(!a.spanGaps){let nt=[];nt.push(...ah(l,c,r,o,U,w,e)),G.gaps=nt=a.gaps(n,s,r,o,nt),G.clip=Na(nt,h.ori,g,y,m,p)}return $!=0&&(G.band=$==2?[Zi(n,s,r,o,q,-1),Zi(n,s,r,o,q,1)]:Zi(n,s,r,o,q,$)),G})}function _y(i){return xy(by,i)}function by(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+d[u]/3,t[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,t[u+1]-l[u+1]*d[u]/3,i[u+1],t[u+1])}return a}var Yc=new Set;function Wf(){for(let i of Yc)i.syncRect(!0)}Nr&&(Bs(ev,Rr,Wf),Bs(nv,Rr,Wf,!0),Bs(Ra,Rr,()=>{ln.pxRatio=_e}));var My=Ep(),wy=wp();function Xf(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>$c(r,o,t,e))}function Sy(i,t){return i.map((e,n)=>n==0?{}:en({},t,e))}function $c(i,t,e,n){return en({},t==0?e:n,i)}function Ap(i,t,e){return t==null?Lr:[t,e]}var Ey=Ap;function Ay(i,t,e){return t==null?Lr:Pa(t,e,Qc,!0)}function Tp(i,t,e,n){return t==null?Lr:La(t,e,i.scales[n].log,!1)}var Ty=Tp;function Cp(i,t,e,n){return t==null?Lr:jc(t,e,i.scales[n].log,!1)}var Cy=Cp;function Ry(i,t,e,n,s){let r=wn(wf(i),wf(t)),o=t-i,a=vi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?gs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function qf(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=on((e=+s)*_e))+"px"),[i,t,e]}function Py(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ue(t[2]*_e,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ln(i,t,e){let n={mode:ye(i.mode,1)},s=n.mode;function r(v,M){return((M.distr==3?$i(v>0?v:M.clamp(n,v,M.min,M.max,M.key)):M.distr==4?Nc(v,M.asinh):M.distr==100?M.fwd(v):v)-M._min)/(M._max-M._min)}function o(v,M,I,L){let B=r(v,M);return L+I*(M.dir==-1?1-B:B)}function a(v,M,I,L){let B=r(v,M);return L+I*(M.dir==-1?B:1-B)}function l(v,M,I,L){return M.ori==0?o(v,M,I,L):a(v,M,I,L)}n.valToPosH=o,n.valToPosV=a;let c=!1;n.status=0;let h=n.root=ri(O0);if(i.id!=null&&(h.id=i.id),Yn(h,i.class),i.title){let v=ri(z0,h);v.textContent=i.title}let d=gi("canvas"),u=n.ctx=d.getContext("2d"),f=ri(V0,h);Bs("click",f,v=>{v.target===y&&(Fe!=_r||He!=br)&&bn.click(n,v)},!0);let g=n.under=ri(H0,f);f.appendChild(d);let y=n.over=ri(G0,f);i=Dr(i);let m=+ye(i.pxAlign,1),p=Hf(m);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let S=i.ms||.001,w=n.series=s==1?Xf(i.series||[],Nf,zf,!1):Sy(i.series||[null],Bf),x=n.axes=Xf(i.axes||[],Uf,Of,!0),D=n.scales={},C=n.bands=i.bands||[];C.forEach(v=>{v.fill=ue(v.fill||null),v.dir=ye(v.dir,-1)});let R=s==2?w[1].facets[0].scale:w[0].scale,U={axes:y0,series:Le},E=(i.drawOrder||["axes","series"]).map(v=>U[v]);function b(v){let M=D[v];if(M==null){let I=(i.scales||Bo)[v]||Bo;if(I.from!=null)b(I.from),D[v]=en({},D[I.from],I,{key:v});else{M=D[v]=en({},v==R?gp:dy,I),M.key=v;let L=M.time,B=M.range,Y=ms(B);if((v!=R||s==2&&!L)&&(Y&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?_f:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?_f:{mode:1,hard:B[1],soft:B[1]}},Y=!1),!Y&&Ua(B))){let st=B;B=(lt,pt,At)=>pt==null?Lr:Pa(pt,At,st)}M.range=ue(B||(L?Ey:v==R?M.distr==3?Ty:M.distr==4?Cy:Ap:M.distr==3?Tp:M.distr==4?Cp:Ay)),M.auto=ue(Y?!1:M.auto),M.clamp=ue(M.clamp||uy),M._min=M._max=null}}}b("x"),b("y"),s==1&&w.forEach(v=>{b(v.scale)}),x.forEach(v=>{b(v.scale)});for(let v in i.scales)b(v);let T=D[R],H=T.distr,G,q;T.ori==0?(Yn(h,k0),G=o,q=a):(Yn(h,B0),G=a,q=o);let J={};for(let v in D){let M=D[v];(M.min!=null||M.max!=null)&&(J[v]={min:M.min,max:M.max},M.min=M.max=null)}let $=i.tzDate||(v=>new Date(on(v/S))),nt=i.fmtDate||nh,Q=S==1?kv($):Vv($),ht=If($,Pf(S==1?Ov:zv,nt)),ot=Df($,Lf(Gv,nt)),mt=[],ft=n.legend=en({},qv,i.legend),Wt=ft.show,K=ft.markers;ft.idxs=mt,K.width=ue(K.width),K.dash=ue(K.dash),K.stroke=ue(K.stroke),K.fill=ue(K.fill);let ct,Lt,ut,Ut=[],Gt=[],Vt,re=!1,te={};if(ft.live){let v=w[1]?w[1].values:null;re=v!=null,Vt=re?v(n,1,0):{_:0};for(let M in Vt)te[M]=Jc}if(Wt)if(ct=gi("table",Z0,h),ut=gi("tbody",null,ct),ft.mount(n,ct),re){Lt=gi("thead",null,ct,ut);let v=gi("tr",null,Lt);gi("th",null,v);for(var Ee in Vt)gi("th",of,v).textContent=Ee}else Yn(ct,K0),ft.live&&Yn(ct,J0);let W={show:!0},rn={show:!1};function ie(v,M){if(M==0&&(re||!ft.live||s==2))return Lr;let I=[],L=gi("tr",j0,ut,ut.childNodes[M]);Yn(L,v.class),v.show||Yn(L,ks);let B=gi("th",null,L);if(K.show){let lt=ri(Q0,B);if(M>0){let pt=K.width(n,M);pt&&(lt.style.border=pt+"px "+K.dash(n,M)+" "+K.stroke(n,M)),lt.style.background=K.fill(n,M)}}let Y=ri(of,B);Y.textContent=v.label,M>0&&(K.show||(Y.style.color=v.width>0?K.stroke(n,M):K.fill(n,M)),Nt("click",B,lt=>{if(Ct._lock)return;oe(lt);let pt=w.indexOf(v);if((lt.ctrlKey||lt.metaKey)!=ft.isolate){let At=w.some((Tt,Pt)=>Pt>0&&Pt!=pt&&Tt.show);w.forEach((Tt,Pt)=>{Pt>0&&Ri(Pt,At?Pt==pt?W:rn:W,!0,Qe.setSeries)})}else Ri(pt,{show:!v.show},!0,Qe.setSeries)},!1),zi&&Nt(uf,B,lt=>{Ct._lock||(oe(lt),Ri(w.indexOf(v),wr,!0,Qe.setSeries))},!1));for(var st in Vt){let lt=gi("td",tv,L);lt.textContent="--",I.push(lt)}return[L,I]}let Jt=new Map;function Nt(v,M,I,L=!0){let B=Jt.get(M)||{},Y=Ct.bind[v](n,M,I,L);Y&&(Bs(v,M,B[v]=Y),Jt.set(M,B))}function be(v,M,I){let L=Jt.get(M)||{};for(let B in L)(v==null||B==v)&&(Hc(B,M,L[B]),delete L[B]);v==null&&Jt.delete(M)}let kt=0,P=0,_=0,z=0,it=0,j=0,et=it,It=j,gt=_,bt=z,qt=0,at=0,vt=0,Bt=0;n.bbox={};let Ht=!1,wt=!1,ee=!1,Yt=!1,xe=!1,O=!1;function yt(v,M,I){(I||v!=n.width||M!=n.height)&&tt(v,M),gr(!1),ee=!0,wt=!0,vr()}function tt(v,M){n.width=kt=_=v,n.height=P=z=M,it=j=0,Kt(),Ve();let I=n.bbox;qt=I.left=Fs(it*_e,.5),at=I.top=Fs(j*_e,.5),vt=I.width=Fs(_*_e,.5),Bt=I.height=Fs(z*_e,.5)}let rt=3;function Et(){let v=!1,M=0;for(;!v;){M++;let I=g0(M),L=v0(M);v=M==rt||I&&L,v||(tt(n.width,n.height),wt=!0)}}function St({width:v,height:M}){yt(v,M)}n.setSize=St;function Kt(){let v=!1,M=!1,I=!1,L=!1;x.forEach((B,Y)=>{if(B.show&&B._show){let{side:st,_size:lt}=B,pt=st%2,At=B.label!=null?B.labelSize:0,Tt=lt+At;Tt>0&&(pt?(_-=Tt,st==3?(it+=Tt,L=!0):I=!0):(z-=Tt,st==0?(j+=Tt,v=!0):M=!0))}}),Ti[0]=v,Ti[1]=I,Ti[2]=M,Ti[3]=L,_-=Ci[1]+Ci[3],it+=Ci[3],z-=Ci[2]+Ci[0],j+=Ci[0]}function Ve(){let v=it+_,M=j+z,I=it,L=j;function B(Y,st){switch(Y){case 1:return v+=st,v-st;case 2:return M+=st,M-st;case 3:return I-=st,I+st;case 0:return L-=st,L+st}}x.forEach((Y,st)=>{if(Y.show&&Y._show){let lt=Y.side;Y._pos=B(lt,Y._size),Y.label!=null&&(Y._lpos=B(lt,Y.labelSize))}})}let Ct=n.cursor=en({},jv,{drag:{y:s==2}},i.cursor);if(Ct.dataIdx==null){let v=Ct.hover,M=v.skip=new Set(v.skip??[]);M.add(void 0);let I=v.prox=ue(v.prox),L=v.bias??(v.bias=0);Ct.dataIdx=(B,Y,st,lt)=>{if(Y==0)return st;let pt=st,At=I(B,Y,st,lt)??de,Tt=At>=0&&At<de,Pt=T.ori==0?_:z,Zt=Ct.left,De=t[0],pe=t[Y];if(M.has(pe[st])){pt=null;let ae=null,jt=null,zt;if(L==0||L==-1)for(zt=st;ae==null&&zt-- >0;)M.has(pe[zt])||(ae=zt);if(L==0||L==1)for(zt=st;jt==null&&zt++<pe.length;)M.has(pe[zt])||(jt=zt);if(ae!=null||jt!=null)if(Tt){let Te=ae==null?-1/0:G(De[ae],T,Pt,0),Ke=jt==null?1/0:G(De[jt],T,Pt,0),Ze=Zt-Te,ke=Ke-Zt;Ze<=ke?Ze<=At&&(pt=ae):ke<=At&&(pt=jt)}else pt=jt==null?ae:ae==null?jt:st-ae<=jt-st?ae:jt}else Tt&&an(Zt-G(De[st],T,Pt,0))>At&&(pt=null);return pt}}let oe=v=>{Ct.event=v};Ct.idxs=mt,Ct._lock=!1;let Ae=Ct.points;Ae.show=ue(Ae.show),Ae.size=ue(Ae.size),Ae.stroke=ue(Ae.stroke),Ae.width=ue(Ae.width),Ae.fill=ue(Ae.fill);let pn=n.focus=en({},i.focus||{alpha:.3},Ct.focus),zi=pn.prox>=0,Vi=zi&&Ae.one,je=[],Ai=[],Hi=[];function So(v,M){let I=Ae.show(n,M);if(I)return Yn(I,$0),Yn(I,v.class),Di(I,-10,-10,_,z),y.insertBefore(I,je[M]),I}function Ps(v,M){if(s==1||M>0){let I=s==1&&D[v.scale].time,L=v.value;v.value=I?Af(L)?Df($,Lf(L,nt)):L||ot:L||ly,v.label=v.label||(I?ty:Qv)}if(Vi||M>0){v.width=v.width==null?1:v.width,v.paths=v.paths||My||dv,v.fillTo=ue(v.fillTo||fy),v.pxAlign=+ye(v.pxAlign,m),v.pxRound=Hf(v.pxAlign),v.stroke=ue(v.stroke||null),v.fill=ue(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let I=cy(wn(1,v.width),1),L=v.points=en({},{size:I,width:wn(1,I*.2),stroke:v.stroke,space:I*2,paths:wy,_stroke:null,_fill:null},v.points);L.show=ue(L.show),L.filter=ue(L.filter),L.fill=ue(L.fill),L.stroke=ue(L.stroke),L.paths=ue(L.paths),L.pxAlign=v.pxAlign}if(Wt){let I=ie(v,M);Ut.splice(M,0,I[0]),Gt.splice(M,0,I[1]),ft.values.push(null)}if(Ct.show){mt.splice(M,0,null);let I=null;Vi?M==0&&(I=So(v,M)):M>0&&(I=So(v,M)),je.splice(M,0,I),Ai.splice(M,0,0),Hi.splice(M,0,0)}yn("addSeries",M)}function da(v,M){M=M??w.length,v=s==1?$c(v,M,Nf,zf):$c(v,M,{},Bf),w.splice(M,0,v),Ps(w[M],M)}n.addSeries=da;function mr(v){if(w.splice(v,1),Wt){ft.values.splice(v,1),Gt.splice(v,1);let M=Ut.splice(v,1)[0];be(null,M.firstChild),M.remove()}Ct.show&&(mt.splice(v,1),je.splice(v,1)[0].remove(),Ai.splice(v,1),Hi.splice(v,1)),yn("delSeries",v)}n.delSeries=mr;let Ti=[!1,!1,!1,!1];function fa(v,M){if(v._show=v.show,v.show){let I=v.side%2,L=D[v.scale];L==null&&(v.scale=I?w[1].scale:R,L=D[v.scale]);let B=L.time;v.size=ue(v.size),v.space=ue(v.space),v.rotate=ue(v.rotate),ms(v.incrs)&&v.incrs.forEach(st=>{!gs.has(st)&&gs.set(st,Kf(st))}),v.incrs=ue(v.incrs||(L.distr==2?Uv:B?S==1?Fv:Bv:Os)),v.splits=ue(v.splits||(B&&L.distr==1?Q:L.distr==3?Wc:L.distr==4?iy:ny)),v.stroke=ue(v.stroke),v.grid.stroke=ue(v.grid.stroke),v.ticks.stroke=ue(v.ticks.stroke),v.border.stroke=ue(v.border.stroke);let Y=v.values;v.values=ms(Y)&&!ms(Y[0])?ue(Y):B?ms(Y)?If($,Pf(Y,nt)):Af(Y)?Hv($,Y):Y||ht:Y||ey,v.filter=ue(v.filter||(L.distr>=3&&L.log==10?oy:L.distr==3&&L.log==2?ay:Zf)),v.font=qf(v.font),v.labelFont=qf(v.labelFont),v._size=v.size(n,null,M,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Ti[M]=!0,v._el=ri(W0,f))}}function Is(v,M,I,L){let[B,Y,st,lt]=I,pt=M%2,At=0;return pt==0&&(lt||Y)&&(At=M==0&&!B||M==2&&!st?on(Uf.size/3):0),pt==1&&(B||st)&&(At=M==1&&!Y||M==3&&!lt?on(Of.size/2):0),At}let pa=n.padding=(i.padding||[Is,Is,Is,Is]).map(v=>ue(ye(v,Is))),Ci=n._padding=pa.map((v,M)=>v(n,M,Ti,0)),A,k=null,X=null,Z=s==1?w[0].idxs:null,V=null,dt=!1;function Mt(v,M){if(t=v??[],n.data=n._data=t,s==2){A=0;for(let I=1;I<w.length;I++)A+=t[I][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),V=t[0],A=V.length;let I=t;if(H==2){I=t.slice();let L=I[0]=Array(A);for(let B=0;B<A;B++)L[B]=B}n._data=t=I}if(gr(!0),yn("setData"),H==2&&(ee=!0),M!==!1){let I=T;I.auto(n,dt)?Ft():us(R,I.min,I.max),Yt=Yt||Ct.left>=0,O=!0,vr()}}n.setData=Mt;function Ft(){dt=!0;let v,M;s==1&&(A>0?(k=Z[0]=0,X=Z[1]=A-1,v=t[0][k],M=t[0][X],H==2?(v=k,M=X):v==M&&(H==3?[v,M]=La(v,v,T.log,!1):H==4?[v,M]=jc(v,v,T.log,!1):T.time?M=v+on(86400/S):[v,M]=Pa(v,M,Qc,!0))):(k=Z[0]=v=null,X=Z[1]=M=null)),us(R,v,M)}let Dt,Xt,$t,Ot,ce,Me,Se,mn,me,Rt;function ei(v,M,I,L,B,Y){v??(v=lf),I??(I=eh),L??(L="butt"),B??(B=lf),Y??(Y="round"),v!=Dt&&(u.strokeStyle=Dt=v),B!=Xt&&(u.fillStyle=Xt=B),M!=$t&&(u.lineWidth=$t=M),Y!=ce&&(u.lineJoin=ce=Y),L!=Me&&(u.lineCap=Me=L),I!=Ot&&u.setLineDash(Ot=I)}function ge(v,M,I,L){M!=Xt&&(u.fillStyle=Xt=M),v!=Se&&(u.font=Se=v),I!=mn&&(u.textAlign=mn=I),L!=me&&(u.textBaseline=me=L)}function An(v,M,I,L,B=0){if(L.length>0&&v.auto(n,dt)&&(M==null||M.min==null)){let Y=ye(k,0),st=ye(X,L.length-1),lt=I.min==null?v.distr==3?ov(L,Y,st):rv(L,Y,st,B):[I.min,I.max];v.min=ai(v.min,I.min=lt[0]),v.max=wn(v.max,I.max=lt[1])}}let Gi={min:null,max:null};function Tn(){for(let L in D){let B=D[L];J[L]==null&&(B.min==null||J[R]!=null&&B.auto(n,dt))&&(J[L]=Gi)}for(let L in D){let B=D[L];J[L]==null&&B.from!=null&&J[B.from]!=null&&(J[L]=Gi)}J[R]!=null&&gr(!0);let v={};for(let L in J){let B=J[L];if(B!=null){let Y=v[L]=Dr(D[L],mv);if(B.min!=null)en(Y,B);else if(L!=R||s==2)if(A==0&&Y.from==null){let st=Y.range(n,null,null,L);Y.min=st[0],Y.max=st[1]}else Y.min=de,Y.max=-de}}if(A>0){w.forEach((L,B)=>{if(s==1){let Y=L.scale,st=J[Y];if(st==null)return;let lt=v[Y];if(B==0){let pt=lt.range(n,lt.min,lt.max,Y);lt.min=pt[0],lt.max=pt[1],k=vi(lt.min,t[0]),X=vi(lt.max,t[0]),X-k>1&&(t[0][k]<lt.min&&k++,t[0][X]>lt.max&&X--),L.min=V[k],L.max=V[X]}else L.show&&L.auto&&An(lt,st,L,t[B],L.sorted);L.idxs[0]=k,L.idxs[1]=X}else if(B>0&&L.show&&L.auto){let[Y,st]=L.facets,lt=Y.scale,pt=st.scale,[At,Tt]=t[B],Pt=v[lt],Zt=v[pt];Pt!=null&&An(Pt,J[lt],Y,At,Y.sorted),Zt!=null&&An(Zt,J[pt],st,Tt,st.sorted),L.min=st.min,L.max=st.max}});for(let L in v){let B=v[L],Y=J[L];if(B.from==null&&(Y==null||Y.min==null)){let st=B.range(n,B.min==de?null:B.min,B.max==-de?null:B.max,L);B.min=st[0],B.max=st[1]}}}for(let L in v){let B=v[L];if(B.from!=null){let Y=v[B.from];if(Y.min==null)B.min=B.max=null;else{let st=B.range(n,Y.min,Y.max,L);B.min=st[0],B.max=st[1]}}}let M={},I=!1;for(let L in v){let B=v[L],Y=D[L];if(Y.min!=B.min||Y.max!=B.max){Y.min=B.min,Y.max=B.max;let st=Y.distr;Y._min=st==3?$i(Y.min):st==4?Nc(Y.min,Y.asinh):st==100?Y.fwd(Y.min):Y.min,Y._max=st==3?$i(Y.max):st==4?Nc(Y.max,Y.asinh):st==100?Y.fwd(Y.max):Y.max,M[L]=I=!0}}if(I){w.forEach((L,B)=>{s==2?B>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)ee=!0,yn("setScale",L);Ct.show&&Ct.left>=0&&(Yt=O=!0)}for(let L in J)J[L]=null}function Ls(v){let M=Gc(k-1,0,A-1),I=Gc(X+1,0,A-1);for(;v[M]==null&&M>0;)M--;for(;v[I]==null&&I<A-1;)I++;return[M,I]}function Le(){A>0&&(w.forEach((v,M)=>{if(M>0&&v.show&&(Xn(M,!1),Xn(M,!0),v._paths==null)){Rt!=v.alpha&&(u.globalAlpha=Rt=v.alpha);let I=s==2?[0,t[M][0].length-1]:Ls(t[M]);v._paths=v.paths(n,M,I[0],I[1]),Rt!=1&&(u.globalAlpha=Rt=1)}}),w.forEach((v,M)=>{if(M>0&&v.show){Rt!=v.alpha&&(u.globalAlpha=Rt=v.alpha),v._paths!=null&&cs(M,!1);{let I=v._paths!=null?v._paths.gaps:null,L=v.points.show(n,M,k,X,I),B=v.points.filter(n,M,L,I);(L||B)&&(v.points._paths=v.points.paths(n,M,k,X,B),cs(M,!0))}Rt!=1&&(u.globalAlpha=Rt=1),yn("drawSeries",M)}}))}function Xn(v,M){let I=M?w[v].points:w[v];I._stroke=I.stroke(n,v),I._fill=I.fill(n,v)}function cs(v,M){let I=M?w[v].points:w[v],{stroke:L,fill:B,clip:Y,flags:st,_stroke:lt=I._stroke,_fill:pt=I._fill,_width:At=I.width}=I._paths;At=Ue(At*_e,3);let Tt=null,Pt=At%2/2;M&&pt==null&&(pt=At>0?"#fff":lt);let Zt=I.pxAlign==1&&Pt>0;if(Zt&&u.translate(Pt,Pt),!M){let De=qt-At/2,pe=at-At/2,ae=vt+At,jt=Bt+At;Tt=new Path2D,Tt.rect(De,pe,ae,jt)}M?ni(lt,At,I.dash,I.cap,pt,L,B,st,Y):Fn(v,lt,At,I.dash,I.cap,pt,L,B,st,Tt,Y),Zt&&u.translate(-Pt,-Pt)}function Fn(v,M,I,L,B,Y,st,lt,pt,At,Tt){let Pt=!1;pt!=0&&C.forEach((Zt,De)=>{if(Zt.series[0]==v){let pe=w[Zt.series[1]],ae=t[Zt.series[1]],jt=(pe._paths||Bo).band;ms(jt)&&(jt=Zt.dir==1?jt[0]:jt[1]);let zt,Te=null;pe.show&&jt&&lv(ae,k,X)?(Te=Zt.fill(n,De)||Y,zt=pe._paths.clip):jt=null,ni(M,I,L,B,Te,st,lt,pt,At,Tt,zt,jt),Pt=!0}}),Pt||ni(M,I,L,B,Y,st,lt,pt,At,Tt)}let fi=Ur|qc;function ni(v,M,I,L,B,Y,st,lt,pt,At,Tt,Pt){ei(v,M,I,L,B),(pt||At||Pt)&&(u.save(),pt&&u.clip(pt),At&&u.clip(At)),Pt?(lt&fi)==fi?(u.clip(Pt),Tt&&u.clip(Tt),ma(B,st),Ds(v,Y,M)):lt&qc?(ma(B,st),u.clip(Pt),Ds(v,Y,M)):lt&Ur&&(u.save(),u.clip(Pt),Tt&&u.clip(Tt),ma(B,st),u.restore(),Ds(v,Y,M)):(ma(B,st),Ds(v,Y,M)),(pt||At||Pt)&&u.restore()}function Ds(v,M,I){I>0&&(M instanceof Map?M.forEach((L,B)=>{u.strokeStyle=Dt=B,u.stroke(L)}):M!=null&&v&&u.stroke(M))}function ma(v,M){M instanceof Map?M.forEach((I,L)=>{u.fillStyle=Xt=L,u.fill(I)}):M!=null&&v&&u.fill(M)}function m0(v,M,I,L){let B=x[v],Y;if(L<=0)Y=[0,0];else{let st=B._space=B.space(n,v,M,I,L),lt=B._incrs=B.incrs(n,v,M,I,L,st);Y=Ry(M,I,lt,L,st)}return B._found=Y}function Mc(v,M,I,L,B,Y,st,lt,pt,At){let Tt=st%2/2;m==1&&u.translate(Tt,Tt),ei(lt,st,pt,At,lt),u.beginPath();let Pt,Zt,De,pe,ae=B+(L==0||L==3?-Y:Y);I==0?(Zt=B,pe=ae):(Pt=B,De=ae);for(let jt=0;jt<v.length;jt++)M[jt]!=null&&(I==0?Pt=De=v[jt]:Zt=pe=v[jt],u.moveTo(Pt,Zt),u.lineTo(De,pe));u.stroke(),m==1&&u.translate(-Tt,-Tt)}function g0(v){let M=!0;return x.forEach((I,L)=>{if(!I.show)return;let B=D[I.scale];if(B.min==null){I._show&&(M=!1,I._show=!1,gr(!1));return}else I._show||(M=!1,I._show=!0,gr(!1));let Y=I.side,st=Y%2,{min:lt,max:pt}=B,[At,Tt]=m0(L,lt,pt,st==0?_:z);if(Tt==0)return;let Pt=B.distr==2,Zt=I._splits=I.splits(n,L,lt,pt,At,Tt,Pt),De=B.distr==2?Zt.map(zt=>V[zt]):Zt,pe=B.distr==2?V[Zt[1]]-V[Zt[0]]:At,ae=I._values=I.values(n,I.filter(n,De,L,Tt,pe),L,Tt,pe);I._rotate=Y==2?I.rotate(n,ae,L,Tt):0;let jt=I._size;I._size=oi(I.size(n,ae,L,v)),jt!=null&&I._size!=jt&&(M=!1)}),M}function v0(v){let M=!0;return pa.forEach((I,L)=>{let B=I(n,L,Ti,v);B!=Ci[L]&&(M=!1),Ci[L]=B}),M}function y0(){for(let v=0;v<x.length;v++){let M=x[v];if(!M.show||!M._show)continue;let I=M.side,L=I%2,B,Y,st=M.stroke(n,v),lt=I==0||I==3?-1:1;if(M.label){let Pn=M.labelGap*lt,qn=on((M._lpos+Pn)*_e);ge(M.labelFont[0],st,"center",I==2?Do:af),u.save(),L==1?(B=Y=0,u.translate(qn,on(at+Bt/2)),u.rotate((I==3?-Ca:Ca)/2)):(B=on(qt+vt/2),Y=qn),u.fillText(M.label,B,Y),u.restore()}let[pt,At]=M._found;if(At==0)continue;let Tt=D[M.scale],Pt=L==0?vt:Bt,Zt=L==0?qt:at,De=on(M.gap*_e),pe=M._splits,ae=Tt.distr==2?pe.map(Pn=>V[Pn]):pe,jt=Tt.distr==2?V[pe[1]]-V[pe[0]]:pt,zt=M.ticks,Te=M.border,Ke=zt.show?on(zt.size*_e):0,Ze=M._rotate*-Ca/180,ke=p(M._pos*_e),tn=(Ke+De)*lt,On=ke+tn;Y=L==0?On:0,B=L==1?On:0;let kn=M.font[0],ii=M.align==1?Tr:M.align==2?Dc:Ze>0?Tr:Ze<0?Dc:L==0?"center":I==3?Dc:Tr,pi=Ze||L==1?"middle":I==2?Do:af;ge(kn,st,ii,pi);let mi=M.font[1]*M.lineGap,Cn=pe.map(Pn=>p(l(Pn,Tt,Pt,Zt))),Ii=M._values;for(let Pn=0;Pn<Ii.length;Pn++){let qn=Ii[Pn];if(qn!=null){L==0?B=Cn[Pn]:Y=Cn[Pn],qn=""+qn;let Er=qn.indexOf(`
`)==-1?[qn]:qn.split(/\n/gm);for(let ps=0;ps<Er.length;ps++){let si=Er[ps];Ze?(u.save(),u.translate(B,Y+ps*mi),u.rotate(Ze),u.fillText(si,0,0),u.restore()):u.fillText(si,B,Y+ps*mi)}}}zt.show&&Mc(Cn,zt.filter(n,ae,v,At,jt),L,I,ke,Ke,Ue(zt.width*_e,3),zt.stroke(n,v),zt.dash,zt.cap);let Rn=M.grid;Rn.show&&Mc(Cn,Rn.filter(n,ae,v,At,jt),L,L==0?2:1,L==0?at:qt,L==0?Bt:vt,Ue(Rn.width*_e,3),Rn.stroke(n,v),Rn.dash,Rn.cap),Te.show&&Mc([ke],[1],L==0?1:0,L==0?1:2,L==1?at:qt,L==1?Bt:vt,Ue(Te.width*_e,3),Te.stroke(n,v),Te.dash,Te.cap)}yn("drawAxes")}function gr(v){w.forEach((M,I)=>{I>0&&(M._paths=null,v&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let ga=!1,wc=!1,Eo=[];function x0(){wc=!1;for(let v=0;v<Eo.length;v++)yn(...Eo[v]);Eo.length=0}function vr(){ga||(Mv(kd),ga=!0)}function _0(v,M=!1){ga=!0,wc=M,v(n),kd(),M&&Eo.length>0&&queueMicrotask(x0)}n.batch=_0;function kd(){if(Ht&&(Tn(),Ht=!1),ee&&(Et(),ee=!1),wt){if(Be(g,Tr,it),Be(g,Do,j),Be(g,No,_),Be(g,Fo,z),Be(y,Tr,it),Be(y,Do,j),Be(y,No,_),Be(y,Fo,z),Be(f,No,kt),Be(f,Fo,P),d.width=on(kt*_e),d.height=on(P*_e),x.forEach(({_el:v,_show:M,_size:I,_pos:L,side:B})=>{if(v!=null)if(M){let Y=B===3||B===0?I:0,st=B%2==1;Be(v,st?"left":"top",L-Y),Be(v,st?"width":"height",I),Be(v,st?"top":"left",st?j:it),Be(v,st?"height":"width",st?z:_),Vc(v,ks)}else Yn(v,ks)}),Dt=Xt=$t=ce=Me=Se=mn=me=Ot=null,Rt=1,Co(!0),it!=et||j!=It||_!=gt||z!=bt){gr(!1);let v=_/gt,M=z/bt;if(Ct.show&&!Yt&&Ct.left>=0){Ct.left*=v,Ct.top*=M,yr&&Di(yr,on(Ct.left),0,_,z),xr&&Di(xr,0,on(Ct.top),_,z);for(let I=0;I<je.length;I++){let L=je[I];L!=null&&(Ai[I]*=v,Hi[I]*=M,Di(L,oi(Ai[I]),oi(Hi[I]),_,z))}}if(Oe.show&&!xe&&Oe.left>=0&&Oe.width>0){Oe.left*=v,Oe.width*=v,Oe.top*=M,Oe.height*=M;for(let I in Rc)Be(Mr,I,Oe[I])}et=it,It=j,gt=_,bt=z}yn("setSize"),wt=!1}kt>0&&P>0&&(u.clearRect(0,0,d.width,d.height),yn("drawClear"),E.forEach(v=>v()),yn("draw")),Oe.show&&xe&&(va(Oe),xe=!1),Ct.show&&Yt&&(Ns(null,!0,!1),Yt=!1),ft.show&&ft.live&&O&&(Tc(),O=!1),c||(c=!0,n.status=1,yn("ready")),dt=!1,ga=!1}n.redraw=(v,M)=>{ee=M||!1,v!==!1?us(R,T.min,T.max):vr()};function Sc(v,M){let I=D[v];if(I.from==null){if(A==0){let L=I.range(n,M.min,M.max,v);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(A>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;v==R&&I.distr==2&&A>0&&(M.min=vi(M.min,t[0]),M.max=vi(M.max,t[0]),M.min==M.max&&M.max++),J[v]=M,Ht=!0,vr()}}n.setScale=Sc;let Ec,Ac,yr,xr,Bd,zd,_r,br,Vd,Hd,Fe,He,hs=!1,bn=Ct.drag,gn=bn.x,vn=bn.y;Ct.show&&(Ct.x&&(Ec=ri(q0,y)),Ct.y&&(Ac=ri(Y0,y)),T.ori==0?(yr=Ec,xr=Ac):(yr=Ac,xr=Ec),Fe=Ct.left,He=Ct.top);let Oe=n.select=en({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Mr=Oe.show?ri(X0,Oe.over?y:g):null;function va(v,M){if(Oe.show){for(let I in v)Oe[I]=v[I],I in Rc&&Be(Mr,I,v[I]);M!==!1&&yn("setSelect")}}n.setSelect=va;function b0(v,M){let I=w[v],L=Wt?Ut[v]:null;if(I.show)L&&Vc(L,ks);else{L&&Yn(L,ks);let B=Vi?je[0]:je[v];Di(B,-10,-10,_,z)}}function us(v,M,I){Sc(v,{min:M,max:I})}function Ri(v,M,I,L){M.focus!=null&&A0(v),M.show!=null&&w.forEach((B,Y)=>{Y>0&&(v==Y||v==null)&&(B.show=M.show,b0(Y,M.show),s==2?(us(B.facets[0].scale,null,null),us(B.facets[1].scale,null,null)):us(B.scale,null,null),vr())}),I!==!1&&yn("setSeries",v,M),L&&Ro("setSeries",n,v,M)}n.setSeries=Ri;function M0(v,M){en(C[v],M)}function w0(v,M){v.fill=ue(v.fill||null),v.dir=ye(v.dir,-1),M=M??C.length,C.splice(M,0,v)}function S0(v){v==null?C.length=0:C.splice(v,1)}n.addBand=w0,n.setBand=M0,n.delBand=S0;function E0(v,M){w[v].alpha=M,Ct.show&&je[v]&&(je[v].style.opacity=M),Wt&&Ut[v]&&(Ut[v].style.opacity=M)}let Wi,ds,Us,wr={focus:!0};function A0(v){if(v!=Us){let M=v==null,I=pn.alpha!=1;w.forEach((L,B)=>{if(s==1||B>0){let Y=M||B==0||B==v;L._focus=M?null:Y,I&&E0(B,Y?1:pn.alpha)}}),Us=v,I&&vr()}}Wt&&zi&&Nt(df,ct,v=>{Ct._lock||(oe(v),Us!=null&&Ri(null,wr,!0,Qe.setSeries))});function Pi(v,M,I){let L=D[M];I&&(v=v/_e-(L.ori==1?j:it));let B=_;L.ori==1&&(B=z,v=B-v),L.dir==-1&&(v=B-v);let Y=L._min,st=L._max,lt=v/B,pt=Y+(st-Y)*lt,At=L.distr;return At==3?Ir(10,pt):At==4?hv(pt,L.asinh):At==100?L.bwd(pt):pt}function T0(v,M){let I=Pi(v,R,M);return vi(I,t[0],k,X)}n.valToIdx=v=>vi(v,t[0]),n.posToIdx=T0,n.posToVal=Pi,n.valToPos=(v,M,I)=>D[M].ori==0?o(v,D[M],I?vt:_,I?qt:0):a(v,D[M],I?Bt:z,I?at:0),n.setCursor=(v,M,I)=>{Fe=v.left,He=v.top,Ns(null,M,I)};function Gd(v,M){Be(Mr,Tr,Oe.left=v),Be(Mr,No,Oe.width=M)}function Wd(v,M){Be(Mr,Do,Oe.top=v),Be(Mr,Fo,Oe.height=M)}let Ao=T.ori==0?Gd:Wd,To=T.ori==1?Gd:Wd;function C0(){if(Wt&&ft.live)for(let v=s==2?1:0;v<w.length;v++){if(v==0&&re)continue;let M=ft.values[v],I=0;for(let L in M)Gt[v][I++].firstChild.nodeValue=M[L]}}function Tc(v,M){if(v!=null&&(v.idxs?v.idxs.forEach((I,L)=>{mt[L]=I}):pv(v.idx)||mt.fill(v.idx),ft.idx=mt[0]),Wt&&ft.live){for(let I=0;I<w.length;I++)(I>0||s==1&&!re)&&R0(I,mt[I]);C0()}O=!1,M!==!1&&yn("setLegend")}n.setLegend=Tc;function R0(v,M){let I=w[v],L=v==0&&H==2?V:t[v],B;re?B=I.values(n,v,M)??te:(B=I.value(n,M==null?null:L[M],v,M),B=B==null?te:{_:B}),ft.values[v]=B}function Ns(v,M,I){Vd=Fe,Hd=He,[Fe,He]=Ct.move(n,Fe,He),Ct.left=Fe,Ct.top=He,Ct.show&&(yr&&Di(yr,on(Fe),0,_,z),xr&&Di(xr,0,on(He),_,z));let L,B=k>X;Wi=de,ds=null;let Y=T.ori==0?_:z,st=T.ori==1?_:z;if(Fe<0||A==0||B){L=Ct.idx=null;for(let lt=0;lt<w.length;lt++){let pt=je[lt];pt!=null&&Di(pt,-10,-10,_,z)}zi&&Ri(null,wr,!0,v==null&&Qe.setSeries),ft.live&&(mt.fill(L),O=!0)}else{let lt,pt,At;s==1&&(lt=T.ori==0?Fe:He,pt=Pi(lt,R),L=Ct.idx=vi(pt,t[0],k,X),At=G(t[0][L],T,Y,0));let Tt=-10,Pt=-10,Zt=0,De=0,pe=!0,ae="",jt="";for(let zt=s==2?1:0;zt<w.length;zt++){let Te=w[zt],Ke=mt[zt],Ze=Ke==null?null:s==1?t[zt][Ke]:t[zt][1][Ke],ke=Ct.dataIdx(n,zt,L,pt),tn=ke==null?null:s==1?t[zt][ke]:t[zt][1][ke];O=O||tn!=Ze||ke!=Ke,mt[zt]=ke;let On=ke==L?At:G(s==1?t[0][ke]:t[zt][0][ke],T,Y,0);if(zt>0&&Te.show){let kn=tn==null?-10:q(tn,s==1?D[Te.scale]:D[Te.facets[1].scale],st,0);if(zi&&tn!=null){let ii=T.ori==1?Fe:He,pi=an(pn.dist(n,zt,ke,kn,ii));if(pi<Wi){let mi=pn.bias;if(mi!=0){let Cn=Pi(ii,Te.scale),Ii=tn>=0?1:-1,Rn=Cn>=0?1:-1;Rn==Ii&&(Rn==1?mi==1?tn>=Cn:tn<=Cn:mi==1?tn<=Cn:tn>=Cn)&&(Wi=pi,ds=zt)}else Wi=pi,ds=zt}}if(O||Vi){let ii,pi;T.ori==0?(ii=On,pi=kn):(ii=kn,pi=On);let mi,Cn,Ii,Rn,Pn,qn,Er=!0,ps=Ae.bbox;if(ps!=null){Er=!1;let si=ps(n,zt);Ii=si.left,Rn=si.top,mi=si.width,Cn=si.height}else Ii=ii,Rn=pi,mi=Cn=Ae.size(n,zt);if(qn=Ae.fill(n,zt),Pn=Ae.stroke(n,zt),Vi)zt==ds&&Wi<=pn.prox&&(Tt=Ii,Pt=Rn,Zt=mi,De=Cn,pe=Er,ae=qn,jt=Pn);else{let si=je[zt];si!=null&&(Ai[zt]=Ii,Hi[zt]=Rn,xf(si,mi,Cn,Er),vf(si,qn,Pn),Di(si,oi(Ii),oi(Rn),_,z))}}}}if(Vi){let zt=pn.prox,Te=Us==null?Wi<=zt:Wi>zt||ds!=Us;if(O||Te){let Ke=je[0];Ai[0]=Tt,Hi[0]=Pt,xf(Ke,Zt,De,pe),vf(Ke,ae,jt),Di(Ke,oi(Tt),oi(Pt),_,z)}}}if(Oe.show&&hs)if(v!=null){let[lt,pt]=Qe.scales,[At,Tt]=Qe.match,[Pt,Zt]=v.cursor.sync.scales,De=v.cursor.drag;if(gn=De._x,vn=De._y,gn||vn){let{left:pe,top:ae,width:jt,height:zt}=v.select,Te=v.scales[Pt].ori,Ke=v.posToVal,Ze,ke,tn,On,kn,ii=lt!=null&&At(lt,Pt),pi=pt!=null&&Tt(pt,Zt);ii&&gn?(Te==0?(Ze=pe,ke=jt):(Ze=ae,ke=zt),tn=D[lt],On=G(Ke(Ze,Pt),tn,Y,0),kn=G(Ke(Ze+ke,Pt),tn,Y,0),Ao(ai(On,kn),an(kn-On))):Ao(0,Y),pi&&vn?(Te==1?(Ze=pe,ke=jt):(Ze=ae,ke=zt),tn=D[pt],On=q(Ke(Ze,Zt),tn,st,0),kn=q(Ke(Ze+ke,Zt),tn,st,0),To(ai(On,kn),an(kn-On))):To(0,st)}else ya()}else{let lt=an(Vd-Bd),pt=an(Hd-zd);if(T.ori==1){let Zt=lt;lt=pt,pt=Zt}gn=bn.x&&lt>=bn.dist,vn=bn.y&&pt>=bn.dist;let At=bn.uni;At!=null?gn&&vn&&(gn=lt>=At,vn=pt>=At,!gn&&!vn&&(pt>lt?vn=!0:gn=!0)):bn.x&&bn.y&&(gn||vn)&&(gn=vn=!0);let Tt,Pt;gn&&(T.ori==0?(Tt=_r,Pt=Fe):(Tt=br,Pt=He),Ao(ai(Tt,Pt),an(Pt-Tt)),vn||To(0,st)),vn&&(T.ori==1?(Tt=_r,Pt=Fe):(Tt=br,Pt=He),To(ai(Tt,Pt),an(Pt-Tt)),gn||Ao(0,Y)),!gn&&!vn&&(Ao(0,0),To(0,0))}if(bn._x=gn,bn._y=vn,v==null){if(I){if(ef!=null){let[lt,pt]=Qe.scales;Qe.values[0]=lt!=null?Pi(T.ori==0?Fe:He,lt):null,Qe.values[1]=pt!=null?Pi(T.ori==1?Fe:He,pt):null}Ro(cf,n,Fe,He,_,z,L)}if(zi){let lt=I&&Qe.setSeries,pt=pn.prox;Us==null?Wi<=pt&&Ri(ds,wr,!0,lt):Wi>pt?Ri(null,wr,!0,lt):ds!=Us&&Ri(ds,wr,!0,lt)}}O&&(ft.idx=L,Tc()),M!==!1&&yn("setCursor")}let fs=null;Object.defineProperty(n,"rect",{get(){return fs==null&&Co(!1),fs}});function Co(v=!1){v?fs=null:(fs=y.getBoundingClientRect(),yn("syncRect",fs))}function Xd(v,M,I,L,B,Y,st){Ct._lock||hs&&v!=null&&v.movementX==0&&v.movementY==0||(Cc(v,M,I,L,B,Y,st,!1,v!=null),v!=null?Ns(null,!0,!0):Ns(M,!0,!1))}function Cc(v,M,I,L,B,Y,st,lt,pt){if(fs==null&&Co(!1),oe(v),v!=null)I=v.clientX-fs.left,L=v.clientY-fs.top;else{if(I<0||L<0){Fe=-10,He=-10;return}let[At,Tt]=Qe.scales,Pt=M.cursor.sync,[Zt,De]=Pt.values,[pe,ae]=Pt.scales,[jt,zt]=Qe.match,Te=M.axes[0].side%2==1,Ke=T.ori==0?_:z,Ze=T.ori==1?_:z,ke=Te?Y:B,tn=Te?B:Y,On=Te?L:I,kn=Te?I:L;if(pe!=null?I=jt(At,pe)?l(Zt,D[At],Ke,0):-10:I=Ke*(On/ke),ae!=null?L=zt(Tt,ae)?l(De,D[Tt],Ze,0):-10:L=Ze*(kn/tn),T.ori==1){let ii=I;I=L,L=ii}}pt&&((I<=1||I>=_-1)&&(I=Fs(I,_)),(L<=1||L>=z-1)&&(L=Fs(L,z))),lt?(Bd=I,zd=L,[_r,br]=Ct.move(n,I,L)):(Fe=I,He=L)}let Rc={width:0,height:0,left:0,top:0};function ya(){va(Rc,!1)}let qd,Yd,$d,Zd;function Jd(v,M,I,L,B,Y,st){hs=!0,gn=vn=bn._x=bn._y=!1,Cc(v,M,I,L,B,Y,st,!0,!1),v!=null&&(Nt(Uc,Bc,Kd,!1),Ro(hf,n,_r,br,_,z,null));let{left:lt,top:pt,width:At,height:Tt}=Oe;qd=lt,Yd=pt,$d=At,Zd=Tt,ya()}function Kd(v,M,I,L,B,Y,st){hs=bn._x=bn._y=!1,Cc(v,M,I,L,B,Y,st,!1,!0);let{left:lt,top:pt,width:At,height:Tt}=Oe,Pt=At>0||Tt>0,Zt=qd!=lt||Yd!=pt||$d!=At||Zd!=Tt;if(Pt&&Zt&&va(Oe),bn.setScale&&Pt&&Zt){let De=lt,pe=At,ae=pt,jt=Tt;if(T.ori==1&&(De=pt,pe=Tt,ae=lt,jt=At),gn&&us(R,Pi(De,R),Pi(De+pe,R)),vn)for(let zt in D){let Te=D[zt];zt!=R&&Te.from==null&&Te.min!=de&&us(zt,Pi(ae+jt,zt),Pi(ae,zt))}ya()}else Ct.lock&&(Ct._lock=!Ct._lock,Ns(null,!0,!1));v!=null&&(be(Uc,Bc),Ro(Uc,n,Fe,He,_,z,null))}function P0(v,M,I,L,B,Y,st){if(Ct._lock)return;oe(v);let lt=hs;if(hs){let pt=!0,At=!0,Tt=10,Pt,Zt;T.ori==0?(Pt=gn,Zt=vn):(Pt=vn,Zt=gn),Pt&&Zt&&(pt=Fe<=Tt||Fe>=_-Tt,At=He<=Tt||He>=z-Tt),Pt&&pt&&(Fe=Fe<_r?0:_),Zt&&At&&(He=He<br?0:z),Ns(null,!0,!0),hs=!1}Fe=-10,He=-10,Ns(null,!0,!0),lt&&(hs=lt)}function jd(v,M,I,L,B,Y,st){Ct._lock||(oe(v),Ft(),ya(),v!=null&&Ro(ff,n,Fe,He,_,z,null))}function Qd(){x.forEach(Py),yt(n.width,n.height,!0)}Bs(Ra,Rr,Qd);let Sr={};Sr.mousedown=Jd,Sr.mousemove=Xd,Sr.mouseup=Kd,Sr.dblclick=jd,Sr.setSeries=(v,M,I,L)=>{let B=Qe.match[2];I=B(n,M,I),I!=-1&&Ri(I,L,!0,!1)},Ct.show&&(Nt(hf,y,Jd),Nt(cf,y,Xd),Nt(uf,y,v=>{oe(v),Co(!1)}),Nt(df,y,P0),Nt(ff,y,jd),Yc.add(n),n.syncRect=Co);let xa=n.hooks=i.hooks||{};function yn(v,M,I){wc?Eo.push([v,M,I]):v in xa&&xa[v].forEach(L=>{L.call(null,n,M,I)})}(i.plugins||[]).forEach(v=>{for(let M in v.hooks)xa[M]=(xa[M]||[]).concat(v.hooks[M])});let tf=(v,M,I)=>I,Qe=en({key:null,setSeries:!1,filters:{pub:Sf,sub:Sf},scales:[R,w[1]?w[1].scale:null],match:[Ef,Ef,tf],values:[null,null]},Ct.sync);Qe.match.length==2&&Qe.match.push(tf),Ct.sync=Qe;let ef=Qe.key,Pc=vp(ef);function Ro(v,M,I,L,B,Y,st){Qe.filters.pub(v,M,I,L,B,Y,st)&&Pc.pub(v,M,I,L,B,Y,st)}Pc.sub(n);function I0(v,M,I,L,B,Y,st){Qe.filters.sub(v,M,I,L,B,Y,st)&&Sr[v](null,M,I,L,B,Y,st)}n.pub=I0;function L0(){Pc.unsub(n),Yc.delete(n),Jt.clear(),Hc(Ra,Rr,Qd),h.remove(),ct?.remove(),yn("destroy")}n.destroy=L0;function Ic(){yn("init",i,t),Mt(t||i.data,!1),J[R]?Sc(R,J[R]):Ft(),xe=Oe.show&&(Oe.width>0||Oe.height>0),Yt=O=!0,yt(i.width,i.height)}return w.forEach(Ps),x.forEach(fa),e?e instanceof HTMLElement?(e.appendChild(h),Ic()):e(n,Ic):Ic(),n}ln.assign=en;ln.fmtNum=th;ln.rangeNum=Pa;ln.rangeLog=La;ln.rangeAsinh=jc;ln.orient=Vs;ln.pxRatio=_e;ln.join=bv;ln.fmtDate=nh,ln.tzDate=Lv;ln.sync=vp;{ln.addGap=py,ln.clipGaps=Na;let i=ln.paths={points:wp};i.linear=Ep,i.stepped=vy,i.bars=yy,i.spline=_y}function zn(i,t){let e=0,n=i.length-1;for(;e<n;){let s=e+n+1>>1;i[s]<=t?e=s:n=s-1}return e}function Rp(i,t){if(i.length===0)return-1;let e=zn(i,t);return e+1<i.length&&i[e+1]-t<t-i[e]?e+1:e}var Pp=150,kr=class{constructor(t,e){this.element=t;this.seek=e;this.list=[];this.sync=ln.sync("time");this.lines=new Map;this.time=0;new ResizeObserver(()=>this.resize()).observe(t)}add(t,e){this.list.push(this.chart(t,e))}replace(t,e){let n=this.list[t],s=n.root.parentElement,r=e.length+1!==n.series.length||e.some(({label:o},a)=>n.series[a+1].label!==o);s&&r?(this.remove(n),this.list[t]=this.chart(s,e)):Iy(n,Ip(e))}keep(t){for(let e of this.list.splice(t))this.remove(e)}setTime(t){this.time=t;for(let[e,n]of this.lines){let s=e.valToPos(t,"x");n.style.transform=`translateX(${s}px)`,n.hidden=!(s>=0&&s<=e.over.clientWidth),(e.cursor.left??-1)<0&&e.setLegend({idx:zn(e.data[0],t)},!1)}}redraw(){for(let t of this.list)t.redraw(!1,!0)}resize(){for(let t of this.list){let e=t.root.parentElement?.clientWidth??0;e>0&&e!==t.width&&t.setSize({width:e,height:Pp})}this.setTime(this.time)}remove(t){t.destroy(),this.lines.delete(t)}chart(t,e){let n=l=>()=>getComputedStyle(this.element).getPropertyValue(l),s={stroke:n("--text"),grid:{stroke:n("--grid"),width:1},ticks:{stroke:n("--grid"),width:1}},r=F("div",{class:"now"}),o=new ln({width:Math.max(200,t.clientWidth),height:Pp,cursor:{sync:{key:this.sync.key},drag:{x:!0,y:!1},points:{size:5}},scales:{x:{time:!1},y:{range:(l,c,h)=>Uy(c,h)}},axes:[{...s,size:28},{...s,size:62,values:(l,c)=>c.map(h=>he(h,4))}],series:[{label:"t",value:(l,c)=>c==null?"\u2013":`${he(c,6)} s`},...e.map(Ly)],hooks:{setScale:[()=>this.setTime(this.time)]}},Ip(e),t);o.over.append(r),this.lines.set(o,r);let a=0;return o.over.addEventListener("pointerdown",l=>a=l.clientX),o.over.addEventListener("click",l=>{Math.abs(l.clientX-a)<4&&this.seek(o.posToVal(l.offsetX,"x"))}),o}};function Iy(i,t){let[e]=i.data,{min:n,max:s}=i.scales.x,r=n==null||s==null||n<=e[0]&&s>=e[e.length-1];i.setData(t,r),r||i.redraw()}function Ly({label:i,color:t,width:e,isDashed:n}){return{label:i,stroke:t,width:e??1.6,dash:n?[5,4]:void 0,spanGaps:!0,points:{show:!1},value:(s,r)=>r==null?"\u2013":he(r,6)}}function Ip(i){let t=[...new Set(i.map(({times:o})=>o))],e=t.flatMap(o=>i.filter(a=>a.times===o)),n=t.map(o=>[Array.from(o),...i.filter(a=>a.times===o).map(({values:a})=>Array.from(a))]);if(n.length===0)return[[]];let[s,...r]=n.length===1?n[0]:ln.join(n);return[s,...i.map(o=>r[e.indexOf(o)])]}function Ba(i){let t=0;for(let{values:e}of i)for(let n=0;n<e.length;++n)t=Math.max(t,Math.abs(e[n]));return t===0||!Number.isFinite(t)||t>=.001&&t<1e6?0:3*Math.floor(Math.log10(t)/3)}function za(i,t){return t===0?i:i.map(e=>({...e,values:Array.from(e.values,n=>n/10**t)}))}function Va(i,t){let e=[t===0?"":`10${Dy(t)}`,i].filter(Boolean).join(" ");return e&&` [${e}]`}function Dy(i){return String(i).replace(/./g,t=>"\u207B\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079"["-0123456789".indexOf(t)])}function Uy(i,t){if(i==null||t==null||i===0&&t===0)return[0,1];let e=.06*(t-i)||.1*Math.abs(t);return[i===0?0:i-e,t+e]}function vs(i,t){let{look:e,mass:n,moments:s}=i.bodies[t],r=i.looks[e];if(r.length>0||n<=0)return r;let[o,a,l]=s,c=[a+l-o,l+o-a,o+a-l].map(u=>2.5*Math.max(0,u)/n),h=Math.max(Math.sqrt(Math.max(...c)),...ch(i,t).map(u=>Math.hypot(...u)))||1;return[{type:"ellipsoid",radii:c.map(u=>Math.max(Math.sqrt(u),.05*h)),p:[0,0,0],q:[1,0,0,0],material:0,color:""}]}var Lp=new WeakMap;function ch(i,t){let e=Lp.get(i);if(!e){e=new Map;for(let n of i.joints)for(let s of[0,1]){let r=e.get(n.bodies[s]);r?r.push(n.points[s]):e.set(n.bodies[s],[n.points[s]])}Lp.set(i,e)}return e.get(t)??[]}var fd="170",cr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},hr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Ny=0,Dp=1,Fy=2;var Vm=1,Oy=2,es=3,Fi=0,Hn=1,hi=2,Es=0,eo=1,Up=2,Np=3,Fp=4,ky=5,Zs=100,By=101,zy=102,Vy=103,Hy=104,Gy=200,Wy=201,Xy=202,qy=203,Hh=204,Gh=205,Yy=206,$y=207,Zy=208,Jy=209,Ky=210,jy=211,Qy=212,tx=213,ex=214,Wh=0,Xh=1,qh=2,ro=3,Yh=4,$h=5,Zh=6,Jh=7,Hm=0,nx=1,ix=2,As=0,sx=1,rx=2,ox=3,ax=4,lx=5,cx=6,hx=7;var Gm=300,oo=301,ao=302,Kh=303,jh=304,Jl=306,Qh=1e3,js=1001,tu=1002,Qn=1003,ux=1004;var Ha=1005;var Ni=1006,hh=1007;var Qs=1008;var ss=1009,Wm=1010,Xm=1011,Qo=1012,pd=1013,tr=1014,Mi=1015,sa=1016,md=1017,gd=1018,lo=1020,qm=35902,Ym=1021,$m=1022,jn=1023,Zm=1024,Jm=1025,no=1026,co=1027,Km=1028,vd=1029,jm=1030,yd=1031;var xd=1033,ml=33776,gl=33777,vl=33778,yl=33779,eu=35840,nu=35841,iu=35842,su=35843,ru=36196,ou=37492,au=37496,lu=37808,cu=37809,hu=37810,uu=37811,du=37812,fu=37813,pu=37814,mu=37815,gu=37816,vu=37817,yu=37818,xu=37819,_u=37820,bu=37821,xl=36492,Mu=36494,wu=36495,Qm=36283,Su=36284,Eu=36285,Au=36286;var _l=2300,Tu=2301,uh=2302,Op=2400,kp=2401,Bp=2402;var dx=3200,fx=3201;var px=0,mx=1,Ss="",ci="srgb",mo="srgb-linear",Kl="linear",Pe="srgb";var Br=7680;var tg=7682;var eg=514;var zp=519,gx=512,vx=513,yx=514,ng=515,xx=516,_x=517,bx=518,Mx=519,Vp=35044,ig=35048;var Oi="300 es",ns=2e3,bl=2001,rs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;let n=this._listeners;return n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;let s=this._listeners[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;let n=this._listeners[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Sn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Hp=1234567,$o=Math.PI/180,ta=180/Math.PI;function go(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Sn[i&255]+Sn[i>>8&255]+Sn[i>>16&255]+Sn[i>>24&255]+"-"+Sn[t&255]+Sn[t>>8&255]+"-"+Sn[t>>16&15|64]+Sn[t>>24&255]+"-"+Sn[e&63|128]+Sn[e>>8&255]+"-"+Sn[e>>16&255]+Sn[e>>24&255]+Sn[n&255]+Sn[n>>8&255]+Sn[n>>16&255]+Sn[n>>24&255]).toLowerCase()}function hn(i,t,e){return Math.max(t,Math.min(e,i))}function _d(i,t){return(i%t+t)%t}function wx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Sx(i,t,e){return i!==t?(e-i)/(t-i):0}function Zo(i,t,e){return(1-e)*i+e*t}function Ex(i,t,e,n){return Zo(i,t,1-Math.exp(-e*n))}function Ax(i,t=1){return t-Math.abs(_d(i,t*2)-t)}function Tx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Cx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Rx(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Px(i,t){return i+Math.random()*(t-i)}function Ix(i){return i*(.5-Math.random())}function Lx(i){i!==void 0&&(Hp=i);let t=Hp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Dx(i){return i*$o}function Ux(i){return i*ta}function Nx(i){return(i&i-1)===0&&i!==0}function Fx(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Ox(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function kx(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),d=r((t-n)/2),u=o((t-n)/2),f=r((n-t)/2),g=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*d,l*u,a*c);break;case"YZY":i.set(l*u,a*h,l*d,a*c);break;case"ZXZ":i.set(l*d,l*u,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Qr(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function In(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var sg={DEG2RAD:$o,RAD2DEG:ta,generateUUID:go,clamp:hn,euclideanModulo:_d,mapLinear:wx,inverseLerp:Sx,lerp:Zo,damp:Ex,pingpong:Ax,smoothstep:Tx,smootherstep:Cx,randInt:Rx,randFloat:Px,randFloatSpread:Ix,seededRandom:Lx,degToRad:Dx,radToDeg:Ux,isPowerOfTwo:Nx,ceilPowerOfTwo:Fx,floorPowerOfTwo:Ox,setQuaternionFromProperEuler:kx,normalize:In,denormalize:Qr},_t=class i{constructor(t=0,e=0){i.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(hn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ne=class i{constructor(t,e,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],g=n[8],y=s[0],m=s[3],p=s[6],S=s[1],w=s[4],x=s[7],D=s[2],C=s[5],R=s[8];return r[0]=o*y+a*S+l*D,r[3]=o*m+a*w+l*C,r[6]=o*p+a*x+l*R,r[1]=c*y+h*S+d*D,r[4]=c*m+h*w+d*C,r[7]=c*p+h*x+d*R,r[2]=u*y+f*S+g*D,r[5]=u*m+f*w+g*C,r[8]=u*p+f*x+g*R,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,g=e*d+n*u+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=d*y,t[1]=(s*c-h*n)*y,t[2]=(a*n-s*o)*y,t[3]=u*y,t[4]=(h*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(dh.makeScale(t,e)),this}rotate(t){return this.premultiply(dh.makeRotation(-t)),this}translate(t,e){return this.premultiply(dh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},dh=new ne;function rg(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Ml(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Bx(){let i=Ml("canvas");return i.style.display="block",i}var Gp={};function qo(i){i in Gp||(Gp[i]=!0,console.warn(i))}function zx(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}function Vx(i){let t=i.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function Hx(i){let t=i.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}var ve={enabled:!0,workingColorSpace:mo,spaces:{},convert:function(i,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Pe&&(i.r=is(i.r),i.g=is(i.g),i.b=is(i.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(i.applyMatrix3(this.spaces[t].toXYZ),i.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Pe&&(i.r=io(i.r),i.g=io(i.g),i.b=io(i.b))),i},fromWorkingColorSpace:function(i,t){return this.convert(i,this.workingColorSpace,t)},toWorkingColorSpace:function(i,t){return this.convert(i,t,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===Ss?Kl:this.spaces[i].transfer},getLuminanceCoefficients:function(i,t=this.workingColorSpace){return i.fromArray(this.spaces[t].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,t,e){return i.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function is(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function io(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Wp=[.64,.33,.3,.6,.15,.06],Xp=[.2126,.7152,.0722],qp=[.3127,.329],Yp=new ne().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),$p=new ne().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ve.define({[mo]:{primaries:Wp,whitePoint:qp,transfer:Kl,toXYZ:Yp,fromXYZ:$p,luminanceCoefficients:Xp,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:Wp,whitePoint:qp,transfer:Pe,toXYZ:Yp,fromXYZ:$p,luminanceCoefficients:Xp,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}});var zr,Cu=class{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{zr===void 0&&(zr=Ml("canvas")),zr.width=t.width,zr.height=t.height;let n=zr.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),e=zr}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Ml("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=is(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(is(e[n]/255)*255):e[n]=is(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Gx=0,wl=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Gx++}),this.uuid=go(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(fh(s[o].image)):r.push(fh(s[o]))}else r=fh(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function fh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Cu.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Wx=0,Un=class i extends rs{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=js,s=js,r=Ni,o=Qs,a=jn,l=ss,c=i.DEFAULT_ANISOTROPY,h=Ss){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Wx++}),this.uuid=go(),this.name="",this.source=new wl(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new _t(0,0),this.repeat=new _t(1,1),this.center=new _t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ne,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Gm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Qh:t.x=t.x-Math.floor(t.x);break;case js:t.x=t.x<0?0:1;break;case tu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Qh:t.y=t.y-Math.floor(t.y);break;case js:t.y=t.y<0?0:1;break;case tu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Un.DEFAULT_IMAGE=null;Un.DEFAULT_MAPPING=Gm;Un.DEFAULT_ANISOTROPY=1;var We=class i{constructor(t=0,e=0,n=0,s=1){i.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],g=l[9],y=l[2],m=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,x=(f+1)/2,D=(p+1)/2,C=(h+u)/4,R=(d+y)/4,U=(g+m)/4;return w>x&&w>D?w<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(w),s=C/n,r=R/n):x>D?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=C/s,r=U/s):D<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(D),n=R/r,s=U/r),this.set(n,s,r,e),this}let S=Math.sqrt((m-g)*(m-g)+(d-y)*(d-y)+(u-h)*(u-h));return Math.abs(S)<.001&&(S=1),this.x=(m-g)/S,this.y=(d-y)/S,this.z=(u-h)/S,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ru=class extends rs{constructor(t=1,e=1,n={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new We(0,0,t,e),this.scissorTest=!1,this.viewport=new We(0,0,t,e);let s={width:t,height:e,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ni,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);let r=new Un(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);r.flipY=!1,r.generateMipmaps=n.generateMipmaps,r.internalFormat=n.internalFormat,this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,s=t.textures.length;n<s;n++)this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;let e=Object.assign({},t.texture.image);return this.texture.source=new wl(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},wi=class extends Ru{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},Sl=class extends Un{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Qn,this.minFilter=Qn,this.wrapR=js,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Pu=class extends Un{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Qn,this.minFilter=Qn,this.wrapR=js,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Nn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d;return}if(a===1){t[e+0]=u,t[e+1]=f,t[e+2]=g,t[e+3]=y;return}if(d!==y||l!==u||c!==f||h!==g){let m=1-a,p=l*u+c*f+h*g+d*y,S=p>=0?1:-1,w=1-p*p;if(w>Number.EPSILON){let D=Math.sqrt(w),C=Math.atan2(D,p*S);m=Math.sin(m*C)/D,a=Math.sin(a*C)/D}let x=a*S;if(l=l*m+u*x,c=c*m+f*x,h=h*m+g*x,d=d*m+y*x,m===1-a){let D=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=D,c*=D,h*=D,d*=D}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[o],u=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+h*d+l*f-c*u,t[e+1]=l*g+h*u+c*d-a*f,t[e+2]=c*g+h*f+a*u-l*d,t[e+3]=h*g-a*d-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),d=a(r/2),u=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d-u*f*g;break;case"YXZ":this._x=u*h*d+c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d+u*f*g;break;case"ZXY":this._x=u*h*d-c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d-u*f*g;break;case"ZYX":this._x=u*h*d-c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d+u*f*g;break;case"YZX":this._x=u*h*d+c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d-u*f*g;break;case"XZY":this._x=u*h*d-c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d+u*f*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<Number.EPSILON?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(hn(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let f=1-e;return this._w=f*o+e*this._w,this._x=f*n+e*this._x,this._y=f*s+e*this._y,this._z=f*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),h=Math.atan2(c,a),d=Math.sin((1-e)*h)/c,u=Math.sin(e*h)/c;return this._w=o*d+this._w*u,this._x=n*d+this._x*u,this._y=s*d+this._y*u,this._z=r*d+this._z*u,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},N=class i{constructor(t=0,e=0,n=0){i.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Zp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Zp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),d=2*(r*n-o*e);return this.x=e+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return ph.copy(this).projectOnVector(t),this.sub(ph)}reflect(t){return this.sub(ph.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(hn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ph=new N,Zp=new Nn,er=class{constructor(t=new N(1/0,1/0,1/0),e=new N(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(yi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(yi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=yi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,yi):yi.fromBufferAttribute(r,o),yi.applyMatrix4(t.matrixWorld),this.expandByPoint(yi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ga.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ga.copy(n.boundingBox)),Ga.applyMatrix4(t.matrixWorld),this.union(Ga)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,yi),yi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Vo),Wa.subVectors(this.max,Vo),Vr.subVectors(t.a,Vo),Hr.subVectors(t.b,Vo),Gr.subVectors(t.c,Vo),ys.subVectors(Hr,Vr),xs.subVectors(Gr,Hr),Hs.subVectors(Vr,Gr);let e=[0,-ys.z,ys.y,0,-xs.z,xs.y,0,-Hs.z,Hs.y,ys.z,0,-ys.x,xs.z,0,-xs.x,Hs.z,0,-Hs.x,-ys.y,ys.x,0,-xs.y,xs.x,0,-Hs.y,Hs.x,0];return!mh(e,Vr,Hr,Gr,Wa)||(e=[1,0,0,0,1,0,0,0,1],!mh(e,Vr,Hr,Gr,Wa))?!1:(Xa.crossVectors(ys,xs),e=[Xa.x,Xa.y,Xa.z],mh(e,Vr,Hr,Gr,Wa))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,yi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(yi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ji[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ji[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ji[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ji[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ji[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ji[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ji[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ji[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ji),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}},Ji=[new N,new N,new N,new N,new N,new N,new N,new N],yi=new N,Ga=new er,Vr=new N,Hr=new N,Gr=new N,ys=new N,xs=new N,Hs=new N,Vo=new N,Wa=new N,Xa=new N,Gs=new N;function mh(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Gs.fromArray(i,r);let a=s.x*Math.abs(Gs.x)+s.y*Math.abs(Gs.y)+s.z*Math.abs(Gs.z),l=t.dot(Gs),c=e.dot(Gs),h=n.dot(Gs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Xx=new er,Ho=new N,gh=new N,nr=class{constructor(t=new N,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Xx.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ho.subVectors(t,this.center);let e=Ho.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Ho,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(gh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ho.copy(t.center).add(gh)),this.expandByPoint(Ho.copy(t.center).sub(gh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}},Ki=new N,vh=new N,qa=new N,_s=new N,yh=new N,Ya=new N,xh=new N,ir=class{constructor(t=new N,e=new N(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ki)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ki.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ki.copy(this.origin).addScaledVector(this.direction,e),Ki.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){vh.copy(t).add(e).multiplyScalar(.5),qa.copy(e).sub(t).normalize(),_s.copy(this.origin).sub(vh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(qa),a=_s.dot(this.direction),l=-_s.dot(qa),c=_s.lengthSq(),h=Math.abs(1-o*o),d,u,f,g;if(h>0)if(d=o*l-a,u=o*a-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let y=1/h;d*=y,u*=y,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(vh).addScaledVector(qa,u),f}intersectSphere(t,e){Ki.subVectors(t.center,this.origin);let n=Ki.dot(this.direction),s=Ki.dot(Ki)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ki)!==null}intersectTriangle(t,e,n,s,r){yh.subVectors(e,t),Ya.subVectors(n,t),xh.crossVectors(yh,Ya);let o=this.direction.dot(xh),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;_s.subVectors(this.origin,t);let l=a*this.direction.dot(Ya.crossVectors(_s,Ya));if(l<0)return null;let c=a*this.direction.dot(yh.cross(_s));if(c<0||l+c>o)return null;let h=-a*_s.dot(xh);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Je=class i{constructor(t,e,n,s,r,o,a,l,c,h,d,u,f,g,y,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,d,u,f,g,y,m)}set(t,e,n,s,r,o,a,l,c,h,d,u,f,g,y,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=f,p[7]=g,p[11]=y,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,n=t.elements,s=1/Wr.setFromMatrixColumn(t,0).length(),r=1/Wr.setFromMatrixColumn(t,1).length(),o=1/Wr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,f=o*d,g=a*h,y=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=f+g*c,e[5]=u-y*c,e[9]=-a*l,e[2]=y-u*c,e[6]=g+f*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,f=l*d,g=c*h,y=c*d;e[0]=u+y*a,e[4]=g*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-g,e[6]=y+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,f=l*d,g=c*h,y=c*d;e[0]=u-y*a,e[4]=-o*d,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*h,e[9]=y-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,f=o*d,g=a*h,y=a*d;e[0]=l*h,e[4]=g*c-f,e[8]=u*c+y,e[1]=l*d,e[5]=y*c+u,e[9]=f*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,f=o*c,g=a*l,y=a*c;e[0]=l*h,e[4]=y-u*d,e[8]=g*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*d+g,e[10]=u-y*d}else if(t.order==="XZY"){let u=o*l,f=o*c,g=a*l,y=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+y,e[5]=o*h,e[9]=f*d-g,e[2]=g*d-f,e[6]=a*h,e[10]=y*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(qx,t,Yx)}lookAt(t,e,n){let s=this.elements;return Jn.subVectors(t,e),Jn.lengthSq()===0&&(Jn.z=1),Jn.normalize(),bs.crossVectors(n,Jn),bs.lengthSq()===0&&(Math.abs(n.z)===1?Jn.x+=1e-4:Jn.z+=1e-4,Jn.normalize(),bs.crossVectors(n,Jn)),bs.normalize(),$a.crossVectors(Jn,bs),s[0]=bs.x,s[4]=$a.x,s[8]=Jn.x,s[1]=bs.y,s[5]=$a.y,s[9]=Jn.y,s[2]=bs.z,s[6]=$a.z,s[10]=Jn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],g=n[2],y=n[6],m=n[10],p=n[14],S=n[3],w=n[7],x=n[11],D=n[15],C=s[0],R=s[4],U=s[8],E=s[12],b=s[1],T=s[5],H=s[9],G=s[13],q=s[2],J=s[6],$=s[10],nt=s[14],Q=s[3],ht=s[7],ot=s[11],mt=s[15];return r[0]=o*C+a*b+l*q+c*Q,r[4]=o*R+a*T+l*J+c*ht,r[8]=o*U+a*H+l*$+c*ot,r[12]=o*E+a*G+l*nt+c*mt,r[1]=h*C+d*b+u*q+f*Q,r[5]=h*R+d*T+u*J+f*ht,r[9]=h*U+d*H+u*$+f*ot,r[13]=h*E+d*G+u*nt+f*mt,r[2]=g*C+y*b+m*q+p*Q,r[6]=g*R+y*T+m*J+p*ht,r[10]=g*U+y*H+m*$+p*ot,r[14]=g*E+y*G+m*nt+p*mt,r[3]=S*C+w*b+x*q+D*Q,r[7]=S*R+w*T+x*J+D*ht,r[11]=S*U+w*H+x*$+D*ot,r[15]=S*E+w*G+x*nt+D*mt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],f=t[14],g=t[3],y=t[7],m=t[11],p=t[15];return g*(+r*l*d-s*c*d-r*a*u+n*c*u+s*a*f-n*l*f)+y*(+e*l*f-e*c*u+r*o*u-s*o*f+s*c*h-r*l*h)+m*(+e*c*d-e*a*f-r*o*d+n*o*f+r*a*h-n*c*h)+p*(-s*a*h-e*l*d+e*a*u+s*o*d-n*o*u+n*l*h)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],f=t[11],g=t[12],y=t[13],m=t[14],p=t[15],S=d*m*c-y*u*c+y*l*f-a*m*f-d*l*p+a*u*p,w=g*u*c-h*m*c-g*l*f+o*m*f+h*l*p-o*u*p,x=h*y*c-g*d*c+g*a*f-o*y*f-h*a*p+o*d*p,D=g*d*l-h*y*l-g*a*u+o*y*u+h*a*m-o*d*m,C=e*S+n*w+s*x+r*D;if(C===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let R=1/C;return t[0]=S*R,t[1]=(y*u*r-d*m*r-y*s*f+n*m*f+d*s*p-n*u*p)*R,t[2]=(a*m*r-y*l*r+y*s*c-n*m*c-a*s*p+n*l*p)*R,t[3]=(d*l*r-a*u*r-d*s*c+n*u*c+a*s*f-n*l*f)*R,t[4]=w*R,t[5]=(h*m*r-g*u*r+g*s*f-e*m*f-h*s*p+e*u*p)*R,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*R,t[7]=(o*u*r-h*l*r+h*s*c-e*u*c-o*s*f+e*l*f)*R,t[8]=x*R,t[9]=(g*d*r-h*y*r-g*n*f+e*y*f+h*n*p-e*d*p)*R,t[10]=(o*y*r-g*a*r+g*n*c-e*y*c-o*n*p+e*a*p)*R,t[11]=(h*a*r-o*d*r-h*n*c+e*d*c+o*n*f-e*a*f)*R,t[12]=D*R,t[13]=(h*y*s-g*d*s+g*n*u-e*y*u-h*n*m+e*d*m)*R,t[14]=(g*a*s-o*y*s-g*n*l+e*y*l+o*n*m-e*a*m)*R,t[15]=(o*d*s-h*a*s+h*n*l-e*d*l-o*n*u+e*a*u)*R,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,g=r*d,y=o*h,m=o*d,p=a*d,S=l*c,w=l*h,x=l*d,D=n.x,C=n.y,R=n.z;return s[0]=(1-(y+p))*D,s[1]=(f+x)*D,s[2]=(g-w)*D,s[3]=0,s[4]=(f-x)*C,s[5]=(1-(u+p))*C,s[6]=(m+S)*C,s[7]=0,s[8]=(g+w)*R,s[9]=(m-S)*R,s[10]=(1-(u+y))*R,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements,r=Wr.set(s[0],s[1],s[2]).length(),o=Wr.set(s[4],s[5],s[6]).length(),a=Wr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],xi.copy(this);let c=1/r,h=1/o,d=1/a;return xi.elements[0]*=c,xi.elements[1]*=c,xi.elements[2]*=c,xi.elements[4]*=h,xi.elements[5]*=h,xi.elements[6]*=h,xi.elements[8]*=d,xi.elements[9]*=d,xi.elements[10]*=d,e.setFromRotationMatrix(xi),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=ns){let l=this.elements,c=2*r/(e-t),h=2*r/(n-s),d=(e+t)/(e-t),u=(n+s)/(n-s),f,g;if(a===ns)f=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===bl)f=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=h,l[9]=u,l[13]=0,l[2]=0,l[6]=0,l[10]=f,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=ns){let l=this.elements,c=1/(e-t),h=1/(n-s),d=1/(o-r),u=(e+t)*c,f=(n+s)*h,g,y;if(a===ns)g=(o+r)*d,y=-2*d;else if(a===bl)g=r*d,y=-1*d;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-u,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-f,l[2]=0,l[6]=0,l[10]=y,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Wr=new N,xi=new Je,qx=new N(0,0,0),Yx=new N(1,1,1),bs=new N,$a=new N,Jn=new N,Jp=new Je,Kp=new Nn,os=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(hn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-hn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(hn(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-hn(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(hn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-hn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Jp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Jp,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Kp.setFromEuler(this),this.setFromQuaternion(Kp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};os.DEFAULT_ORDER="XYZ";var El=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},$x=0,jp=new N,Xr=new Nn,ji=new Je,Za=new N,Go=new N,Zx=new N,Jx=new Nn,Qp=new N(1,0,0),tm=new N(0,1,0),em=new N(0,0,1),nm={type:"added"},Kx={type:"removed"},qr={type:"childadded",child:null},_h={type:"childremoved",child:null},ti=class i extends rs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:$x++}),this.uuid=go(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new N,e=new os,n=new Nn,s=new N(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Je},normalMatrix:{value:new ne}}),this.matrix=new Je,this.matrixWorld=new Je,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new El,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Xr.setFromAxisAngle(t,e),this.quaternion.multiply(Xr),this}rotateOnWorldAxis(t,e){return Xr.setFromAxisAngle(t,e),this.quaternion.premultiply(Xr),this}rotateX(t){return this.rotateOnAxis(Qp,t)}rotateY(t){return this.rotateOnAxis(tm,t)}rotateZ(t){return this.rotateOnAxis(em,t)}translateOnAxis(t,e){return jp.copy(t).applyQuaternion(this.quaternion),this.position.add(jp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Qp,t)}translateY(t){return this.translateOnAxis(tm,t)}translateZ(t){return this.translateOnAxis(em,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ji.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Za.copy(t):Za.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Go.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ji.lookAt(Go,Za,this.up):ji.lookAt(Za,Go,this.up),this.quaternion.setFromRotationMatrix(ji),s&&(ji.extractRotation(s.matrixWorld),Xr.setFromRotationMatrix(ji),this.quaternion.premultiply(Xr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(nm),qr.child=t,this.dispatchEvent(qr),qr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Kx),_h.child=t,this.dispatchEvent(_h),_h.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ji.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ji.multiply(t.parent.matrixWorld)),t.applyMatrix4(ji),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(nm),qr.child=t,this.dispatchEvent(qr),qr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Go,t,Zx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Go,Jx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}};ti.DEFAULT_UP=new N(0,1,0);ti.DEFAULT_MATRIX_AUTO_UPDATE=!0;ti.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var _i=new N,Qi=new N,bh=new N,ts=new N,Yr=new N,$r=new N,im=new N,Mh=new N,wh=new N,Sh=new N,Eh=new We,Ah=new We,Th=new We,Js=class i{constructor(t=new N,e=new N,n=new N){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),_i.subVectors(t,e),s.cross(_i);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){_i.subVectors(s,e),Qi.subVectors(n,e),bh.subVectors(t,e);let o=_i.dot(_i),a=_i.dot(Qi),l=_i.dot(bh),c=Qi.dot(Qi),h=Qi.dot(bh),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-f-g,g,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,ts)===null?!1:ts.x>=0&&ts.y>=0&&ts.x+ts.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ts.x),l.addScaledVector(o,ts.y),l.addScaledVector(a,ts.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Eh.setScalar(0),Ah.setScalar(0),Th.setScalar(0),Eh.fromBufferAttribute(t,e),Ah.fromBufferAttribute(t,n),Th.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Eh,r.x),o.addScaledVector(Ah,r.y),o.addScaledVector(Th,r.z),o}static isFrontFacing(t,e,n,s){return _i.subVectors(n,e),Qi.subVectors(t,e),_i.cross(Qi).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return _i.subVectors(this.c,this.b),Qi.subVectors(this.a,this.b),_i.cross(Qi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Yr.subVectors(s,n),$r.subVectors(r,n),Mh.subVectors(t,n);let l=Yr.dot(Mh),c=$r.dot(Mh);if(l<=0&&c<=0)return e.copy(n);wh.subVectors(t,s);let h=Yr.dot(wh),d=$r.dot(wh);if(h>=0&&d<=h)return e.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0)return o=l/(l-h),e.copy(n).addScaledVector(Yr,o);Sh.subVectors(t,r);let f=Yr.dot(Sh),g=$r.dot(Sh);if(g>=0&&f<=g)return e.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector($r,a);let m=h*g-f*d;if(m<=0&&d-h>=0&&f-g>=0)return im.subVectors(r,s),a=(d-h)/(d-h+(f-g)),e.copy(s).addScaledVector(im,a);let p=1/(m+y+u);return o=y*p,a=u*p,e.copy(n).addScaledVector(Yr,o).addScaledVector($r,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},og={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ms={h:0,s:0,l:0},Ja={h:0,s:0,l:0};function Ch(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var le=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ci){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.toWorkingColorSpace(this,e),this}setRGB(t,e,n,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=n,ve.toWorkingColorSpace(this,s),this}setHSL(t,e,n,s=ve.workingColorSpace){if(t=_d(t,1),e=hn(e,0,1),n=hn(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Ch(o,r,t+1/3),this.g=Ch(o,r,t),this.b=Ch(o,r,t-1/3)}return ve.toWorkingColorSpace(this,s),this}setStyle(t,e=ci){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ci){let n=og[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=is(t.r),this.g=is(t.g),this.b=is(t.b),this}copyLinearToSRGB(t){return this.r=io(t.r),this.g=io(t.g),this.b=io(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ci){return ve.fromWorkingColorSpace(En.copy(this),t),Math.round(hn(En.r*255,0,255))*65536+Math.round(hn(En.g*255,0,255))*256+Math.round(hn(En.b*255,0,255))}getHexString(t=ci){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.fromWorkingColorSpace(En.copy(this),e);let n=En.r,s=En.g,r=En.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ve.workingColorSpace){return ve.fromWorkingColorSpace(En.copy(this),e),t.r=En.r,t.g=En.g,t.b=En.b,t}getStyle(t=ci){ve.fromWorkingColorSpace(En.copy(this),t);let e=En.r,n=En.g,s=En.b;return t!==ci?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ms),this.setHSL(Ms.h+t,Ms.s+e,Ms.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ms),t.getHSL(Ja);let n=Zo(Ms.h,Ja.h,e),s=Zo(Ms.s,Ja.s,e),r=Zo(Ms.l,Ja.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},En=new le;le.NAMES=og;var jx=0,Ts=class extends rs{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:jx++}),this.uuid=go(),this.name="",this.blending=eo,this.side=Fi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hh,this.blendDst=Gh,this.blendEquation=Zs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new le(0,0,0),this.blendAlpha=0,this.depthFunc=ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=zp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Br,this.stencilZFail=Br,this.stencilZPass=Br,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==eo&&(n.blending=this.blending),this.side!==Fi&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Hh&&(n.blendSrc=this.blendSrc),this.blendDst!==Gh&&(n.blendDst=this.blendDst),this.blendEquation!==Zs&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==ro&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==zp&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Br&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Br&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Br&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}},Al=class extends Ts{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new le(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new os,this.combine=Hm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var nn=new N,Ka=new _t,ze=class{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Vp,this.updateRanges=[],this.gpuType=Mi,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ka.fromBufferAttribute(this,e),Ka.applyMatrix3(t),this.setXY(e,Ka.x,Ka.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyMatrix3(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyMatrix4(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyNormalMatrix(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.transformDirection(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Qr(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=In(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Qr(e,this.array)),e}setX(t,e){return this.normalized&&(e=In(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Qr(e,this.array)),e}setY(t,e){return this.normalized&&(e=In(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Qr(e,this.array)),e}setZ(t,e){return this.normalized&&(e=In(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Qr(e,this.array)),e}setW(t,e){return this.normalized&&(e=In(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=In(e,this.array),n=In(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=In(e,this.array),n=In(n,this.array),s=In(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=In(e,this.array),n=In(n,this.array),s=In(s,this.array),r=In(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Vp&&(t.usage=this.usage),t}};var Tl=class extends ze{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Cl=class extends ze{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Xe=class extends ze{constructor(t,e,n){super(new Float32Array(t),e,n)}},Qx=0,li=new Je,Rh=new ti,Zr=new N,Kn=new er,Wo=new er,xn=new N,qe=class i extends rs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Qx++}),this.uuid=go(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(rg(t)?Cl:Tl)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ne().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return li.makeRotationFromQuaternion(t),this.applyMatrix4(li),this}rotateX(t){return li.makeRotationX(t),this.applyMatrix4(li),this}rotateY(t){return li.makeRotationY(t),this.applyMatrix4(li),this}rotateZ(t){return li.makeRotationZ(t),this.applyMatrix4(li),this}translate(t,e,n){return li.makeTranslation(t,e,n),this.applyMatrix4(li),this}scale(t,e,n){return li.makeScale(t,e,n),this.applyMatrix4(li),this}lookAt(t){return Rh.lookAt(t),Rh.updateMatrix(),this.applyMatrix4(Rh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Zr).negate(),this.translate(Zr.x,Zr.y,Zr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Xe(n,3))}else{for(let n=0,s=e.count;n<s;n++){let r=t[n];e.setXYZ(n,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new er);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new N(-1/0,-1/0,-1/0),new N(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];Kn.setFromBufferAttribute(r),this.morphTargetsRelative?(xn.addVectors(this.boundingBox.min,Kn.min),this.boundingBox.expandByPoint(xn),xn.addVectors(this.boundingBox.max,Kn.max),this.boundingBox.expandByPoint(xn)):(this.boundingBox.expandByPoint(Kn.min),this.boundingBox.expandByPoint(Kn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new nr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new N,1/0);return}if(t){let n=this.boundingSphere.center;if(Kn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Wo.setFromBufferAttribute(a),this.morphTargetsRelative?(xn.addVectors(Kn.min,Wo.min),Kn.expandByPoint(xn),xn.addVectors(Kn.max,Wo.max),Kn.expandByPoint(xn)):(Kn.expandByPoint(Wo.min),Kn.expandByPoint(Wo.max))}Kn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)xn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(xn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)xn.fromBufferAttribute(a,c),l&&(Zr.fromBufferAttribute(t,c),xn.add(Zr)),s=Math.max(s,n.distanceToSquared(xn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new ze(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let U=0;U<n.count;U++)a[U]=new N,l[U]=new N;let c=new N,h=new N,d=new N,u=new _t,f=new _t,g=new _t,y=new N,m=new N;function p(U,E,b){c.fromBufferAttribute(n,U),h.fromBufferAttribute(n,E),d.fromBufferAttribute(n,b),u.fromBufferAttribute(r,U),f.fromBufferAttribute(r,E),g.fromBufferAttribute(r,b),h.sub(c),d.sub(c),f.sub(u),g.sub(u);let T=1/(f.x*g.y-g.x*f.y);isFinite(T)&&(y.copy(h).multiplyScalar(g.y).addScaledVector(d,-f.y).multiplyScalar(T),m.copy(d).multiplyScalar(f.x).addScaledVector(h,-g.x).multiplyScalar(T),a[U].add(y),a[E].add(y),a[b].add(y),l[U].add(m),l[E].add(m),l[b].add(m))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let U=0,E=S.length;U<E;++U){let b=S[U],T=b.start,H=b.count;for(let G=T,q=T+H;G<q;G+=3)p(t.getX(G+0),t.getX(G+1),t.getX(G+2))}let w=new N,x=new N,D=new N,C=new N;function R(U){D.fromBufferAttribute(s,U),C.copy(D);let E=a[U];w.copy(E),w.sub(D.multiplyScalar(D.dot(E))).normalize(),x.crossVectors(C,E);let T=x.dot(l[U])<0?-1:1;o.setXYZW(U,w.x,w.y,w.z,T)}for(let U=0,E=S.length;U<E;++U){let b=S[U],T=b.start,H=b.count;for(let G=T,q=T+H;G<q;G+=3)R(t.getX(G+0)),R(t.getX(G+1)),R(t.getX(G+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new ze(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new N,r=new N,o=new N,a=new N,l=new N,c=new N,h=new N,d=new N;if(t)for(let u=0,f=t.count;u<f;u+=3){let g=t.getX(u+0),y=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)xn.fromBufferAttribute(t,e),xn.normalize(),t.setXYZ(e,xn.x,xn.y,xn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,g=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let p=0;p<h;p++)u[g++]=c[f++]}return new ze(u,h,d)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=t(u,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone(e));let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},sm=new Je,Ws=new ir,ja=new nr,rm=new N,Qa=new N,tl=new N,el=new N,Ph=new N,nl=new N,om=new N,il=new N,Mn=class extends ti{constructor(t=new qe,e=new Al){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){nl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(Ph.fromBufferAttribute(d,t),o?nl.addScaledVector(Ph,h):nl.addScaledVector(Ph.sub(e),h))}e.add(nl)}return e}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ja.copy(n.boundingSphere),ja.applyMatrix4(r),Ws.copy(t.ray).recast(t.near),!(ja.containsPoint(Ws.origin)===!1&&(Ws.intersectSphere(ja,rm)===null||Ws.origin.distanceToSquared(rm)>(t.far-t.near)**2))&&(sm.copy(r).invert(),Ws.copy(t.ray).applyMatrix4(sm),!(n.boundingBox!==null&&Ws.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Ws)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=u.length;g<y;g++){let m=u[g],p=o[m.materialIndex],S=Math.max(m.start,f.start),w=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let x=S,D=w;x<D;x+=3){let C=a.getX(x),R=a.getX(x+1),U=a.getX(x+2);s=sl(this,p,t,n,c,h,d,C,R,U),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let S=a.getX(m),w=a.getX(m+1),x=a.getX(m+2);s=sl(this,o,t,n,c,h,d,S,w,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=u.length;g<y;g++){let m=u[g],p=o[m.materialIndex],S=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let x=S,D=w;x<D;x+=3){let C=x,R=x+1,U=x+2;s=sl(this,p,t,n,c,h,d,C,R,U),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let S=m,w=m+1,x=m+2;s=sl(this,o,t,n,c,h,d,S,w,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function t_(i,t,e,n,s,r,o,a){let l;if(t.side===Hn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Fi,a),l===null)return null;il.copy(a),il.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(il);return c<e.near||c>e.far?null:{distance:c,point:il.clone(),object:i}}function sl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Qa),i.getVertexPosition(l,tl),i.getVertexPosition(c,el);let h=t_(i,t,e,n,Qa,tl,el,om);if(h){let d=new N;Js.getBarycoord(om,Qa,tl,el,d),s&&(h.uv=Js.getInterpolatedAttribute(s,a,l,c,d,new _t)),r&&(h.uv1=Js.getInterpolatedAttribute(r,a,l,c,d,new _t)),o&&(h.normal=Js.getInterpolatedAttribute(o,a,l,c,d,new N),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new N,materialIndex:0};Js.getNormal(Qa,tl,el,u.normal),h.face=u,h.barycoord=d}return h}var sr=class i extends qe{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Xe(c,3)),this.setAttribute("normal",new Xe(h,3)),this.setAttribute("uv",new Xe(d,2));function g(y,m,p,S,w,x,D,C,R,U,E){let b=x/R,T=D/U,H=x/2,G=D/2,q=C/2,J=R+1,$=U+1,nt=0,Q=0,ht=new N;for(let ot=0;ot<$;ot++){let mt=ot*T-G;for(let ft=0;ft<J;ft++){let Wt=ft*b-H;ht[y]=Wt*S,ht[m]=mt*w,ht[p]=q,c.push(ht.x,ht.y,ht.z),ht[y]=0,ht[m]=0,ht[p]=C>0?1:-1,h.push(ht.x,ht.y,ht.z),d.push(ft/R),d.push(1-ot/U),nt+=1}}for(let ot=0;ot<U;ot++)for(let mt=0;mt<R;mt++){let ft=u+mt+J*ot,Wt=u+mt+J*(ot+1),K=u+(mt+1)+J*(ot+1),ct=u+(mt+1)+J*ot;l.push(ft,Wt,ct),l.push(Wt,K,ct),Q+=6}a.addGroup(f,Q,E),f+=Q,u+=nt}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function ho(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function Ln(i){let t={};for(let e=0;e<i.length;e++){let n=ho(i[e]);for(let s in n)t[s]=n[s]}return t}function e_(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function ag(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var n_={clone:ho,merge:Ln},i_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,s_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,_n=class extends Ts{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=i_,this.fragmentShader=s_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ho(t.uniforms),this.uniformsGroups=e_(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}},Rl=class extends ti{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Je,this.projectionMatrix=new Je,this.projectionMatrixInverse=new Je,this.coordinateSystem=ns}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},ws=new N,am=new _t,lm=new _t,Dn=class extends Rl{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ta*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan($o*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ta*2*Math.atan(Math.tan($o*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){ws.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ws.x,ws.y).multiplyScalar(-t/ws.z),ws.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ws.x,ws.y).multiplyScalar(-t/ws.z)}getViewSize(t,e){return this.getViewBounds(t,am,lm),e.subVectors(lm,am)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan($o*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},Jr=-90,Kr=1,Iu=class extends ti{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Dn(Jr,Kr,t,e);s.layers=this.layers,this.add(s);let r=new Dn(Jr,Kr,t,e);r.layers=this.layers,this.add(r);let o=new Dn(Jr,Kr,t,e);o.layers=this.layers,this.add(o);let a=new Dn(Jr,Kr,t,e);a.layers=this.layers,this.add(a);let l=new Dn(Jr,Kr,t,e);l.layers=this.layers,this.add(l);let c=new Dn(Jr,Kr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===ns)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===bl)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=y,t.setRenderTarget(n,5,s),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Pl=class extends Un{constructor(t,e,n,s,r,o,a,l,c,h){t=t!==void 0?t:[],e=e!==void 0?e:oo,super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Lu=class extends wi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Pl(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:Ni}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new sr(5,5,5),r=new _n({name:"CubemapFromEquirect",uniforms:ho(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Hn,blending:Es});r.uniforms.tEquirect.value=e;let o=new Mn(s,r),a=e.minFilter;return e.minFilter===Qs&&(e.minFilter=Ni),new Iu(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,n,s){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Ih=new N,r_=new N,o_=new ne,bi=class{constructor(t=new N(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Ih.subVectors(n,e).cross(r_.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let n=t.delta(Ih),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||o_.getNormalMatrix(t),s=this.coplanarPoint(Ih).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},Xs=new nr,rl=new N,Il=class{constructor(t=new bi,e=new bi,n=new bi,s=new bi,r=new bi,o=new bi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=ns){let n=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],h=s[5],d=s[6],u=s[7],f=s[8],g=s[9],y=s[10],m=s[11],p=s[12],S=s[13],w=s[14],x=s[15];if(n[0].setComponents(l-r,u-c,m-f,x-p).normalize(),n[1].setComponents(l+r,u+c,m+f,x+p).normalize(),n[2].setComponents(l+o,u+h,m+g,x+S).normalize(),n[3].setComponents(l-o,u-h,m-g,x-S).normalize(),n[4].setComponents(l-a,u-d,m-y,x-w).normalize(),e===ns)n[5].setComponents(l+a,u+d,m+y,x+w).normalize();else if(e===bl)n[5].setComponents(a,d,y,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Xs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Xs.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Xs)}intersectsSprite(t){return Xs.center.set(0,0,0),Xs.radius=.7071067811865476,Xs.applyMatrix4(t.matrixWorld),this.intersectsSphere(Xs)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(rl.x=s.normal.x>0?t.max.x:t.min.x,rl.y=s.normal.y>0?t.max.y:t.min.y,rl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(rl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};function lg(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function a_(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,g)=>f.start-g.start);let u=0;for(let f=1;f<d.length;f++){let g=d[u],y=d[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++u,d[u]=y)}d.length=u+1;for(let f=0,g=d.length;f<g;f++){let y=d[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Cs=class i extends qe{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,d=t/a,u=e/l,f=[],g=[],y=[],m=[];for(let p=0;p<h;p++){let S=p*u-o;for(let w=0;w<c;w++){let x=w*d-r;g.push(x,-S,0),y.push(0,0,1),m.push(w/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let S=0;S<a;S++){let w=S+c*p,x=S+c*(p+1),D=S+1+c*(p+1),C=S+1+c*p;f.push(w,x,C),f.push(x,D,C)}this.setIndex(f),this.setAttribute("position",new Xe(g,3)),this.setAttribute("normal",new Xe(y,3)),this.setAttribute("uv",new Xe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},l_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,c_=`#ifdef USE_ALPHAHASH
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
#endif`,h_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,u_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,d_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,f_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,p_=`#ifdef USE_AOMAP
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
#endif`,m_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,g_=`#ifdef USE_BATCHING
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
#endif`,v_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,y_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,x_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,__=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,b_=`#ifdef USE_IRIDESCENCE
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
#endif`,M_=`#ifdef USE_BUMPMAP
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
#endif`,w_=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,S_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,E_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,A_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,T_=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,C_=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,R_=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,P_=`#if defined( USE_COLOR_ALPHA )
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
#endif`,I_=`#define PI 3.141592653589793
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
} // validated`,L_=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,D_=`vec3 transformedNormal = objectNormal;
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
#endif`,U_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,N_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,F_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,O_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,k_="gl_FragColor = linearToOutputTexel( gl_FragColor );",B_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,z_=`#ifdef USE_ENVMAP
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
#endif`,V_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,H_=`#ifdef USE_ENVMAP
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
#endif`,G_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,W_=`#ifdef USE_ENVMAP
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
#endif`,X_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,q_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Y_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,$_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Z_=`#ifdef USE_GRADIENTMAP
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
}`,J_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,K_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,j_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Q_=`uniform bool receiveShadow;
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
#endif`,tb=`#ifdef USE_ENVMAP
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
#endif`,eb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,nb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ib=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,sb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,rb=`PhysicalMaterial material;
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
#endif`,ob=`struct PhysicalMaterial {
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
}`,ab=`
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
#endif`,lb=`#if defined( RE_IndirectDiffuse )
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
#endif`,cb=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,hb=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ub=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,db=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,fb=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,pb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,mb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,gb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,vb=`#if defined( USE_POINTS_UV )
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
#endif`,yb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,xb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,_b=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,bb=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Mb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,wb=`#ifdef USE_MORPHTARGETS
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
#endif`,Sb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Eb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Ab=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Tb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Cb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Rb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Pb=`#ifdef USE_NORMALMAP
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
#endif`,Ib=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Lb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Db=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Ub=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Nb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Fb=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Ob=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,kb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Bb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,zb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Vb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Hb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Gb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Wb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Xb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,qb=`float getShadowMask() {
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
}`,Yb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,$b=`#ifdef USE_SKINNING
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
#endif`,Zb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Jb=`#ifdef USE_SKINNING
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
#endif`,Kb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,jb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Qb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,tM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,eM=`#ifdef USE_TRANSMISSION
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
#endif`,nM=`#ifdef USE_TRANSMISSION
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
#endif`,iM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,rM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,oM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,aM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,lM=`uniform sampler2D t2D;
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
}`,cM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,hM=`#ifdef ENVMAP_TYPE_CUBE
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
}`,uM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,dM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fM=`#include <common>
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
}`,pM=`#if DEPTH_PACKING == 3200
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
}`,mM=`#define DISTANCE
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
}`,gM=`#define DISTANCE
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
}`,vM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,yM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xM=`uniform float scale;
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
}`,_M=`uniform vec3 diffuse;
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
}`,bM=`#include <common>
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
}`,MM=`uniform vec3 diffuse;
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
}`,wM=`#define LAMBERT
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
}`,SM=`#define LAMBERT
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
}`,EM=`#define MATCAP
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
}`,AM=`#define MATCAP
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
}`,TM=`#define NORMAL
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
}`,CM=`#define NORMAL
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
}`,RM=`#define PHONG
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
}`,PM=`#define PHONG
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
}`,IM=`#define STANDARD
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
}`,LM=`#define STANDARD
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
}`,DM=`#define TOON
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
}`,UM=`#define TOON
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
}`,NM=`uniform float size;
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
}`,FM=`uniform vec3 diffuse;
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
}`,OM=`#include <common>
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
}`,kM=`uniform vec3 color;
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
}`,BM=`uniform float rotation;
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
}`,zM=`uniform vec3 diffuse;
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
}`,se={alphahash_fragment:l_,alphahash_pars_fragment:c_,alphamap_fragment:h_,alphamap_pars_fragment:u_,alphatest_fragment:d_,alphatest_pars_fragment:f_,aomap_fragment:p_,aomap_pars_fragment:m_,batching_pars_vertex:g_,batching_vertex:v_,begin_vertex:y_,beginnormal_vertex:x_,bsdfs:__,iridescence_fragment:b_,bumpmap_pars_fragment:M_,clipping_planes_fragment:w_,clipping_planes_pars_fragment:S_,clipping_planes_pars_vertex:E_,clipping_planes_vertex:A_,color_fragment:T_,color_pars_fragment:C_,color_pars_vertex:R_,color_vertex:P_,common:I_,cube_uv_reflection_fragment:L_,defaultnormal_vertex:D_,displacementmap_pars_vertex:U_,displacementmap_vertex:N_,emissivemap_fragment:F_,emissivemap_pars_fragment:O_,colorspace_fragment:k_,colorspace_pars_fragment:B_,envmap_fragment:z_,envmap_common_pars_fragment:V_,envmap_pars_fragment:H_,envmap_pars_vertex:G_,envmap_physical_pars_fragment:tb,envmap_vertex:W_,fog_vertex:X_,fog_pars_vertex:q_,fog_fragment:Y_,fog_pars_fragment:$_,gradientmap_pars_fragment:Z_,lightmap_pars_fragment:J_,lights_lambert_fragment:K_,lights_lambert_pars_fragment:j_,lights_pars_begin:Q_,lights_toon_fragment:eb,lights_toon_pars_fragment:nb,lights_phong_fragment:ib,lights_phong_pars_fragment:sb,lights_physical_fragment:rb,lights_physical_pars_fragment:ob,lights_fragment_begin:ab,lights_fragment_maps:lb,lights_fragment_end:cb,logdepthbuf_fragment:hb,logdepthbuf_pars_fragment:ub,logdepthbuf_pars_vertex:db,logdepthbuf_vertex:fb,map_fragment:pb,map_pars_fragment:mb,map_particle_fragment:gb,map_particle_pars_fragment:vb,metalnessmap_fragment:yb,metalnessmap_pars_fragment:xb,morphinstance_vertex:_b,morphcolor_vertex:bb,morphnormal_vertex:Mb,morphtarget_pars_vertex:wb,morphtarget_vertex:Sb,normal_fragment_begin:Eb,normal_fragment_maps:Ab,normal_pars_fragment:Tb,normal_pars_vertex:Cb,normal_vertex:Rb,normalmap_pars_fragment:Pb,clearcoat_normal_fragment_begin:Ib,clearcoat_normal_fragment_maps:Lb,clearcoat_pars_fragment:Db,iridescence_pars_fragment:Ub,opaque_fragment:Nb,packing:Fb,premultiplied_alpha_fragment:Ob,project_vertex:kb,dithering_fragment:Bb,dithering_pars_fragment:zb,roughnessmap_fragment:Vb,roughnessmap_pars_fragment:Hb,shadowmap_pars_fragment:Gb,shadowmap_pars_vertex:Wb,shadowmap_vertex:Xb,shadowmask_pars_fragment:qb,skinbase_vertex:Yb,skinning_pars_vertex:$b,skinning_vertex:Zb,skinnormal_vertex:Jb,specularmap_fragment:Kb,specularmap_pars_fragment:jb,tonemapping_fragment:Qb,tonemapping_pars_fragment:tM,transmission_fragment:eM,transmission_pars_fragment:nM,uv_pars_fragment:iM,uv_pars_vertex:sM,uv_vertex:rM,worldpos_vertex:oM,background_vert:aM,background_frag:lM,backgroundCube_vert:cM,backgroundCube_frag:hM,cube_vert:uM,cube_frag:dM,depth_vert:fM,depth_frag:pM,distanceRGBA_vert:mM,distanceRGBA_frag:gM,equirect_vert:vM,equirect_frag:yM,linedashed_vert:xM,linedashed_frag:_M,meshbasic_vert:bM,meshbasic_frag:MM,meshlambert_vert:wM,meshlambert_frag:SM,meshmatcap_vert:EM,meshmatcap_frag:AM,meshnormal_vert:TM,meshnormal_frag:CM,meshphong_vert:RM,meshphong_frag:PM,meshphysical_vert:IM,meshphysical_frag:LM,meshtoon_vert:DM,meshtoon_frag:UM,points_vert:NM,points_frag:FM,shadow_vert:OM,shadow_frag:kM,sprite_vert:BM,sprite_frag:zM},xt={common:{diffuse:{value:new le(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ne}},envmap:{envMap:{value:null},envMapRotation:{value:new ne},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ne}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ne}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ne},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ne},normalScale:{value:new _t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ne},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ne}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ne}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ne}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new le(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new le(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0},uvTransform:{value:new ne}},sprite:{diffuse:{value:new le(16777215)},opacity:{value:1},center:{value:new _t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}}},Ui={basic:{uniforms:Ln([xt.common,xt.specularmap,xt.envmap,xt.aomap,xt.lightmap,xt.fog]),vertexShader:se.meshbasic_vert,fragmentShader:se.meshbasic_frag},lambert:{uniforms:Ln([xt.common,xt.specularmap,xt.envmap,xt.aomap,xt.lightmap,xt.emissivemap,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.fog,xt.lights,{emissive:{value:new le(0)}}]),vertexShader:se.meshlambert_vert,fragmentShader:se.meshlambert_frag},phong:{uniforms:Ln([xt.common,xt.specularmap,xt.envmap,xt.aomap,xt.lightmap,xt.emissivemap,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.fog,xt.lights,{emissive:{value:new le(0)},specular:{value:new le(1118481)},shininess:{value:30}}]),vertexShader:se.meshphong_vert,fragmentShader:se.meshphong_frag},standard:{uniforms:Ln([xt.common,xt.envmap,xt.aomap,xt.lightmap,xt.emissivemap,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.roughnessmap,xt.metalnessmap,xt.fog,xt.lights,{emissive:{value:new le(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:se.meshphysical_vert,fragmentShader:se.meshphysical_frag},toon:{uniforms:Ln([xt.common,xt.aomap,xt.lightmap,xt.emissivemap,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.gradientmap,xt.fog,xt.lights,{emissive:{value:new le(0)}}]),vertexShader:se.meshtoon_vert,fragmentShader:se.meshtoon_frag},matcap:{uniforms:Ln([xt.common,xt.bumpmap,xt.normalmap,xt.displacementmap,xt.fog,{matcap:{value:null}}]),vertexShader:se.meshmatcap_vert,fragmentShader:se.meshmatcap_frag},points:{uniforms:Ln([xt.points,xt.fog]),vertexShader:se.points_vert,fragmentShader:se.points_frag},dashed:{uniforms:Ln([xt.common,xt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:se.linedashed_vert,fragmentShader:se.linedashed_frag},depth:{uniforms:Ln([xt.common,xt.displacementmap]),vertexShader:se.depth_vert,fragmentShader:se.depth_frag},normal:{uniforms:Ln([xt.common,xt.bumpmap,xt.normalmap,xt.displacementmap,{opacity:{value:1}}]),vertexShader:se.meshnormal_vert,fragmentShader:se.meshnormal_frag},sprite:{uniforms:Ln([xt.sprite,xt.fog]),vertexShader:se.sprite_vert,fragmentShader:se.sprite_frag},background:{uniforms:{uvTransform:{value:new ne},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:se.background_vert,fragmentShader:se.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ne}},vertexShader:se.backgroundCube_vert,fragmentShader:se.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:se.cube_vert,fragmentShader:se.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:se.equirect_vert,fragmentShader:se.equirect_frag},distanceRGBA:{uniforms:Ln([xt.common,xt.displacementmap,{referencePosition:{value:new N},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:se.distanceRGBA_vert,fragmentShader:se.distanceRGBA_frag},shadow:{uniforms:Ln([xt.lights,xt.fog,{color:{value:new le(0)},opacity:{value:1}}]),vertexShader:se.shadow_vert,fragmentShader:se.shadow_frag}};Ui.physical={uniforms:Ln([Ui.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ne},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ne},clearcoatNormalScale:{value:new _t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ne},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ne},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ne},sheen:{value:0},sheenColor:{value:new le(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ne},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ne},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ne},transmissionSamplerSize:{value:new _t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ne},attenuationDistance:{value:0},attenuationColor:{value:new le(0)},specularColor:{value:new le(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ne},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ne},anisotropyVector:{value:new _t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ne}}]),vertexShader:se.meshphysical_vert,fragmentShader:se.meshphysical_frag};var ol={r:0,b:0,g:0},qs=new os,VM=new Je;function HM(i,t,e,n,s,r,o){let a=new le(0),l=r===!0?0:1,c,h,d=null,u=0,f=null;function g(S){let w=S.isScene===!0?S.background:null;return w&&w.isTexture&&(w=(S.backgroundBlurriness>0?e:t).get(w)),w}function y(S){let w=!1,x=g(S);x===null?p(a,l):x&&x.isColor&&(p(x,1),w=!0);let D=i.xr.getEnvironmentBlendMode();D==="additive"?n.buffers.color.setClear(0,0,0,1,o):D==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||w)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(S,w){let x=g(w);x&&(x.isCubeTexture||x.mapping===Jl)?(h===void 0&&(h=new Mn(new sr(1,1,1),new _n({name:"BackgroundCubeMaterial",uniforms:ho(Ui.backgroundCube.uniforms),vertexShader:Ui.backgroundCube.vertexShader,fragmentShader:Ui.backgroundCube.fragmentShader,side:Hn,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(D,C,R){this.matrixWorld.copyPosition(R.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),qs.copy(w.backgroundRotation),qs.x*=-1,qs.y*=-1,qs.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(qs.y*=-1,qs.z*=-1),h.material.uniforms.envMap.value=x,h.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(VM.makeRotationFromEuler(qs)),h.material.toneMapped=ve.getTransfer(x.colorSpace)!==Pe,(d!==x||u!==x.version||f!==i.toneMapping)&&(h.material.needsUpdate=!0,d=x,u=x.version,f=i.toneMapping),h.layers.enableAll(),S.unshift(h,h.geometry,h.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new Mn(new Cs(2,2),new _n({name:"BackgroundMaterial",uniforms:ho(Ui.background.uniforms),vertexShader:Ui.background.vertexShader,fragmentShader:Ui.background.fragmentShader,side:Fi,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.toneMapped=ve.getTransfer(x.colorSpace)!==Pe,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(d!==x||u!==x.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,d=x,u=x.version,f=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function p(S,w){S.getRGB(ol,ag(i)),n.buffers.color.setClear(ol.r,ol.g,ol.b,w,o)}return{getClearColor:function(){return a},setClearColor:function(S,w=1){a.set(S),l=w,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(S){l=S,p(a,l)},render:y,addToRenderList:m}}function GM(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(b,T,H,G,q){let J=!1,$=d(G,H,T);r!==$&&(r=$,c(r.object)),J=f(b,G,H,q),J&&g(b,G,H,q),q!==null&&t.update(q,i.ELEMENT_ARRAY_BUFFER),(J||o)&&(o=!1,x(b,T,H,G),q!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(q).buffer))}function l(){return i.createVertexArray()}function c(b){return i.bindVertexArray(b)}function h(b){return i.deleteVertexArray(b)}function d(b,T,H){let G=H.wireframe===!0,q=n[b.id];q===void 0&&(q={},n[b.id]=q);let J=q[T.id];J===void 0&&(J={},q[T.id]=J);let $=J[G];return $===void 0&&($=u(l()),J[G]=$),$}function u(b){let T=[],H=[],G=[];for(let q=0;q<e;q++)T[q]=0,H[q]=0,G[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:T,enabledAttributes:H,attributeDivisors:G,object:b,attributes:{},index:null}}function f(b,T,H,G){let q=r.attributes,J=T.attributes,$=0,nt=H.getAttributes();for(let Q in nt)if(nt[Q].location>=0){let ot=q[Q],mt=J[Q];if(mt===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(mt=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(mt=b.instanceColor)),ot===void 0||ot.attribute!==mt||mt&&ot.data!==mt.data)return!0;$++}return r.attributesNum!==$||r.index!==G}function g(b,T,H,G){let q={},J=T.attributes,$=0,nt=H.getAttributes();for(let Q in nt)if(nt[Q].location>=0){let ot=J[Q];ot===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(ot=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(ot=b.instanceColor));let mt={};mt.attribute=ot,ot&&ot.data&&(mt.data=ot.data),q[Q]=mt,$++}r.attributes=q,r.attributesNum=$,r.index=G}function y(){let b=r.newAttributes;for(let T=0,H=b.length;T<H;T++)b[T]=0}function m(b){p(b,0)}function p(b,T){let H=r.newAttributes,G=r.enabledAttributes,q=r.attributeDivisors;H[b]=1,G[b]===0&&(i.enableVertexAttribArray(b),G[b]=1),q[b]!==T&&(i.vertexAttribDivisor(b,T),q[b]=T)}function S(){let b=r.newAttributes,T=r.enabledAttributes;for(let H=0,G=T.length;H<G;H++)T[H]!==b[H]&&(i.disableVertexAttribArray(H),T[H]=0)}function w(b,T,H,G,q,J,$){$===!0?i.vertexAttribIPointer(b,T,H,q,J):i.vertexAttribPointer(b,T,H,G,q,J)}function x(b,T,H,G){y();let q=G.attributes,J=H.getAttributes(),$=T.defaultAttributeValues;for(let nt in J){let Q=J[nt];if(Q.location>=0){let ht=q[nt];if(ht===void 0&&(nt==="instanceMatrix"&&b.instanceMatrix&&(ht=b.instanceMatrix),nt==="instanceColor"&&b.instanceColor&&(ht=b.instanceColor)),ht!==void 0){let ot=ht.normalized,mt=ht.itemSize,ft=t.get(ht);if(ft===void 0)continue;let Wt=ft.buffer,K=ft.type,ct=ft.bytesPerElement,Lt=K===i.INT||K===i.UNSIGNED_INT||ht.gpuType===pd;if(ht.isInterleavedBufferAttribute){let ut=ht.data,Ut=ut.stride,Gt=ht.offset;if(ut.isInstancedInterleavedBuffer){for(let Vt=0;Vt<Q.locationSize;Vt++)p(Q.location+Vt,ut.meshPerAttribute);b.isInstancedMesh!==!0&&G._maxInstanceCount===void 0&&(G._maxInstanceCount=ut.meshPerAttribute*ut.count)}else for(let Vt=0;Vt<Q.locationSize;Vt++)m(Q.location+Vt);i.bindBuffer(i.ARRAY_BUFFER,Wt);for(let Vt=0;Vt<Q.locationSize;Vt++)w(Q.location+Vt,mt/Q.locationSize,K,ot,Ut*ct,(Gt+mt/Q.locationSize*Vt)*ct,Lt)}else{if(ht.isInstancedBufferAttribute){for(let ut=0;ut<Q.locationSize;ut++)p(Q.location+ut,ht.meshPerAttribute);b.isInstancedMesh!==!0&&G._maxInstanceCount===void 0&&(G._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let ut=0;ut<Q.locationSize;ut++)m(Q.location+ut);i.bindBuffer(i.ARRAY_BUFFER,Wt);for(let ut=0;ut<Q.locationSize;ut++)w(Q.location+ut,mt/Q.locationSize,K,ot,mt*ct,mt/Q.locationSize*ut*ct,Lt)}}else if($!==void 0){let ot=$[nt];if(ot!==void 0)switch(ot.length){case 2:i.vertexAttrib2fv(Q.location,ot);break;case 3:i.vertexAttrib3fv(Q.location,ot);break;case 4:i.vertexAttrib4fv(Q.location,ot);break;default:i.vertexAttrib1fv(Q.location,ot)}}}}S()}function D(){U();for(let b in n){let T=n[b];for(let H in T){let G=T[H];for(let q in G)h(G[q].object),delete G[q];delete T[H]}delete n[b]}}function C(b){if(n[b.id]===void 0)return;let T=n[b.id];for(let H in T){let G=T[H];for(let q in G)h(G[q].object),delete G[q];delete T[H]}delete n[b.id]}function R(b){for(let T in n){let H=n[T];if(H[b.id]===void 0)continue;let G=H[b.id];for(let q in G)h(G[q].object),delete G[q];delete H[b.id]}}function U(){E(),o=!0,r!==s&&(r=s,c(r.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:E,dispose:D,releaseStatesOfGeometry:C,releaseStatesOfProgram:R,initAttributes:y,enableAttribute:m,disableUnusedAttributes:S}}function WM(i,t,e){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),e.update(h,n,1)}function o(c,h,d){d!==0&&(i.drawArraysInstanced(n,c,h,d),e.update(h,n,d))}function a(c,h,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,d);let f=0;for(let g=0;g<d;g++)f+=h[g];e.update(f,n,1)}function l(c,h,d,u){if(d===0)return;let f=t.get("WEBGL_multi_draw");if(f===null)for(let g=0;g<c.length;g++)o(c[g],h[g],u[g]);else{f.multiDrawArraysInstancedWEBGL(n,c,0,h,0,u,0,d);let g=0;for(let y=0;y<d;y++)g+=h[y]*u[y];e.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function XM(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let R=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(R.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(R){return!(R!==jn&&n.convert(R)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(R){let U=R===sa&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(R!==ss&&n.convert(R)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&R!==Mi&&!U)}function l(R){if(R==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";R="mediump"}return R==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.logarithmicDepthBuffer===!0,u=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),S=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),w=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),D=g>0,C=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reverseDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:S,maxVaryings:w,maxFragmentUniforms:x,vertexTextures:D,maxSamples:C}}function qM(i){let t=this,e=null,n=0,s=!1,r=!1,o=new bi,a=new ne,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let g=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,p=i.get(d);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let S=r?0:n,w=S*4,x=p.clippingState||null;l.value=x,x=h(g,u,w,f);for(let D=0;D!==w;++D)x[D]=e[D];p.clippingState=x,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=S}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(d,u,f,g){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let p=f+y*4,S=u.matrixWorldInverse;a.getNormalMatrix(S),(m===null||m.length<p)&&(m=new Float32Array(p));for(let w=0,x=f;w!==y;++w,x+=4)o.copy(d[w]).applyMatrix4(S,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}function YM(i){let t=new WeakMap;function e(o,a){return a===Kh?o.mapping=oo:a===jh&&(o.mapping=ao),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Kh||a===jh)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new Lu(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}var Du=class extends Rl{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},to=4,cm=[.125,.215,.35,.446,.526,.582],Ks=20,Lh=new Du,hm=new le,Dh=null,Uh=0,Nh=0,Fh=!1,$s=(1+Math.sqrt(5))/2,jr=1/$s,um=[new N(-$s,jr,0),new N($s,jr,0),new N(-jr,0,$s),new N(jr,0,$s),new N(0,$s,-jr),new N(0,$s,jr),new N(-1,1,-1),new N(1,1,-1),new N(-1,1,1),new N(1,1,1)],Ll=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100){Dh=this._renderer.getRenderTarget(),Uh=this._renderer.getActiveCubeFace(),Nh=this._renderer.getActiveMipmapLevel(),Fh=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);let r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,n,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=pm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=fm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Dh,Uh,Nh),this._renderer.xr.enabled=Fh,t.scissorTest=!1,al(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===oo||t.mapping===ao?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Dh=this._renderer.getRenderTarget(),Uh=this._renderer.getActiveCubeFace(),Nh=this._renderer.getActiveMipmapLevel(),Fh=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:Ni,minFilter:Ni,generateMipmaps:!1,type:sa,format:jn,colorSpace:mo,depthBuffer:!1},s=dm(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=dm(t,e,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=$M(r)),this._blurMaterial=ZM(r,t,e)}return s}_compileMaterial(t){let e=new Mn(this._lodPlanes[0],t);this._renderer.compile(e,Lh)}_sceneToCubeUV(t,e,n,s){let a=new Dn(90,1,e,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,d=h.autoClear,u=h.toneMapping;h.getClearColor(hm),h.toneMapping=As,h.autoClear=!1;let f=new Al({name:"PMREM.Background",side:Hn,depthWrite:!1,depthTest:!1}),g=new Mn(new sr,f),y=!1,m=t.background;m?m.isColor&&(f.color.copy(m),t.background=null,y=!0):(f.color.copy(hm),y=!0);for(let p=0;p<6;p++){let S=p%3;S===0?(a.up.set(0,l[p],0),a.lookAt(c[p],0,0)):S===1?(a.up.set(0,0,l[p]),a.lookAt(0,c[p],0)):(a.up.set(0,l[p],0),a.lookAt(0,0,c[p]));let w=this._cubeSize;al(s,S*w,p>2?w:0,w,w),h.setRenderTarget(s),y&&h.render(g,a),h.render(t,a)}g.geometry.dispose(),g.material.dispose(),h.toneMapping=u,h.autoClear=d,t.background=m}_textureToCubeUV(t,e){let n=this._renderer,s=t.mapping===oo||t.mapping===ao;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=pm()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=fm());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Mn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;al(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,Lh)}_applyPMREM(t){let e=this._renderer,n=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=um[(s-r-1)%um.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,d=new Mn(this._lodPlanes[s],c),u=c.uniforms,f=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*Ks-1),y=r/g,m=isFinite(r)?1+Math.floor(h*y):Ks;m>Ks&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Ks}`);let p=[],S=0;for(let R=0;R<Ks;++R){let U=R/y,E=Math.exp(-U*U/2);p.push(E),R===0?S+=E:R<m&&(S+=2*E)}for(let R=0;R<p.length;R++)p[R]=p[R]/S;u.envMap.value=t.texture,u.samples.value=m,u.weights.value=p,u.latitudinal.value=o==="latitudinal",a&&(u.poleAxis.value=a);let{_lodMax:w}=this;u.dTheta.value=g,u.mipInt.value=w-n;let x=this._sizeLods[s],D=3*x*(s>w-to?s-w+to:0),C=4*(this._cubeSize-x);al(e,D,C,3*x,2*x),l.setRenderTarget(e),l.render(d,Lh)}};function $M(i){let t=[],e=[],n=[],s=i,r=i-to+1+cm.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>i-to?l=cm[o-i+to-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),h=-c,d=1+c,u=[h,h,d,h,d,d,h,h,d,d,h,d],f=6,g=6,y=3,m=2,p=1,S=new Float32Array(y*g*f),w=new Float32Array(m*g*f),x=new Float32Array(p*g*f);for(let C=0;C<f;C++){let R=C%3*2/3-1,U=C>2?0:-1,E=[R,U,0,R+2/3,U,0,R+2/3,U+1,0,R,U,0,R+2/3,U+1,0,R,U+1,0];S.set(E,y*g*C),w.set(u,m*g*C);let b=[C,C,C,C,C,C];x.set(b,p*g*C)}let D=new qe;D.setAttribute("position",new ze(S,y)),D.setAttribute("uv",new ze(w,m)),D.setAttribute("faceIndex",new ze(x,p)),t.push(D),s>to&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function dm(i,t,e){let n=new wi(i,t,e);return n.texture.mapping=Jl,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function al(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function ZM(i,t,e){let n=new Float32Array(Ks),s=new N(0,1,0);return new _n({name:"SphericalGaussianBlur",defines:{n:Ks,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:bd(),fragmentShader:`

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
		`,blending:Es,depthTest:!1,depthWrite:!1})}function fm(){return new _n({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:bd(),fragmentShader:`

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
		`,blending:Es,depthTest:!1,depthWrite:!1})}function pm(){return new _n({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:bd(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Es,depthTest:!1,depthWrite:!1})}function bd(){return`

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
	`}function JM(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Kh||l===jh,h=l===oo||l===ao;if(c||h){let d=t.get(a),u=d!==void 0?d.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==u)return e===null&&(e=new Ll(i)),d=c?e.fromEquirectangular(a,d):e.fromCubemap(a,d),d.texture.pmremVersion=a.pmremVersion,t.set(a,d),d.texture;if(d!==void 0)return d.texture;{let f=a.image;return c&&f&&f.height>0||h&&f&&s(f)?(e===null&&(e=new Ll(i)),d=c?e.fromEquirectangular(a):e.fromCubemap(a),d.texture.pmremVersion=a.pmremVersion,t.set(a,d),a.addEventListener("dispose",r),d.texture):null}}}return a}function s(a){let l=0,c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function KM(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&qo("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function jM(i,t,e,n){let s={},r=new WeakMap;function o(d){let u=d.target;u.index!==null&&t.remove(u.index);for(let g in u.attributes)t.remove(u.attributes[g]);for(let g in u.morphAttributes){let y=u.morphAttributes[g];for(let m=0,p=y.length;m<p;m++)t.remove(y[m])}u.removeEventListener("dispose",o),delete s[u.id];let f=r.get(u);f&&(t.remove(f),r.delete(u)),n.releaseStatesOfGeometry(u),u.isInstancedBufferGeometry===!0&&delete u._maxInstanceCount,e.memory.geometries--}function a(d,u){return s[u.id]===!0||(u.addEventListener("dispose",o),s[u.id]=!0,e.memory.geometries++),u}function l(d){let u=d.attributes;for(let g in u)t.update(u[g],i.ARRAY_BUFFER);let f=d.morphAttributes;for(let g in f){let y=f[g];for(let m=0,p=y.length;m<p;m++)t.update(y[m],i.ARRAY_BUFFER)}}function c(d){let u=[],f=d.index,g=d.attributes.position,y=0;if(f!==null){let S=f.array;y=f.version;for(let w=0,x=S.length;w<x;w+=3){let D=S[w+0],C=S[w+1],R=S[w+2];u.push(D,C,C,R,R,D)}}else if(g!==void 0){let S=g.array;y=g.version;for(let w=0,x=S.length/3-1;w<x;w+=3){let D=w+0,C=w+1,R=w+2;u.push(D,C,C,R,R,D)}}else return;let m=new(rg(u)?Cl:Tl)(u,1);m.version=y;let p=r.get(d);p&&t.remove(p),r.set(d,m)}function h(d){let u=r.get(d);if(u){let f=d.index;f!==null&&u.version<f.version&&c(d)}else c(d);return r.get(d)}return{get:a,update:l,getWireframeAttribute:h}}function QM(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),e.update(f,n,1)}function c(u,f,g){g!==0&&(i.drawElementsInstanced(n,f,r,u*o,g),e.update(f,n,g))}function h(u,f,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,g);let m=0;for(let p=0;p<g;p++)m+=f[p];e.update(m,n,1)}function d(u,f,g,y){if(g===0)return;let m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<u.length;p++)c(u[p]/o,f[p],y[p]);else{m.multiDrawElementsInstancedWEBGL(n,f,0,r,u,0,y,0,g);let p=0;for(let S=0;S<g;S++)p+=f[S]*y[S];e.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=d}function tw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function ew(i,t,e){let n=new WeakMap,s=new We;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let E=function(){R.dispose(),n.delete(a),a.removeEventListener("dispose",E)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],S=a.morphAttributes.color||[],w=0;f===!0&&(w=1),g===!0&&(w=2),y===!0&&(w=3);let x=a.attributes.position.count*w,D=1;x>t.maxTextureSize&&(D=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);let C=new Float32Array(x*D*4*d),R=new Sl(C,x,D,d);R.type=Mi,R.needsUpdate=!0;let U=w*4;for(let b=0;b<d;b++){let T=m[b],H=p[b],G=S[b],q=x*D*4*b;for(let J=0;J<T.count;J++){let $=J*U;f===!0&&(s.fromBufferAttribute(T,J),C[q+$+0]=s.x,C[q+$+1]=s.y,C[q+$+2]=s.z,C[q+$+3]=0),g===!0&&(s.fromBufferAttribute(H,J),C[q+$+4]=s.x,C[q+$+5]=s.y,C[q+$+6]=s.z,C[q+$+7]=0),y===!0&&(s.fromBufferAttribute(G,J),C[q+$+8]=s.x,C[q+$+9]=s.y,C[q+$+10]=s.z,C[q+$+11]=G.itemSize===4?s.w:1)}}u={count:d,texture:R,size:new _t(x,D)},n.set(a,u),a.addEventListener("dispose",E)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function nw(i,t,e,n){let s=new WeakMap;function r(l){let c=n.render.frame,h=l.geometry,d=t.get(l,h);if(s.get(d)!==c&&(t.update(d),s.set(d,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let u=l.skeleton;s.get(u)!==c&&(u.update(),s.set(u,c))}return d}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var Dl=class extends Un{constructor(t,e,n,s,r,o,a,l,c,h=no){if(h!==no&&h!==co)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===no&&(n=tr),n===void 0&&h===co&&(n=lo),super(null,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:Qn,this.minFilter=l!==void 0?l:Qn,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},cg=new Un,mm=new Dl(1,1),hg=new Sl,ug=new Pu,dg=new Pl,gm=[],vm=[],ym=new Float32Array(16),xm=new Float32Array(9),_m=new Float32Array(4);function vo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=gm[s];if(r===void 0&&(r=new Float32Array(s),gm[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function un(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function dn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function jl(i,t){let e=vm[t];e===void 0&&(e=new Int32Array(t),vm[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function iw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function sw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(un(e,t))return;i.uniform2fv(this.addr,t),dn(e,t)}}function rw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(un(e,t))return;i.uniform3fv(this.addr,t),dn(e,t)}}function ow(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(un(e,t))return;i.uniform4fv(this.addr,t),dn(e,t)}}function aw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(un(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),dn(e,t)}else{if(un(e,n))return;_m.set(n),i.uniformMatrix2fv(this.addr,!1,_m),dn(e,n)}}function lw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(un(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),dn(e,t)}else{if(un(e,n))return;xm.set(n),i.uniformMatrix3fv(this.addr,!1,xm),dn(e,n)}}function cw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(un(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),dn(e,t)}else{if(un(e,n))return;ym.set(n),i.uniformMatrix4fv(this.addr,!1,ym),dn(e,n)}}function hw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function uw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(un(e,t))return;i.uniform2iv(this.addr,t),dn(e,t)}}function dw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(un(e,t))return;i.uniform3iv(this.addr,t),dn(e,t)}}function fw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(un(e,t))return;i.uniform4iv(this.addr,t),dn(e,t)}}function pw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function mw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(un(e,t))return;i.uniform2uiv(this.addr,t),dn(e,t)}}function gw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(un(e,t))return;i.uniform3uiv(this.addr,t),dn(e,t)}}function vw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(un(e,t))return;i.uniform4uiv(this.addr,t),dn(e,t)}}function yw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(mm.compareFunction=ng,r=mm):r=cg,e.setTexture2D(t||r,s)}function xw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||ug,s)}function _w(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||dg,s)}function bw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||hg,s)}function Mw(i){switch(i){case 5126:return iw;case 35664:return sw;case 35665:return rw;case 35666:return ow;case 35674:return aw;case 35675:return lw;case 35676:return cw;case 5124:case 35670:return hw;case 35667:case 35671:return uw;case 35668:case 35672:return dw;case 35669:case 35673:return fw;case 5125:return pw;case 36294:return mw;case 36295:return gw;case 36296:return vw;case 35678:case 36198:case 36298:case 36306:case 35682:return yw;case 35679:case 36299:case 36307:return xw;case 35680:case 36300:case 36308:case 36293:return _w;case 36289:case 36303:case 36311:case 36292:return bw}}function ww(i,t){i.uniform1fv(this.addr,t)}function Sw(i,t){let e=vo(t,this.size,2);i.uniform2fv(this.addr,e)}function Ew(i,t){let e=vo(t,this.size,3);i.uniform3fv(this.addr,e)}function Aw(i,t){let e=vo(t,this.size,4);i.uniform4fv(this.addr,e)}function Tw(i,t){let e=vo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Cw(i,t){let e=vo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Rw(i,t){let e=vo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Pw(i,t){i.uniform1iv(this.addr,t)}function Iw(i,t){i.uniform2iv(this.addr,t)}function Lw(i,t){i.uniform3iv(this.addr,t)}function Dw(i,t){i.uniform4iv(this.addr,t)}function Uw(i,t){i.uniform1uiv(this.addr,t)}function Nw(i,t){i.uniform2uiv(this.addr,t)}function Fw(i,t){i.uniform3uiv(this.addr,t)}function Ow(i,t){i.uniform4uiv(this.addr,t)}function kw(i,t,e){let n=this.cache,s=t.length,r=jl(e,s);un(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||cg,r[o])}function Bw(i,t,e){let n=this.cache,s=t.length,r=jl(e,s);un(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||ug,r[o])}function zw(i,t,e){let n=this.cache,s=t.length,r=jl(e,s);un(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||dg,r[o])}function Vw(i,t,e){let n=this.cache,s=t.length,r=jl(e,s);un(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||hg,r[o])}function Hw(i){switch(i){case 5126:return ww;case 35664:return Sw;case 35665:return Ew;case 35666:return Aw;case 35674:return Tw;case 35675:return Cw;case 35676:return Rw;case 5124:case 35670:return Pw;case 35667:case 35671:return Iw;case 35668:case 35672:return Lw;case 35669:case 35673:return Dw;case 5125:return Uw;case 36294:return Nw;case 36295:return Fw;case 36296:return Ow;case 35678:case 36198:case 36298:case 36306:case 35682:return kw;case 35679:case 36299:case 36307:return Bw;case 35680:case 36300:case 36308:case 36293:return zw;case 36289:case 36303:case 36311:case 36292:return Vw}}var Uu=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Mw(e.type)}},Nu=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Hw(e.type)}},Fu=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Oh=/(\w+)(\])?(\[|\.)?/g;function bm(i,t){i.seq.push(t),i.map[t.id]=t}function Gw(i,t,e){let n=i.name,s=n.length;for(Oh.lastIndex=0;;){let r=Oh.exec(n),o=Oh.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){bm(e,c===void 0?new Uu(a,i,t):new Nu(a,i,t));break}else{let d=e.map[a];d===void 0&&(d=new Fu(a),bm(e,d)),e=d}}}var so=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);Gw(r,o,this)}}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Mm(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Ww=37297,Xw=0;function qw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var wm=new ne;function Yw(i){ve._getMatrix(wm,ve.workingColorSpace,i);let t=`mat3( ${wm.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(i)){case Kl:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Sm(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),s=i.getShaderInfoLog(t).trim();if(n&&s==="")return"";let r=/ERROR: 0:(\d+)/.exec(s);if(r){let o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+qw(i.getShaderSource(t),o)}else return s}function $w(i,t){let e=Yw(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function Zw(i,t){let e;switch(t){case sx:e="Linear";break;case rx:e="Reinhard";break;case ox:e="Cineon";break;case ax:e="ACESFilmic";break;case cx:e="AgX";break;case hx:e="Neutral";break;case lx:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ll=new N;function Jw(){ve.getLuminanceCoefficients(ll);let i=ll.x.toFixed(4),t=ll.y.toFixed(4),e=ll.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Kw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Yo).join(`
`)}function jw(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Qw(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Yo(i){return i!==""}function Em(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function Am(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var tS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ou(i){return i.replace(tS,nS)}var eS=new Map;function nS(i,t){let e=se[t];if(e===void 0){let n=eS.get(t);if(n!==void 0)e=se[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return Ou(e)}var iS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Tm(i){return i.replace(iS,sS)}function sS(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Cm(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}function rS(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Vm?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===Oy?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===es&&(t="SHADOWMAP_TYPE_VSM"),t}function oS(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case oo:case ao:t="ENVMAP_TYPE_CUBE";break;case Jl:t="ENVMAP_TYPE_CUBE_UV";break}return t}function aS(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case ao:t="ENVMAP_MODE_REFRACTION";break}return t}function lS(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Hm:t="ENVMAP_BLENDING_MULTIPLY";break;case nx:t="ENVMAP_BLENDING_MIX";break;case ix:t="ENVMAP_BLENDING_ADD";break}return t}function cS(i){let t=i.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),7*16)),texelHeight:n,maxMip:e}}function hS(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=rS(e),c=oS(e),h=aS(e),d=lS(e),u=cS(e),f=Kw(e),g=jw(r),y=s.createProgram(),m,p,S=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Yo).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Yo).join(`
`),p.length>0&&(p+=`
`)):(m=[Cm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Yo).join(`
`),p=[Cm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",u?"#define CUBEUV_TEXEL_WIDTH "+u.texelWidth:"",u?"#define CUBEUV_TEXEL_HEIGHT "+u.texelHeight:"",u?"#define CUBEUV_MAX_MIP "+u.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==As?"#define TONE_MAPPING":"",e.toneMapping!==As?se.tonemapping_pars_fragment:"",e.toneMapping!==As?Zw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",se.colorspace_pars_fragment,$w("linearToOutputTexel",e.outputColorSpace),Jw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Yo).join(`
`)),o=Ou(o),o=Em(o,e),o=Am(o,e),a=Ou(a),a=Em(a,e),a=Am(a,e),o=Tm(o),a=Tm(a),e.isRawShaderMaterial!==!0&&(S=`#version 300 es
`,m=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===Oi?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Oi?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let w=S+m+o,x=S+p+a,D=Mm(s,s.VERTEX_SHADER,w),C=Mm(s,s.FRAGMENT_SHADER,x);s.attachShader(y,D),s.attachShader(y,C),e.index0AttributeName!==void 0?s.bindAttribLocation(y,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(y,0,"position"),s.linkProgram(y);function R(T){if(i.debug.checkShaderErrors){let H=s.getProgramInfoLog(y).trim(),G=s.getShaderInfoLog(D).trim(),q=s.getShaderInfoLog(C).trim(),J=!0,$=!0;if(s.getProgramParameter(y,s.LINK_STATUS)===!1)if(J=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,y,D,C);else{let nt=Sm(s,D,"vertex"),Q=Sm(s,C,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(y,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+H+`
`+nt+`
`+Q)}else H!==""?console.warn("THREE.WebGLProgram: Program Info Log:",H):(G===""||q==="")&&($=!1);$&&(T.diagnostics={runnable:J,programLog:H,vertexShader:{log:G,prefix:m},fragmentShader:{log:q,prefix:p}})}s.deleteShader(D),s.deleteShader(C),U=new so(s,y),E=Qw(s,y)}let U;this.getUniforms=function(){return U===void 0&&R(this),U};let E;this.getAttributes=function(){return E===void 0&&R(this),E};let b=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(y,Ww)),b},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(y),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Xw++,this.cacheKey=t,this.usedTimes=1,this.program=y,this.vertexShader=D,this.fragmentShader=C,this}var uS=0,ku=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Bu(t),e.set(t,n)),n}},Bu=class{constructor(t){this.id=uS++,this.code=t,this.usedTimes=0}};function dS(i,t,e,n,s,r,o){let a=new El,l=new ku,c=new Set,h=[],d=s.logarithmicDepthBuffer,u=s.vertexTextures,f=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function y(E){return c.add(E),E===0?"uv":`uv${E}`}function m(E,b,T,H,G){let q=H.fog,J=G.geometry,$=E.isMeshStandardMaterial?H.environment:null,nt=(E.isMeshStandardMaterial?e:t).get(E.envMap||$),Q=nt&&nt.mapping===Jl?nt.image.height:null,ht=g[E.type];E.precision!==null&&(f=s.getMaxPrecision(E.precision),f!==E.precision&&console.warn("THREE.WebGLProgram.getParameters:",E.precision,"not supported, using",f,"instead."));let ot=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,mt=ot!==void 0?ot.length:0,ft=0;J.morphAttributes.position!==void 0&&(ft=1),J.morphAttributes.normal!==void 0&&(ft=2),J.morphAttributes.color!==void 0&&(ft=3);let Wt,K,ct,Lt;if(ht){let oe=Ui[ht];Wt=oe.vertexShader,K=oe.fragmentShader}else Wt=E.vertexShader,K=E.fragmentShader,l.update(E),ct=l.getVertexShaderID(E),Lt=l.getFragmentShaderID(E);let ut=i.getRenderTarget(),Ut=i.state.buffers.depth.getReversed(),Gt=G.isInstancedMesh===!0,Vt=G.isBatchedMesh===!0,re=!!E.map,te=!!E.matcap,Ee=!!nt,W=!!E.aoMap,rn=!!E.lightMap,ie=!!E.bumpMap,Jt=!!E.normalMap,Nt=!!E.displacementMap,be=!!E.emissiveMap,kt=!!E.metalnessMap,P=!!E.roughnessMap,_=E.anisotropy>0,z=E.clearcoat>0,it=E.dispersion>0,j=E.iridescence>0,et=E.sheen>0,It=E.transmission>0,gt=_&&!!E.anisotropyMap,bt=z&&!!E.clearcoatMap,qt=z&&!!E.clearcoatNormalMap,at=z&&!!E.clearcoatRoughnessMap,vt=j&&!!E.iridescenceMap,Bt=j&&!!E.iridescenceThicknessMap,Ht=et&&!!E.sheenColorMap,wt=et&&!!E.sheenRoughnessMap,ee=!!E.specularMap,Yt=!!E.specularColorMap,xe=!!E.specularIntensityMap,O=It&&!!E.transmissionMap,yt=It&&!!E.thicknessMap,tt=!!E.gradientMap,rt=!!E.alphaMap,Et=E.alphaTest>0,St=!!E.alphaHash,Kt=!!E.extensions,Ve=As;E.toneMapped&&(ut===null||ut.isXRRenderTarget===!0)&&(Ve=i.toneMapping);let Ct={shaderID:ht,shaderType:E.type,shaderName:E.name,vertexShader:Wt,fragmentShader:K,defines:E.defines,customVertexShaderID:ct,customFragmentShaderID:Lt,isRawShaderMaterial:E.isRawShaderMaterial===!0,glslVersion:E.glslVersion,precision:f,batching:Vt,batchingColor:Vt&&G._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&G.instanceColor!==null,instancingMorph:Gt&&G.morphTexture!==null,supportsVertexTextures:u,outputColorSpace:ut===null?i.outputColorSpace:ut.isXRRenderTarget===!0?ut.texture.colorSpace:mo,alphaToCoverage:!!E.alphaToCoverage,map:re,matcap:te,envMap:Ee,envMapMode:Ee&&nt.mapping,envMapCubeUVHeight:Q,aoMap:W,lightMap:rn,bumpMap:ie,normalMap:Jt,displacementMap:u&&Nt,emissiveMap:be,normalMapObjectSpace:Jt&&E.normalMapType===mx,normalMapTangentSpace:Jt&&E.normalMapType===px,metalnessMap:kt,roughnessMap:P,anisotropy:_,anisotropyMap:gt,clearcoat:z,clearcoatMap:bt,clearcoatNormalMap:qt,clearcoatRoughnessMap:at,dispersion:it,iridescence:j,iridescenceMap:vt,iridescenceThicknessMap:Bt,sheen:et,sheenColorMap:Ht,sheenRoughnessMap:wt,specularMap:ee,specularColorMap:Yt,specularIntensityMap:xe,transmission:It,transmissionMap:O,thicknessMap:yt,gradientMap:tt,opaque:E.transparent===!1&&E.blending===eo&&E.alphaToCoverage===!1,alphaMap:rt,alphaTest:Et,alphaHash:St,combine:E.combine,mapUv:re&&y(E.map.channel),aoMapUv:W&&y(E.aoMap.channel),lightMapUv:rn&&y(E.lightMap.channel),bumpMapUv:ie&&y(E.bumpMap.channel),normalMapUv:Jt&&y(E.normalMap.channel),displacementMapUv:Nt&&y(E.displacementMap.channel),emissiveMapUv:be&&y(E.emissiveMap.channel),metalnessMapUv:kt&&y(E.metalnessMap.channel),roughnessMapUv:P&&y(E.roughnessMap.channel),anisotropyMapUv:gt&&y(E.anisotropyMap.channel),clearcoatMapUv:bt&&y(E.clearcoatMap.channel),clearcoatNormalMapUv:qt&&y(E.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:at&&y(E.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&y(E.iridescenceMap.channel),iridescenceThicknessMapUv:Bt&&y(E.iridescenceThicknessMap.channel),sheenColorMapUv:Ht&&y(E.sheenColorMap.channel),sheenRoughnessMapUv:wt&&y(E.sheenRoughnessMap.channel),specularMapUv:ee&&y(E.specularMap.channel),specularColorMapUv:Yt&&y(E.specularColorMap.channel),specularIntensityMapUv:xe&&y(E.specularIntensityMap.channel),transmissionMapUv:O&&y(E.transmissionMap.channel),thicknessMapUv:yt&&y(E.thicknessMap.channel),alphaMapUv:rt&&y(E.alphaMap.channel),vertexTangents:!!J.attributes.tangent&&(Jt||_),vertexColors:E.vertexColors,vertexAlphas:E.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,pointsUvs:G.isPoints===!0&&!!J.attributes.uv&&(re||rt),fog:!!q,useFog:E.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:E.flatShading===!0,sizeAttenuation:E.sizeAttenuation===!0,logarithmicDepthBuffer:d,reverseDepthBuffer:Ut,skinning:G.isSkinnedMesh===!0,morphTargets:J.morphAttributes.position!==void 0,morphNormals:J.morphAttributes.normal!==void 0,morphColors:J.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:ft,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:E.dithering,shadowMapEnabled:i.shadowMap.enabled&&T.length>0,shadowMapType:i.shadowMap.type,toneMapping:Ve,decodeVideoTexture:re&&E.map.isVideoTexture===!0&&ve.getTransfer(E.map.colorSpace)===Pe,decodeVideoTextureEmissive:be&&E.emissiveMap.isVideoTexture===!0&&ve.getTransfer(E.emissiveMap.colorSpace)===Pe,premultipliedAlpha:E.premultipliedAlpha,doubleSided:E.side===hi,flipSided:E.side===Hn,useDepthPacking:E.depthPacking>=0,depthPacking:E.depthPacking||0,index0AttributeName:E.index0AttributeName,extensionClipCullDistance:Kt&&E.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Kt&&E.extensions.multiDraw===!0||Vt)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:E.customProgramCacheKey()};return Ct.vertexUv1s=c.has(1),Ct.vertexUv2s=c.has(2),Ct.vertexUv3s=c.has(3),c.clear(),Ct}function p(E){let b=[];if(E.shaderID?b.push(E.shaderID):(b.push(E.customVertexShaderID),b.push(E.customFragmentShaderID)),E.defines!==void 0)for(let T in E.defines)b.push(T),b.push(E.defines[T]);return E.isRawShaderMaterial===!1&&(S(b,E),w(b,E),b.push(i.outputColorSpace)),b.push(E.customProgramCacheKey),b.join()}function S(E,b){E.push(b.precision),E.push(b.outputColorSpace),E.push(b.envMapMode),E.push(b.envMapCubeUVHeight),E.push(b.mapUv),E.push(b.alphaMapUv),E.push(b.lightMapUv),E.push(b.aoMapUv),E.push(b.bumpMapUv),E.push(b.normalMapUv),E.push(b.displacementMapUv),E.push(b.emissiveMapUv),E.push(b.metalnessMapUv),E.push(b.roughnessMapUv),E.push(b.anisotropyMapUv),E.push(b.clearcoatMapUv),E.push(b.clearcoatNormalMapUv),E.push(b.clearcoatRoughnessMapUv),E.push(b.iridescenceMapUv),E.push(b.iridescenceThicknessMapUv),E.push(b.sheenColorMapUv),E.push(b.sheenRoughnessMapUv),E.push(b.specularMapUv),E.push(b.specularColorMapUv),E.push(b.specularIntensityMapUv),E.push(b.transmissionMapUv),E.push(b.thicknessMapUv),E.push(b.combine),E.push(b.fogExp2),E.push(b.sizeAttenuation),E.push(b.morphTargetsCount),E.push(b.morphAttributeCount),E.push(b.numDirLights),E.push(b.numPointLights),E.push(b.numSpotLights),E.push(b.numSpotLightMaps),E.push(b.numHemiLights),E.push(b.numRectAreaLights),E.push(b.numDirLightShadows),E.push(b.numPointLightShadows),E.push(b.numSpotLightShadows),E.push(b.numSpotLightShadowsWithMaps),E.push(b.numLightProbes),E.push(b.shadowMapType),E.push(b.toneMapping),E.push(b.numClippingPlanes),E.push(b.numClipIntersection),E.push(b.depthPacking)}function w(E,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),E.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reverseDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),E.push(a.mask)}function x(E){let b=g[E.type],T;if(b){let H=Ui[b];T=n_.clone(H.uniforms)}else T=E.uniforms;return T}function D(E,b){let T;for(let H=0,G=h.length;H<G;H++){let q=h[H];if(q.cacheKey===b){T=q,++T.usedTimes;break}}return T===void 0&&(T=new hS(i,b,E,r),h.push(T)),T}function C(E){if(--E.usedTimes===0){let b=h.indexOf(E);h[b]=h[h.length-1],h.pop(),E.destroy()}}function R(E){l.remove(E)}function U(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:x,acquireProgram:D,releaseProgram:C,releaseShaderCache:R,programs:h,dispose:U}}function fS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function pS(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function Rm(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Pm(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d,u,f,g,y,m){let p=i[t];return p===void 0?(p={id:d.id,object:d,geometry:u,material:f,groupOrder:g,renderOrder:d.renderOrder,z:y,group:m},i[t]=p):(p.id=d.id,p.object=d,p.geometry=u,p.material=f,p.groupOrder=g,p.renderOrder=d.renderOrder,p.z=y,p.group=m),t++,p}function a(d,u,f,g,y,m){let p=o(d,u,f,g,y,m);f.transmission>0?n.push(p):f.transparent===!0?s.push(p):e.push(p)}function l(d,u,f,g,y,m){let p=o(d,u,f,g,y,m);f.transmission>0?n.unshift(p):f.transparent===!0?s.unshift(p):e.unshift(p)}function c(d,u){e.length>1&&e.sort(d||pS),n.length>1&&n.sort(u||Rm),s.length>1&&s.sort(u||Rm)}function h(){for(let d=t,u=i.length;d<u;d++){let f=i[d];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function mS(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new Pm,i.set(n,[o])):s>=r.length?(o=new Pm,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function gS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new N,color:new le};break;case"SpotLight":e={position:new N,direction:new N,color:new le,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new N,color:new le,distance:0,decay:0};break;case"HemisphereLight":e={direction:new N,skyColor:new le,groundColor:new le};break;case"RectAreaLight":e={color:new le,position:new N,halfWidth:new N,halfHeight:new N};break}return i[t.id]=e,e}}}function vS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var yS=0;function xS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function _S(i){let t=new gS,e=vS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new N);let s=new N,r=new Je,o=new Je;function a(c){let h=0,d=0,u=0;for(let E=0;E<9;E++)n.probe[E].set(0,0,0);let f=0,g=0,y=0,m=0,p=0,S=0,w=0,x=0,D=0,C=0,R=0;c.sort(xS);for(let E=0,b=c.length;E<b;E++){let T=c[E],H=T.color,G=T.intensity,q=T.distance,J=T.shadow&&T.shadow.map?T.shadow.map.texture:null;if(T.isAmbientLight)h+=H.r*G,d+=H.g*G,u+=H.b*G;else if(T.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(T.sh.coefficients[$],G);R++}else if(T.isDirectionalLight){let $=t.get(T);if($.color.copy(T.color).multiplyScalar(T.intensity),T.castShadow){let nt=T.shadow,Q=e.get(T);Q.shadowIntensity=nt.intensity,Q.shadowBias=nt.bias,Q.shadowNormalBias=nt.normalBias,Q.shadowRadius=nt.radius,Q.shadowMapSize=nt.mapSize,n.directionalShadow[f]=Q,n.directionalShadowMap[f]=J,n.directionalShadowMatrix[f]=T.shadow.matrix,S++}n.directional[f]=$,f++}else if(T.isSpotLight){let $=t.get(T);$.position.setFromMatrixPosition(T.matrixWorld),$.color.copy(H).multiplyScalar(G),$.distance=q,$.coneCos=Math.cos(T.angle),$.penumbraCos=Math.cos(T.angle*(1-T.penumbra)),$.decay=T.decay,n.spot[y]=$;let nt=T.shadow;if(T.map&&(n.spotLightMap[D]=T.map,D++,nt.updateMatrices(T),T.castShadow&&C++),n.spotLightMatrix[y]=nt.matrix,T.castShadow){let Q=e.get(T);Q.shadowIntensity=nt.intensity,Q.shadowBias=nt.bias,Q.shadowNormalBias=nt.normalBias,Q.shadowRadius=nt.radius,Q.shadowMapSize=nt.mapSize,n.spotShadow[y]=Q,n.spotShadowMap[y]=J,x++}y++}else if(T.isRectAreaLight){let $=t.get(T);$.color.copy(H).multiplyScalar(G),$.halfWidth.set(T.width*.5,0,0),$.halfHeight.set(0,T.height*.5,0),n.rectArea[m]=$,m++}else if(T.isPointLight){let $=t.get(T);if($.color.copy(T.color).multiplyScalar(T.intensity),$.distance=T.distance,$.decay=T.decay,T.castShadow){let nt=T.shadow,Q=e.get(T);Q.shadowIntensity=nt.intensity,Q.shadowBias=nt.bias,Q.shadowNormalBias=nt.normalBias,Q.shadowRadius=nt.radius,Q.shadowMapSize=nt.mapSize,Q.shadowCameraNear=nt.camera.near,Q.shadowCameraFar=nt.camera.far,n.pointShadow[g]=Q,n.pointShadowMap[g]=J,n.pointShadowMatrix[g]=T.shadow.matrix,w++}n.point[g]=$,g++}else if(T.isHemisphereLight){let $=t.get(T);$.skyColor.copy(T.color).multiplyScalar(G),$.groundColor.copy(T.groundColor).multiplyScalar(G),n.hemi[p]=$,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=xt.LTC_FLOAT_1,n.rectAreaLTC2=xt.LTC_FLOAT_2):(n.rectAreaLTC1=xt.LTC_HALF_1,n.rectAreaLTC2=xt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let U=n.hash;(U.directionalLength!==f||U.pointLength!==g||U.spotLength!==y||U.rectAreaLength!==m||U.hemiLength!==p||U.numDirectionalShadows!==S||U.numPointShadows!==w||U.numSpotShadows!==x||U.numSpotMaps!==D||U.numLightProbes!==R)&&(n.directional.length=f,n.spot.length=y,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=S,n.directionalShadowMap.length=S,n.pointShadow.length=w,n.pointShadowMap.length=w,n.spotShadow.length=x,n.spotShadowMap.length=x,n.directionalShadowMatrix.length=S,n.pointShadowMatrix.length=w,n.spotLightMatrix.length=x+D-C,n.spotLightMap.length=D,n.numSpotLightShadowsWithMaps=C,n.numLightProbes=R,U.directionalLength=f,U.pointLength=g,U.spotLength=y,U.rectAreaLength=m,U.hemiLength=p,U.numDirectionalShadows=S,U.numPointShadows=w,U.numSpotShadows=x,U.numSpotMaps=D,U.numLightProbes=R,n.version=yS++)}function l(c,h){let d=0,u=0,f=0,g=0,y=0,m=h.matrixWorldInverse;for(let p=0,S=c.length;p<S;p++){let w=c[p];if(w.isDirectionalLight){let x=n.directional[d];x.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),d++}else if(w.isSpotLight){let x=n.spot[f];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),f++}else if(w.isRectAreaLight){let x=n.rectArea[g];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(w.width*.5,0,0),x.halfHeight.set(0,w.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),g++}else if(w.isPointLight){let x=n.point[u];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),u++}else if(w.isHemisphereLight){let x=n.hemi[y];x.direction.setFromMatrixPosition(w.matrixWorld),x.direction.transformDirection(m),y++}}}return{setup:a,setupView:l,state:n}}function Im(i){let t=new _S(i),e=[],n=[];function s(h){c.camera=h,e.length=0,n.length=0}function r(h){e.push(h)}function o(h){n.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}let c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function bS(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Im(i),t.set(s,[a])):r>=o.length?(a=new Im(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var zu=class extends Ts{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=dx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Vu=class extends Ts{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}},MS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,wS=`uniform sampler2D shadow_pass;
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
}`;function SS(i,t,e){let n=new Il,s=new _t,r=new _t,o=new We,a=new zu({depthPacking:fx}),l=new Vu,c={},h=e.maxTextureSize,d={[Fi]:Hn,[Hn]:Fi,[hi]:hi},u=new _n({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new _t},radius:{value:4}},vertexShader:MS,fragmentShader:wS}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let g=new qe;g.setAttribute("position",new ze(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Mn(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Vm;let p=this.type;this.render=function(C,R,U){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||C.length===0)return;let E=i.getRenderTarget(),b=i.getActiveCubeFace(),T=i.getActiveMipmapLevel(),H=i.state;H.setBlending(Es),H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let G=p!==es&&this.type===es,q=p===es&&this.type!==es;for(let J=0,$=C.length;J<$;J++){let nt=C[J],Q=nt.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",nt,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);let ht=Q.getFrameExtents();if(s.multiply(ht),r.copy(Q.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ht.x),s.x=r.x*ht.x,Q.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ht.y),s.y=r.y*ht.y,Q.mapSize.y=r.y)),Q.map===null||G===!0||q===!0){let mt=this.type!==es?{minFilter:Qn,magFilter:Qn}:{};Q.map!==null&&Q.map.dispose(),Q.map=new wi(s.x,s.y,mt),Q.map.texture.name=nt.name+".shadowMap",Q.camera.updateProjectionMatrix()}i.setRenderTarget(Q.map),i.clear();let ot=Q.getViewportCount();for(let mt=0;mt<ot;mt++){let ft=Q.getViewport(mt);o.set(r.x*ft.x,r.y*ft.y,r.x*ft.z,r.y*ft.w),H.viewport(o),Q.updateMatrices(nt,mt),n=Q.getFrustum(),x(R,U,Q.camera,nt,this.type)}Q.isPointLightShadow!==!0&&this.type===es&&S(Q,U),Q.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(E,b,T)};function S(C,R){let U=t.update(y);u.defines.VSM_SAMPLES!==C.blurSamples&&(u.defines.VSM_SAMPLES=C.blurSamples,f.defines.VSM_SAMPLES=C.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),C.mapPass===null&&(C.mapPass=new wi(s.x,s.y)),u.uniforms.shadow_pass.value=C.map.texture,u.uniforms.resolution.value=C.mapSize,u.uniforms.radius.value=C.radius,i.setRenderTarget(C.mapPass),i.clear(),i.renderBufferDirect(R,null,U,u,y,null),f.uniforms.shadow_pass.value=C.mapPass.texture,f.uniforms.resolution.value=C.mapSize,f.uniforms.radius.value=C.radius,i.setRenderTarget(C.map),i.clear(),i.renderBufferDirect(R,null,U,f,y,null)}function w(C,R,U,E){let b=null,T=U.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(T!==void 0)b=T;else if(b=U.isPointLight===!0?l:a,i.localClippingEnabled&&R.clipShadows===!0&&Array.isArray(R.clippingPlanes)&&R.clippingPlanes.length!==0||R.displacementMap&&R.displacementScale!==0||R.alphaMap&&R.alphaTest>0||R.map&&R.alphaTest>0){let H=b.uuid,G=R.uuid,q=c[H];q===void 0&&(q={},c[H]=q);let J=q[G];J===void 0&&(J=b.clone(),q[G]=J,R.addEventListener("dispose",D)),b=J}if(b.visible=R.visible,b.wireframe=R.wireframe,E===es?b.side=R.shadowSide!==null?R.shadowSide:R.side:b.side=R.shadowSide!==null?R.shadowSide:d[R.side],b.alphaMap=R.alphaMap,b.alphaTest=R.alphaTest,b.map=R.map,b.clipShadows=R.clipShadows,b.clippingPlanes=R.clippingPlanes,b.clipIntersection=R.clipIntersection,b.displacementMap=R.displacementMap,b.displacementScale=R.displacementScale,b.displacementBias=R.displacementBias,b.wireframeLinewidth=R.wireframeLinewidth,b.linewidth=R.linewidth,U.isPointLight===!0&&b.isMeshDistanceMaterial===!0){let H=i.properties.get(b);H.light=U}return b}function x(C,R,U,E,b){if(C.visible===!1)return;if(C.layers.test(R.layers)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&b===es)&&(!C.frustumCulled||n.intersectsObject(C))){C.modelViewMatrix.multiplyMatrices(U.matrixWorldInverse,C.matrixWorld);let G=t.update(C),q=C.material;if(Array.isArray(q)){let J=G.groups;for(let $=0,nt=J.length;$<nt;$++){let Q=J[$],ht=q[Q.materialIndex];if(ht&&ht.visible){let ot=w(C,ht,E,b);C.onBeforeShadow(i,C,R,U,G,ot,Q),i.renderBufferDirect(U,null,G,ot,C,Q),C.onAfterShadow(i,C,R,U,G,ot,Q)}}}else if(q.visible){let J=w(C,q,E,b);C.onBeforeShadow(i,C,R,U,G,J,null),i.renderBufferDirect(U,null,G,J,C,null),C.onAfterShadow(i,C,R,U,G,J,null)}}let H=C.children;for(let G=0,q=H.length;G<q;G++)x(H[G],R,U,E,b)}function D(C){C.target.removeEventListener("dispose",D);for(let U in c){let E=c[U],b=C.target.uuid;b in E&&(E[b].dispose(),delete E[b])}}}var ES={[Wh]:Xh,[qh]:Zh,[Yh]:Jh,[ro]:$h,[Xh]:Wh,[Zh]:qh,[Jh]:Yh,[$h]:ro};function AS(i,t){function e(){let O=!1,yt=new We,tt=null,rt=new We(0,0,0,0);return{setMask:function(Et){tt!==Et&&!O&&(i.colorMask(Et,Et,Et,Et),tt=Et)},setLocked:function(Et){O=Et},setClear:function(Et,St,Kt,Ve,Ct){Ct===!0&&(Et*=Ve,St*=Ve,Kt*=Ve),yt.set(Et,St,Kt,Ve),rt.equals(yt)===!1&&(i.clearColor(Et,St,Kt,Ve),rt.copy(yt))},reset:function(){O=!1,tt=null,rt.set(-1,0,0,0)}}}function n(){let O=!1,yt=!1,tt=null,rt=null,Et=null;return{setReversed:function(St){if(yt!==St){let Kt=t.get("EXT_clip_control");yt?Kt.clipControlEXT(Kt.LOWER_LEFT_EXT,Kt.ZERO_TO_ONE_EXT):Kt.clipControlEXT(Kt.LOWER_LEFT_EXT,Kt.NEGATIVE_ONE_TO_ONE_EXT);let Ve=Et;Et=null,this.setClear(Ve)}yt=St},getReversed:function(){return yt},setTest:function(St){St?ut(i.DEPTH_TEST):Ut(i.DEPTH_TEST)},setMask:function(St){tt!==St&&!O&&(i.depthMask(St),tt=St)},setFunc:function(St){if(yt&&(St=ES[St]),rt!==St){switch(St){case Wh:i.depthFunc(i.NEVER);break;case Xh:i.depthFunc(i.ALWAYS);break;case qh:i.depthFunc(i.LESS);break;case ro:i.depthFunc(i.LEQUAL);break;case Yh:i.depthFunc(i.EQUAL);break;case $h:i.depthFunc(i.GEQUAL);break;case Zh:i.depthFunc(i.GREATER);break;case Jh:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}rt=St}},setLocked:function(St){O=St},setClear:function(St){Et!==St&&(yt&&(St=1-St),i.clearDepth(St),Et=St)},reset:function(){O=!1,tt=null,rt=null,Et=null,yt=!1}}}function s(){let O=!1,yt=null,tt=null,rt=null,Et=null,St=null,Kt=null,Ve=null,Ct=null;return{setTest:function(oe){O||(oe?ut(i.STENCIL_TEST):Ut(i.STENCIL_TEST))},setMask:function(oe){yt!==oe&&!O&&(i.stencilMask(oe),yt=oe)},setFunc:function(oe,Ae,pn){(tt!==oe||rt!==Ae||Et!==pn)&&(i.stencilFunc(oe,Ae,pn),tt=oe,rt=Ae,Et=pn)},setOp:function(oe,Ae,pn){(St!==oe||Kt!==Ae||Ve!==pn)&&(i.stencilOp(oe,Ae,pn),St=oe,Kt=Ae,Ve=pn)},setLocked:function(oe){O=oe},setClear:function(oe){Ct!==oe&&(i.clearStencil(oe),Ct=oe)},reset:function(){O=!1,yt=null,tt=null,rt=null,Et=null,St=null,Kt=null,Ve=null,Ct=null}}}let r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap,h={},d={},u=new WeakMap,f=[],g=null,y=!1,m=null,p=null,S=null,w=null,x=null,D=null,C=null,R=new le(0,0,0),U=0,E=!1,b=null,T=null,H=null,G=null,q=null,J=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),$=!1,nt=0,Q=i.getParameter(i.VERSION);Q.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec(Q)[1]),$=nt>=1):Q.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),$=nt>=2);let ht=null,ot={},mt=i.getParameter(i.SCISSOR_BOX),ft=i.getParameter(i.VIEWPORT),Wt=new We().fromArray(mt),K=new We().fromArray(ft);function ct(O,yt,tt,rt){let Et=new Uint8Array(4),St=i.createTexture();i.bindTexture(O,St),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Kt=0;Kt<tt;Kt++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(yt,0,i.RGBA,1,1,rt,0,i.RGBA,i.UNSIGNED_BYTE,Et):i.texImage2D(yt+Kt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Et);return St}let Lt={};Lt[i.TEXTURE_2D]=ct(i.TEXTURE_2D,i.TEXTURE_2D,1),Lt[i.TEXTURE_CUBE_MAP]=ct(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[i.TEXTURE_2D_ARRAY]=ct(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Lt[i.TEXTURE_3D]=ct(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ut(i.DEPTH_TEST),o.setFunc(ro),ie(!1),Jt(Dp),ut(i.CULL_FACE),W(Es);function ut(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function Ut(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function Gt(O,yt){return d[O]!==yt?(i.bindFramebuffer(O,yt),d[O]=yt,O===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=yt),O===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=yt),!0):!1}function Vt(O,yt){let tt=f,rt=!1;if(O){tt=u.get(yt),tt===void 0&&(tt=[],u.set(yt,tt));let Et=O.textures;if(tt.length!==Et.length||tt[0]!==i.COLOR_ATTACHMENT0){for(let St=0,Kt=Et.length;St<Kt;St++)tt[St]=i.COLOR_ATTACHMENT0+St;tt.length=Et.length,rt=!0}}else tt[0]!==i.BACK&&(tt[0]=i.BACK,rt=!0);rt&&i.drawBuffers(tt)}function re(O){return g!==O?(i.useProgram(O),g=O,!0):!1}let te={[Zs]:i.FUNC_ADD,[By]:i.FUNC_SUBTRACT,[zy]:i.FUNC_REVERSE_SUBTRACT};te[Vy]=i.MIN,te[Hy]=i.MAX;let Ee={[Gy]:i.ZERO,[Wy]:i.ONE,[Xy]:i.SRC_COLOR,[Hh]:i.SRC_ALPHA,[Ky]:i.SRC_ALPHA_SATURATE,[Zy]:i.DST_COLOR,[Yy]:i.DST_ALPHA,[qy]:i.ONE_MINUS_SRC_COLOR,[Gh]:i.ONE_MINUS_SRC_ALPHA,[Jy]:i.ONE_MINUS_DST_COLOR,[$y]:i.ONE_MINUS_DST_ALPHA,[jy]:i.CONSTANT_COLOR,[Qy]:i.ONE_MINUS_CONSTANT_COLOR,[tx]:i.CONSTANT_ALPHA,[ex]:i.ONE_MINUS_CONSTANT_ALPHA};function W(O,yt,tt,rt,Et,St,Kt,Ve,Ct,oe){if(O===Es){y===!0&&(Ut(i.BLEND),y=!1);return}if(y===!1&&(ut(i.BLEND),y=!0),O!==ky){if(O!==m||oe!==E){if((p!==Zs||x!==Zs)&&(i.blendEquation(i.FUNC_ADD),p=Zs,x=Zs),oe)switch(O){case eo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Up:i.blendFunc(i.ONE,i.ONE);break;case Np:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Fp:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}else switch(O){case eo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Up:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case Np:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Fp:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",O);break}S=null,w=null,D=null,C=null,R.set(0,0,0),U=0,m=O,E=oe}return}Et=Et||yt,St=St||tt,Kt=Kt||rt,(yt!==p||Et!==x)&&(i.blendEquationSeparate(te[yt],te[Et]),p=yt,x=Et),(tt!==S||rt!==w||St!==D||Kt!==C)&&(i.blendFuncSeparate(Ee[tt],Ee[rt],Ee[St],Ee[Kt]),S=tt,w=rt,D=St,C=Kt),(Ve.equals(R)===!1||Ct!==U)&&(i.blendColor(Ve.r,Ve.g,Ve.b,Ct),R.copy(Ve),U=Ct),m=O,E=!1}function rn(O,yt){O.side===hi?Ut(i.CULL_FACE):ut(i.CULL_FACE);let tt=O.side===Hn;yt&&(tt=!tt),ie(tt),O.blending===eo&&O.transparent===!1?W(Es):W(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let rt=O.stencilWrite;a.setTest(rt),rt&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),be(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?ut(i.SAMPLE_ALPHA_TO_COVERAGE):Ut(i.SAMPLE_ALPHA_TO_COVERAGE)}function ie(O){b!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),b=O)}function Jt(O){O!==Ny?(ut(i.CULL_FACE),O!==T&&(O===Dp?i.cullFace(i.BACK):O===Fy?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ut(i.CULL_FACE),T=O}function Nt(O){O!==H&&($&&i.lineWidth(O),H=O)}function be(O,yt,tt){O?(ut(i.POLYGON_OFFSET_FILL),(G!==yt||q!==tt)&&(i.polygonOffset(yt,tt),G=yt,q=tt)):Ut(i.POLYGON_OFFSET_FILL)}function kt(O){O?ut(i.SCISSOR_TEST):Ut(i.SCISSOR_TEST)}function P(O){O===void 0&&(O=i.TEXTURE0+J-1),ht!==O&&(i.activeTexture(O),ht=O)}function _(O,yt,tt){tt===void 0&&(ht===null?tt=i.TEXTURE0+J-1:tt=ht);let rt=ot[tt];rt===void 0&&(rt={type:void 0,texture:void 0},ot[tt]=rt),(rt.type!==O||rt.texture!==yt)&&(ht!==tt&&(i.activeTexture(tt),ht=tt),i.bindTexture(O,yt||Lt[O]),rt.type=O,rt.texture=yt)}function z(){let O=ot[ht];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function it(){try{i.compressedTexImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function j(){try{i.compressedTexImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function et(){try{i.texSubImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function It(){try{i.texSubImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function gt(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function bt(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function qt(){try{i.texStorage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function at(){try{i.texStorage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function vt(){try{i.texImage2D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Bt(){try{i.texImage3D.apply(i,arguments)}catch(O){console.error("THREE.WebGLState:",O)}}function Ht(O){Wt.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),Wt.copy(O))}function wt(O){K.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),K.copy(O))}function ee(O,yt){let tt=c.get(yt);tt===void 0&&(tt=new WeakMap,c.set(yt,tt));let rt=tt.get(O);rt===void 0&&(rt=i.getUniformBlockIndex(yt,O.name),tt.set(O,rt))}function Yt(O,yt){let rt=c.get(yt).get(O);l.get(yt)!==rt&&(i.uniformBlockBinding(yt,rt,O.__bindingPointIndex),l.set(yt,rt))}function xe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ht=null,ot={},d={},u=new WeakMap,f=[],g=null,y=!1,m=null,p=null,S=null,w=null,x=null,D=null,C=null,R=new le(0,0,0),U=0,E=!1,b=null,T=null,H=null,G=null,q=null,Wt.set(0,0,i.canvas.width,i.canvas.height),K.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ut,disable:Ut,bindFramebuffer:Gt,drawBuffers:Vt,useProgram:re,setBlending:W,setMaterial:rn,setFlipSided:ie,setCullFace:Jt,setLineWidth:Nt,setPolygonOffset:be,setScissorTest:kt,activeTexture:P,bindTexture:_,unbindTexture:z,compressedTexImage2D:it,compressedTexImage3D:j,texImage2D:vt,texImage3D:Bt,updateUBOMapping:ee,uniformBlockBinding:Yt,texStorage2D:qt,texStorage3D:at,texSubImage2D:et,texSubImage3D:It,compressedTexSubImage2D:gt,compressedTexSubImage3D:bt,scissor:Ht,viewport:wt,reset:xe}}function Lm(i,t,e,n){let s=TS(n);switch(e){case Ym:return i*t;case Zm:return i*t;case Jm:return i*t*2;case Km:return i*t/s.components*s.byteLength;case vd:return i*t/s.components*s.byteLength;case jm:return i*t*2/s.components*s.byteLength;case yd:return i*t*2/s.components*s.byteLength;case $m:return i*t*3/s.components*s.byteLength;case jn:return i*t*4/s.components*s.byteLength;case xd:return i*t*4/s.components*s.byteLength;case ml:case gl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case vl:case yl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case nu:case su:return Math.max(i,16)*Math.max(t,8)/4;case eu:case iu:return Math.max(i,8)*Math.max(t,8)/2;case ru:case ou:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case au:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case lu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case cu:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case hu:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case uu:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case du:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case fu:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case pu:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case mu:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case gu:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case vu:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case yu:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case xu:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case _u:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case bu:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case xl:case Mu:case wu:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Qm:case Su:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Eu:case Au:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function TS(i){switch(i){case ss:case Wm:return{byteLength:1,components:1};case Qo:case Xm:case sa:return{byteLength:2,components:1};case md:case gd:return{byteLength:2,components:4};case tr:case pd:case Mi:return{byteLength:4,components:1};case qm:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function CS(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new _t,h=new WeakMap,d,u=new WeakMap,f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,_){return f?new OffscreenCanvas(P,_):Ml("canvas")}function y(P,_,z){let it=1,j=kt(P);if((j.width>z||j.height>z)&&(it=z/Math.max(j.width,j.height)),it<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let et=Math.floor(it*j.width),It=Math.floor(it*j.height);d===void 0&&(d=g(et,It));let gt=_?g(et,It):d;return gt.width=et,gt.height=It,gt.getContext("2d").drawImage(P,0,0,et,It),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+et+"x"+It+")."),gt}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){i.generateMipmap(P)}function S(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(P,_,z,it,j=!1){if(P!==null){if(i[P]!==void 0)return i[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let et=_;if(_===i.RED&&(z===i.FLOAT&&(et=i.R32F),z===i.HALF_FLOAT&&(et=i.R16F),z===i.UNSIGNED_BYTE&&(et=i.R8)),_===i.RED_INTEGER&&(z===i.UNSIGNED_BYTE&&(et=i.R8UI),z===i.UNSIGNED_SHORT&&(et=i.R16UI),z===i.UNSIGNED_INT&&(et=i.R32UI),z===i.BYTE&&(et=i.R8I),z===i.SHORT&&(et=i.R16I),z===i.INT&&(et=i.R32I)),_===i.RG&&(z===i.FLOAT&&(et=i.RG32F),z===i.HALF_FLOAT&&(et=i.RG16F),z===i.UNSIGNED_BYTE&&(et=i.RG8)),_===i.RG_INTEGER&&(z===i.UNSIGNED_BYTE&&(et=i.RG8UI),z===i.UNSIGNED_SHORT&&(et=i.RG16UI),z===i.UNSIGNED_INT&&(et=i.RG32UI),z===i.BYTE&&(et=i.RG8I),z===i.SHORT&&(et=i.RG16I),z===i.INT&&(et=i.RG32I)),_===i.RGB_INTEGER&&(z===i.UNSIGNED_BYTE&&(et=i.RGB8UI),z===i.UNSIGNED_SHORT&&(et=i.RGB16UI),z===i.UNSIGNED_INT&&(et=i.RGB32UI),z===i.BYTE&&(et=i.RGB8I),z===i.SHORT&&(et=i.RGB16I),z===i.INT&&(et=i.RGB32I)),_===i.RGBA_INTEGER&&(z===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),z===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),z===i.UNSIGNED_INT&&(et=i.RGBA32UI),z===i.BYTE&&(et=i.RGBA8I),z===i.SHORT&&(et=i.RGBA16I),z===i.INT&&(et=i.RGBA32I)),_===i.RGB&&z===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),_===i.RGBA){let It=j?Kl:ve.getTransfer(it);z===i.FLOAT&&(et=i.RGBA32F),z===i.HALF_FLOAT&&(et=i.RGBA16F),z===i.UNSIGNED_BYTE&&(et=It===Pe?i.SRGB8_ALPHA8:i.RGBA8),z===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),z===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function x(P,_){let z;return P?_===null||_===tr||_===lo?z=i.DEPTH24_STENCIL8:_===Mi?z=i.DEPTH32F_STENCIL8:_===Qo&&(z=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):_===null||_===tr||_===lo?z=i.DEPTH_COMPONENT24:_===Mi?z=i.DEPTH_COMPONENT32F:_===Qo&&(z=i.DEPTH_COMPONENT16),z}function D(P,_){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==Qn&&P.minFilter!==Ni?Math.log2(Math.max(_.width,_.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?_.mipmaps.length:1}function C(P){let _=P.target;_.removeEventListener("dispose",C),U(_),_.isVideoTexture&&h.delete(_)}function R(P){let _=P.target;_.removeEventListener("dispose",R),b(_)}function U(P){let _=n.get(P);if(_.__webglInit===void 0)return;let z=P.source,it=u.get(z);if(it){let j=it[_.__cacheKey];j.usedTimes--,j.usedTimes===0&&E(P),Object.keys(it).length===0&&u.delete(z)}n.remove(P)}function E(P){let _=n.get(P);i.deleteTexture(_.__webglTexture);let z=P.source,it=u.get(z);delete it[_.__cacheKey],o.memory.textures--}function b(P){let _=n.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),n.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let it=0;it<6;it++){if(Array.isArray(_.__webglFramebuffer[it]))for(let j=0;j<_.__webglFramebuffer[it].length;j++)i.deleteFramebuffer(_.__webglFramebuffer[it][j]);else i.deleteFramebuffer(_.__webglFramebuffer[it]);_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer[it])}else{if(Array.isArray(_.__webglFramebuffer))for(let it=0;it<_.__webglFramebuffer.length;it++)i.deleteFramebuffer(_.__webglFramebuffer[it]);else i.deleteFramebuffer(_.__webglFramebuffer);if(_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer),_.__webglMultisampledFramebuffer&&i.deleteFramebuffer(_.__webglMultisampledFramebuffer),_.__webglColorRenderbuffer)for(let it=0;it<_.__webglColorRenderbuffer.length;it++)_.__webglColorRenderbuffer[it]&&i.deleteRenderbuffer(_.__webglColorRenderbuffer[it]);_.__webglDepthRenderbuffer&&i.deleteRenderbuffer(_.__webglDepthRenderbuffer)}let z=P.textures;for(let it=0,j=z.length;it<j;it++){let et=n.get(z[it]);et.__webglTexture&&(i.deleteTexture(et.__webglTexture),o.memory.textures--),n.remove(z[it])}n.remove(P)}let T=0;function H(){T=0}function G(){let P=T;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),T+=1,P}function q(P){let _=[];return _.push(P.wrapS),_.push(P.wrapT),_.push(P.wrapR||0),_.push(P.magFilter),_.push(P.minFilter),_.push(P.anisotropy),_.push(P.internalFormat),_.push(P.format),_.push(P.type),_.push(P.generateMipmaps),_.push(P.premultiplyAlpha),_.push(P.flipY),_.push(P.unpackAlignment),_.push(P.colorSpace),_.join()}function J(P,_){let z=n.get(P);if(P.isVideoTexture&&Nt(P),P.isRenderTargetTexture===!1&&P.version>0&&z.__version!==P.version){let it=P.image;if(it===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(it.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{K(z,P,_);return}}e.bindTexture(i.TEXTURE_2D,z.__webglTexture,i.TEXTURE0+_)}function $(P,_){let z=n.get(P);if(P.version>0&&z.__version!==P.version){K(z,P,_);return}e.bindTexture(i.TEXTURE_2D_ARRAY,z.__webglTexture,i.TEXTURE0+_)}function nt(P,_){let z=n.get(P);if(P.version>0&&z.__version!==P.version){K(z,P,_);return}e.bindTexture(i.TEXTURE_3D,z.__webglTexture,i.TEXTURE0+_)}function Q(P,_){let z=n.get(P);if(P.version>0&&z.__version!==P.version){ct(z,P,_);return}e.bindTexture(i.TEXTURE_CUBE_MAP,z.__webglTexture,i.TEXTURE0+_)}let ht={[Qh]:i.REPEAT,[js]:i.CLAMP_TO_EDGE,[tu]:i.MIRRORED_REPEAT},ot={[Qn]:i.NEAREST,[ux]:i.NEAREST_MIPMAP_NEAREST,[Ha]:i.NEAREST_MIPMAP_LINEAR,[Ni]:i.LINEAR,[hh]:i.LINEAR_MIPMAP_NEAREST,[Qs]:i.LINEAR_MIPMAP_LINEAR},mt={[gx]:i.NEVER,[Mx]:i.ALWAYS,[vx]:i.LESS,[ng]:i.LEQUAL,[yx]:i.EQUAL,[bx]:i.GEQUAL,[xx]:i.GREATER,[_x]:i.NOTEQUAL};function ft(P,_){if(_.type===Mi&&t.has("OES_texture_float_linear")===!1&&(_.magFilter===Ni||_.magFilter===hh||_.magFilter===Ha||_.magFilter===Qs||_.minFilter===Ni||_.minFilter===hh||_.minFilter===Ha||_.minFilter===Qs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,ht[_.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,ht[_.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,ht[_.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,ot[_.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,ot[_.minFilter]),_.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,mt[_.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(_.magFilter===Qn||_.minFilter!==Ha&&_.minFilter!==Qs||_.type===Mi&&t.has("OES_texture_float_linear")===!1)return;if(_.anisotropy>1||n.get(_).__currentAnisotropy){let z=t.get("EXT_texture_filter_anisotropic");i.texParameterf(P,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(_.anisotropy,s.getMaxAnisotropy())),n.get(_).__currentAnisotropy=_.anisotropy}}}function Wt(P,_){let z=!1;P.__webglInit===void 0&&(P.__webglInit=!0,_.addEventListener("dispose",C));let it=_.source,j=u.get(it);j===void 0&&(j={},u.set(it,j));let et=q(_);if(et!==P.__cacheKey){j[et]===void 0&&(j[et]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,z=!0),j[et].usedTimes++;let It=j[P.__cacheKey];It!==void 0&&(j[P.__cacheKey].usedTimes--,It.usedTimes===0&&E(_)),P.__cacheKey=et,P.__webglTexture=j[et].texture}return z}function K(P,_,z){let it=i.TEXTURE_2D;(_.isDataArrayTexture||_.isCompressedArrayTexture)&&(it=i.TEXTURE_2D_ARRAY),_.isData3DTexture&&(it=i.TEXTURE_3D);let j=Wt(P,_),et=_.source;e.bindTexture(it,P.__webglTexture,i.TEXTURE0+z);let It=n.get(et);if(et.version!==It.__version||j===!0){e.activeTexture(i.TEXTURE0+z);let gt=ve.getPrimaries(ve.workingColorSpace),bt=_.colorSpace===Ss?null:ve.getPrimaries(_.colorSpace),qt=_.colorSpace===Ss||gt===bt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,qt);let at=y(_.image,!1,s.maxTextureSize);at=be(_,at);let vt=r.convert(_.format,_.colorSpace),Bt=r.convert(_.type),Ht=w(_.internalFormat,vt,Bt,_.colorSpace,_.isVideoTexture);ft(it,_);let wt,ee=_.mipmaps,Yt=_.isVideoTexture!==!0,xe=It.__version===void 0||j===!0,O=et.dataReady,yt=D(_,at);if(_.isDepthTexture)Ht=x(_.format===co,_.type),xe&&(Yt?e.texStorage2D(i.TEXTURE_2D,1,Ht,at.width,at.height):e.texImage2D(i.TEXTURE_2D,0,Ht,at.width,at.height,0,vt,Bt,null));else if(_.isDataTexture)if(ee.length>0){Yt&&xe&&e.texStorage2D(i.TEXTURE_2D,yt,Ht,ee[0].width,ee[0].height);for(let tt=0,rt=ee.length;tt<rt;tt++)wt=ee[tt],Yt?O&&e.texSubImage2D(i.TEXTURE_2D,tt,0,0,wt.width,wt.height,vt,Bt,wt.data):e.texImage2D(i.TEXTURE_2D,tt,Ht,wt.width,wt.height,0,vt,Bt,wt.data);_.generateMipmaps=!1}else Yt?(xe&&e.texStorage2D(i.TEXTURE_2D,yt,Ht,at.width,at.height),O&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at.width,at.height,vt,Bt,at.data)):e.texImage2D(i.TEXTURE_2D,0,Ht,at.width,at.height,0,vt,Bt,at.data);else if(_.isCompressedTexture)if(_.isCompressedArrayTexture){Yt&&xe&&e.texStorage3D(i.TEXTURE_2D_ARRAY,yt,Ht,ee[0].width,ee[0].height,at.depth);for(let tt=0,rt=ee.length;tt<rt;tt++)if(wt=ee[tt],_.format!==jn)if(vt!==null)if(Yt){if(O)if(_.layerUpdates.size>0){let Et=Lm(wt.width,wt.height,_.format,_.type);for(let St of _.layerUpdates){let Kt=wt.data.subarray(St*Et/wt.data.BYTES_PER_ELEMENT,(St+1)*Et/wt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,tt,0,0,St,wt.width,wt.height,1,vt,Kt)}_.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,tt,0,0,0,wt.width,wt.height,at.depth,vt,wt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,tt,Ht,wt.width,wt.height,at.depth,0,wt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?O&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,tt,0,0,0,wt.width,wt.height,at.depth,vt,Bt,wt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,tt,Ht,wt.width,wt.height,at.depth,0,vt,Bt,wt.data)}else{Yt&&xe&&e.texStorage2D(i.TEXTURE_2D,yt,Ht,ee[0].width,ee[0].height);for(let tt=0,rt=ee.length;tt<rt;tt++)wt=ee[tt],_.format!==jn?vt!==null?Yt?O&&e.compressedTexSubImage2D(i.TEXTURE_2D,tt,0,0,wt.width,wt.height,vt,wt.data):e.compressedTexImage2D(i.TEXTURE_2D,tt,Ht,wt.width,wt.height,0,wt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?O&&e.texSubImage2D(i.TEXTURE_2D,tt,0,0,wt.width,wt.height,vt,Bt,wt.data):e.texImage2D(i.TEXTURE_2D,tt,Ht,wt.width,wt.height,0,vt,Bt,wt.data)}else if(_.isDataArrayTexture)if(Yt){if(xe&&e.texStorage3D(i.TEXTURE_2D_ARRAY,yt,Ht,at.width,at.height,at.depth),O)if(_.layerUpdates.size>0){let tt=Lm(at.width,at.height,_.format,_.type);for(let rt of _.layerUpdates){let Et=at.data.subarray(rt*tt/at.data.BYTES_PER_ELEMENT,(rt+1)*tt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,rt,at.width,at.height,1,vt,Bt,Et)}_.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,Bt,at.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ht,at.width,at.height,at.depth,0,vt,Bt,at.data);else if(_.isData3DTexture)Yt?(xe&&e.texStorage3D(i.TEXTURE_3D,yt,Ht,at.width,at.height,at.depth),O&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,Bt,at.data)):e.texImage3D(i.TEXTURE_3D,0,Ht,at.width,at.height,at.depth,0,vt,Bt,at.data);else if(_.isFramebufferTexture){if(xe)if(Yt)e.texStorage2D(i.TEXTURE_2D,yt,Ht,at.width,at.height);else{let tt=at.width,rt=at.height;for(let Et=0;Et<yt;Et++)e.texImage2D(i.TEXTURE_2D,Et,Ht,tt,rt,0,vt,Bt,null),tt>>=1,rt>>=1}}else if(ee.length>0){if(Yt&&xe){let tt=kt(ee[0]);e.texStorage2D(i.TEXTURE_2D,yt,Ht,tt.width,tt.height)}for(let tt=0,rt=ee.length;tt<rt;tt++)wt=ee[tt],Yt?O&&e.texSubImage2D(i.TEXTURE_2D,tt,0,0,vt,Bt,wt):e.texImage2D(i.TEXTURE_2D,tt,Ht,vt,Bt,wt);_.generateMipmaps=!1}else if(Yt){if(xe){let tt=kt(at);e.texStorage2D(i.TEXTURE_2D,yt,Ht,tt.width,tt.height)}O&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,vt,Bt,at)}else e.texImage2D(i.TEXTURE_2D,0,Ht,vt,Bt,at);m(_)&&p(it),It.__version=et.version,_.onUpdate&&_.onUpdate(_)}P.__version=_.version}function ct(P,_,z){if(_.image.length!==6)return;let it=Wt(P,_),j=_.source;e.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+z);let et=n.get(j);if(j.version!==et.__version||it===!0){e.activeTexture(i.TEXTURE0+z);let It=ve.getPrimaries(ve.workingColorSpace),gt=_.colorSpace===Ss?null:ve.getPrimaries(_.colorSpace),bt=_.colorSpace===Ss||It===gt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,bt);let qt=_.isCompressedTexture||_.image[0].isCompressedTexture,at=_.image[0]&&_.image[0].isDataTexture,vt=[];for(let rt=0;rt<6;rt++)!qt&&!at?vt[rt]=y(_.image[rt],!0,s.maxCubemapSize):vt[rt]=at?_.image[rt].image:_.image[rt],vt[rt]=be(_,vt[rt]);let Bt=vt[0],Ht=r.convert(_.format,_.colorSpace),wt=r.convert(_.type),ee=w(_.internalFormat,Ht,wt,_.colorSpace),Yt=_.isVideoTexture!==!0,xe=et.__version===void 0||it===!0,O=j.dataReady,yt=D(_,Bt);ft(i.TEXTURE_CUBE_MAP,_);let tt;if(qt){Yt&&xe&&e.texStorage2D(i.TEXTURE_CUBE_MAP,yt,ee,Bt.width,Bt.height);for(let rt=0;rt<6;rt++){tt=vt[rt].mipmaps;for(let Et=0;Et<tt.length;Et++){let St=tt[Et];_.format!==jn?Ht!==null?Yt?O&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Et,0,0,St.width,St.height,Ht,St.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Et,ee,St.width,St.height,0,St.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Et,0,0,St.width,St.height,Ht,wt,St.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Et,ee,St.width,St.height,0,Ht,wt,St.data)}}}else{if(tt=_.mipmaps,Yt&&xe){tt.length>0&&yt++;let rt=kt(vt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,yt,ee,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(at){Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,vt[rt].width,vt[rt].height,Ht,wt,vt[rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ee,vt[rt].width,vt[rt].height,0,Ht,wt,vt[rt].data);for(let Et=0;Et<tt.length;Et++){let Kt=tt[Et].image[rt].image;Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Et+1,0,0,Kt.width,Kt.height,Ht,wt,Kt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Et+1,ee,Kt.width,Kt.height,0,Ht,wt,Kt.data)}}else{Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ht,wt,vt[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ee,Ht,wt,vt[rt]);for(let Et=0;Et<tt.length;Et++){let St=tt[Et];Yt?O&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Et+1,0,0,Ht,wt,St.image[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Et+1,ee,Ht,wt,St.image[rt])}}}m(_)&&p(i.TEXTURE_CUBE_MAP),et.__version=j.version,_.onUpdate&&_.onUpdate(_)}P.__version=_.version}function Lt(P,_,z,it,j,et){let It=r.convert(z.format,z.colorSpace),gt=r.convert(z.type),bt=w(z.internalFormat,It,gt,z.colorSpace),qt=n.get(_),at=n.get(z);if(at.__renderTarget=_,!qt.__hasExternalTextures){let vt=Math.max(1,_.width>>et),Bt=Math.max(1,_.height>>et);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?e.texImage3D(j,et,bt,vt,Bt,_.depth,0,It,gt,null):e.texImage2D(j,et,bt,vt,Bt,0,It,gt,null)}e.bindFramebuffer(i.FRAMEBUFFER,P),Jt(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,it,j,at.__webglTexture,0,ie(_)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,it,j,at.__webglTexture,et),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ut(P,_,z){if(i.bindRenderbuffer(i.RENDERBUFFER,P),_.depthBuffer){let it=_.depthTexture,j=it&&it.isDepthTexture?it.type:null,et=x(_.stencilBuffer,j),It=_.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,gt=ie(_);Jt(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,gt,et,_.width,_.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,gt,et,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,et,_.width,_.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,It,i.RENDERBUFFER,P)}else{let it=_.textures;for(let j=0;j<it.length;j++){let et=it[j],It=r.convert(et.format,et.colorSpace),gt=r.convert(et.type),bt=w(et.internalFormat,It,gt,et.colorSpace),qt=ie(_);z&&Jt(_)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,qt,bt,_.width,_.height):Jt(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,qt,bt,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,bt,_.width,_.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ut(P,_){if(_&&_.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,P),!(_.depthTexture&&_.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let it=n.get(_.depthTexture);it.__renderTarget=_,(!it.__webglTexture||_.depthTexture.image.width!==_.width||_.depthTexture.image.height!==_.height)&&(_.depthTexture.image.width=_.width,_.depthTexture.image.height=_.height,_.depthTexture.needsUpdate=!0),J(_.depthTexture,0);let j=it.__webglTexture,et=ie(_);if(_.depthTexture.format===no)Jt(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0);else if(_.depthTexture.format===co)Jt(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0);else throw new Error("Unknown depthTexture format")}function Gt(P){let _=n.get(P),z=P.isWebGLCubeRenderTarget===!0;if(_.__boundDepthTexture!==P.depthTexture){let it=P.depthTexture;if(_.__depthDisposeCallback&&_.__depthDisposeCallback(),it){let j=()=>{delete _.__boundDepthTexture,delete _.__depthDisposeCallback,it.removeEventListener("dispose",j)};it.addEventListener("dispose",j),_.__depthDisposeCallback=j}_.__boundDepthTexture=it}if(P.depthTexture&&!_.__autoAllocateDepthBuffer){if(z)throw new Error("target.depthTexture not supported in Cube render targets");Ut(_.__webglFramebuffer,P)}else if(z){_.__webglDepthbuffer=[];for(let it=0;it<6;it++)if(e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[it]),_.__webglDepthbuffer[it]===void 0)_.__webglDepthbuffer[it]=i.createRenderbuffer(),ut(_.__webglDepthbuffer[it],P,!1);else{let j=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,et=_.__webglDepthbuffer[it];i.bindRenderbuffer(i.RENDERBUFFER,et),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,et)}}else if(e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer),_.__webglDepthbuffer===void 0)_.__webglDepthbuffer=i.createRenderbuffer(),ut(_.__webglDepthbuffer,P,!1);else{let it=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,j=_.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,j),i.framebufferRenderbuffer(i.FRAMEBUFFER,it,i.RENDERBUFFER,j)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Vt(P,_,z){let it=n.get(P);_!==void 0&&Lt(it.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),z!==void 0&&Gt(P)}function re(P){let _=P.texture,z=n.get(P),it=n.get(_);P.addEventListener("dispose",R);let j=P.textures,et=P.isWebGLCubeRenderTarget===!0,It=j.length>1;if(It||(it.__webglTexture===void 0&&(it.__webglTexture=i.createTexture()),it.__version=_.version,o.memory.textures++),et){z.__webglFramebuffer=[];for(let gt=0;gt<6;gt++)if(_.mipmaps&&_.mipmaps.length>0){z.__webglFramebuffer[gt]=[];for(let bt=0;bt<_.mipmaps.length;bt++)z.__webglFramebuffer[gt][bt]=i.createFramebuffer()}else z.__webglFramebuffer[gt]=i.createFramebuffer()}else{if(_.mipmaps&&_.mipmaps.length>0){z.__webglFramebuffer=[];for(let gt=0;gt<_.mipmaps.length;gt++)z.__webglFramebuffer[gt]=i.createFramebuffer()}else z.__webglFramebuffer=i.createFramebuffer();if(It)for(let gt=0,bt=j.length;gt<bt;gt++){let qt=n.get(j[gt]);qt.__webglTexture===void 0&&(qt.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&Jt(P)===!1){z.__webglMultisampledFramebuffer=i.createFramebuffer(),z.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let gt=0;gt<j.length;gt++){let bt=j[gt];z.__webglColorRenderbuffer[gt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,z.__webglColorRenderbuffer[gt]);let qt=r.convert(bt.format,bt.colorSpace),at=r.convert(bt.type),vt=w(bt.internalFormat,qt,at,bt.colorSpace,P.isXRRenderTarget===!0),Bt=ie(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,Bt,vt,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,z.__webglColorRenderbuffer[gt])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(z.__webglDepthRenderbuffer=i.createRenderbuffer(),ut(z.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(et){e.bindTexture(i.TEXTURE_CUBE_MAP,it.__webglTexture),ft(i.TEXTURE_CUBE_MAP,_);for(let gt=0;gt<6;gt++)if(_.mipmaps&&_.mipmaps.length>0)for(let bt=0;bt<_.mipmaps.length;bt++)Lt(z.__webglFramebuffer[gt][bt],P,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,bt);else Lt(z.__webglFramebuffer[gt],P,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,0);m(_)&&p(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(It){for(let gt=0,bt=j.length;gt<bt;gt++){let qt=j[gt],at=n.get(qt);e.bindTexture(i.TEXTURE_2D,at.__webglTexture),ft(i.TEXTURE_2D,qt),Lt(z.__webglFramebuffer,P,qt,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,0),m(qt)&&p(i.TEXTURE_2D)}e.unbindTexture()}else{let gt=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(gt=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(gt,it.__webglTexture),ft(gt,_),_.mipmaps&&_.mipmaps.length>0)for(let bt=0;bt<_.mipmaps.length;bt++)Lt(z.__webglFramebuffer[bt],P,_,i.COLOR_ATTACHMENT0,gt,bt);else Lt(z.__webglFramebuffer,P,_,i.COLOR_ATTACHMENT0,gt,0);m(_)&&p(gt),e.unbindTexture()}P.depthBuffer&&Gt(P)}function te(P){let _=P.textures;for(let z=0,it=_.length;z<it;z++){let j=_[z];if(m(j)){let et=S(P),It=n.get(j).__webglTexture;e.bindTexture(et,It),p(et),e.unbindTexture()}}}let Ee=[],W=[];function rn(P){if(P.samples>0){if(Jt(P)===!1){let _=P.textures,z=P.width,it=P.height,j=i.COLOR_BUFFER_BIT,et=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,It=n.get(P),gt=_.length>1;if(gt)for(let bt=0;bt<_.length;bt++)e.bindFramebuffer(i.FRAMEBUFFER,It.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,It.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,It.__webglMultisampledFramebuffer),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,It.__webglFramebuffer);for(let bt=0;bt<_.length;bt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),gt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,It.__webglColorRenderbuffer[bt]);let qt=n.get(_[bt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,qt,0)}i.blitFramebuffer(0,0,z,it,0,0,z,it,j,i.NEAREST),l===!0&&(Ee.length=0,W.length=0,Ee.push(i.COLOR_ATTACHMENT0+bt),P.depthBuffer&&P.resolveDepthBuffer===!1&&(Ee.push(et),W.push(et),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,W)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ee))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),gt)for(let bt=0;bt<_.length;bt++){e.bindFramebuffer(i.FRAMEBUFFER,It.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.RENDERBUFFER,It.__webglColorRenderbuffer[bt]);let qt=n.get(_[bt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,It.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.TEXTURE_2D,qt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,It.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){let _=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[_])}}}function ie(P){return Math.min(s.maxSamples,P.samples)}function Jt(P){let _=n.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&_.__useRenderToTexture!==!1}function Nt(P){let _=o.render.frame;h.get(P)!==_&&(h.set(P,_),P.update())}function be(P,_){let z=P.colorSpace,it=P.format,j=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||z!==mo&&z!==Ss&&(ve.getTransfer(z)===Pe?(it!==jn||j!==ss)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",z)),_}function kt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=G,this.resetTextureUnits=H,this.setTexture2D=J,this.setTexture2DArray=$,this.setTexture3D=nt,this.setTextureCube=Q,this.rebindTextures=Vt,this.setupRenderTarget=re,this.updateRenderTargetMipmap=te,this.updateMultisampleRenderTarget=rn,this.setupDepthRenderbuffer=Gt,this.setupFrameBufferTexture=Lt,this.useMultisampledRTT=Jt}function RS(i,t){function e(n,s=Ss){let r,o=ve.getTransfer(s);if(n===ss)return i.UNSIGNED_BYTE;if(n===md)return i.UNSIGNED_SHORT_4_4_4_4;if(n===gd)return i.UNSIGNED_SHORT_5_5_5_1;if(n===qm)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Wm)return i.BYTE;if(n===Xm)return i.SHORT;if(n===Qo)return i.UNSIGNED_SHORT;if(n===pd)return i.INT;if(n===tr)return i.UNSIGNED_INT;if(n===Mi)return i.FLOAT;if(n===sa)return i.HALF_FLOAT;if(n===Ym)return i.ALPHA;if(n===$m)return i.RGB;if(n===jn)return i.RGBA;if(n===Zm)return i.LUMINANCE;if(n===Jm)return i.LUMINANCE_ALPHA;if(n===no)return i.DEPTH_COMPONENT;if(n===co)return i.DEPTH_STENCIL;if(n===Km)return i.RED;if(n===vd)return i.RED_INTEGER;if(n===jm)return i.RG;if(n===yd)return i.RG_INTEGER;if(n===xd)return i.RGBA_INTEGER;if(n===ml||n===gl||n===vl||n===yl)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ml)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===gl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===yl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ml)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===gl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===vl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===yl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===eu||n===nu||n===iu||n===su)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===eu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===nu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===iu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===su)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ru||n===ou||n===au)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===ru||n===ou)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===au)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===lu||n===cu||n===hu||n===uu||n===du||n===fu||n===pu||n===mu||n===gu||n===vu||n===yu||n===xu||n===_u||n===bu)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===lu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===cu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===hu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===uu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===du)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===fu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===pu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===mu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===gu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===vu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===yu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===xu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===_u)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===bu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===xl||n===Mu||n===wu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===xl)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Mu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===wu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Qm||n===Su||n===Eu||n===Au)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===xl)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Su)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Eu)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Au)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===lo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Hu=class extends Dn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}},Vn=class extends ti{constructor(){super(),this.isGroup=!0,this.type="Group"}},PS={type:"move"},Jo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Vn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Vn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new N,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new N),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Vn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new N,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new N),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,n),p=this._getHandJoint(c,y);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,g=.005;c.inputState.pinching&&u>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(PS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Vn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},IS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,LS=`
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

}`,Gu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,n){if(this.texture===null){let s=new Un,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=n.depthNear||e.depthFar!=n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new _n({vertexShader:IS,fragmentShader:LS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Mn(new Cs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Wu=class extends rs{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,g=null,y=new Gu,m=e.getContextAttributes(),p=null,S=null,w=[],x=[],D=new _t,C=null,R=new Dn;R.viewport=new We;let U=new Dn;U.viewport=new We;let E=[R,U],b=new Hu,T=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let ct=w[K];return ct===void 0&&(ct=new Jo,w[K]=ct),ct.getTargetRaySpace()},this.getControllerGrip=function(K){let ct=w[K];return ct===void 0&&(ct=new Jo,w[K]=ct),ct.getGripSpace()},this.getHand=function(K){let ct=w[K];return ct===void 0&&(ct=new Jo,w[K]=ct),ct.getHandSpace()};function G(K){let ct=x.indexOf(K.inputSource);if(ct===-1)return;let Lt=w[ct];Lt!==void 0&&(Lt.update(K.inputSource,K.frame,c||o),Lt.dispatchEvent({type:K.type,data:K.inputSource}))}function q(){s.removeEventListener("select",G),s.removeEventListener("selectstart",G),s.removeEventListener("selectend",G),s.removeEventListener("squeeze",G),s.removeEventListener("squeezestart",G),s.removeEventListener("squeezeend",G),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",J);for(let K=0;K<w.length;K++){let ct=x[K];ct!==null&&(x[K]=null,w[K].disconnect(ct))}T=null,H=null,y.reset(),t.setRenderTarget(p),f=null,u=null,d=null,s=null,S=null,Wt.stop(),n.isPresenting=!1,t.setPixelRatio(C),t.setSize(D.width,D.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(p=t.getRenderTarget(),s.addEventListener("select",G),s.addEventListener("selectstart",G),s.addEventListener("selectend",G),s.addEventListener("squeeze",G),s.addEventListener("squeezestart",G),s.addEventListener("squeezeend",G),s.addEventListener("end",q),s.addEventListener("inputsourceschange",J),m.xrCompatible!==!0&&await e.makeXRCompatible(),C=t.getPixelRatio(),t.getSize(D),s.renderState.layers===void 0){let ct={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,ct),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new wi(f.framebufferWidth,f.framebufferHeight,{format:jn,type:ss,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let ct=null,Lt=null,ut=null;m.depth&&(ut=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,ct=m.stencil?co:no,Lt=m.stencil?lo:tr);let Ut={colorFormat:e.RGBA8,depthFormat:ut,scaleFactor:r};d=new XRWebGLBinding(s,e),u=d.createProjectionLayer(Ut),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),S=new wi(u.textureWidth,u.textureHeight,{format:jn,type:ss,depthTexture:new Dl(u.textureWidth,u.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,ct),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Wt.setContext(s),Wt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return y.getDepthTexture()};function J(K){for(let ct=0;ct<K.removed.length;ct++){let Lt=K.removed[ct],ut=x.indexOf(Lt);ut>=0&&(x[ut]=null,w[ut].disconnect(Lt))}for(let ct=0;ct<K.added.length;ct++){let Lt=K.added[ct],ut=x.indexOf(Lt);if(ut===-1){for(let Gt=0;Gt<w.length;Gt++)if(Gt>=x.length){x.push(Lt),ut=Gt;break}else if(x[Gt]===null){x[Gt]=Lt,ut=Gt;break}if(ut===-1)break}let Ut=w[ut];Ut&&Ut.connect(Lt)}}let $=new N,nt=new N;function Q(K,ct,Lt){$.setFromMatrixPosition(ct.matrixWorld),nt.setFromMatrixPosition(Lt.matrixWorld);let ut=$.distanceTo(nt),Ut=ct.projectionMatrix.elements,Gt=Lt.projectionMatrix.elements,Vt=Ut[14]/(Ut[10]-1),re=Ut[14]/(Ut[10]+1),te=(Ut[9]+1)/Ut[5],Ee=(Ut[9]-1)/Ut[5],W=(Ut[8]-1)/Ut[0],rn=(Gt[8]+1)/Gt[0],ie=Vt*W,Jt=Vt*rn,Nt=ut/(-W+rn),be=Nt*-W;if(ct.matrixWorld.decompose(K.position,K.quaternion,K.scale),K.translateX(be),K.translateZ(Nt),K.matrixWorld.compose(K.position,K.quaternion,K.scale),K.matrixWorldInverse.copy(K.matrixWorld).invert(),Ut[10]===-1)K.projectionMatrix.copy(ct.projectionMatrix),K.projectionMatrixInverse.copy(ct.projectionMatrixInverse);else{let kt=Vt+Nt,P=re+Nt,_=ie-be,z=Jt+(ut-be),it=te*re/P*kt,j=Ee*re/P*kt;K.projectionMatrix.makePerspective(_,z,it,j,kt,P),K.projectionMatrixInverse.copy(K.projectionMatrix).invert()}}function ht(K,ct){ct===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(ct.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let ct=K.near,Lt=K.far;y.texture!==null&&(y.depthNear>0&&(ct=y.depthNear),y.depthFar>0&&(Lt=y.depthFar)),b.near=U.near=R.near=ct,b.far=U.far=R.far=Lt,(T!==b.near||H!==b.far)&&(s.updateRenderState({depthNear:b.near,depthFar:b.far}),T=b.near,H=b.far),R.layers.mask=K.layers.mask|2,U.layers.mask=K.layers.mask|4,b.layers.mask=R.layers.mask|U.layers.mask;let ut=K.parent,Ut=b.cameras;ht(b,ut);for(let Gt=0;Gt<Ut.length;Gt++)ht(Ut[Gt],ut);Ut.length===2?Q(b,R,U):b.projectionMatrix.copy(R.projectionMatrix),ot(K,b,ut)};function ot(K,ct,Lt){Lt===null?K.matrix.copy(ct.matrixWorld):(K.matrix.copy(Lt.matrixWorld),K.matrix.invert(),K.matrix.multiply(ct.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(ct.projectionMatrix),K.projectionMatrixInverse.copy(ct.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=ta*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return b},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(K){l=K,u!==null&&(u.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return y.texture!==null},this.getDepthSensingMesh=function(){return y.getMesh(b)};let mt=null;function ft(K,ct){if(h=ct.getViewerPose(c||o),g=ct,h!==null){let Lt=h.views;f!==null&&(t.setRenderTargetFramebuffer(S,f.framebuffer),t.setRenderTarget(S));let ut=!1;Lt.length!==b.cameras.length&&(b.cameras.length=0,ut=!0);for(let Gt=0;Gt<Lt.length;Gt++){let Vt=Lt[Gt],re=null;if(f!==null)re=f.getViewport(Vt);else{let Ee=d.getViewSubImage(u,Vt);re=Ee.viewport,Gt===0&&(t.setRenderTargetTextures(S,Ee.colorTexture,u.ignoreDepthValues?void 0:Ee.depthStencilTexture),t.setRenderTarget(S))}let te=E[Gt];te===void 0&&(te=new Dn,te.layers.enable(Gt),te.viewport=new We,E[Gt]=te),te.matrix.fromArray(Vt.transform.matrix),te.matrix.decompose(te.position,te.quaternion,te.scale),te.projectionMatrix.fromArray(Vt.projectionMatrix),te.projectionMatrixInverse.copy(te.projectionMatrix).invert(),te.viewport.set(re.x,re.y,re.width,re.height),Gt===0&&(b.matrix.copy(te.matrix),b.matrix.decompose(b.position,b.quaternion,b.scale)),ut===!0&&b.cameras.push(te)}let Ut=s.enabledFeatures;if(Ut&&Ut.includes("depth-sensing")){let Gt=d.getDepthInformation(Lt[0]);Gt&&Gt.isValid&&Gt.texture&&y.init(t,Gt,s.renderState)}}for(let Lt=0;Lt<w.length;Lt++){let ut=x[Lt],Ut=w[Lt];ut!==null&&Ut!==void 0&&Ut.update(ut,ct,c||o)}mt&&mt(K,ct),ct.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ct}),g=null}let Wt=new lg;Wt.setAnimationLoop(ft),this.setAnimationLoop=function(K){mt=K},this.dispose=function(){}}},Ys=new os,DS=new Je;function US(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,ag(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,S,w,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),d(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p)):p.isMeshStandardMaterial?(r(m,p),u(m,p),p.isMeshPhysicalMaterial&&f(m,p,x)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),y(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,S,w):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Hn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Hn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let S=t.get(p),w=S.envMap,x=S.envMapRotation;w&&(m.envMap.value=w,Ys.copy(x),Ys.x*=-1,Ys.y*=-1,Ys.z*=-1,w.isCubeTexture&&w.isRenderTargetTexture===!1&&(Ys.y*=-1,Ys.z*=-1),m.envMapRotation.value.setFromMatrix4(DS.makeRotationFromEuler(Ys)),m.flipEnvMap.value=w.isCubeTexture&&w.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,S,w){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*S,m.scale.value=w*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function d(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function u(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,S){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Hn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=S.texture,m.transmissionSamplerSize.value.set(S.width,S.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function y(m,p){let S=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(S.matrixWorld),m.nearDistance.value=S.shadow.camera.near,m.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function NS(i,t,e,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(S,w){let x=w.program;n.uniformBlockBinding(S,x)}function c(S,w){let x=s[S.id];x===void 0&&(g(S),x=h(S),s[S.id]=x,S.addEventListener("dispose",m));let D=w.program;n.updateUBOMapping(S,D);let C=t.render.frame;r[S.id]!==C&&(u(S),r[S.id]=C)}function h(S){let w=d();S.__bindingPointIndex=w;let x=i.createBuffer(),D=S.__size,C=S.usage;return i.bindBuffer(i.UNIFORM_BUFFER,x),i.bufferData(i.UNIFORM_BUFFER,D,C),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,w,x),x}function d(){for(let S=0;S<a;S++)if(o.indexOf(S)===-1)return o.push(S),S;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function u(S){let w=s[S.id],x=S.uniforms,D=S.__cache;i.bindBuffer(i.UNIFORM_BUFFER,w);for(let C=0,R=x.length;C<R;C++){let U=Array.isArray(x[C])?x[C]:[x[C]];for(let E=0,b=U.length;E<b;E++){let T=U[E];if(f(T,C,E,D)===!0){let H=T.__offset,G=Array.isArray(T.value)?T.value:[T.value],q=0;for(let J=0;J<G.length;J++){let $=G[J],nt=y($);typeof $=="number"||typeof $=="boolean"?(T.__data[0]=$,i.bufferSubData(i.UNIFORM_BUFFER,H+q,T.__data)):$.isMatrix3?(T.__data[0]=$.elements[0],T.__data[1]=$.elements[1],T.__data[2]=$.elements[2],T.__data[3]=0,T.__data[4]=$.elements[3],T.__data[5]=$.elements[4],T.__data[6]=$.elements[5],T.__data[7]=0,T.__data[8]=$.elements[6],T.__data[9]=$.elements[7],T.__data[10]=$.elements[8],T.__data[11]=0):($.toArray(T.__data,q),q+=nt.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,H,T.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function f(S,w,x,D){let C=S.value,R=w+"_"+x;if(D[R]===void 0)return typeof C=="number"||typeof C=="boolean"?D[R]=C:D[R]=C.clone(),!0;{let U=D[R];if(typeof C=="number"||typeof C=="boolean"){if(U!==C)return D[R]=C,!0}else if(U.equals(C)===!1)return U.copy(C),!0}return!1}function g(S){let w=S.uniforms,x=0,D=16;for(let R=0,U=w.length;R<U;R++){let E=Array.isArray(w[R])?w[R]:[w[R]];for(let b=0,T=E.length;b<T;b++){let H=E[b],G=Array.isArray(H.value)?H.value:[H.value];for(let q=0,J=G.length;q<J;q++){let $=G[q],nt=y($),Q=x%D,ht=Q%nt.boundary,ot=Q+ht;x+=ht,ot!==0&&D-ot<nt.storage&&(x+=D-ot),H.__data=new Float32Array(nt.storage/Float32Array.BYTES_PER_ELEMENT),H.__offset=x,x+=nt.storage}}}let C=x%D;return C>0&&(x+=D-C),S.__size=x,S.__cache={},this}function y(S){let w={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(w.boundary=4,w.storage=4):S.isVector2?(w.boundary=8,w.storage=8):S.isVector3||S.isColor?(w.boundary=16,w.storage=12):S.isVector4?(w.boundary=16,w.storage=16):S.isMatrix3?(w.boundary=48,w.storage=48):S.isMatrix4?(w.boundary=64,w.storage=64):S.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",S),w}function m(S){let w=S.target;w.removeEventListener("dispose",m);let x=o.indexOf(w.__bindingPointIndex);o.splice(x,1),i.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(let S in s)i.deleteBuffer(s[S]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}var Ul=class{constructor(t={}){let{canvas:e=Bx(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reverseDepthBuffer:u=!1}=t;this.isWebGLRenderer=!0;let f;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=n.getContextAttributes().alpha}else f=o;let g=new Uint32Array(4),y=new Int32Array(4),m=null,p=null,S=[],w=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=ci,this.toneMapping=As,this.toneMappingExposure=1;let x=this,D=!1,C=0,R=0,U=null,E=-1,b=null,T=new We,H=new We,G=null,q=new le(0),J=0,$=e.width,nt=e.height,Q=1,ht=null,ot=null,mt=new We(0,0,$,nt),ft=new We(0,0,$,nt),Wt=!1,K=new Il,ct=!1,Lt=!1,ut=new Je,Ut=new Je,Gt=new N,Vt=new We,re={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},te=!1;function Ee(){return U===null?Q:1}let W=n;function rn(A,k){return e.getContext(A,k)}try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${fd}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",Et,!1),e.addEventListener("webglcontextcreationerror",St,!1),W===null){let k="webgl2";if(W=rn(k,A),W===null)throw rn(k)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(A){throw console.error("THREE.WebGLRenderer: "+A.message),A}let ie,Jt,Nt,be,kt,P,_,z,it,j,et,It,gt,bt,qt,at,vt,Bt,Ht,wt,ee,Yt,xe,O;function yt(){ie=new KM(W),ie.init(),Yt=new RS(W,ie),Jt=new XM(W,ie,t,Yt),Nt=new AS(W,ie),Jt.reverseDepthBuffer&&u&&Nt.buffers.depth.setReversed(!0),be=new tw(W),kt=new fS,P=new CS(W,ie,Nt,kt,Jt,Yt,be),_=new YM(x),z=new JM(x),it=new a_(W),xe=new GM(W,it),j=new jM(W,it,be,xe),et=new nw(W,j,it,be),Ht=new ew(W,Jt,P),at=new qM(kt),It=new dS(x,_,z,ie,Jt,xe,at),gt=new US(x,kt),bt=new mS,qt=new bS(ie),Bt=new HM(x,_,z,Nt,et,f,l),vt=new SS(x,et,Jt),O=new NS(W,be,Jt,Nt),wt=new WM(W,ie,be),ee=new QM(W,ie,be),be.programs=It.programs,x.capabilities=Jt,x.extensions=ie,x.properties=kt,x.renderLists=bt,x.shadowMap=vt,x.state=Nt,x.info=be}yt();let tt=new Wu(x,W);this.xr=tt,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let A=ie.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=ie.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(A){A!==void 0&&(Q=A,this.setSize($,nt,!1))},this.getSize=function(A){return A.set($,nt)},this.setSize=function(A,k,X=!0){if(tt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}$=A,nt=k,e.width=Math.floor(A*Q),e.height=Math.floor(k*Q),X===!0&&(e.style.width=A+"px",e.style.height=k+"px"),this.setViewport(0,0,A,k)},this.getDrawingBufferSize=function(A){return A.set($*Q,nt*Q).floor()},this.setDrawingBufferSize=function(A,k,X){$=A,nt=k,Q=X,e.width=Math.floor(A*X),e.height=Math.floor(k*X),this.setViewport(0,0,A,k)},this.getCurrentViewport=function(A){return A.copy(T)},this.getViewport=function(A){return A.copy(mt)},this.setViewport=function(A,k,X,Z){A.isVector4?mt.set(A.x,A.y,A.z,A.w):mt.set(A,k,X,Z),Nt.viewport(T.copy(mt).multiplyScalar(Q).round())},this.getScissor=function(A){return A.copy(ft)},this.setScissor=function(A,k,X,Z){A.isVector4?ft.set(A.x,A.y,A.z,A.w):ft.set(A,k,X,Z),Nt.scissor(H.copy(ft).multiplyScalar(Q).round())},this.getScissorTest=function(){return Wt},this.setScissorTest=function(A){Nt.setScissorTest(Wt=A)},this.setOpaqueSort=function(A){ht=A},this.setTransparentSort=function(A){ot=A},this.getClearColor=function(A){return A.copy(Bt.getClearColor())},this.setClearColor=function(){Bt.setClearColor.apply(Bt,arguments)},this.getClearAlpha=function(){return Bt.getClearAlpha()},this.setClearAlpha=function(){Bt.setClearAlpha.apply(Bt,arguments)},this.clear=function(A=!0,k=!0,X=!0){let Z=0;if(A){let V=!1;if(U!==null){let dt=U.texture.format;V=dt===xd||dt===yd||dt===vd}if(V){let dt=U.texture.type,Mt=dt===ss||dt===tr||dt===Qo||dt===lo||dt===md||dt===gd,Ft=Bt.getClearColor(),Dt=Bt.getClearAlpha(),Xt=Ft.r,$t=Ft.g,Ot=Ft.b;Mt?(g[0]=Xt,g[1]=$t,g[2]=Ot,g[3]=Dt,W.clearBufferuiv(W.COLOR,0,g)):(y[0]=Xt,y[1]=$t,y[2]=Ot,y[3]=Dt,W.clearBufferiv(W.COLOR,0,y))}else Z|=W.COLOR_BUFFER_BIT}k&&(Z|=W.DEPTH_BUFFER_BIT),X&&(Z|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),W.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",Et,!1),e.removeEventListener("webglcontextcreationerror",St,!1),bt.dispose(),qt.dispose(),kt.dispose(),_.dispose(),z.dispose(),et.dispose(),xe.dispose(),O.dispose(),It.dispose(),tt.dispose(),tt.removeEventListener("sessionstart",zi),tt.removeEventListener("sessionend",Vi),je.stop()};function rt(A){A.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),D=!0}function Et(){console.log("THREE.WebGLRenderer: Context Restored."),D=!1;let A=be.autoReset,k=vt.enabled,X=vt.autoUpdate,Z=vt.needsUpdate,V=vt.type;yt(),be.autoReset=A,vt.enabled=k,vt.autoUpdate=X,vt.needsUpdate=Z,vt.type=V}function St(A){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function Kt(A){let k=A.target;k.removeEventListener("dispose",Kt),Ve(k)}function Ve(A){Ct(A),kt.remove(A)}function Ct(A){let k=kt.get(A).programs;k!==void 0&&(k.forEach(function(X){It.releaseProgram(X)}),A.isShaderMaterial&&It.releaseShaderCache(A))}this.renderBufferDirect=function(A,k,X,Z,V,dt){k===null&&(k=re);let Mt=V.isMesh&&V.matrixWorld.determinant()<0,Ft=Is(A,k,X,Z,V);Nt.setMaterial(Z,Mt);let Dt=X.index,Xt=1;if(Z.wireframe===!0){if(Dt=j.getWireframeAttribute(X),Dt===void 0)return;Xt=2}let $t=X.drawRange,Ot=X.attributes.position,ce=$t.start*Xt,Me=($t.start+$t.count)*Xt;dt!==null&&(ce=Math.max(ce,dt.start*Xt),Me=Math.min(Me,(dt.start+dt.count)*Xt)),Dt!==null?(ce=Math.max(ce,0),Me=Math.min(Me,Dt.count)):Ot!=null&&(ce=Math.max(ce,0),Me=Math.min(Me,Ot.count));let Se=Me-ce;if(Se<0||Se===1/0)return;xe.setup(V,Z,Ft,X,Dt);let mn,me=wt;if(Dt!==null&&(mn=it.get(Dt),me=ee,me.setIndex(mn)),V.isMesh)Z.wireframe===!0?(Nt.setLineWidth(Z.wireframeLinewidth*Ee()),me.setMode(W.LINES)):me.setMode(W.TRIANGLES);else if(V.isLine){let Rt=Z.linewidth;Rt===void 0&&(Rt=1),Nt.setLineWidth(Rt*Ee()),V.isLineSegments?me.setMode(W.LINES):V.isLineLoop?me.setMode(W.LINE_LOOP):me.setMode(W.LINE_STRIP)}else V.isPoints?me.setMode(W.POINTS):V.isSprite&&me.setMode(W.TRIANGLES);if(V.isBatchedMesh)if(V._multiDrawInstances!==null)me.renderMultiDrawInstances(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount,V._multiDrawInstances);else if(ie.get("WEBGL_multi_draw"))me.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let Rt=V._multiDrawStarts,ei=V._multiDrawCounts,ge=V._multiDrawCount,An=Dt?it.get(Dt).bytesPerElement:1,Gi=kt.get(Z).currentProgram.getUniforms();for(let Tn=0;Tn<ge;Tn++)Gi.setValue(W,"_gl_DrawID",Tn),me.render(Rt[Tn]/An,ei[Tn])}else if(V.isInstancedMesh)me.renderInstances(ce,Se,V.count);else if(X.isInstancedBufferGeometry){let Rt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,ei=Math.min(X.instanceCount,Rt);me.renderInstances(ce,Se,ei)}else me.render(ce,Se)};function oe(A,k,X){A.transparent===!0&&A.side===hi&&A.forceSinglePass===!1?(A.side=Hn,A.needsUpdate=!0,mr(A,k,X),A.side=Fi,A.needsUpdate=!0,mr(A,k,X),A.side=hi):mr(A,k,X)}this.compile=function(A,k,X=null){X===null&&(X=A),p=qt.get(X),p.init(k),w.push(p),X.traverseVisible(function(V){V.isLight&&V.layers.test(k.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),A!==X&&A.traverseVisible(function(V){V.isLight&&V.layers.test(k.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),p.setupLights();let Z=new Set;return A.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let dt=V.material;if(dt)if(Array.isArray(dt))for(let Mt=0;Mt<dt.length;Mt++){let Ft=dt[Mt];oe(Ft,X,V),Z.add(Ft)}else oe(dt,X,V),Z.add(dt)}),w.pop(),p=null,Z},this.compileAsync=function(A,k,X=null){let Z=this.compile(A,k,X);return new Promise(V=>{function dt(){if(Z.forEach(function(Mt){kt.get(Mt).currentProgram.isReady()&&Z.delete(Mt)}),Z.size===0){V(A);return}setTimeout(dt,10)}ie.get("KHR_parallel_shader_compile")!==null?dt():setTimeout(dt,10)})};let Ae=null;function pn(A){Ae&&Ae(A)}function zi(){je.stop()}function Vi(){je.start()}let je=new lg;je.setAnimationLoop(pn),typeof self<"u"&&je.setContext(self),this.setAnimationLoop=function(A){Ae=A,tt.setAnimationLoop(A),A===null?je.stop():je.start()},tt.addEventListener("sessionstart",zi),tt.addEventListener("sessionend",Vi),this.render=function(A,k){if(k!==void 0&&k.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),tt.enabled===!0&&tt.isPresenting===!0&&(tt.cameraAutoUpdate===!0&&tt.updateCamera(k),k=tt.getCamera()),A.isScene===!0&&A.onBeforeRender(x,A,k,U),p=qt.get(A,w.length),p.init(k),w.push(p),Ut.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),K.setFromProjectionMatrix(Ut),Lt=this.localClippingEnabled,ct=at.init(this.clippingPlanes,Lt),m=bt.get(A,S.length),m.init(),S.push(m),tt.enabled===!0&&tt.isPresenting===!0){let dt=x.xr.getDepthSensingMesh();dt!==null&&Ai(dt,k,-1/0,x.sortObjects)}Ai(A,k,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(ht,ot),te=tt.enabled===!1||tt.isPresenting===!1||tt.hasDepthSensing()===!1,te&&Bt.addToRenderList(m,A),this.info.render.frame++,ct===!0&&at.beginShadows();let X=p.state.shadowsArray;vt.render(X,A,k),ct===!0&&at.endShadows(),this.info.autoReset===!0&&this.info.reset();let Z=m.opaque,V=m.transmissive;if(p.setupLights(),k.isArrayCamera){let dt=k.cameras;if(V.length>0)for(let Mt=0,Ft=dt.length;Mt<Ft;Mt++){let Dt=dt[Mt];So(Z,V,A,Dt)}te&&Bt.render(A);for(let Mt=0,Ft=dt.length;Mt<Ft;Mt++){let Dt=dt[Mt];Hi(m,A,Dt,Dt.viewport)}}else V.length>0&&So(Z,V,A,k),te&&Bt.render(A),Hi(m,A,k);U!==null&&(P.updateMultisampleRenderTarget(U),P.updateRenderTargetMipmap(U)),A.isScene===!0&&A.onAfterRender(x,A,k),xe.resetDefaultState(),E=-1,b=null,w.pop(),w.length>0?(p=w[w.length-1],ct===!0&&at.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,S.pop(),S.length>0?m=S[S.length-1]:m=null};function Ai(A,k,X,Z){if(A.visible===!1)return;if(A.layers.test(k.layers)){if(A.isGroup)X=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(k);else if(A.isLight)p.pushLight(A),A.castShadow&&p.pushShadow(A);else if(A.isSprite){if(!A.frustumCulled||K.intersectsSprite(A)){Z&&Vt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ut);let Mt=et.update(A),Ft=A.material;Ft.visible&&m.push(A,Mt,Ft,X,Vt.z,null)}}else if((A.isMesh||A.isLine||A.isPoints)&&(!A.frustumCulled||K.intersectsObject(A))){let Mt=et.update(A),Ft=A.material;if(Z&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),Vt.copy(A.boundingSphere.center)):(Mt.boundingSphere===null&&Mt.computeBoundingSphere(),Vt.copy(Mt.boundingSphere.center)),Vt.applyMatrix4(A.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ft)){let Dt=Mt.groups;for(let Xt=0,$t=Dt.length;Xt<$t;Xt++){let Ot=Dt[Xt],ce=Ft[Ot.materialIndex];ce&&ce.visible&&m.push(A,Mt,ce,X,Vt.z,Ot)}}else Ft.visible&&m.push(A,Mt,Ft,X,Vt.z,null)}}let dt=A.children;for(let Mt=0,Ft=dt.length;Mt<Ft;Mt++)Ai(dt[Mt],k,X,Z)}function Hi(A,k,X,Z){let V=A.opaque,dt=A.transmissive,Mt=A.transparent;p.setupLightsView(X),ct===!0&&at.setGlobalState(x.clippingPlanes,X),Z&&Nt.viewport(T.copy(Z)),V.length>0&&Ps(V,k,X),dt.length>0&&Ps(dt,k,X),Mt.length>0&&Ps(Mt,k,X),Nt.buffers.depth.setTest(!0),Nt.buffers.depth.setMask(!0),Nt.buffers.color.setMask(!0),Nt.setPolygonOffset(!1)}function So(A,k,X,Z){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[Z.id]===void 0&&(p.state.transmissionRenderTarget[Z.id]=new wi(1,1,{generateMipmaps:!0,type:ie.has("EXT_color_buffer_half_float")||ie.has("EXT_color_buffer_float")?sa:ss,minFilter:Qs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ve.workingColorSpace}));let dt=p.state.transmissionRenderTarget[Z.id],Mt=Z.viewport||T;dt.setSize(Mt.z,Mt.w);let Ft=x.getRenderTarget();x.setRenderTarget(dt),x.getClearColor(q),J=x.getClearAlpha(),J<1&&x.setClearColor(16777215,.5),x.clear(),te&&Bt.render(X);let Dt=x.toneMapping;x.toneMapping=As;let Xt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),p.setupLightsView(Z),ct===!0&&at.setGlobalState(x.clippingPlanes,Z),Ps(A,X,Z),P.updateMultisampleRenderTarget(dt),P.updateRenderTargetMipmap(dt),ie.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let Ot=0,ce=k.length;Ot<ce;Ot++){let Me=k[Ot],Se=Me.object,mn=Me.geometry,me=Me.material,Rt=Me.group;if(me.side===hi&&Se.layers.test(Z.layers)){let ei=me.side;me.side=Hn,me.needsUpdate=!0,da(Se,X,Z,mn,me,Rt),me.side=ei,me.needsUpdate=!0,$t=!0}}$t===!0&&(P.updateMultisampleRenderTarget(dt),P.updateRenderTargetMipmap(dt))}x.setRenderTarget(Ft),x.setClearColor(q,J),Xt!==void 0&&(Z.viewport=Xt),x.toneMapping=Dt}function Ps(A,k,X){let Z=k.isScene===!0?k.overrideMaterial:null;for(let V=0,dt=A.length;V<dt;V++){let Mt=A[V],Ft=Mt.object,Dt=Mt.geometry,Xt=Z===null?Mt.material:Z,$t=Mt.group;Ft.layers.test(X.layers)&&da(Ft,k,X,Dt,Xt,$t)}}function da(A,k,X,Z,V,dt){A.onBeforeRender(x,k,X,Z,V,dt),A.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),V.onBeforeRender(x,k,X,Z,A,dt),V.transparent===!0&&V.side===hi&&V.forceSinglePass===!1?(V.side=Hn,V.needsUpdate=!0,x.renderBufferDirect(X,k,Z,V,A,dt),V.side=Fi,V.needsUpdate=!0,x.renderBufferDirect(X,k,Z,V,A,dt),V.side=hi):x.renderBufferDirect(X,k,Z,V,A,dt),A.onAfterRender(x,k,X,Z,V,dt)}function mr(A,k,X){k.isScene!==!0&&(k=re);let Z=kt.get(A),V=p.state.lights,dt=p.state.shadowsArray,Mt=V.state.version,Ft=It.getParameters(A,V.state,dt,k,X),Dt=It.getProgramCacheKey(Ft),Xt=Z.programs;Z.environment=A.isMeshStandardMaterial?k.environment:null,Z.fog=k.fog,Z.envMap=(A.isMeshStandardMaterial?z:_).get(A.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&A.envMap===null?k.environmentRotation:A.envMapRotation,Xt===void 0&&(A.addEventListener("dispose",Kt),Xt=new Map,Z.programs=Xt);let $t=Xt.get(Dt);if($t!==void 0){if(Z.currentProgram===$t&&Z.lightsStateVersion===Mt)return fa(A,Ft),$t}else Ft.uniforms=It.getUniforms(A),A.onBeforeCompile(Ft,x),$t=It.acquireProgram(Ft,Dt),Xt.set(Dt,$t),Z.uniforms=Ft.uniforms;let Ot=Z.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ot.clippingPlanes=at.uniform),fa(A,Ft),Z.needsLights=Ci(A),Z.lightsStateVersion=Mt,Z.needsLights&&(Ot.ambientLightColor.value=V.state.ambient,Ot.lightProbe.value=V.state.probe,Ot.directionalLights.value=V.state.directional,Ot.directionalLightShadows.value=V.state.directionalShadow,Ot.spotLights.value=V.state.spot,Ot.spotLightShadows.value=V.state.spotShadow,Ot.rectAreaLights.value=V.state.rectArea,Ot.ltc_1.value=V.state.rectAreaLTC1,Ot.ltc_2.value=V.state.rectAreaLTC2,Ot.pointLights.value=V.state.point,Ot.pointLightShadows.value=V.state.pointShadow,Ot.hemisphereLights.value=V.state.hemi,Ot.directionalShadowMap.value=V.state.directionalShadowMap,Ot.directionalShadowMatrix.value=V.state.directionalShadowMatrix,Ot.spotShadowMap.value=V.state.spotShadowMap,Ot.spotLightMatrix.value=V.state.spotLightMatrix,Ot.spotLightMap.value=V.state.spotLightMap,Ot.pointShadowMap.value=V.state.pointShadowMap,Ot.pointShadowMatrix.value=V.state.pointShadowMatrix),Z.currentProgram=$t,Z.uniformsList=null,$t}function Ti(A){if(A.uniformsList===null){let k=A.currentProgram.getUniforms();A.uniformsList=so.seqWithValue(k.seq,A.uniforms)}return A.uniformsList}function fa(A,k){let X=kt.get(A);X.outputColorSpace=k.outputColorSpace,X.batching=k.batching,X.batchingColor=k.batchingColor,X.instancing=k.instancing,X.instancingColor=k.instancingColor,X.instancingMorph=k.instancingMorph,X.skinning=k.skinning,X.morphTargets=k.morphTargets,X.morphNormals=k.morphNormals,X.morphColors=k.morphColors,X.morphTargetsCount=k.morphTargetsCount,X.numClippingPlanes=k.numClippingPlanes,X.numIntersection=k.numClipIntersection,X.vertexAlphas=k.vertexAlphas,X.vertexTangents=k.vertexTangents,X.toneMapping=k.toneMapping}function Is(A,k,X,Z,V){k.isScene!==!0&&(k=re),P.resetTextureUnits();let dt=k.fog,Mt=Z.isMeshStandardMaterial?k.environment:null,Ft=U===null?x.outputColorSpace:U.isXRRenderTarget===!0?U.texture.colorSpace:mo,Dt=(Z.isMeshStandardMaterial?z:_).get(Z.envMap||Mt),Xt=Z.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,$t=!!X.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ot=!!X.morphAttributes.position,ce=!!X.morphAttributes.normal,Me=!!X.morphAttributes.color,Se=As;Z.toneMapped&&(U===null||U.isXRRenderTarget===!0)&&(Se=x.toneMapping);let mn=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,me=mn!==void 0?mn.length:0,Rt=kt.get(Z),ei=p.state.lights;if(ct===!0&&(Lt===!0||A!==b)){let Fn=A===b&&Z.id===E;at.setState(Z,A,Fn)}let ge=!1;Z.version===Rt.__version?(Rt.needsLights&&Rt.lightsStateVersion!==ei.state.version||Rt.outputColorSpace!==Ft||V.isBatchedMesh&&Rt.batching===!1||!V.isBatchedMesh&&Rt.batching===!0||V.isBatchedMesh&&Rt.batchingColor===!0&&V.colorTexture===null||V.isBatchedMesh&&Rt.batchingColor===!1&&V.colorTexture!==null||V.isInstancedMesh&&Rt.instancing===!1||!V.isInstancedMesh&&Rt.instancing===!0||V.isSkinnedMesh&&Rt.skinning===!1||!V.isSkinnedMesh&&Rt.skinning===!0||V.isInstancedMesh&&Rt.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Rt.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Rt.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Rt.instancingMorph===!1&&V.morphTexture!==null||Rt.envMap!==Dt||Z.fog===!0&&Rt.fog!==dt||Rt.numClippingPlanes!==void 0&&(Rt.numClippingPlanes!==at.numPlanes||Rt.numIntersection!==at.numIntersection)||Rt.vertexAlphas!==Xt||Rt.vertexTangents!==$t||Rt.morphTargets!==Ot||Rt.morphNormals!==ce||Rt.morphColors!==Me||Rt.toneMapping!==Se||Rt.morphTargetsCount!==me)&&(ge=!0):(ge=!0,Rt.__version=Z.version);let An=Rt.currentProgram;ge===!0&&(An=mr(Z,k,V));let Gi=!1,Tn=!1,Ls=!1,Le=An.getUniforms(),Xn=Rt.uniforms;if(Nt.useProgram(An.program)&&(Gi=!0,Tn=!0,Ls=!0),Z.id!==E&&(E=Z.id,Tn=!0),Gi||b!==A){Nt.buffers.depth.getReversed()?(ut.copy(A.projectionMatrix),Vx(ut),Hx(ut),Le.setValue(W,"projectionMatrix",ut)):Le.setValue(W,"projectionMatrix",A.projectionMatrix),Le.setValue(W,"viewMatrix",A.matrixWorldInverse);let fi=Le.map.cameraPosition;fi!==void 0&&fi.setValue(W,Gt.setFromMatrixPosition(A.matrixWorld)),Jt.logarithmicDepthBuffer&&Le.setValue(W,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&Le.setValue(W,"isOrthographic",A.isOrthographicCamera===!0),b!==A&&(b=A,Tn=!0,Ls=!0)}if(V.isSkinnedMesh){Le.setOptional(W,V,"bindMatrix"),Le.setOptional(W,V,"bindMatrixInverse");let Fn=V.skeleton;Fn&&(Fn.boneTexture===null&&Fn.computeBoneTexture(),Le.setValue(W,"boneTexture",Fn.boneTexture,P))}V.isBatchedMesh&&(Le.setOptional(W,V,"batchingTexture"),Le.setValue(W,"batchingTexture",V._matricesTexture,P),Le.setOptional(W,V,"batchingIdTexture"),Le.setValue(W,"batchingIdTexture",V._indirectTexture,P),Le.setOptional(W,V,"batchingColorTexture"),V._colorsTexture!==null&&Le.setValue(W,"batchingColorTexture",V._colorsTexture,P));let cs=X.morphAttributes;if((cs.position!==void 0||cs.normal!==void 0||cs.color!==void 0)&&Ht.update(V,X,An),(Tn||Rt.receiveShadow!==V.receiveShadow)&&(Rt.receiveShadow=V.receiveShadow,Le.setValue(W,"receiveShadow",V.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(Xn.envMap.value=Dt,Xn.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&k.environment!==null&&(Xn.envMapIntensity.value=k.environmentIntensity),Tn&&(Le.setValue(W,"toneMappingExposure",x.toneMappingExposure),Rt.needsLights&&pa(Xn,Ls),dt&&Z.fog===!0&&gt.refreshFogUniforms(Xn,dt),gt.refreshMaterialUniforms(Xn,Z,Q,nt,p.state.transmissionRenderTarget[A.id]),so.upload(W,Ti(Rt),Xn,P)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(so.upload(W,Ti(Rt),Xn,P),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&Le.setValue(W,"center",V.center),Le.setValue(W,"modelViewMatrix",V.modelViewMatrix),Le.setValue(W,"normalMatrix",V.normalMatrix),Le.setValue(W,"modelMatrix",V.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){let Fn=Z.uniformsGroups;for(let fi=0,ni=Fn.length;fi<ni;fi++){let Ds=Fn[fi];O.update(Ds,An),O.bind(Ds,An)}}return An}function pa(A,k){A.ambientLightColor.needsUpdate=k,A.lightProbe.needsUpdate=k,A.directionalLights.needsUpdate=k,A.directionalLightShadows.needsUpdate=k,A.pointLights.needsUpdate=k,A.pointLightShadows.needsUpdate=k,A.spotLights.needsUpdate=k,A.spotLightShadows.needsUpdate=k,A.rectAreaLights.needsUpdate=k,A.hemisphereLights.needsUpdate=k}function Ci(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return C},this.getActiveMipmapLevel=function(){return R},this.getRenderTarget=function(){return U},this.setRenderTargetTextures=function(A,k,X){kt.get(A.texture).__webglTexture=k,kt.get(A.depthTexture).__webglTexture=X;let Z=kt.get(A);Z.__hasExternalTextures=!0,Z.__autoAllocateDepthBuffer=X===void 0,Z.__autoAllocateDepthBuffer||ie.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),Z.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(A,k){let X=kt.get(A);X.__webglFramebuffer=k,X.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(A,k=0,X=0){U=A,C=k,R=X;let Z=!0,V=null,dt=!1,Mt=!1;if(A){let Dt=kt.get(A);if(Dt.__useDefaultFramebuffer!==void 0)Nt.bindFramebuffer(W.FRAMEBUFFER,null),Z=!1;else if(Dt.__webglFramebuffer===void 0)P.setupRenderTarget(A);else if(Dt.__hasExternalTextures)P.rebindTextures(A,kt.get(A.texture).__webglTexture,kt.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let Ot=A.depthTexture;if(Dt.__boundDepthTexture!==Ot){if(Ot!==null&&kt.has(Ot)&&(A.width!==Ot.image.width||A.height!==Ot.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(A)}}let Xt=A.texture;(Xt.isData3DTexture||Xt.isDataArrayTexture||Xt.isCompressedArrayTexture)&&(Mt=!0);let $t=kt.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray($t[k])?V=$t[k][X]:V=$t[k],dt=!0):A.samples>0&&P.useMultisampledRTT(A)===!1?V=kt.get(A).__webglMultisampledFramebuffer:Array.isArray($t)?V=$t[X]:V=$t,T.copy(A.viewport),H.copy(A.scissor),G=A.scissorTest}else T.copy(mt).multiplyScalar(Q).floor(),H.copy(ft).multiplyScalar(Q).floor(),G=Wt;if(Nt.bindFramebuffer(W.FRAMEBUFFER,V)&&Z&&Nt.drawBuffers(A,V),Nt.viewport(T),Nt.scissor(H),Nt.setScissorTest(G),dt){let Dt=kt.get(A.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+k,Dt.__webglTexture,X)}else if(Mt){let Dt=kt.get(A.texture),Xt=k||0;W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,Dt.__webglTexture,X||0,Xt)}E=-1},this.readRenderTargetPixels=function(A,k,X,Z,V,dt,Mt){if(!(A&&A.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=kt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Mt!==void 0&&(Ft=Ft[Mt]),Ft){Nt.bindFramebuffer(W.FRAMEBUFFER,Ft);try{let Dt=A.texture,Xt=Dt.format,$t=Dt.type;if(!Jt.textureFormatReadable(Xt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Jt.textureTypeReadable($t)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=A.width-Z&&X>=0&&X<=A.height-V&&W.readPixels(k,X,Z,V,Yt.convert(Xt),Yt.convert($t),dt)}finally{let Dt=U!==null?kt.get(U).__webglFramebuffer:null;Nt.bindFramebuffer(W.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(A,k,X,Z,V,dt,Mt){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=kt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Mt!==void 0&&(Ft=Ft[Mt]),Ft){let Dt=A.texture,Xt=Dt.format,$t=Dt.type;if(!Jt.textureFormatReadable(Xt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Jt.textureTypeReadable($t))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(k>=0&&k<=A.width-Z&&X>=0&&X<=A.height-V){Nt.bindFramebuffer(W.FRAMEBUFFER,Ft);let Ot=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,Ot),W.bufferData(W.PIXEL_PACK_BUFFER,dt.byteLength,W.STREAM_READ),W.readPixels(k,X,Z,V,Yt.convert(Xt),Yt.convert($t),0);let ce=U!==null?kt.get(U).__webglFramebuffer:null;Nt.bindFramebuffer(W.FRAMEBUFFER,ce);let Me=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await zx(W,Me,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,Ot),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,dt),W.deleteBuffer(Ot),W.deleteSync(Me),dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(A,k=null,X=0){A.isTexture!==!0&&(qo("WebGLRenderer: copyFramebufferToTexture function signature has changed."),k=arguments[0]||null,A=arguments[1]);let Z=Math.pow(2,-X),V=Math.floor(A.image.width*Z),dt=Math.floor(A.image.height*Z),Mt=k!==null?k.x:0,Ft=k!==null?k.y:0;P.setTexture2D(A,0),W.copyTexSubImage2D(W.TEXTURE_2D,X,0,0,Mt,Ft,V,dt),Nt.unbindTexture()},this.copyTextureToTexture=function(A,k,X=null,Z=null,V=0){A.isTexture!==!0&&(qo("WebGLRenderer: copyTextureToTexture function signature has changed."),Z=arguments[0]||null,A=arguments[1],k=arguments[2],V=arguments[3]||0,X=null);let dt,Mt,Ft,Dt,Xt,$t,Ot,ce,Me,Se=A.isCompressedTexture?A.mipmaps[V]:A.image;X!==null?(dt=X.max.x-X.min.x,Mt=X.max.y-X.min.y,Ft=X.isBox3?X.max.z-X.min.z:1,Dt=X.min.x,Xt=X.min.y,$t=X.isBox3?X.min.z:0):(dt=Se.width,Mt=Se.height,Ft=Se.depth||1,Dt=0,Xt=0,$t=0),Z!==null?(Ot=Z.x,ce=Z.y,Me=Z.z):(Ot=0,ce=0,Me=0);let mn=Yt.convert(k.format),me=Yt.convert(k.type),Rt;k.isData3DTexture?(P.setTexture3D(k,0),Rt=W.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(P.setTexture2DArray(k,0),Rt=W.TEXTURE_2D_ARRAY):(P.setTexture2D(k,0),Rt=W.TEXTURE_2D),W.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,k.flipY),W.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),W.pixelStorei(W.UNPACK_ALIGNMENT,k.unpackAlignment);let ei=W.getParameter(W.UNPACK_ROW_LENGTH),ge=W.getParameter(W.UNPACK_IMAGE_HEIGHT),An=W.getParameter(W.UNPACK_SKIP_PIXELS),Gi=W.getParameter(W.UNPACK_SKIP_ROWS),Tn=W.getParameter(W.UNPACK_SKIP_IMAGES);W.pixelStorei(W.UNPACK_ROW_LENGTH,Se.width),W.pixelStorei(W.UNPACK_IMAGE_HEIGHT,Se.height),W.pixelStorei(W.UNPACK_SKIP_PIXELS,Dt),W.pixelStorei(W.UNPACK_SKIP_ROWS,Xt),W.pixelStorei(W.UNPACK_SKIP_IMAGES,$t);let Ls=A.isDataArrayTexture||A.isData3DTexture,Le=k.isDataArrayTexture||k.isData3DTexture;if(A.isRenderTargetTexture||A.isDepthTexture){let Xn=kt.get(A),cs=kt.get(k),Fn=kt.get(Xn.__renderTarget),fi=kt.get(cs.__renderTarget);Nt.bindFramebuffer(W.READ_FRAMEBUFFER,Fn.__webglFramebuffer),Nt.bindFramebuffer(W.DRAW_FRAMEBUFFER,fi.__webglFramebuffer);for(let ni=0;ni<Ft;ni++)Ls&&W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,kt.get(A).__webglTexture,V,$t+ni),A.isDepthTexture?(Le&&W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,kt.get(k).__webglTexture,V,Me+ni),W.blitFramebuffer(Dt,Xt,dt,Mt,Ot,ce,dt,Mt,W.DEPTH_BUFFER_BIT,W.NEAREST)):Le?W.copyTexSubImage3D(Rt,V,Ot,ce,Me+ni,Dt,Xt,dt,Mt):W.copyTexSubImage2D(Rt,V,Ot,ce,Me+ni,Dt,Xt,dt,Mt);Nt.bindFramebuffer(W.READ_FRAMEBUFFER,null),Nt.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else Le?A.isDataTexture||A.isData3DTexture?W.texSubImage3D(Rt,V,Ot,ce,Me,dt,Mt,Ft,mn,me,Se.data):k.isCompressedArrayTexture?W.compressedTexSubImage3D(Rt,V,Ot,ce,Me,dt,Mt,Ft,mn,Se.data):W.texSubImage3D(Rt,V,Ot,ce,Me,dt,Mt,Ft,mn,me,Se):A.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,V,Ot,ce,dt,Mt,mn,me,Se.data):A.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,V,Ot,ce,Se.width,Se.height,mn,Se.data):W.texSubImage2D(W.TEXTURE_2D,V,Ot,ce,dt,Mt,mn,me,Se);W.pixelStorei(W.UNPACK_ROW_LENGTH,ei),W.pixelStorei(W.UNPACK_IMAGE_HEIGHT,ge),W.pixelStorei(W.UNPACK_SKIP_PIXELS,An),W.pixelStorei(W.UNPACK_SKIP_ROWS,Gi),W.pixelStorei(W.UNPACK_SKIP_IMAGES,Tn),V===0&&k.generateMipmaps&&W.generateMipmap(Rt),Nt.unbindTexture()},this.copyTextureToTexture3D=function(A,k,X=null,Z=null,V=0){return A.isTexture!==!0&&(qo("WebGLRenderer: copyTextureToTexture3D function signature has changed."),X=arguments[0]||null,Z=arguments[1]||null,A=arguments[2],k=arguments[3],V=arguments[4]||0),qo('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(A,k,X,Z,V)},this.initRenderTarget=function(A){kt.get(A).__webglFramebuffer===void 0&&P.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?P.setTextureCube(A,0):A.isData3DTexture?P.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?P.setTexture2DArray(A,0):P.setTexture2D(A,0),Nt.unbindTexture()},this.resetState=function(){C=0,R=0,U=null,Nt.reset(),xe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ns}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorspace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var Nl=class extends ti{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new os,this.environmentIntensity=1,this.environmentRotation=new os,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};var Fl=class extends Un{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Qn,h=Qn,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var rr=class extends ze{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}};var ea=class extends Ts{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new le(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ol=new N,kl=new N,Dm=new Je,Xo=new ir,cl=new nr,kh=new N,Um=new N,Xu=class extends ti{constructor(t=new qe,e=new ea){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Ol.fromBufferAttribute(e,s-1),kl.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Ol.distanceTo(kl);t.setAttribute("lineDistance",new Xe(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),cl.copy(n.boundingSphere),cl.applyMatrix4(s),cl.radius+=r,t.ray.intersectsSphere(cl)===!1)return;Dm.copy(s).invert(),Xo.copy(t.ray).applyMatrix4(Dm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let p=h.getX(y),S=h.getX(y+1),w=hl(this,t,Xo,l,p,S);w&&e.push(w)}if(this.isLineLoop){let y=h.getX(g-1),m=h.getX(f),p=hl(this,t,Xo,l,y,m);p&&e.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let p=hl(this,t,Xo,l,y,y+1);p&&e.push(p)}if(this.isLineLoop){let y=hl(this,t,Xo,l,g-1,f);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function hl(i,t,e,n,s,r){let o=i.geometry.attributes.position;if(Ol.fromBufferAttribute(o,s),kl.fromBufferAttribute(o,r),e.distanceSqToSegment(Ol,kl,kh,Um)>n)return;kh.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(kh);if(!(l<t.near||l>t.far))return{distance:l,point:Um.clone().applyMatrix4(i.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:i}}var Nm=new N,Fm=new N,Bl=class extends Xu{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Nm.fromBufferAttribute(e,s),Fm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Nm.distanceTo(Fm);t.setAttribute("lineDistance",new Xe(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var qu=class extends Ts{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new le(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Om=new Je,Yu=new ir,ul=new nr,dl=new N,zl=class extends ti{constructor(t=new qe,e=new qu){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ul.copy(n.boundingSphere),ul.applyMatrix4(s),ul.radius+=r,t.ray.intersectsSphere(ul)===!1)return;Om.copy(s).invert(),Yu.copy(t.ray).applyMatrix4(Om);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,d=n.attributes.position;if(c!==null){let u=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=u,y=f;g<y;g++){let m=c.getX(g);dl.fromBufferAttribute(d,m),km(dl,m,l,s,t,e,this)}}else{let u=Math.max(0,o.start),f=Math.min(d.count,o.start+o.count);for(let g=u,y=f;g<y;g++)dl.fromBufferAttribute(d,g),km(dl,g,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function km(i,t,e,n,s,r,o){let a=Yu.distanceSqToPoint(i);if(a<e){let l=new N;Yu.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var ui=class{constructor(){this.type="Curve",this.arcLengthDivisions=200}getPoint(){return console.warn("THREE.Curve: .getPoint() not implemented."),null}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],u=n[s+1]-h,f=(o-h)/u;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new _t:new N);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e){let n=new N,s=[],r=[],o=[],a=new N,l=new Je;for(let f=0;f<=t;f++){let g=f/t;s[f]=this.getTangentAt(g,new N)}r[0]=new N,o[0]=new N;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),d=Math.abs(s[0].y),u=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),d<=c&&(c=d,n.set(0,1,0)),u<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(hn(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,g))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(hn(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let g=1;g<=t;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],f*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}toJSON(){let t={metadata:{version:4.6,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}},na=class extends ui{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new _t){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),d=Math.sin(this.aRotation),u=l-this.aX,f=c-this.aY;l=u*h-f*d+this.aX,c=u*d+f*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},$u=class extends na{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Md(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,d){let u=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+d)+(l-a)/d;u*=h,f*=h,s(o,a,u,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var fl=new N,Bh=new Md,zh=new Md,Vh=new Md,Zu=class extends ui{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new N){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(fl.subVectors(s[0],s[1]).add(s[0]),c=fl);let d=s[a%r],u=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(fl.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=fl),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(d),f),y=Math.pow(d.distanceToSquared(u),f),m=Math.pow(u.distanceToSquared(h),f);y<1e-4&&(y=1),g<1e-4&&(g=y),m<1e-4&&(m=y),Bh.initNonuniformCatmullRom(c.x,d.x,u.x,h.x,g,y,m),zh.initNonuniformCatmullRom(c.y,d.y,u.y,h.y,g,y,m),Vh.initNonuniformCatmullRom(c.z,d.z,u.z,h.z,g,y,m)}else this.curveType==="catmullrom"&&(Bh.initCatmullRom(c.x,d.x,u.x,h.x,this.tension),zh.initCatmullRom(c.y,d.y,u.y,h.y,this.tension),Vh.initCatmullRom(c.z,d.z,u.z,h.z,this.tension));return n.set(Bh.calc(l),zh.calc(l),Vh.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new N().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Bm(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function FS(i,t){let e=1-i;return e*e*t}function OS(i,t){return 2*(1-i)*i*t}function kS(i,t){return i*i*t}function Ko(i,t,e,n){return FS(i,t)+OS(i,e)+kS(i,n)}function BS(i,t){let e=1-i;return e*e*e*t}function zS(i,t){let e=1-i;return 3*e*e*i*t}function VS(i,t){return 3*(1-i)*i*i*t}function HS(i,t){return i*i*i*t}function jo(i,t,e,n,s){return BS(i,t)+zS(i,e)+VS(i,n)+HS(i,s)}var Vl=class extends ui{constructor(t=new _t,e=new _t,n=new _t,s=new _t){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new _t){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(jo(t,s.x,r.x,o.x,a.x),jo(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Ju=class extends ui{constructor(t=new N,e=new N,n=new N,s=new N){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new N){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(jo(t,s.x,r.x,o.x,a.x),jo(t,s.y,r.y,o.y,a.y),jo(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Hl=class extends ui{constructor(t=new _t,e=new _t){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new _t){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new _t){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Ku=class extends ui{constructor(t=new N,e=new N){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new N){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new N){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Gl=class extends ui{constructor(t=new _t,e=new _t,n=new _t){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new _t){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(Ko(t,s.x,r.x,o.x),Ko(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ju=class extends ui{constructor(t=new N,e=new N,n=new N){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new N){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(Ko(t,s.x,r.x,o.x),Ko(t,s.y,r.y,o.y),Ko(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Wl=class extends ui{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new _t){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],d=s[o>s.length-3?s.length-1:o+2];return n.set(Bm(a,l.x,c.x,h.x,d.x),Bm(a,l.y,c.y,h.y,d.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new _t().fromArray(s))}return this}},zm=Object.freeze({__proto__:null,ArcCurve:$u,CatmullRomCurve3:Zu,CubicBezierCurve:Vl,CubicBezierCurve3:Ju,EllipseCurve:na,LineCurve:Hl,LineCurve3:Ku,QuadraticBezierCurve:Gl,QuadraticBezierCurve3:ju,SplineCurve:Wl}),Qu=class extends ui{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new zm[n](e,t))}return this}getPoint(t,e){let n=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(e.push(h),n=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(new zm[s.type]().fromJSON(s))}return this}},td=class extends Qu{constructor(t){super(),this.type="Path",this.currentPoint=new _t,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let n=new Hl(this.currentPoint.clone(),new _t(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){let r=new Gl(this.currentPoint.clone(),new _t(t,e),new _t(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){let a=new Vl(this.currentPoint.clone(),new _t(t,e),new _t(n,s),new _t(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),n=new Wl(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){let c=new na(t,e,n,s,r,o,a,l);if(this.curves.length>0){let d=c.getPoint(0);d.equals(this.currentPoint)||this.lineTo(d.x,d.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},ed=class i extends qe{constructor(t=[new _t(0,-.5),new _t(.5,0),new _t(0,.5)],e=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:n,phiLength:s},e=Math.floor(e),s=hn(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/e,d=new N,u=new _t,f=new N,g=new N,y=new N,m=0,p=0;for(let S=0;S<=t.length-1;S++)switch(S){case 0:m=t[S+1].x-t[S].x,p=t[S+1].y-t[S].y,f.x=p*1,f.y=-m,f.z=p*0,y.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:l.push(y.x,y.y,y.z);break;default:m=t[S+1].x-t[S].x,p=t[S+1].y-t[S].y,f.x=p*1,f.y=-m,f.z=p*0,g.copy(f),f.x+=y.x,f.y+=y.y,f.z+=y.z,f.normalize(),l.push(f.x,f.y,f.z),y.copy(g)}for(let S=0;S<=e;S++){let w=n+S*h*s,x=Math.sin(w),D=Math.cos(w);for(let C=0;C<=t.length-1;C++){d.x=t[C].x*x,d.y=t[C].y,d.z=t[C].x*D,o.push(d.x,d.y,d.z),u.x=S/e,u.y=C/(t.length-1),a.push(u.x,u.y);let R=l[3*C+0]*x,U=l[3*C+1],E=l[3*C+0]*D;c.push(R,U,E)}}for(let S=0;S<e;S++)for(let w=0;w<t.length-1;w++){let x=w+S*t.length,D=x,C=x+t.length,R=x+t.length+1,U=x+1;r.push(D,C,U),r.push(R,U,C)}this.setIndex(r),this.setAttribute("position",new Xe(o,3)),this.setAttribute("uv",new Xe(a,2)),this.setAttribute("normal",new Xe(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.points,t.segments,t.phiStart,t.phiLength)}},Xl=class i extends ed{constructor(t=1,e=1,n=4,s=8){let r=new td;r.absarc(0,-e/2,t,Math.PI*1.5,0),r.absarc(0,e/2,t,0,Math.PI*.5),super(r.getPoints(n),s),this.type="CapsuleGeometry",this.parameters={radius:t,length:e,capSegments:n,radialSegments:s}}static fromJSON(t){return new i(t.radius,t.length,t.capSegments,t.radialSegments)}};var or=class i extends qe{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],f=[],g=0,y=[],m=n/2,p=0;S(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new Xe(d,3)),this.setAttribute("normal",new Xe(u,3)),this.setAttribute("uv",new Xe(f,2));function S(){let x=new N,D=new N,C=0,R=(e-t)/n;for(let U=0;U<=r;U++){let E=[],b=U/r,T=b*(e-t)+t;for(let H=0;H<=s;H++){let G=H/s,q=G*l+a,J=Math.sin(q),$=Math.cos(q);D.x=T*J,D.y=-b*n+m,D.z=T*$,d.push(D.x,D.y,D.z),x.set(J,R,$).normalize(),u.push(x.x,x.y,x.z),f.push(G,1-b),E.push(g++)}y.push(E)}for(let U=0;U<s;U++)for(let E=0;E<r;E++){let b=y[E][U],T=y[E+1][U],H=y[E+1][U+1],G=y[E][U+1];(t>0||E!==0)&&(h.push(b,T,G),C+=3),(e>0||E!==r-1)&&(h.push(T,H,G),C+=3)}c.addGroup(p,C,0),p+=C}function w(x){let D=g,C=new _t,R=new N,U=0,E=x===!0?t:e,b=x===!0?1:-1;for(let H=1;H<=s;H++)d.push(0,m*b,0),u.push(0,b,0),f.push(.5,.5),g++;let T=g;for(let H=0;H<=s;H++){let q=H/s*l+a,J=Math.cos(q),$=Math.sin(q);R.x=E*$,R.y=m*b,R.z=E*J,d.push(R.x,R.y,R.z),u.push(0,b,0),C.x=J*.5+.5,C.y=$*.5*b+.5,f.push(C.x,C.y),g++}for(let H=0;H<s;H++){let G=D+H,q=T+H;x===!0?h.push(q,q+1,G):h.push(q+1,q,G),U+=3}c.addGroup(p,U,x===!0?1:2),p+=U}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},uo=class i extends or{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},nd=class i extends qe{constructor(t=[],e=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:n,detail:s};let r=[],o=[];a(s),c(n),h(),this.setAttribute("position",new Xe(r,3)),this.setAttribute("normal",new Xe(r.slice(),3)),this.setAttribute("uv",new Xe(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(S){let w=new N,x=new N,D=new N;for(let C=0;C<e.length;C+=3)f(e[C+0],w),f(e[C+1],x),f(e[C+2],D),l(w,x,D,S)}function l(S,w,x,D){let C=D+1,R=[];for(let U=0;U<=C;U++){R[U]=[];let E=S.clone().lerp(x,U/C),b=w.clone().lerp(x,U/C),T=C-U;for(let H=0;H<=T;H++)H===0&&U===C?R[U][H]=E:R[U][H]=E.clone().lerp(b,H/T)}for(let U=0;U<C;U++)for(let E=0;E<2*(C-U)-1;E++){let b=Math.floor(E/2);E%2===0?(u(R[U][b+1]),u(R[U+1][b]),u(R[U][b])):(u(R[U][b+1]),u(R[U+1][b+1]),u(R[U+1][b]))}}function c(S){let w=new N;for(let x=0;x<r.length;x+=3)w.x=r[x+0],w.y=r[x+1],w.z=r[x+2],w.normalize().multiplyScalar(S),r[x+0]=w.x,r[x+1]=w.y,r[x+2]=w.z}function h(){let S=new N;for(let w=0;w<r.length;w+=3){S.x=r[w+0],S.y=r[w+1],S.z=r[w+2];let x=m(S)/2/Math.PI+.5,D=p(S)/Math.PI+.5;o.push(x,1-D)}g(),d()}function d(){for(let S=0;S<o.length;S+=6){let w=o[S+0],x=o[S+2],D=o[S+4],C=Math.max(w,x,D),R=Math.min(w,x,D);C>.9&&R<.1&&(w<.2&&(o[S+0]+=1),x<.2&&(o[S+2]+=1),D<.2&&(o[S+4]+=1))}}function u(S){r.push(S.x,S.y,S.z)}function f(S,w){let x=S*3;w.x=t[x+0],w.y=t[x+1],w.z=t[x+2]}function g(){let S=new N,w=new N,x=new N,D=new N,C=new _t,R=new _t,U=new _t;for(let E=0,b=0;E<r.length;E+=9,b+=6){S.set(r[E+0],r[E+1],r[E+2]),w.set(r[E+3],r[E+4],r[E+5]),x.set(r[E+6],r[E+7],r[E+8]),C.set(o[b+0],o[b+1]),R.set(o[b+2],o[b+3]),U.set(o[b+4],o[b+5]),D.copy(S).add(w).add(x).divideScalar(3);let T=m(D);y(C,b+0,S,T),y(R,b+2,w,T),y(U,b+4,x,T)}}function y(S,w,x,D){D<0&&S.x===1&&(o[w]=S.x-1),x.x===0&&x.z===0&&(o[w]=D/2/Math.PI+.5)}function m(S){return Math.atan2(S.z,-S.x)}function p(S){return Math.atan2(-S.y,Math.sqrt(S.x*S.x+S.z*S.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.vertices,t.indices,t.radius,t.details)}};var ql=class i extends nd{constructor(t=1,e=0){let n=(1+Math.sqrt(5))/2,s=[-1,n,0,1,n,0,-1,-n,0,1,-n,0,0,-1,n,0,1,n,0,-1,-n,0,1,-n,n,0,-1,n,0,1,-n,0,-1,-n,0,1],r=[0,11,5,0,5,1,0,1,7,0,7,10,0,10,11,1,5,9,5,11,4,11,10,2,10,7,6,7,1,8,3,9,4,3,4,2,3,2,6,3,6,8,3,8,9,4,9,5,2,4,11,6,2,10,8,6,7,9,8,1];super(s,r,t,e),this.type="IcosahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new i(t.radius,t.detail)}};var Yl=class i extends qe{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new N,u=new N,f=[],g=[],y=[],m=[];for(let p=0;p<=n;p++){let S=[],w=p/n,x=0;p===0&&o===0?x=.5/e:p===n&&l===Math.PI&&(x=-.5/e);for(let D=0;D<=e;D++){let C=D/e;d.x=-t*Math.cos(s+C*r)*Math.sin(o+w*a),d.y=t*Math.cos(o+w*a),d.z=t*Math.sin(s+C*r)*Math.sin(o+w*a),g.push(d.x,d.y,d.z),u.copy(d).normalize(),y.push(u.x,u.y,u.z),m.push(C+x,1-w),S.push(c++)}h.push(S)}for(let p=0;p<n;p++)for(let S=0;S<e;S++){let w=h[p][S+1],x=h[p][S],D=h[p+1][S],C=h[p+1][S+1];(p!==0||o>0)&&f.push(w,x,C),(p!==n-1||l<Math.PI)&&f.push(x,D,C)}this.setIndex(f),this.setAttribute("position",new Xe(g,3)),this.setAttribute("normal",new Xe(y,3)),this.setAttribute("uv",new Xe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function pl(i,t,e){return!i||!e&&i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function GS(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var fo=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},id=class extends fo{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Op,endingEnd:Op}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case kp:r=t,a=2*e-n;break;case Bp:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case kp:o=t,l=2*n-e;break;case Bp:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,g=(n-e)/(s-e),y=g*g,m=y*g,p=-u*m+2*u*y-u*g,S=(1+u)*m+(-1.5-2*u)*y+(-.5+u)*g+1,w=(-1-f)*m+(1.5+f)*y+.5*g,x=f*m-f*y;for(let D=0;D!==a;++D)r[D]=p*o[h+D]+S*o[c+D]+w*o[l+D]+x*o[d+D];return r}},sd=class extends fo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},rd=class extends fo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Si=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=pl(e,this.TimeBufferType),this.values=pl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:pl(t.times,Array),values:pl(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s)}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new rd(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new sd(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new id(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case _l:e=this.InterpolantFactoryMethodDiscrete;break;case Tu:e=this.InterpolantFactoryMethodLinear;break;case uh:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return _l;case this.InterpolantFactoryMethodLinear:return Tu;case this.InterpolantFactoryMethodSmooth:return uh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&GS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===uh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*n,u=d-n,f=d+n;for(let g=0;g!==n;++g){let y=e[d+g];if(y!==e[u+g]||y!==e[f+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)e[u+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};Si.prototype.TimeBufferType=Float32Array;Si.prototype.ValueBufferType=Float32Array;Si.prototype.DefaultInterpolation=Tu;var ar=class extends Si{constructor(t,e,n){super(t,e,n)}};ar.prototype.ValueTypeName="bool";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=_l;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var od=class extends Si{};od.prototype.ValueTypeName="color";var ad=class extends Si{};ad.prototype.ValueTypeName="number";var ld=class extends fo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Nn.slerpFlat(r,0,o,c-a,o,c,l);return r}},$l=class extends Si{InterpolantFactoryMethodLinear(t){return new ld(this.times,this.values,this.getValueSize(),t)}};$l.prototype.ValueTypeName="quaternion";$l.prototype.InterpolantFactoryMethodSmooth=void 0;var lr=class extends Si{constructor(t,e,n){super(t,e,n)}};lr.prototype.ValueTypeName="string";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=_l;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var cd=class extends Si{};cd.prototype.ValueTypeName="vector";var hd=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],g=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null}}},WS=new hd,ud=class{constructor(t){this.manager=t!==void 0?t:WS,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}};ud.DEFAULT_MATERIAL_NAME="__DEFAULT";var po=class extends qe{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var wd="\\[\\]\\.:\\/",XS=new RegExp("["+wd+"]","g"),Sd="[^"+wd+"]",qS="[^"+wd.replace("\\.","")+"]",YS=/((?:WC+[\/:])*)/.source.replace("WC",Sd),$S=/(WCOD+)?/.source.replace("WCOD",qS),ZS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Sd),JS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Sd),KS=new RegExp("^"+YS+$S+ZS+JS+"$"),jS=["material","materials","bones","map"],dd=class{constructor(t,e,n){let s=n||Ge.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ge=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(XS,"")}static parseTrackName(t){let e=KS.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);jS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.needsUpdate!==void 0?a=this.Versioning.NeedsUpdate:t.matrixWorldNeedsUpdate!==void 0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ge.Composite=dd;Ge.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ge.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ge.prototype.GetterByBindingType=[Ge.prototype._getValue_direct,Ge.prototype._getValue_array,Ge.prototype._getValue_arrayElement,Ge.prototype._getValue_toArray];Ge.prototype.SetterByBindingTypeAndVersioning=[[Ge.prototype._setValue_direct,Ge.prototype._setValue_direct_setNeedsUpdate,Ge.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_array,Ge.prototype._setValue_array_setNeedsUpdate,Ge.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_arrayElement,Ge.prototype._setValue_arrayElement_setNeedsUpdate,Ge.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_fromArray,Ge.prototype._setValue_fromArray_setNeedsUpdate,Ge.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var BE=new Float32Array(1);var ia=class{constructor(t=1,e=0,n=0){return this.radius=t,this.phi=e,this.theta=n,this}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Math.max(1e-6,Math.min(Math.PI-1e-6,this.phi)),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(hn(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Zl=class extends rs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(){}disconnect(){}dispose(){}update(){}};typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:fd}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=fd);function pg(i,t=!1){let e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new qe,c=0;for(let h=0;h<i.length;++h){let d=i[h],u=0;if(e!==(d.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let f in d.attributes){if(!n.has(f))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+f+'" attribute exists among all geometries, or in none of them.'),null;r[f]===void 0&&(r[f]=[]),r[f].push(d.attributes[f]),u++}if(u!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==d.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let f in d.morphAttributes){if(!s.has(f))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;o[f]===void 0&&(o[f]=[]),o[f].push(d.morphAttributes[f])}if(t){let f;if(e)f=d.index.count;else if(d.attributes.position!==void 0)f=d.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,f,h),c+=f}}if(e){let h=0,d=[];for(let u=0;u<i.length;++u){let f=i[u].index;for(let g=0;g<f.count;++g)d.push(f.getX(g)+h);h+=i[u].attributes.position.count}l.setIndex(d)}for(let h in r){let d=fg(r[h]);if(!d)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,d)}for(let h in o){let d=o[h][0].length;if(d===0)break;l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let u=0;u<d;++u){let f=[];for(let y=0;y<o[h].length;++y)f.push(o[h][y][u]);let g=fg(f);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(g)}}return l}function fg(i){let t,e,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new ze(o,e,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let d=l/e;for(let u=0,f=h.count;u<f;u++)for(let g=0;g<e;g++){let y=h.getComponent(u,g);a.setComponent(u+d,g,y)}}else o.set(h.array,l);l+=h.count*e}return s!==void 0&&(a.gpuType=s),a}var Ql=`
vec3 turn(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }`,mg=`
uniform vec3 uUp;
vec3 shade(vec3 color, vec3 normal, vec3 toEye) {
  vec3 light = normalize(uUp * 0.8 + toEye * 0.8 + cross(uUp, toEye) * 0.45);
  float sky = 0.5 + 0.5 * dot(normal, uUp);
  float direct = max(dot(normal, light), 0.0);
  float gloss = pow(max(dot(normal, normalize(light + toEye)), 0.0), 40.0);
  return color * (0.36 + 0.24 * sky + 0.50 * direct) + 0.12 * gloss;
}`,gg=`
uniform float uPick;
uniform float uAlpha;
uniform vec4 uTint;
uniform vec3 uSelected;
uniform vec3 uWarning;
out vec4 fragment;
vec4 finish(vec3 color, vec3 normal, vec3 toEye, float body, float mark) {
  if (uPick > 0.5) return vec4(mod(body, 256.0), mod(floor(body / 256.0), 256.0), floor(body / 65536.0), 255.0) / 255.0;
  vec3 base = mix(color, uTint.rgb, uTint.a);
  vec3 lit = shade(base, normal, toEye);
  float rim = 1.0 - max(dot(normal, toEye), 0.0);
  if (mark > 1.5) lit = mix(lit, uWarning, 0.55);
  else if (mark > 0.5) lit = mix(lit, uSelected, 0.25 + 0.75 * smoothstep(0.45, 0.75, rim));
  return vec4(lit, uAlpha);
}`;var tc=`
in float shapeIndex;
uniform highp sampler2D uPose; uniform highp sampler2D uLook;
flat out vec3 vColor; flat out vec2 vMark;
vec3 iPosition; vec4 iOrientation; vec3 iScale;
void readShape() {
  int at = 2 * int(shapeIndex + 0.5);
  ivec2 first = ivec2(at % 2048, at / 2048), second = first + ivec2(1, 0);
  vec4 place = texelFetch(uPose, first, 0), size = texelFetch(uLook, first, 0);
  iPosition = place.xyz; iOrientation = texelFetch(uPose, second, 0); iScale = size.xyz;
  vColor = texelFetch(uLook, second, 0).rgb; vMark = vec2(size.w, place.w);
}`,vg=`${tc}${Ql}
out vec3 vNormal; out vec3 vWorld; out vec3 vOwn;
void main() {
  readShape();
  vNormal = turn(iOrientation, normalize(normal / iScale));
  vOwn = position;
  vWorld = iPosition + turn(iOrientation, position * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`,yg=`${tc}${Ql}
out vec3 vNormal; out vec3 vWorld; out vec3 vOwn;
void main() {
  readShape();
  vec3 eye = turn(vec4(-iOrientation.xyz, iOrientation.w), cameraPosition - iPosition);
  vOwn = position * vec3(eye.x < 0.0 ? -1.0 : 1.0, eye.y < 0.0 ? -1.0 : 1.0, eye.z < 0.0 ? -1.0 : 1.0);
  vNormal = vec3(0.0);
  vWorld = iPosition + turn(iOrientation, vOwn * iScale);
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`,xg=`
flat in vec3 vColor; flat in vec2 vMark; in vec3 vNormal; in vec3 vWorld; in vec3 vOwn;
${mg}${gg}
uniform float uIsRound; uniform float uIsFlat;
void main() {
  vec3 normal = normalize(uIsFlat > 0.5 ? cross(dFdx(vWorld), dFdy(vWorld)) : vNormal);
  vec3 color = vColor * (uIsRound > 0.5 && vOwn.x * vOwn.y > 0.0 ? 0.82 : 1.0);
  fragment = finish(color, normal, normalize(cameraPosition - vWorld), vMark.x, vMark.y);
}`,_g=`${tc}
out vec3 vRay; flat out vec3 vCenter; flat out vec4 vTurn; flat out float vRadius;
void main() {
  readShape();
  vTurn = iOrientation; vRadius = iScale.x;
  vCenter = (viewMatrix * vec4(iPosition, 1.0)).xyz;
  float d2 = dot(vCenter, vCenter);
  float reach = vRadius * sqrt(d2 / max(d2 - vRadius * vRadius, 1e-6 * d2));
  vec3 z = -vCenter / sqrt(d2);
  vec3 x = normalize(cross(abs(z.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0), z));
  vRay = vCenter + reach * (position.x * x + position.y * cross(z, x));
  gl_Position = projectionMatrix * vec4(vRay, 1.0);
}`,bg=`
flat in vec3 vColor; flat in vec2 vMark; in vec3 vRay; flat in vec3 vCenter; flat in vec4 vTurn; flat in float vRadius;
uniform mat4 projectionMatrix;
${Ql}${mg}${gg}
void main() {
  vec3 ray = normalize(vRay);
  float along = dot(ray, vCenter);
  float under = vRadius * vRadius - dot(vCenter, vCenter) + along * along;
  if (under < 0.0) discard;
  vec3 hit = (along - sqrt(under)) * ray;
  mat3 toWorld = transpose(mat3(viewMatrix));
  vec3 normal = toWorld * ((hit - vCenter) / vRadius);
  vec3 own = turn(vec4(-vTurn.xyz, vTurn.w), normal);
  vec3 color = vColor * (own.x * own.y * own.z > 0.0 ? 1.0 : 0.78);
  fragment = finish(color, normal, -(toWorld * ray), vMark.x, vMark.y);
  vec4 clip = projectionMatrix * vec4(hit, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
}`,Mg=`${tc}${Ql}
uniform vec4 uPlane; uniform vec3 uLight;
void main() {
  readShape();
  vec3 world = iPosition + turn(iOrientation, position * iScale);
  float height = max(dot(uPlane.xyz, world) - uPlane.w, 0.0);
  world -= (height / dot(uPlane.xyz, uLight)) * uLight;
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
}`,wg=`
flat in vec3 vColor; flat in vec2 vMark; out vec4 fragment;
void main() { fragment = vec4(0.0, 0.0, 0.0, 0.22); }`,Sg=`
out vec2 vPlace;
void main() {
  vPlace = position.xy;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,Eg=`
in vec2 vPlace; out vec4 fragment;
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
  fragment = vec4(mix(uColor, uLine, line), 0.92 * fade);
}`,Ag=`
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
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
}`,Tg=`
in vec3 vColor; out vec4 fragment;
void main() { fragment = vec4(vColor, 1.0); }`,Cg=`
in vec3 color; in float size;
out vec3 vColor;
uniform float uRatio;
void main() {
  vColor = color;
  gl_PointSize = size * uRatio;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,Rg=`
in vec3 vColor; out vec4 fragment;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  if (r > 1.0) discard;
  fragment = vec4(r > 0.68 ? vec3(0.05) : vColor, 1.0);
}`;var as=class{constructor(){this.array=new Float32Array(3*64);this.size=0}push(t,e,n){if(this.size+3>this.array.length){let s=new Float32Array(2*this.array.length);s.set(this.array),this.array=s}this.array[this.size++]=t,this.array[this.size++]=e,this.array[this.size++]=n}},ec=class{constructor(t){this.geometry=new po;this.start=new as;this.vector=new as;this.color=new as;let e=new or(1,1,1,6,1,!0).rotateX(Math.PI/2).translate(0,0,.5),n=new uo(1,1,10).rotateX(Math.PI/2).translate(0,0,.5),s=pg([e,n]),r=e.getAttribute("position").count,o=Float32Array.from({length:s.getAttribute("position").count},(l,c)=>c<r?0:1);this.geometry.index=s.index,this.geometry.setAttribute("position",s.getAttribute("position")),this.geometry.setAttribute("part",new ze(o,1));let a=new _n({glslVersion:Oi,vertexShader:Ag,fragmentShader:Tg,uniforms:{uPixel:t},depthTest:!1,depthWrite:!1,transparent:!0});this.mesh=new Mn(this.geometry,a),this.mesh.frustumCulled=!1,this.mesh.renderOrder=10,this.mesh.layers.enable(0)}clear(){this.start.size=this.vector.size=this.color.size=0}add(t,e,n){this.start.push(t[0],t[1],t[2]),this.vector.push(e[0],e[1],e[2]),this.color.push(...n)}commit(){ur(this.geometry,"iStart",this.start,!0),ur(this.geometry,"iVector",this.vector,!0),ur(this.geometry,"iColor",this.color,!0),this.geometry.instanceCount=this.start.size/3,this.mesh.visible=this.start.size>0}},ra=class{constructor(t,e){this.geometry=new qe;this.place=new as;this.color=new as;let n=new _n({glslVersion:Oi,vertexShader:Cg.replace("in float size;",`const float size = ${t.toFixed(1)};`),fragmentShader:Rg,uniforms:{uRatio:e},depthTest:!1,depthWrite:!1,transparent:!0});this.points=new zl(this.geometry,n),this.points.frustumCulled=!1,this.points.renderOrder=11}clear(){this.place.size=this.color.size=0}add(t,e){this.place.push(t[0],t[1],t[2]),this.color.push(...e)}commit(){ur(this.geometry,"position",this.place,!1),ur(this.geometry,"color",this.color,!1),this.geometry.setDrawRange(0,this.place.size/3),this.points.visible=this.place.size>0}},dr=class{constructor(){this.geometry=new qe;this.place=new as;this.color=new as;this.lines=new Bl(this.geometry,new ea({vertexColors:!0,toneMapped:!1})),this.lines.frustumCulled=!1,this.lines.renderOrder=5}clear(){this.place.size=this.color.size=0}add(t,e,n){this.place.push(t[0],t[1],t[2]),this.place.push(e[0],e[1],e[2]),this.color.push(...n),this.color.push(...n)}commit(){ur(this.geometry,"position",this.place,!1),ur(this.geometry,"color",this.color,!1),this.geometry.setDrawRange(0,this.place.size/3),this.lines.visible=this.place.size>0}};function ur(i,t,e,n){let s=i.getAttribute(t);if(s?.array===e.array){s.needsUpdate=!0;return}let r=n?new rr(e.array,3):new ze(e.array,3);r.setUsage(ig),i.setAttribute(t,r)}var Dg={contacts:!0,velocities:!1,frames:!1,inertia:!1,joints:!0,trails:!1,penetration:!0,ghost:!0,shadows:!0,arrowScale:1},sn=Object.fromEntries(Object.entries(Re).map(([i,t])=>[i,Yi(t)])),Pg=120,QS=400,nc=class{constructor(t,e,n,s){this.source=t;this.radius=e;this.trails=new dr;this.links=new dr;this.largestForce=0;this.arrows=new ec(n),this.dots=new ra(6.5,s),this.ring=new ra(15,s),this.header=t.header,this.sizes=this.header.bodies.map((r,o)=>r.radius||Math.max(0,...vs(this.header,o).flatMap(({radii:a})=>a??[]))),this.largestSpeed=Lg(t.frames.velocity),this.largestImpulse=Ig(t)}update(t,e,n,s,r,o){let a=[this.arrows,this.ring,this.dots,this.trails,this.links];for(let l of a)l.clear();s.contacts&&this.addContacts(n,s.arrowScale),s.velocities&&this.addVelocities(e,s.arrowScale),s.frames&&this.addFrames(e,r),s.inertia&&this.addInertia(e,r),s.joints&&this.addJoints(e),s.trails&&this.addTrails(t,r),o&&this.addEvent(o,s.arrowScale),this.addSprings(e),s.penetration&&this.addDeepest(n);for(let l of a)l.commit()}addContacts(t,e){for(let{force:s}of t)this.largestForce=Math.max(this.largestForce,Math.hypot(...s));let n=this.largestForce>0?.3*e*this.radius/this.largestForce:0;for(let{point:s,normal:r,force:o,mode:a}of t){this.dots.add(s,sn[a]);let l=o[0]*r[0]+o[1]*r[1]+o[2]*r[2];if(l<=0)continue;this.arrows.add(s,r.map(h=>h*l*n),sn.normal);let c=o.map((h,d)=>(h-l*r[d])*n);Math.hypot(...c)>.001*this.radius*e&&this.arrows.add(s,c,sn[a])}}addDeepest(t){let e;for(let n of t)n.gap<(e?.gap??0)&&(e=n);e&&this.ring.add(e.point,sn.penetration)}addVelocities(t,e){if(this.source.kind==="live"&&(this.largestSpeed=Math.max(this.largestSpeed,Lg(t.velocity))),this.largestSpeed===0)return;let n=.3*e*this.radius/this.largestSpeed;for(let s of this.source.moving){let r=Ye(t.velocity,s,n);Math.hypot(...r)>.001*this.radius&&this.arrows.add(Ye(t.position,s),r,sn.velocity)}}addFrames(t,e){for(let n of this.chosen(e)){let{frame:s}=this.header.bodies[n],r=1.2*Math.min(this.sizes[n]||this.radius,this.radius),o=ki(t,n),a=Gn(Ye(t.position,n),Ne(o,s.p)),[l,c,h,d]=s.q;[sn.x,sn.y,sn.z].forEach((u,f)=>{let g=[0,0,0];g[f]=r,this.arrows.add(a,Ne(o,Ne([l,c,h,d],g)),u)})}}addInertia(t,e){for(let n of this.chosen(e)){let{moments:s,mass:r}=this.header.bodies[n];if(r<=0)continue;let o=Math.sqrt(Math.max(...s)),a=ki(t,n),l=Ye(t.position,n);[sn.x,sn.y,sn.z].forEach((c,h)=>{let d=[0,0,0];d[h]=1.35*(this.sizes[n]||this.radius)*Math.sqrt(s[h])/o;let u=Ne(a,d);this.arrows.add(l,u,c),this.arrows.add(l,u.map(f=>-f),c)})}}addJoints(t){for(let{type:e,bodies:n,points:s,axes:r}of this.header.joints){let o=n.map((c,h)=>this.placeOn(c,s[h],t));e==="distance"&&this.links.add(o[0],o[1],sn.impulse);let a=n.map((c,h)=>this.canMove(c)?Math.hypot(...s[h]):0);n.forEach((c,h)=>{a[h]>0&&this.links.add(Ye(t.position,c),o[h],sn.impulse)}),e!=="fixed"&&o.slice(0,e==="distance"?2:1).forEach(c=>this.dots.add(c,sn.impulse));let l=Math.min(.2*this.radius,Math.max(...a)||1/0);r.forEach((c,h)=>{if(c===null)return;let d=n[h]<0?c:Ne(ki(t,n[h]),c);this.arrows.add(o[h],d.map(u=>l*u),sn.impulse)})}}addTrails(t,e){let{frames:n,frameTimes:s}=this.source,r=n.moving.length,o=zn(s,t),a=Math.max(0,o-QS),l=Math.max(1,Math.floor(Math.min(r,Pg)*(o-a)/4e4));n.moving.forEach((c,h)=>{if(e>=0&&n.moving.includes(e)?c!==e:h>=Pg)return;let d=u=>n.position.subarray(3*(u*r+h),3*(u*r+h)+3);for(let u=o;u>a;u-=l){let f=.25+.75*(u-a)/(o-a);this.trails.add(d(Math.max(a,u-l)),d(u),sn.normal.map(g=>g*f))}})}addEvent(t,e){if(t.kind!=="impact")return;this.source.kind==="live"&&(this.largestImpulse=Ig(this.source));let n=t.point.map((a,l)=>a-this.header.origin[l]),s=this.largestImpulse>0?.4*e*this.radius/this.largestImpulse:0,r=.1*this.radius/(Math.hypot(...t.impulse)||1),o=t.impulse.map(a=>a*Math.max(s,r));this.arrows.add(n,o,sn.impulse),this.arrows.add(n,o.map(a=>-a),sn.impulse),this.dots.add(n,sn.impulse)}addSprings(t){for(let{bodies:e,points:n}of this.header.springs){let[s,r]=e.map((o,a)=>this.placeOn(o,n[a],t));this.links.add(s,r,sn.velocity)}}placeOn(t,e,n){return t<0?e.map((s,r)=>s-this.header.origin[r]):Gn(Ye(n.position,t),Ne(ki(n,t),e))}canMove(t){return t>=0&&this.header.bodies[t].motion!=="static"}chosen(t){return t>=0?[t]:this.source.moving.slice(0,500)}};function Ye(i,t,e=1){return[i[3*t]*e,i[3*t+1]*e,i[3*t+2]*e]}function ki(i,t){let e=i.orientation;return[e[4*t+3],e[4*t],e[4*t+1],e[4*t+2]]}function Gn(i,t){return[i[0]+t[0],i[1]+t[1],i[2]+t[2]]}function Ne([i,t,e,n],s){let r=2*(e*s[2]-n*s[1]),o=2*(n*s[0]-t*s[2]),a=2*(t*s[1]-e*s[0]);return[s[0]+i*r+e*a-n*o,s[1]+i*o+n*r-t*a,s[2]+i*a+t*o-e*r]}function Ig({events:i}){return i.reduce((t,e)=>Math.max(t,Math.hypot(...e.impulse)),0)}function Lg(i){let t=0;for(let e=0;e<i.length;e+=3)t=Math.max(t,Math.hypot(i[e],i[e+1],i[e+2]));return t}var di=(i,t)=>i.series.get(t)??new Float64Array;function Ed(i){let[t,e,n]=["kinetic","potential","elastic"].map(s=>di(i,s));return t.map((s,r)=>s+e[r]+n[r])}var t1=i=>Array.from(i.values).some(t=>t!==0),Rs=[{title:"Energy",unit:"J",curves:i=>{let[t,e,n,s]=["kinetic","potential","elastic","work"].map(r=>di(i,r));return[{label:"kinetic",color:Qt.skyBlue,values:t},{label:"potential",color:Qt.orange,values:e},...[{label:"elastic",color:Qt.purple,values:n},{label:"work",color:Qt.yellow,values:s}].filter(t1),{label:"total",color:Qt.green,values:Ed(i)}]}},{title:"Momentum",unit:"kg m/s; kg m\xB2/s",curves:i=>[{label:"linear",color:Qt.skyBlue,values:di(i,"momentum")},{label:"angular",color:Qt.orange,values:di(i,"angular_momentum")}]},{title:"Deepest penetration",unit:"m",curves:i=>[{label:"depth",color:Qt.vermilion,values:di(i,"penetration")}]},{title:"Solver effort an interval",unit:"",curves:i=>[{label:"steps",color:Qt.skyBlue,values:di(i,"steps")},{label:"impacts",color:Qt.vermilion,values:di(i,"impacts")},{label:"iterations",color:Qt.purple,values:di(i,"iterations")}]}],fr={position:{unit:"m",labels:["x","y","z"]},velocity:{unit:"m/s",labels:["x","y","z"]},"angular velocity":{unit:"rad/s",labels:["x","y","z"]},"kinetic energy":{unit:"J",labels:["translation","rotation"]}};function ic(i,t,e){let n=i.frames.moving.indexOf(t),{labels:s}=fr[e],r=i.frameTimes.length,o=s.map(()=>new Array(r));if(n<0)return o.map(d=>d.fill(0));let a=i.frames.moving.length,{mass:l,moments:c}=i.header.bodies[t],h=new Float32Array(4);for(let d=0;d<r;++d){let u=d*a+n,f;e==="position"?f=Ye(i.frames.position,u).map((g,y)=>g+i.header.origin[y]):e==="velocity"?f=Ye(i.frames.velocity,u):e==="angular velocity"?f=Ye(i.frames.spin,u):(i.frames.orientation(d,n,h,0),f=Ug(l,c,Ye(i.frames.velocity,u),Ye(i.frames.spin,u),[h[3],h[0],h[1],h[2]])),f.forEach((g,y)=>o[y][d]=g)}return o}function Ug(i,t,e,n,s){let r=Ne([s[0],-s[1],-s[2],-s[3]],[n[0],n[1],n[2]]);return[.5*i*(e[0]**2+e[1]**2+e[2]**2),.5*(t[0]*r[0]**2+t[1]*r[1]**2+t[2]*r[2]**2)]}var yo=class{constructor(t,e){this.source=t;this.element=F("div",{class:"plots"});this.units=Rs.map(()=>F("small"));this.body=-1;this.all=new kr(this.element,e),this.quantity=F("select",{"aria-label":"Quantity of the body",onchange:()=>this.showBody(this.body)},...Object.keys(fr).map(n=>F("option",{value:n},n))),this.bodyBox=F("section",{class:"plot"}),Rs.forEach((n,s)=>{let r=F("section",{class:"plot"},F("h3",{},n.title,this.units[s]));this.element.append(r),this.all.add(r,this.curvesOf(s))}),this.element.append(this.bodyBox),this.showBody(-1)}get charts(){return this.all.list}refresh(){Rs.forEach((t,e)=>this.all.replace(e,this.curvesOf(e)))}refreshBody(){this.charts.length>Rs.length&&this.all.replace(Rs.length,this.bodyCurvesOf())}showBody(t){this.body=t,this.all.keep(Rs.length);let e=this.source.header.bodies[t]?.name,{unit:n}=fr[this.quantity.value];if(this.bodyBox.replaceChildren(F("h3",{},e??"Chosen body",F("small",{text:e?` [${n}]`:""}),e?this.quantity:void 0)),!e||!this.source.frames.moving.includes(t)){this.bodyBox.append(F("p",{class:"hint",text:e?"This body stands still.":"Click a body in the scene to plot its motion."}));return}this.all.add(this.bodyBox,this.bodyCurvesOf()),this.all.resize()}setTime(t){this.all.setTime(t)}redraw(){this.all.redraw()}curvesOf(t){let{times:e}=this.source,n=Rs[t].curves(this.source).map(r=>({...r,times:e})),s=Ba(n);return this.units[t].textContent=Va(Rs[t].unit,s),za(n,s)}bodyCurvesOf(){let t=[Qt.vermilion,Qt.green,Qt.skyBlue],{labels:e}=fr[this.quantity.value],n=this.source.frameTimes;return ic(this.source,this.body,this.quantity.value).map((s,r)=>({label:e[r],color:t[r],times:n,values:s}))}};function Ng(i,t,e){let{mass:n,moments:s}=i.header.bodies[t],r=e.orientation;return Ug(n,s,Ye(e.velocity,t),Ye(e.spin,t),[r[4*t+3],r[4*t],r[4*t+1],r[4*t+2]])}var Fg=[{title:"Total energy",unit:"J",values:Ed},{title:"Kinetic energy",unit:"J",values:i=>di(i,"kinetic")},{title:"Momentum",unit:"kg m/s",values:i=>di(i,"momentum")},{title:"Deepest penetration",unit:"m",values:i=>di(i,"penetration")}],oa=class{constructor(t,e,n){this.sources=t;this.chosen=e;this.boxes=F("div",{class:"plots"});this.legend=F("span",{class:"legend"});this.bodyBox=F("section",{class:"plot"});this.body="";this.isQuantityChosen=!1;this.all=new kr(this.boxes,n),this.names=Lo(t),this.short=Sa(this.names),this.wantsAll=F("input",{type:"checkbox",id:"all-runs",onchange:()=>this.show()}),this.quantity=F("select",{"aria-label":"Quantity of the body",onchange:()=>{this.isQuantityChosen=!0,this.showBodyPlot()}},...Object.entries(fr).flatMap(([s,{labels:r}])=>r.map((o,a)=>F("option",{value:`${s}/${a}`},`${s} ${o}`)))),this.element=F("div",{class:"compare-plots"},F("div",{class:"plots-head"},F("label",{},this.wantsAll,"all runs"),this.legend),this.boxes),this.show()}get charts(){return this.all.list}setRuns(t){this.chosen=t,this.show()}showBody(t){let e=this.sources[this.chosen.a];this.body=e.header.bodies[t]?.name??"",this.body&&!this.isQuantityChosen&&(this.quantity.value=`position/${e1(ic(e,t,"position"))}`),this.showBodyPlot()}setTime(t){this.all.setTime(t)}redraw(){this.all.redraw()}shownRuns(){let{a:t,b:e}=this.chosen;return this.sources.map((n,s)=>s).filter(n=>this.wantsAll.checked||n===t||n===e)}curvesOf(t,e){let n=Math.min(1,3.5/Math.max(1,t.length-1));return t.map((s,r)=>({label:this.short[s],color:Bn(s),times:this.sources[s].times,values:e(s),width:1.6+n*(t.length-1-r),isDashed:s===this.chosen.b}))}show(){let t=this.shownRuns();this.legend.replaceChildren(...t.map(e=>{let n=e===this.chosen.a?" (A)":e===this.chosen.b?" (B, dashed)":"";return F("span",{},F("span",{class:"dot",style:`background:${Bn(e)}`}),this.names[e]+n)})),this.all.keep(0),this.boxes.replaceChildren();for(let e of Fg){let n=this.curvesOf(t,o=>e.values(this.sources[o])),s=Ba(n),r=F("section",{class:"plot"},F("h3",{},e.title,F("small",{text:Va(e.unit,s)})));this.boxes.append(r),this.all.add(r,za(n,s))}this.boxes.append(this.bodyBox),this.showBodyPlot()}twin(t){return this.sources[t].header.bodies.findIndex(({name:e})=>e===this.body)}showBodyPlot(){this.all.keep(Fg.length);let[t,e]=this.quantity.value.split("/"),{unit:n}=fr[t],s=this.body===""?[]:[F("small",{text:` [${n}]`}),this.quantity];this.bodyBox.replaceChildren(F("h3",{},this.body||"Chosen body",...s));let r=this.shownRuns().filter(a=>this.sources[a].frames.moving.includes(this.twin(a))),o=this.curvesOf(r,a=>ic(this.sources[a],this.twin(a),t)[Number(e)]);o.length===0?this.bodyBox.append(F("p",{class:"hint",text:this.body?"This body stands still.":"Click a body in the scene to plot its motion."})):this.all.add(this.bodyBox,o),this.all.resize()}};function e1(i){let t=i.map(e=>e.reduce((n,s)=>Math.max(n,s),-1/0)-e.reduce((n,s)=>Math.min(n,s),1/0));return t.indexOf(Math.max(...t))}function aa(i,t){let e=t.moving.length,n=t.moving.map((h,d)=>{let u=new Float32Array(4);return t.orientation(0,d,u,0),n1(i,h,[u[3],u[0],u[1],u[2]])}),r=n.map(h=>Math.hypot(...h)).sort((h,d)=>h-d)[e>>1]??0,o=Og(t,n,0,1),a=Math.max(1,Math.floor(t.count/400)),l=Og(t,n,0,t.count,a),c=Math.max(60*r,3*o.radius);return e>0&&l.radius>0?l.radius<=c?l:{center:o.center,half:[c/2,c/2,c/2],radius:c}:i1(i)}function n1(i,t,e){let n=[0,0,0];for(let s of vs(i,t)){if(s.type==="plane")continue;let r=s.radius??0,o=s.half_length??0,a=s.half_extents??s.radii??[r,r,s.type==="capsule"?r+o:o],l=s.type==="sphere"||s.mesh!==void 0,c=s.mesh===void 0?r:i.bodies[t].radius??0,h=Ne(e,s.p),d=[0,1,2].map(u=>Ne(e,Ne(s.q,[0,1,2].map(f=>f===u?a[f]:0))));for(let u=0;u<3;++u){let f=l?c:Math.abs(d[0][u])+Math.abs(d[1][u])+Math.abs(d[2][u]);n[u]=Math.max(n[u],Math.abs(h[u])+f)}}for(let s of ch(i,t))Ne(e,s).forEach((r,o)=>n[o]=Math.max(n[o],Math.abs(r)));return n}function Og(i,t,e,n,s=1){let r=[1/0,1/0,1/0],o=[-1/0,-1/0,-1/0],a=i.moving.length;for(let l=e;l<n;l+=s)for(let c=0;c<a;++c)for(let h=0;h<3;++h){let d=i.position[3*(l*a+c)+h];r[h]=Math.min(r[h],d-t[c][h]),o[h]=Math.max(o[h],d+t[c][h])}return{center:[0,1,2].map(l=>(r[l]+o[l])/2),half:[0,1,2].map(l=>(o[l]-r[l])/2),radius:Math.hypot(...o.map((l,c)=>l-r[c]))/2}}function i1(i){let t=i.bodies.map(n=>Math.hypot(...n.start.p.map((s,r)=>s-i.origin[r]))+(n.radius??0)),e=Math.max(0,...t.filter(Number.isFinite))||1;return{center:[0,0,0],half:[e,e,e],radius:e}}var kg=[["F","follow the chosen body with the camera"],["R","look at the whole scene again"],["Esc","choose no body, close this help"],["/","find a body by name"],["C","contact points and forces"],["V","velocities"],["X","body frames"],["I","axes of inertia"],["J","joints and their axes (where there are joints)"],["T","trails"],["P","overlapping bodies"],["H","shadows"],["S","save a picture"],["D","dark or light"],["?","this help"]],Bg=[["Space","play, pause"],["\u2190 \u2192","one frame back, on (with Shift: ten)"],["Home End","first, last frame"],["[ ]","previous, next impact"],["\u2212 +","slower, faster"],["L","loop"],...kg,["Shift P","go to the deepest penetration"],["G","ghost of run B (where there is one)"]],zg=[["Space","run, pause"],["\u2192","one output interval on"],["Home","back to t = 0"],["[ ]","show the previous, next impact"],...kg];var Ad=200,xo=class{constructor(t,e,n,s,r){this.source=t;this.shown=e;this.actions=s;this.found=F("ul",{class:"found",role:"listbox","aria-label":"Bodies"});this.numbers=F("div",{class:"numbers",id:"numbers"});this.event=F("div",{class:"event",id:"event",role:"status"});this.audit=F("div");this.precision=F("p",{class:"hint"});this.boxes=new Map;this.search=F("input",{type:"search",id:"search",placeholder:"Find a body by name (/)","aria-label":"Find a body by name",oninput:()=>this.list()});let o=[...r?[["Control",r]]:[],["Body",F("div",{},this.search,this.found,this.numbers)],["Show",this.showTab(n)],...r?[]:[["Audit",this.audit]]];this.element=F("aside",{class:"panel"},this.event,r1(o),...o.map(([,a])=>a)),this.setSource(t)}setSource(t){this.source=t;let{position_error:e,orientation_error:n}=t.header;this.precision.textContent=`Positions are stored to ${he(e,2)} m, orientations to ${he(n,2)} rad. Between two frames a body follows a smooth curve through both, over an impact two curves that meet there.`,this.audit.replaceChildren(o1(t.header,this.actions)),this.list()}updateShown(){for(let[t,e]of this.boxes)e.checked=!!this.shown[t]}showEvent(t){if(this.event.hidden=t===void 0,!t)return;let e=n=>this.source.header.bodies[n]?.name??"";this.event.replaceChildren(F("h3",{},F("span",{class:"dot",style:`background:${Re.impulse}`}),`${t.kind} at ${he(t.time,10)} s`),F("p",{},Vg(t.bodyA,e(t.bodyA),this.actions)," \u2194 ",Vg(t.bodyB,e(t.bodyB),this.actions)),Td([["impulse",`${he(Math.hypot(...t.impulse),6)} N s`],[`on ${e(t.bodyB)}`,`[${Xi(t.impulse,5)}] N s`],["at",`[${Xi(t.point,5)}] m`]]))}showBody(t,e,n,s){if(t<0){this.numbers.replaceChildren(F("p",{class:"hint",text:"Click a body in the scene, or choose one here, to see its numbers."}));return}let{header:r}=this.source,o=r.bodies[t],a=ki(e,t),l=Gn(Ye(e.position,t),r.origin),c=Ye(e.velocity,t),h=Ye(e.spin,t),[d,u]=Ng(this.source,t,e),f=r.gravity,g=p=>Math.abs(p)<r.position_error?0:p,y=[["position",`[${Xi(Gn(l,Ne(a,o.frame.p)).map(g))}] m`],["centre of mass",`[${Xi(l.map(g))}] m`],["orientation",`[${Xi(s1(a,o.frame.q))}]`],["velocity",`[${Xi(c)}] m/s`],["speed",`${he(Math.hypot(...c))} m/s`],["angular velocity",`[${Xi(h)}] rad/s`]];o.mass>0&&y.push(["mass",`${he(o.mass)} kg`],["principal moments",`[${Xi(o.moments)}] kg m\xB2`],["kinetic energy",`${he(d+u)} J (turning ${he(u)})`],["height energy",`${he(-o.mass*(f[0]*l[0]+f[1]*l[1]+f[2]*l[2]))} J`]);let m=n.filter(({bodyA:p,bodyB:S})=>p===t||S===t);y.push(["contacts",String(m.length)]),this.numbers.replaceChildren(F("h3",{},o.name,F("small",{text:` ${o.motion}`}),F("button",{type:"button",class:s===t?"on":"",title:"The camera goes along (F)",onclick:()=>this.actions.follow(t)},"follow")),Td(y),this.contactTable(t,m))}contactTable(t,e){if(e.length===0)return"";let n=e.slice(0,50).map(({bodyA:r,bodyB:o,force:a,normal:l,mode:c,gap:h})=>{let d=r===t?o:r,u=a[0]*l[0]+a[1]*l[1]+a[2]*l[2],f=Math.hypot(...a.map((y,m)=>y-u*l[m])),g=c!=="unknown";return F("tr",{},F("td",{},this.source.header.bodies[d].name),F("td",{},c),F("td",{},g?he(u,4):"\u2013"),F("td",{},g?he(f,3):"\u2013"),F("td",{},he(h,2)))}),s=["with","mode","normal [N]","friction [N]","gap [m]"].map(r=>F("th",{text:r}));return F("table",{class:"contacts"},F("tr",{},...s),...n)}list(){let t=this.search.value.trim().toLowerCase(),{bodies:e}=this.source.header,n=e.flatMap((s,r)=>s.name.toLowerCase().includes(t)?[r]:[]);this.found.replaceChildren(...n.slice(0,Ad).map(s=>F("li",{role:"option"},F("button",{type:"button",onclick:()=>this.actions.select(s)},e[s].name,F("small",{text:` ${e[s].motion}`}))))),n.length===0&&this.found.append(F("li",{class:"hint",text:"no body has this in its name"})),n.length>Ad&&this.found.append(F("li",{class:"hint",text:`and ${n.length-Ad} more`}))}showTab(t){let{header:e}=this.source,s=[["contacts","Contact points and forces (C)",[Re.normal,Re.stick,Re.slide],!0],["velocities","Velocities (V)",[Re.velocity],!0],["frames","Body frames (X)",[Re.x,Re.y,Re.z],!0],["inertia","Axes of inertia (I)",[Re.x,Re.y,Re.z],!0],["joints","Joints and their axes (J)",[Re.impulse],e.joints.length>0],["trails","Trails (T)",[Re.normal],!0],["penetration","Overlapping bodies (P)",[Re.penetration],!0],["ghost","Run B as a ghost (G)",[],t],["shadows","Shadows (H)",[],!0]].filter(([,,,a])=>a).map(([a,l,c])=>{let h=F("input",{type:"checkbox",id:`show-${a}`,onchange:()=>{this.shown[a]=h.checked,this.actions.changed()}});return this.boxes.set(a,h),F("label",{},h,...c.map(d=>F("span",{class:"dot",style:`background:${d}`})),l)}),r=F("input",{type:"range",min:-2,max:2,step:.1,value:0,"aria-label":"Length of arrows",oninput:()=>{this.shown.arrowScale=2**Number(r.value),this.actions.changed()}}),o=(a,l)=>F("span",{},F("span",{class:"dot",style:`background:${l}`}),a);return F("div",{class:"show"},...s,F("label",{},"Length of arrows ",r),F("p",{class:"legend"},o("normal force",Re.normal),o("friction, sticks",Re.stick),o("friction, slides",Re.slide),o("no force",Re.open),o("impulse",Re.impulse)),this.precision)}};function s1(i,t){let[e,n,s,r]=i,[o,a,l,c]=t;return[e*o-n*a-s*l-r*c,e*a+n*o+s*c-r*l,e*l-n*c+s*o+r*a,e*c+n*l-s*a+r*o]}function Vg(i,t,e){return F("button",{type:"button",class:"link",onclick:()=>e.select(i)},t||"\u2013")}function Td(i){return F("table",{},...i.map(([t,e])=>F("tr",{},F("th",{scope:"row",text:t}),F("td",{},e))))}function r1(i){let t=i.map(([n],s)=>F("button",{type:"button",role:"tab",onclick:()=>e(s)},n)),e=n=>i.forEach(([,s],r)=>{s.hidden=r!==n,t[r].setAttribute("aria-selected",String(r===n))});for(let[,n]of i)n.classList.add("tab");return e(0),F("div",{class:"tabs",role:"tablist"},...t)}function o1({audit:i},t){let e=ba(i).map(({name:n,value:s})=>[n,a1(n,s,t)]);return F("div",{},F("p",{class:Po(i)?"sound":"broken",text:Po(i)?"\u2713 audit passed":"\u2717 audit violated"}),...Ar(i).map(n=>F("p",{class:"warning",text:n})),Td(e))}function a1(i,t,e){return i!=="penetration: time"||typeof t!="number"?Io(t):F("button",{type:"button",class:"link",title:"Go there",onclick:()=>e.showDeepest()},`${Io(t)} s`)}var pr=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10],sc=class{constructor(t,e){this.begin=t;this.end=e;this.isPlaying=!1;this.isLooping=!0;this.speed=1;this.time=t}advance(t){if(!this.isPlaying||this.end<=this.begin)return!1;let e=this.time+t*this.speed;return e<this.end?this.time=e:this.isLooping?this.time=this.begin+(e-this.begin)%(this.end-this.begin):(this.time=this.end,this.isPlaying=!1),!0}seek(t){this.time=Math.min(Math.max(t,this.begin),this.end)}toggle(){this.isPlaying=!this.isPlaying,this.isPlaying&&this.time>=this.end&&(this.time=this.begin)}changeSpeed(t){let e=pr.indexOf(this.speed)+t;this.speed=pr[Math.min(Math.max(e,0),pr.length-1)]}};function Hg(i,t,e){let n=zn(i,t),s=i[n]<t,r=n+e+(s&&e<0?1:0);return i[Math.min(Math.max(r,0),i.length-1)]}function Cd(i){let t=i.filter(a=>a>0&&Number.isFinite(a)),e=1e-9,n=t.length>0?Math.floor(Math.log10(Math.min(...t))+e):-1,s=Math.max(n+1,t.length>0?Math.ceil(Math.log10(Math.max(...t))-e)+0:0),r=Math.ceil((s-n)/8),o=[];for(let a=n;a<=s;a+=r)o.push(a);return{low:n,high:s,ticks:o}}function Rd({low:i,high:t},e){return(Math.log10(e)-i)/(t-i)}function Gg(i,t){return i.points.filter(e=>e.error>0&&t(e)>0)}function Wg({references:i}){let t=i.map(({error:e})=>e??0).filter(e=>e>0);return t.length>0?Math.max(...t):void 0}var l1="http://www.w3.org/2000/svg",$e={width:420,height:260,left:66,right:12,top:10,bottom:44},c1=[{title:"Error over CPU time",name:"CPU time [s]",x:({cpu_time:i})=>i},{title:"Error over step",name:"step [s]",x:({step:i})=>i}];function qg(i){let{references:t,curves:e}=i,n=e.map(({label:o},a)=>F("span",{},F("span",{class:"dot",style:`background:${Bn(a)}`}),o||"all runs")),s=e.flatMap(({points:o})=>o).filter(({error:o})=>o===0).length,r=s>0?`${s} ${s===1?"run has":"runs have"} no error and no place on a logarithmic axis.`:"";return F("section",{class:"precision"},F("h3",{},"Work and precision",F("small",{text:` errors against: ${t.map(({name:o})=>o).join("; ")}`})),F("span",{class:"legend"},...n),F("div",{class:"plots"},...c1.map(o=>F("section",{class:"plot"},F("h3",{text:o.title}),h1(i,o)))),r?F("p",{class:"hint",text:r}):void 0)}function Ei(i,t,...e){let n=document.createElementNS(l1,i);for(let[s,r]of Object.entries(t))n.setAttribute(s,String(r));return n.append(...e),n}function h1(i,{title:t,name:e,x:n}){let s=i.curves.map(d=>Gg(d,n)),r=Wg(i),o=Cd(s.flat().map(n)),a=Cd([...s.flat().map(({error:d})=>d),...r===void 0?[]:[r]]),l=d=>$e.left+Rd(o,d)*($e.width-$e.left-$e.right),c=d=>$e.height-$e.bottom-Rd(a,d)*($e.height-$e.top-$e.bottom),h=Ei("svg",{viewBox:`0 0 ${$e.width} ${$e.height}`,role:"img","aria-label":`${t}, logarithmic axes`});return h.append(...u1(o,a,e,l,c)),r!==void 0&&h.append(Ei("line",{class:"own",x1:$e.left,x2:$e.width-$e.right,y1:c(r),y2:c(r)},Xg(`the reference's own error, ${he(r,3)} m`))),s.forEach((d,u)=>{h.append(Ei("polyline",{points:d.map(f=>`${l(n(f))},${c(f.error)}`).join(" "),stroke:Bn(u)}));for(let f of d)h.append(Ei("circle",{cx:l(n(f)),cy:c(f.error),r:4,fill:Bn(u)},Xg(d1(f))))}),h}function u1(i,t,e,n,s){let r=$e.height-$e.bottom,o=$e.width-$e.right;return[...i.ticks.flatMap(a=>[Ei("line",{x1:n(10**a),x2:n(10**a),y1:$e.top,y2:r}),Ei("text",{x:n(10**a),y:r+15,"text-anchor":"middle"},`1e${a}`)]),...t.ticks.flatMap(a=>[Ei("line",{x1:$e.left,x2:o,y1:s(10**a),y2:s(10**a)}),Ei("text",{x:$e.left-6,y:s(10**a)+4,"text-anchor":"end"},`1e${a}`)]),Ei("text",{x:($e.left+o)/2,y:$e.height-8,"text-anchor":"middle"},e),Ei("text",{x:0,y:0,"text-anchor":"middle",transform:`translate(14 ${($e.top+r)/2}) rotate(-90)`},"error [m]")]}function Xg(i){return Ei("title",{},i)}function d1({label:i,step:t,cpu_time:e,error:n,order:s}){let r=s===null?"":`, observed order ${he(s,3)}`;return`${i}: error ${he(n,3)} m, step ${he(t,3)} s, CPU time ${he(e,3)} s${r}`}var Yg={type:"change"},Id={type:"start"},Zg={type:"end"},rc=new ir,$g=new bi,f1=Math.cos(70*sg.DEG2RAD),fn=new N,Wn=2*Math.PI,Ie={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Pd=1e-6,oc=class extends Zl{constructor(t,e=null){super(t,e),this.state=Ie.NONE,this.enabled=!0,this.target=new N,this.cursor=new N,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:cr.ROTATE,MIDDLE:cr.DOLLY,RIGHT:cr.PAN},this.touches={ONE:hr.ROTATE,TWO:hr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new N,this._lastQuaternion=new Nn,this._lastTargetPosition=new N,this._quat=new Nn().setFromUnitVectors(t.up,new N(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ia,this._sphericalDelta=new ia,this._scale=1,this._panOffset=new N,this._rotateStart=new _t,this._rotateEnd=new _t,this._rotateDelta=new _t,this._panStart=new _t,this._panEnd=new _t,this._panDelta=new _t,this._dollyStart=new _t,this._dollyEnd=new _t,this._dollyDelta=new _t,this._dollyDirection=new N,this._mouse=new _t,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=m1.bind(this),this._onPointerDown=p1.bind(this),this._onPointerUp=g1.bind(this),this._onContextMenu=w1.bind(this),this._onMouseWheel=x1.bind(this),this._onKeyDown=_1.bind(this),this._onTouchStart=b1.bind(this),this._onTouchMove=M1.bind(this),this._onMouseDown=v1.bind(this),this._onMouseMove=y1.bind(this),this._interceptControlDown=S1.bind(this),this._interceptControlUp=E1.bind(this),this.domElement!==null&&this.connect(),this.update()}connect(){this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Yg),this.update(),this.state=Ie.NONE}update(t=null){let e=this.object.position;fn.copy(e).sub(this.target),fn.applyQuaternion(this._quat),this._spherical.setFromVector3(fn),this.autoRotate&&this.state===Ie.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Wn:n>Math.PI&&(n-=Wn),s<-Math.PI?s+=Wn:s>Math.PI&&(s-=Wn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(fn.setFromSpherical(this._spherical),fn.applyQuaternion(this._quatInverse),e.copy(this.target).add(fn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=fn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new N(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new N(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=fn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(rc.origin.copy(this.object.position),rc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(rc.direction))<f1?this.object.lookAt(this.target):($g.setFromNormalAndCoplanarPoint(this.object.up,this.target),rc.intersectPlane($g,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Pd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Pd||this._lastTargetPosition.distanceToSquared(this.target)>Pd?(this.dispatchEvent(Yg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Wn/60*this.autoRotateSpeed*t:Wn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){fn.setFromMatrixColumn(e,0),fn.multiplyScalar(-t),this._panOffset.add(fn)}_panUp(t,e){this.screenSpacePanning===!0?fn.setFromMatrixColumn(e,1):(fn.setFromMatrixColumn(e,0),fn.crossVectors(this.object.up,fn)),fn.multiplyScalar(t),this._panOffset.add(fn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;fn.copy(s).sub(this.target);let r=fn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Wn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Wn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateUp(Wn*this.rotateSpeed/this.domElement.clientHeight):this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateUp(-Wn*this.rotateSpeed/this.domElement.clientHeight):this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateLeft(Wn*this.rotateSpeed/this.domElement.clientHeight):this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateLeft(-Wn*this.rotateSpeed/this.domElement.clientHeight):this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Wn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Wn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new _t,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function p1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function m1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function g1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Zg),this.state=Ie.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function v1(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case cr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ie.DOLLY;break;case cr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ie.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ie.ROTATE}break;case cr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ie.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ie.PAN}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(Id)}function y1(i){switch(this.state){case Ie.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ie.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ie.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function x1(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ie.NONE||(i.preventDefault(),this.dispatchEvent(Id),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Zg))}function _1(i){this.enabled===!1||this.enablePan===!1||this._handleKeyDown(i)}function b1(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case hr.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Ie.TOUCH_ROTATE;break;case hr.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Ie.TOUCH_PAN;break;default:this.state=Ie.NONE}break;case 2:switch(this.touches.TWO){case hr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ie.TOUCH_DOLLY_PAN;break;case hr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ie.TOUCH_DOLLY_ROTATE;break;default:this.state=Ie.NONE}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(Id)}function M1(i){switch(this._trackPointer(i),this.state){case Ie.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ie.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ie.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ie.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ie.NONE}}function w1(i){this.enabled!==!1&&i.preventDefault()}function S1(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function E1(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Jg(i){i.traverse(t=>{let{geometry:e,material:n}=t;e?.dispose();for(let s of[n??[]].flat()){for(let{value:r}of Object.values(s.uniforms??{}))r instanceof Un&&r.dispose();s.dispose()}})}function Kg(i){let t=4294967295;for(let e=0;e<i.length;++e)t=A1[(t^i[e])&255]^t>>>8;return(t^4294967295)>>>0}var A1=Uint32Array.from({length:256},(i,t)=>{let e=t;for(let n=0;n<8;++n)e=e&1?3988292384^e>>>1:e>>>1;return e>>>0});var fe=class extends Error{};async function ac(i){let t=T1(i);if(t.length!==i.size)throw new fe(`the ${i.kind} block is cut: ${t.length} of ${i.size} bytes are there`);if(Kg(t).toString(16).padStart(8,"0")!==i.crc)throw new fe(`the ${i.kind} block is damaged: its checksum is not ${i.crc}`);let e=await C1(t,i.kind);if(e.length!==i.rawSize)throw new fe(`the ${i.kind} block has ${e.length} bytes instead of ${i.rawSize}`);return e}function jg(i){return[...i.querySelectorAll("script.rigor-data")].map(t=>({run:Number(t.dataset.run??0),kind:t.dataset.kind??"unnamed",rawSize:Number(t.dataset.raw??-1),size:Number(t.dataset.size??-1),crc:t.dataset.crc??"",text:t.textContent??""}))}function T1(i){try{let t=i.text.trim(),e=atob(t.slice(0,t.length-t.length%4)),n=new Uint8Array(e.length);for(let s=0;s<e.length;++s)n[s]=e.charCodeAt(s);return n}catch{throw new fe(`the ${i.kind} block is damaged: it holds characters that are not base64`)}}async function C1(i,t){if(typeof DecompressionStream>"u")throw new fe("this browser cannot decompress data (DecompressionStream); a newer one can");try{let e=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}catch{throw new fe(`the ${t} block is damaged: it cannot be decompressed`)}}var Bi=class{constructor(t){this.bytes=t;this.at=0;this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}get left(){return this.bytes.length-this.at}u32(){return this.view.getUint32(this.take(4),!0)}f32(){return this.view.getFloat32(this.take(4),!0)}f64(){return this.view.getFloat64(this.take(8),!0)}varint(){let t=this.bytes,e=t[this.at++];if(e<128)return e&1?-(e+1)/2:e/2;let n=e&127,s=128;do{if(this.at>=t.length)throw new fe("a block ends inside a number");e=t[this.at++],n+=(e&127)*s,s*=128}while(e>=128);return n%2?-(n+1)/2:n/2}column(t,e,n,s,r){let o=0,a=0;for(let l=0,c=s;l<t;++l,c+=r){let h=this.varint()+(l<2?o:2*o-a);n[c]=h*e,a=o,o=h}if(this.at>this.bytes.length)throw new fe("a block ends before its last number")}exactColumn(t){let e=Array.from({length:8},()=>this.take(t)),n=new DataView(new ArrayBuffer(8*t)),s=0n,r=0n;for(let o=0;o<t;++o){let a=0n;for(let h of e)a=a<<8n|BigInt(this.bytes[h+o]);let l=a&1n?-(a>>1n)-1n:a>>1n,c=BigInt.asUintN(64,l+(o<2?s:2n*s-r));n.setBigUint64(8*o,c),r=s,s=c}return Float64Array.from({length:t},(o,a)=>n.getFloat64(8*a))}take(t){if(this.left<t)throw new fe("a block ends before its last number");return this.at+=t,this.at-t}};function la(i){return{position:new Float32Array(3*i),orientation:new Float32Array(4*i),velocity:new Float32Array(3*i),spin:new Float32Array(3*i)}}var lc=class{constructor(t){this.header=t;this.count=0;this.moving=t.bodies.flatMap((n,s)=>n.motion==="static"?[]:[s]);let e=this.moving.length*t.frames;this.position=new Float32Array(3*e),this.velocity=new Float32Array(3*e),this.spin=new Float32Array(3*e),this.components=new Int16Array(3*e),this.largest=new Uint8Array(e)}addChunk(t){let e=new Bi(t),n=e.f64(),s=e.f64(),r=e.u32(),o=e.u32(),a=this.moving.length;if(o!==a||this.count+r>this.header.frames)throw new fe("a frames block does not belong to this run");for(let l=0;l<a;++l){let c=this.count*a+l,h=(d,u)=>{for(let f=0;f<3;++f)e.column(r,u,d,3*c+f,3*a)};h(this.position,this.header.position_step),e.column(r,1,this.largest,c,a),h(this.components,1),h(this.velocity,n),h(this.spin,s)}this.count+=r}orientation(t,e,n,s){let r=t*this.moving.length+e;R1(this.largest[r],this.components,3*r,n,s)}};function R1(i,t,e,n,s){let r=Math.SQRT1_2/32767,o=1;for(let a=0,l=0;a<4;++a){if(a===i)continue;let c=t[e+l++]*r;n[s+(a+3&3)]=c,o-=c*c}n[s+(i+3&3)]=Math.sqrt(Math.max(0,o))}var cc=class{constructor(t,e,n,s){this.center=e;this.offset=s;this.group=new Vn;this.planes=[];let r=10**Math.floor(Math.log10(n/6));t.bodies.forEach((o,a)=>{for(let l of t.looks[o.look]){if(l.type!=="plane")continue;let c=new _n({glslVersion:Oi,vertexShader:Sg,fragmentShader:Eg,transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1,uniforms:{uColor:{value:new le},uLine:{value:new le},uCell:{value:r},uReach:{value:4*n},uShift:{value:[0,0]}}}),h=new Mn(new Cs(8*n,8*n),c);h.renderOrder=-1,this.planes.push({body:a,shape:l,mesh:h}),this.group.add(h)}})}get isEmpty(){return this.planes.length===0}floor(t){let e=new N(...t.gravity).normalize().negate();for(let{body:n,mesh:s}of this.planes){let r=new N(0,0,1).applyQuaternion(s.quaternion);if(t.bodies[n].motion==="static"&&r.dot(e)>.5)return{normal:r,distance:r.dot(s.position)}}}setColors(t,e){for(let{mesh:n}of this.planes)n.material.uniforms.uColor.value.setStyle(t,""),n.material.uniforms.uLine.value.setStyle(e,"")}update(t){for(let{body:e,shape:n,mesh:s}of this.planes){let r=new Nn().fromArray(t.orientation,4*e),o=new N().fromArray(t.position,3*e).add(new N(...this.offset)),[a,l,c,h]=n.q;o.add(new N(...n.p).applyQuaternion(r)),r.multiply(new Nn(l,c,h,a));let d=new N(...n.normal??[0,0,1]),u=new Nn().setFromUnitVectors(new N(0,0,1),d),f=o.clone().add(d.clone().multiplyScalar(n.offset??0).applyQuaternion(r));r.multiply(u);let g=this.center.clone().sub(f).applyQuaternion(r.clone().invert());s.quaternion.copy(r),s.position.copy(new N(g.x,g.y,0).applyQuaternion(r).add(f)),s.material.uniforms.uShift.value=[g.x,g.y]}}};function ca(i){let t=i.radius??1,e=i.half_length??1;switch(i.type){case"sphere":return{key:"sphere",scale:[t,t,t]};case"box":return{key:"box",scale:i.half_extents??[1,1,1]};case"ellipsoid":return{key:"ellipsoid",scale:i.radii??[1,1,1]};case"cylinder":case"cone":return{key:i.type,scale:[t,t,e]};case"capsule":return{key:`capsule ${e/t}`,scale:[t,t,t]};case"plane":return{key:"plane",scale:[1,1,1]};case"convex":case"mesh":return{key:`mesh ${i.mesh}`,scale:[1,1,1]}}}function ha(i,t){let[e,n]=i.split(" ");switch(e){case"sphere":return new Cs(2,2);case"box":return P1();case"ellipsoid":return new Yl(1,32,20).rotateX(Math.PI/2);case"cylinder":return new or(1,1,2,40).rotateX(Math.PI/2);case"cone":return new uo(1,2,40).rotateX(Math.PI/2);case"capsule":return new Xl(1,2*Number(n),8,24).rotateX(Math.PI/2);default:return I1(t[Number(n)])}}function P1(){let i=new qe,t=[[1,1,1],[-1,1,1],[-1,-1,1],[1,-1,1],[1,-1,-1],[1,1,-1],[-1,1,-1]];return i.setAttribute("position",new ze(new Float32Array(t.flat()),3)),i.setIndex([0,1,2,0,2,3,0,3,4,0,4,5,0,5,6,0,6,1]),i}function I1(i){let t=new Float32Array(3*i.triangles.length);i.triangles.forEach((n,s)=>t.set(i.vertices.subarray(3*n,3*n+3),3*s));let e=new qe;return e.setAttribute("position",new ze(t,3)),e.computeVertexNormals(),e}var L1=2e6,ua=class{constructor(t,e,n,s){this.header=t;this.options=s;this.group=new Vn;this.batches=[];this.shadows=new Vn;this.plane={value:new We(0,0,1,0)};this.light={value:new N(.2,.1,1).normalize()};let r=Yi(s.tint??Re.ghost);this.uniforms={uUp:{value:n},uPick:{value:0},uAlpha:{value:s.isGhost?.4:1},uTint:{value:new We(...r,s.isGhost?.75:0)},uSelected:{value:new N(...Yi(Re.selected))},uWarning:{value:new N(...Yi(Re.penetration))}};let o=new Map;t.bodies.forEach((a,l)=>{for(let c of vs(t,l)){let{key:h}=ca(c);if(h==="plane")continue;let d=o.get(h)??[];o.set(h,d),d.push({body:l,shape:c})}});for(let[a,l]of o)this.addBatch(a,l,e);this.group.add(this.shadows),this.shadows.visible=!1}castOn(t,e){this.plane.value.set(t.x,t.y,t.z,e);let n=new N(.3,.2,0).projectOnPlane(t);this.light.value.copy(t).add(n).normalize(),this.shadows.visible=!this.options.isGhost}set hasShadows(t){this.shadows.visible=t}update(t){for(let e of this.batches){let n=e.pose.image.data;e.items.forEach((s,r)=>F1(t,s,this.options.offset,8*r,n)),e.pose.needsUpdate=!0}}mark(t,e){for(let n of this.batches){let s=n.pose.image.data;n.items.forEach(({body:r},o)=>s[8*o+3]=r===t?1:e.has(r)?2:0),n.pose.needsUpdate=!0}}setPicking(t){this.uniforms.uPick.value=t?1:0,this.shadows.traverse(e=>e.layers.set(t?1:0))}addBatch(t,e,n){let s=t==="sphere",r=t==="box",o=Qg(e.length),a={uPose:{value:o},uLook:{value:this.lookTable(e)}},l=new _n({glslVersion:Oi,vertexShader:s?_g:r?yg:vg,fragmentShader:s?bg:xg,uniforms:{...this.uniforms,...a,uIsRound:{value:N1(t)?1:0},uIsFlat:{value:r?1:0}},side:r?hi:Fi,transparent:this.options.isGhost});this.group.add(t0(ha(t,n),e.length,l));let c=s?new ql(1,2):r?new sr(2,2,2):ha(t,n),h=t0(c,e.length,this.shadowMaterial(a));h.renderOrder=1,this.shadows.add(h),this.batches.push({items:e,pose:o})}lookTable(t){let e=Qg(t.length),n=e.image.data;return t.forEach(({body:s,shape:r},o)=>{n.set(ca(r).scale,8*o),n[8*o+3]=s,n.set(Yi(r.color||sf(this.header.bodies[s].motion,s)),8*o+4)}),e}shadowMaterial(t){return new _n({glslVersion:Oi,vertexShader:Mg,fragmentShader:wg,uniforms:{uPlane:this.plane,uLight:this.light,...t},transparent:!0,side:hi,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2,stencilWrite:!0,stencilRef:0,stencilFunc:eg,stencilZPass:tg})}};function Qg(i){let t=Math.max(1,Math.ceil(2*i/2048)),e=new Fl(new Float32Array(4*2048*t),2048,t,jn,Mi);return e.needsUpdate=!0,e}function t0(i,t,e){let n=i.getAttribute("position").count,s=new Mn(n*t<=L1?D1(i,t):U1(i,t),e);return s.frustumCulled=!1,s}function D1(i,t){let e=new qe,n=i.getAttribute("position").count;for(let r of["position","normal"]){let o=i.getAttribute(r);if(!o)continue;let a=new Float32Array(3*n*t);for(let l=0;l<t;++l)a.set(o.array,3*n*l);e.setAttribute(r,new ze(a,3))}let s=i.index?.array??Uint32Array.from({length:n},(r,o)=>o);return e.setIndex(new ze(Uint32Array.from({length:s.length*t},(r,o)=>s[o%s.length]+n*Math.floor(o/s.length)),1)),e.setAttribute("shapeIndex",new ze(Float32Array.from({length:n*t},(r,o)=>Math.floor(o/n)),1)),e}function U1(i,t){let e=new po;e.index=i.index;for(let n of["position","normal"]){let s=i.getAttribute(n);s&&e.setAttribute(n,s)}return e.setAttribute("shapeIndex",new rr(Float32Array.from({length:t},(n,s)=>s),1)),e.instanceCount=t,e}function N1(i){return/^(cylinder|cone|capsule|ellipsoid)/.test(i)}function F1(i,{body:t,shape:e},n,s,r){let o=i.orientation,a=o[4*t],l=o[4*t+1],c=o[4*t+2],h=o[4*t+3],[d,u,f]=e.p,g=2*(l*f-c*u),y=2*(c*d-a*f),m=2*(a*u-l*d);r[s]=i.position[3*t]+n[0]+d+h*g+l*m-c*y,r[s+1]=i.position[3*t+1]+n[1]+u+h*y+c*g-a*m,r[s+2]=i.position[3*t+2]+n[2]+f+h*m+a*y-l*g;let[p,S,w,x]=e.q;r[s+4]=h*S+a*p+l*x-c*w,r[s+5]=h*w-a*x+l*p+c*S,r[s+6]=h*x+a*w-l*S+c*p,r[s+7]=h*p-a*S-l*w-c*x}var O1=3e3,e0=.5,hc=class{constructor(t,e,n,s,r){this.source=e;this.ghost=n;this.extent=s;this.ghostColor=r;this.followed=-1;this.onChange=()=>{};this.scene=new Nl;this.camera=new Dn(40,0,.01,1e3);this.content=new Vn;this.line=new dr;this.pixel={value:.001};this.ratio={value:1};this.followedAt=new N;this.canShadow=!1;this.slowness=0;this.quality=1;this.renderer=new Ul({antialias:!0,stencil:!0,powerPreference:"high-performance"}),this.renderer.outputColorSpace="srgb-linear",this.canvas=this.renderer.domElement,this.canvas.setAttribute("aria-label","The scene. Drag to turn, scroll to come closer, click a body to see its numbers."),t.append(this.canvas);let o=new N(...e.header.gravity);this.up=o.length()>0?o.clone().normalize().negate():new N(0,0,1),this.camera.up.copy(this.up),this.controls=new oc(this.camera,this.canvas),this.controls.addEventListener("change",()=>this.onChange()),this.scene.add(this.line.lines),this.build(e.times[0])}setRuns(t,e,n,s,r){let o=new N(...this.source.header.origin).sub(new N(...t.header.origin));this.camera.position.add(o),this.controls.target.add(o),this.controls.update(),this.followed=-1,this.source=t,this.ghost=e,this.extent=n,this.ghostColor=r,this.content.removeFromParent(),Jg(this.content),this.build(s)}build(t){let{source:e,ghost:n,extent:s}=this,{header:r}=e;if(this.content=new Vn,this.scene.add(this.content),this.motion=la(r.bodies.length),this.shapes=new ua(r,e.meshes,this.up,{isGhost:!1,offset:[0,0,0]}),this.ground=new cc(r,new N(...s.center),s.radius,[0,0,0]),this.marks=new nc(e,s.radius,this.pixel,this.ratio),this.content.add(this.ground.group,this.shapes.group),this.content.add(this.marks.trails.lines,this.marks.links.lines,this.marks.arrows.mesh,this.marks.ring.points,this.marks.dots.points),this.ghostShapes=void 0,n){let a=n.header.origin.map((l,c)=>l-r.origin[c]);this.ghostMotion=la(n.header.bodies.length),this.ghostShapes=new ua(n.header,n.meshes,this.up,{isGhost:!0,offset:a,tint:this.ghostColor}),this.content.add(this.ghostShapes.group)}e.sample(t,this.motion),this.ground.update(this.motion),this.theme&&this.setTheme(...this.theme);let o=this.ground.floor(r);this.canShadow=o!==void 0&&r.bodies.reduce((a,l)=>a+r.looks[l.look].length,0)<=O1,o&&this.canShadow&&this.shapes.castOn(o.normal,o.distance)}fit(){let t=Math.abs(this.up.z)>.7?new N(.35,-1,0):new N(.35,.2,1),e=l=>l.projectOnPlane(this.up).normalize().addScaledVector(this.up,.42).normalize(),n=[e(t.clone()),e(new N().crossVectors(this.up,t))],s=n.map(l=>this.distanceToSeeAll(l)),r=s[1]<.8*s[0]?1:0,o=n[r],a=s[r];this.controls.target.set(...this.extent.center),this.camera.position.copy(this.controls.target).addScaledVector(o,a),this.camera.near=a/500,this.camera.far=a*60,this.camera.updateProjectionMatrix(),this.controls.minDistance=a/200,this.controls.maxDistance=a*20,this.controls.update()}distanceToSeeAll(t){let e=Math.tan(this.camera.fov*Math.PI/360),n=new N().crossVectors(this.up,t).normalize(),s=new N().crossVectors(t,n),r=0;for(let o=0;o<8;++o){let a=new N(...this.extent.half.map((h,d)=>o&1<<d?h:-h)),l=Math.abs(a.dot(n))/this.camera.aspect,c=Math.abs(a.dot(s));r=Math.max(r,Math.max(l,c)/e+a.dot(t))}return 1.12*r}setTheme(t,e,n){this.theme=[t,e,n],this.scene.background=new le().setStyle(t,""),this.ground.setColors(e,n)}resize(t,e){let n=this.camera.aspect===0,s=Math.min(window.devicePixelRatio,2)*this.quality;this.ratio.value=s,this.renderer.setPixelRatio(s),this.renderer.setSize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),n&&this.fit(),this.pixel.value=2*Math.tan(this.camera.fov*Math.PI/360)/e}draw(t,e,n,s,r){this.source.sample(t,this.motion),this.shapes.update(this.motion),this.shapes.hasShadows=this.canShadow&&e.shadows,this.ground.update(this.motion);let o=e.contacts||e.penetration?this.source.contactsAt(t):[],a=o.filter(({gap:c})=>c<-this.source.header.contact_tolerance),l=e.penetration?a.flatMap(({bodyA:c,bodyB:h})=>[c,h]):[];this.shapes.mark(n,new Set([...l,...r])),this.marks.update(t,this.motion,o,e,n,s),this.ghostShapes&&this.ghost&&this.ghostMotion&&(this.ghostShapes.group.visible=e.ghost,e.ghost&&(this.ghost.sample(t,this.ghostMotion),this.ghostShapes.update(this.ghostMotion))),this.follow(),this.renderer.render(this.scene,this.camera)}pick(t,e){let n=this.renderer.getSize(new _t),s=new wi(1,1),r=this.scene.background,o=[this.ground.group,this.marks.trails.lines,this.marks.links.lines,this.marks.arrows.mesh,this.marks.ring.points,this.marks.dots.points,this.ghostShapes?.group],a=o.map(c=>c?.visible);o.forEach(c=>c&&(c.visible=!1)),this.shapes.setPicking(!0),this.scene.background=null,this.camera.setViewOffset(n.x,n.y,t,e,1,1),this.renderer.setRenderTarget(s),this.renderer.setClearColor(0,0),this.renderer.clear(),this.renderer.render(this.scene,this.camera);let l=new Uint8Array(4);return this.renderer.readRenderTargetPixels(s,0,0,1,1,l),this.renderer.setRenderTarget(null),this.camera.clearViewOffset(),this.shapes.setPicking(!1),this.scene.background=r,o.forEach((c,h)=>c&&(c.visible=a[h]??!0)),s.dispose(),l[3]===255?l[0]+256*l[1]+65536*l[2]:-1}rayAt(t,e){let n=this.renderer.getSize(new _t),s=new N(2*t/n.x-1,1-2*e/n.y,.5).unproject(this.camera),r=this.camera.position;return{from:r.toArray(),direction:s.sub(r).normalize().toArray(),forward:this.camera.getWorldDirection(new N).toArray()}}set canTurn(t){this.controls.enabled=t}showLine(t){this.line.clear(),t&&this.line.add(t[0],t[1],Yi(Re.impulse)),this.line.commit()}startFollowing(t){if(this.followed=t,t<0)return;this.followedAt.fromArray(this.motion.position,3*t);let e=this.followedAt.clone().sub(this.controls.target);this.controls.target.add(e),this.camera.position.add(e),this.controls.update()}noteFrameTime(t){return this.slowness=t>1/30?this.slowness+1:Math.max(0,this.slowness-2),this.slowness<12||this.quality<=e0?!1:(this.slowness=0,this.quality=Math.max(e0,.75*this.quality),!0)}get resolution(){return this.quality}follow(){if(this.followed<0)return;let t=new N().fromArray(this.motion.position,3*this.followed),e=t.clone().sub(this.followedAt);this.controls.target.add(e),this.camera.position.add(e),this.followedAt.copy(t),this.camera.lookAt(this.controls.target)}};var k1={c:"contacts",v:"velocities",x:"frames",i:"inertia",j:"joints",t:"trails",p:"penetration",g:"ghost",h:"shadows"},_o=class{constructor(t,e,n,s){this.source=t;this.ghost=e;this.selected=-1;this.shown={...Dg};this.stage=F("div",{class:"stage"});this.flagged=[];this.isDirty=!0;this.lastNumbers=0;this.view=this.makeView(n),this.help=B1(s)}begin(){this.panel.updateShown(),this.panel.showEvent(void 0),new ResizeObserver(()=>this.resize()).observe(this.stage),window.addEventListener("keydown",t=>this.press(t)),window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.applyTheme()),this.resize(),this.applyTheme(),requestAnimationFrame(t=>this.frame(t))}select(t){this.selected=t,this.plots.showBody(t),t<0&&this.view?.startFollowing(-1),this.invalidate()}follow(t){this.view?.startFollowing(this.view.followed===t?-1:t),this.invalidate()}positionOf(t){return this.view?Ye(this.view.motion.position,t).map((e,n)=>e+this.source.header.origin[n]):[]}drawScene(){this.view?.draw(this.time,this.shown,this.selected,this.event,this.flagged)}invalidate(){this.isDirty=!0}setEvent(t){this.event!==t&&(this.event=t,this.panel.showEvent(t))}resize(){this.view?.resize(Math.max(1,this.stage.clientWidth),Math.max(1,this.stage.clientHeight)),this.invalidate()}tools(){return F("span",{class:"tools"},Ce("\u2302","Look at the whole scene again (R)",()=>this.home()),Ce("\u2913","Save a picture (S)",()=>this.savePicture()),Ce("\u25D0","Dark or light (D)",()=>this.changeTheme()),Ce("?","Keyboard help (?)",()=>this.help.showModal()))}makeView(t){try{let e=new hc(this.stage,this.source,this.ghost,t,Bn(1));e.onChange=()=>this.isDirty=!0;let n=[0,0];return e.canvas.addEventListener("pointerdown",s=>n=[s.clientX,s.clientY]),e.canvas.addEventListener("click",s=>{Math.hypot(s.clientX-n[0],s.clientY-n[1])>4||this.select(e.pick(s.offsetX,s.offsetY))}),e}catch{this.stage.append(F("p",{class:"hint",text:"This browser gives no WebGL 2, so the scene cannot be drawn; all the rest of the page is here."}));return}}home(){this.view?.startFollowing(-1),this.view?.fit(),this.invalidate()}changeTheme(){let t=getComputedStyle(this.element).getPropertyValue("--is-dark").trim()==="1";document.documentElement.dataset.theme=t?"light":"dark",this.applyTheme()}applyTheme(){let t=getComputedStyle(this.element),e=n=>t.getPropertyValue(n).trim();this.view?.setTheme(e("--stage"),e("--ground"),e("--ground-line")),this.plots.redraw(),this.redrawTicks(),this.invalidate()}savePicture(){this.drawScene(),this.view?.canvas.toBlob(t=>t&&Dd(`${this.source.header.scene}-${qi(this.time,1e-4)}s.png`,t))}press(t){let e=t.target;if(t.ctrlKey||t.metaKey||t.altKey)return;if(e.matches("input:not([type=checkbox]), select")){t.key==="Escape"&&e.blur();return}let n={f:()=>this.selected>=0&&this.follow(this.selected),r:()=>this.home(),s:()=>this.savePicture(),d:()=>this.changeTheme(),"/":()=>this.panel.search.focus(),"?":()=>this.help.open?this.help.close():this.help.showModal(),Escape:()=>this.help.open?this.help.close():this.select(-1),...this.keys(t)},s=k1[t.key],r=s?()=>this.flip(s):n[t.key];r&&(t.preventDefault(),r(),this.invalidate())}flip(t){this.shown[t]=!this.shown[t],this.panel.updateShown()}};function Dd(i,t){let e=F("a",{href:URL.createObjectURL(t),download:i});e.click(),URL.revokeObjectURL(e.href)}function B1(i){let t=F("dialog",{class:"help","aria-label":"Keyboard help"},F("h2",{text:"Keys"}),F("table",{},...i.map(([e,n])=>F("tr",{},F("th",{scope:"row"},...e.split(" ").map(s=>F("kbd",{text:s}))),F("td",{text:n})))),F("p",{text:"Mouse: drag turns, right drag shifts, wheel comes closer, a click chooses a body. Time line: a click on a tick shows that impact."}),Ce("Close","Close",()=>t.close()));return t}var bo=class{constructor(t){this.run=t;this.kind="recorded";this.impacts=new Map;let e=new Map(t.frames.moving.map((n,s)=>[n,s]));for(let n of t.events){if(n.kind!=="impact")continue;let s=zn(t.times,n.time),r=this.impacts.get(s)??new Map;this.impacts.set(s,r);for(let o of[n.bodyA,n.bodyB]){let a=e.get(o);a!==void 0&&r.set(a,[r.get(a)?.[0]??n.time,n.time])}}}get header(){return this.run.header}get meshes(){return this.run.meshes}get times(){return this.run.times}get series(){return this.run.series}get events(){return this.run.events}get moving(){return this.run.frames.moving}get frames(){return this.run.frames}get frameTimes(){return this.run.times}contactsAt(t){return this.run.contacts.at(zn(this.run.times,t))}sample(t,e){let{times:n,frames:s,header:r}=this.run,o=zn(n,t),a=Math.min(o+1,n.length-1),l=n[a]-n[o],c=l>0?Math.min(Math.max(t-n[o],0),l):0,h=this.impacts.get(o),d=s.moving.length;r.bodies.forEach((u,f)=>{u.motion==="static"&&z1(u.start.p,u.start.q,r.origin,f,e)});for(let u=0;u<d;++u){let f=s.moving[u],g=c>0&&c<l?h?.get(u):void 0,y=3*(o*d+u),m=3*(a*d+u);for(let p=0;p<3;++p){let S=s.position[y+p],w=s.position[m+p],x=s.velocity[y+p],D=s.velocity[m+p];e.position[3*f+p]=g?H1(S,x,w,D,l,c,g[0]-n[o],g[1]-n[o]):c>0?V1(S,x,w,D,l,c):S;let C=g?c<g[1]-n[o]:c<l,R=g?C?0:1:l>0?c/l:0;e.velocity[3*f+p]=x+R*(D-x),e.spin[3*f+p]=s.spin[y+p]+R*(s.spin[m+p]-s.spin[y+p])}s.orientation(o,u,e.orientation,4*f),c>0&&(s.orientation(a,u,n0,0),G1(e.orientation,4*f,n0,c/l))}}},n0=new Float32Array(4);function z1(i,t,e,n,s){for(let r=0;r<3;++r)s.position[3*n+r]=i[r]-e[r],s.orientation[4*n+r]=t[r+1];s.orientation[4*n+3]=t[0]}function V1(i,t,e,n,s,r){let o=r/s,a=1-o;return a*a*((1+2*o)*i+r*t)+o*o*((1+2*a)*e-(s-r)*n)}function H1(i,t,e,n,s,r,o,a){let l=i+t*o,c=e-n*(s-a),h=o===a?(l+c)/2:l,d=o===a?h:c;return r<=o?i0(i,t,h,o,r):r>=a?i0(e,-n,d,s-a,s-r):h+(d-h)*(r-o)/(a-o)}function i0(i,t,e,n,s){return n>0?i+t*s+(e-i-t*n)*(s/n)**2:e}function G1(i,t,e,n){let s=0;for(let a=0;a<4;++a)s+=i[t+a]*e[a];let r=s<0?-1:1,o=0;for(let a=0;a<4;++a)i[t+a]+=n*(r*e[a]-i[t+a]),o+=i[t+a]**2;o=1/Math.sqrt(o);for(let a=0;a<4;++a)i[t+a]*=o}var W1=5,Mo=class{constructor(t,e,n,s){this.range=t;this.resolution=n;this.actions=s;this.ticks=F("canvas");this.handle=F("div",{class:"handle"});this.events=[];this.impactTimes=new Float64Array;this.impacts=[];this.element=F("div",{class:"line",id:"scrubber",role:"slider",tabindex:0,"aria-label":"Time","aria-valuemin":t.begin,"aria-valuemax":t.end},this.ticks,this.handle),this.element.addEventListener("pointerdown",r=>this.press(r)),this.element.addEventListener("pointermove",r=>{this.element.hasPointerCapture(r.pointerId)?s.seek(this.timeAt(r.clientX)):this.element.title=this.hint(r.clientX)}),this.setEvents(e),new ResizeObserver(()=>this.drawTicks()).observe(this.element)}setEvents(t){this.events=t,this.impacts=t.flatMap((e,n)=>e.kind==="impact"?[n]:[]),this.impactTimes=Float64Array.from(this.impacts,e=>t[e].time),this.element.setAttribute("aria-valuemax",String(this.range.end)),this.drawTicks()}get hasImpacts(){return this.impacts.length>0}update(t,e=this.resolution){this.handle.style.left=`${100*this.placeOf(t)}%`,this.element.setAttribute("aria-valuenow",t.toFixed(6)),this.element.setAttribute("aria-valuetext",`${qi(t,e)} seconds`)}impactFrom(t,e){let n=1e-9*Math.max(1,Math.abs(t)),s=this.impactTimes;if(s.length===0)return;let r=zn(s,t+n);return e===1?r=s[r]>t+n?r:r+1:r=zn(s,t-n),r<s.length&&(e===1||s[r]<t-n)?this.impacts[r]:void 0}drawTicks(){let t=this.element.clientWidth,e=this.element.clientHeight;if(t===0)return;let n=window.devicePixelRatio||1;this.ticks.width=t*n,this.ticks.height=e*n;let s=this.ticks.getContext("2d");if(!s)return;s.scale(n,n);let r=getComputedStyle(this.element),o={impact:r.getPropertyValue("--impact"),other:r.getPropertyValue("--quiet")},a=new Set;for(let l of this.events){let c=Math.round(this.placeOf(l.time)*t),h=l.kind==="impact",d=`${c} ${h}`;a.has(d)||(a.add(d),s.fillStyle=h?o.impact:o.other,s.fillRect(c-.5,h?4:e-8,1,h?e-14:6))}}placeOf(t){let{begin:e,end:n}=this.range;return n>e?(t-e)/(n-e):0}timeAt(t){let e=this.element.getBoundingClientRect(),n=Math.min(1,Math.max(0,(t-e.left)/e.width));return this.range.begin+n*(this.range.end-this.range.begin)}tickAt(t){let e=Rp(this.impactTimes,this.timeAt(t));if(e<0)return;let n=this.element.getBoundingClientRect();return Math.abs(n.left+this.placeOf(this.impactTimes[e])*n.width-t)<=W1?this.impacts[e]:void 0}hint(t){let e=this.tickAt(t);return e===void 0?`${qi(this.timeAt(t),this.resolution)} s`:`impact at ${he(this.events[e].time,8)} s`}press(t){this.element.focus();let e=this.tickAt(t.clientX);if(e!==void 0){this.actions.showEvent(e);return}this.element.setPointerCapture(t.pointerId),this.actions.seek(this.timeAt(t.clientX))}};var uc=class{constructor(t,e,n,s){this.playback=t;this.resolution=n;this.line=new Mo(t,e,n,s),this.play=Ce("\u25B6","Play or pause (space)",()=>s.toggle()),this.play.id="play",this.loop=Ce("\u27F3","Loop (L)",()=>{t.isLooping=!t.isLooping,this.update()}),this.speed=F("select",{title:"Speed (\u2212 and +)","aria-label":"Speed",onchange:()=>t.speed=Number(this.speed.value)},...pr.map(r=>F("option",{value:r},_a(r)))),this.clock=F("span",{class:"clock"}),this.impactButtons=[Ce("\u21E4 impact","Previous impact ([)",()=>s.nextImpact(-1)),Ce("impact \u21E5","Next impact (])",()=>s.nextImpact(1))],this.element=F("div",{class:"transport"},F("div",{class:"buttons"},Ce("|\u25C2","First frame (Home)",()=>s.seek(t.begin)),Ce("\u2039","One frame back (\u2190)",()=>s.step(-1)),this.play,Ce("\u203A","One frame on (\u2192)",()=>s.step(1)),Ce("\u25B8|","Last frame (End)",()=>s.seek(t.end)),this.loop,this.speed,...this.impactButtons,this.clock),this.line.element),this.setEvents(e)}setEvents(t){this.line.setEvents(t);for(let e of this.impactButtons)e.hidden=!this.line.hasImpacts}update(){let{playback:t}=this;this.play.textContent=t.isPlaying?"\u275A\u275A":"\u25B6",this.loop.classList.toggle("on",t.isLooping),this.loop.setAttribute("aria-pressed",String(t.isLooping)),this.speed.value=String(t.speed);let e=this.resolution*Math.min(1,t.speed);this.clock.textContent=`${qi(t.time,e)} / ${he(t.end)} s`,this.line.update(t.time,e)}};var X1=100,dc=class extends _o{constructor(e){let n=e.runs.map(h=>new bo(h)),[s,r]=n;super(s,r,aa(s.header,s.frames),Bg);this.lastFrame=0;this.sources=n;let o=n.map(h=>h.times);this.playback=new sc(Math.min(...o.map(h=>h[0])),Math.max(...o.map(h=>h[h.length-1]))),this.transport=new uc(this.playback,s.events,s.header.output_interval,{toggle:()=>this.toggle(),step:h=>this.step(h),seek:h=>this.seek(h),showEvent:h=>this.showEvent(h),nextImpact:h=>this.nextImpact(h)}),this.panel=new xo(s,this.shown,r!==void 0,{select:h=>this.select(h),follow:h=>this.follow(h),changed:()=>this.invalidate(),showDeepest:()=>this.showDeepest()});let a=n.length>1,l=h=>this.seek(h);this.plots=a?new oa(n,{a:0,b:1},l):new yo(s,l);let c=a?new wa(n,{a:0,b:1},h=>this.showRuns(h)).element:void 0;this.element=F("div",{class:a?"app comparison":"app"},this.head(),c,...e.problems.map(h=>F("p",{class:"problem",role:"alert",text:h})),F("div",{class:"middle"},this.stage,this.panel.element),this.transport.element,this.plots.element,e.precision?qg(e.precision):void 0,a?rf(n):void 0,this.help)}toggle(){this.playback.toggle(),this.setEvent(void 0),this.invalidate()}seek(e){this.setEvent(void 0),this.flagged=[],this.playback.seek(e),this.invalidate()}step(e){this.playback.isPlaying=!1,this.seek(Hg(this.source.times,this.playback.time,e))}showEvent(e){let n=this.source.events[e];this.playback.isPlaying=!1,this.playback.seek(n.time),this.setEvent(n),this.invalidate()}nextImpact(e){let n=this.transport.line.impactFrom(this.playback.time,e);n!==void 0&&this.showEvent(n)}showRuns({a:e,b:n}){let s=a=>a<0?-1:this.sources[e].header.bodies.findIndex(({name:l})=>l===this.source.header.bodies[a].name),r=s(this.selected),o=s(this.view?.followed??-1);this.source=this.sources[e],this.ghost=this.sources[n],this.setEvent(void 0),this.flagged=[],this.view?.setRuns(this.source,this.ghost,aa(this.source.header,this.source.frames),this.playback.time,Bn(n)),this.panel.setSource(this.source),this.transport.setEvents(this.source.events),this.plots instanceof oa&&this.plots.setRuns({a:e,b:n}),this.select(r),o>=0&&this.follow(o)}head(){let{header:e}=this.source,n=e.audit.method,s=this.sources.length>1?`${this.sources.length} runs`:[n?.scheme,n?.integrator,n?.impact].filter(Boolean).join(" \xB7 ");return F("header",{},F("h1",{text:e.scene}),F("span",{class:"about",text:`${s} \xB7 ${e.bodies.length} ${e.bodies.length===1?"body":"bodies"} \xB7 ${this.source.times.length} frames`}),this.tools())}get time(){return this.playback.time}frame(e){requestAnimationFrame(s=>this.frame(s));let n=Math.min(.25,(e-this.lastFrame)/1e3);this.lastFrame=e,this.playback.advance(n)&&(this.isDirty=!0,this.view?.noteFrameTime(n)&&this.resize()),this.isDirty&&(this.isDirty=!1,this.draw(e))}draw(e){let{time:n,isPlaying:s}=this.playback;this.drawScene(),this.transport.update(),!(s&&e-this.lastNumbers<X1)&&(this.lastNumbers=e,this.plots.setTime(n),this.view&&this.panel.showBody(this.selected,this.view.motion,this.selected<0?[]:this.source.contactsAt(n),this.view.followed))}invalidate(){super.invalidate(),this.lastNumbers=0}redrawTicks(){this.transport.line.drawTicks()}showDeepest(){let{audit:e,bodies:n}=this.source.header,s=e.penetration;s?.time!=null&&(this.playback.isPlaying=!1,this.seek(s.time),this.flagged=(s.bodies??[]).map(r=>n.findIndex(o=>o.name===r)))}keys(e){let n=e.shiftKey?10:1;return{" ":()=>this.toggle(),ArrowLeft:()=>this.step(-n),ArrowRight:()=>this.step(n),Home:()=>this.seek(this.playback.begin),End:()=>this.seek(this.playback.end),"[":()=>this.nextImpact(-1),"]":()=>this.nextImpact(1),"-":()=>this.playback.changeSpeed(-1),"+":()=>this.playback.changeSpeed(1),"=":()=>this.playback.changeSpeed(1),l:()=>this.playback.isLooping=!this.playback.isLooping,P:()=>this.showDeepest()}}};function s0(i,t){let e=t.center.map((s,r)=>s-t.half[r]),n=t.center.map((s,r)=>s+t.half[r]);for(let s of i.bodies.filter(({motion:r})=>r==="static"))for(let r of i.looks[s.look]){if(r.type!=="plane")continue;let o=r.normal??[0,0,1],a=Ne(s.start.q,Ne(r.q,o)),l=Gn(Gn(s.start.p,Ne(s.start.q,r.p)),a.map(d=>d*(r.offset??0))),c=a.reduce((d,u,f)=>d+u*(t.center[f]+i.origin[f]-l[f]),0);if(!(c>0)||c>60*t.radius)continue;let h=t.center.map((d,u)=>d-c*a[u]);e=e.map((d,u)=>Math.min(d,h[u])),n=n.map((d,u)=>Math.max(d,h[u]))}return{center:e.map((s,r)=>(s+n[r])/2),half:e.map((s,r)=>(n[r]-s)/2),radius:Math.hypot(...e.map((s,r)=>n[r]-s))/2}}var q1=50,fc=class{constructor(t,e){this.send=e;this.element=F("div",{class:"control"});this.errors=F("div",{class:"errors",role:"alert"});this.fileNote=F("p",{class:"hint",id:"file"});this.settings=F("div");this.setters=[];this.isBuilt=!1;let n=Math.hypot(...t.gravity);this.down=n>0?t.gravity.map(s=>s/n):[0,0,-1],this.follow=F("input",{type:"checkbox",id:"follow",onchange:()=>e({do:"follow",value:this.follow.checked})}),this.element.append(this.errors,this.settings,F("h3",{text:"Scene file"}),this.fileNote,F("label",{},this.follow,"Read it again when it changes"),Ce("Read it now","Read the scene file again, from t = 0",()=>e({do:"reload"})))}showErrors(t){this.errors.replaceChildren(...t.map(e=>F("p",{class:"warning",text:e})))}update(t){this.isBuilt||this.build(t);for(let a of this.setters)a(t);let{name:e,follow:n,changed:s,messages:r}=t.file;this.follow.checked=n;let o=r.map(a=>F("span",{class:"warning",text:a}));this.fileNote.replaceChildren(e,s?" has changed":"",...o.flatMap(a=>[F("br"),a]))}build(t){this.isBuilt=!0;let e=Ud("Gravity","m/s\xB2","gravity",[0,30,.01],n=>this.send({do:"gravity",value:this.down.map(s=>s*n)}));this.setters.push(n=>e.set(Math.hypot(...n.gravity))),this.settings.append(F("h3",{text:"World"}),e.element,this.stepField()),this.settings.append(F("h3",{text:"Materials"})),t.surfaces.slice(0,q1).forEach(({material:n},s)=>{let r=Ud(`${n}: friction`,"",`friction-${s}`,[0,2,.01],a=>this.send({do:"surface",material:n,friction:a})),o=Ud(`${n}: restitution`,"",`restitution-${s}`,[0,1,.01],a=>this.send({do:"surface",material:n,restitution:a}));this.setters.push(a=>{r.set(a.surfaces[s].friction),o.set(a.surfaces[s].restitution)}),this.settings.append(r.element,o.element)}),this.settings.append(F("p",{class:"hint",text:"Pairs of materials that the scene gives values of their own keep them."}),F("h3",{text:"Method"})),t.method.forEach((n,s)=>{let r=F("select",{id:`method-${n.key}`,disabled:n.values.length<2,onchange:()=>this.send({do:"method",key:n.key,value:r.value})},...n.values.map(o=>F("option",{value:o},o)));this.setters.push(o=>r.value=o.method[s]?.value??""),this.settings.append(F("label",{},F("span",{class:"name",text:n.key}),r))})}stepField(){let t=F("input",{type:"text",inputmode:"decimal",id:"target-step",onchange:()=>this.send({do:"target_step",value:Number(t.value)})});return this.setters.push(e=>{document.activeElement!==t&&(t.value=String(e.target_step))}),F("label",{},F("span",{class:"name",text:"Target step [s]"}),t)}};function Ud(i,t,e,[n,s,r],o){let a=!1,l=F("output",{}),c=u=>l.textContent=`${he(u,4)} ${t}`,h=F("input",{type:"range",id:e,min:n,max:s,step:r,"aria-label":i,oninput:()=>{c(Number(h.value)),o(Number(h.value))},onpointerdown:()=>a=!0,onpointerup:()=>a=!1,onpointercancel:()=>a=!1}),d=u=>{a||(u>Number(h.max)&&(h.max=String(u)),h.value=String(u),c(u))};return{element:F("label",{class:"slider"},F("span",{class:"name",text:i}),h,l),set:d}}var Y1=["open","stick","slide","unknown"],pc=class{constructor(){this.chunks=[];this.count=0}addChunk(t){let e=new DataView(t.buffer,t.byteOffset).getUint32(24,!0);this.chunks.push({first:this.count,bytes:t}),this.count+=e}at(t){let e=this.chunks.length-1;for(;e>0&&this.chunks[e].first>t;)--e;return e<0?[]:(this.unpacked?.chunk!==e&&(this.unpacked={chunk:e,frames:J1(this.chunks[e].bytes)}),this.unpacked.frames[t-this.chunks[e].first]??[])}},$1=11,Z1=i=>i>=2&&i<8;function J1(i){let t=new Bi(i),e=t.f64(),n=t.f64(),s=t.f64(),r=g=>Array.from({length:g},()=>t.varint()),o=r(t.u32()),a=o.reduce((g,y)=>g+y,0),l=r(a),c=r(a),h=Array.from({length:$1},()=>r(a)),d=new Map,u=new Map,f=0;return o.map(g=>{let y=new Map,m=0,p=-1,S=0,w=Array.from({length:g},()=>{let x=m+l[f],D=x+c[f];S=x===m&&D===p?S+1:0,[m,p]=[x,D];let C=`${x} ${D} ${S}`,R=u.get(C),U=d.get(C),E=h.map((b,T)=>b[f]+(R?R[T]+(U&&Z1(T)?R[T]-U[T]:0):0));return y.set(C,E),++f,K1(x,D,E,s,n,e)});return[d,u]=[u,y],w})}function K1(i,t,e,n,s,r){let o=(a,l)=>[e[a]*l,e[a+1]*l,e[a+2]*l];return{bodyA:i,bodyB:t,mode:Y1[e[0]]??"unknown",gap:e[1]*s,point:o(2,n),normal:o(5,1/1024),force:o(8,r)}}var Nd=["impact","rest","separation","slip_to_stick"];async function r0(i,t,e){if(i.length===0)throw new fe("this page holds no data blocks");let n=[];i.length<t&&n.push(`the page is cut: ${i.length} of ${t} data blocks are there`);let s=[],r=[...new Set(i.map(o=>o.run))];for(let o of r){let a=i.filter(c=>c.run===o),l=[];try{s.push(await Q1(a,l,c=>e((s.length+c)/r.length)))}catch(c){if(!(c instanceof fe))throw c;l.push(c.message)}n.push(...l.map(c=>r.length>1?`run ${o+1}: ${c}`:c))}if(s.length===0)throw new fe(n.join("; "));return{runs:s,precision:await j1(i,n),problems:n}}async function j1(i,t){let e=i.find(({kind:n})=>n==="precision");if(e)try{return JSON.parse(new TextDecoder().decode(await ac(e)))}catch(n){if(!(n instanceof fe))throw n;t.push(`${n.message}; the plots of work and precision are left out`);return}}async function Q1(i,t,e){let n=async a=>{let l=i.find(c=>c.kind===a);if(!l)throw new fe(`the ${a} block is missing`);return ac(l)},s=tE(await n("header")),r={header:s,meshes:iE(await n("meshes"),s),series:new Map,times:new Float64Array,events:[],frames:new lc(s),contacts:new pc},o=new Bi(await n("series"));if(r.events=await eE(s,t,n),await nE(i,r,t,e),r.frames.count===0)throw new fe([...t.splice(0),"no frame could be read"].join("; "));for(let{name:a}of s.series)r.series.set(a,o.exactColumn(s.frames).slice(0,r.frames.count));return r.times=r.series.get("time")??new Float64Array,r}function tE(i){let t=JSON.parse(new TextDecoder().decode(i));if(t.format!==1)throw new fe(`the data have format ${t.format}; this viewer knows format 1`);return t}async function eE(i,t,e){try{return sE(new Bi(await e("events")),i)}catch(n){if(!(n instanceof fe))throw n;return t.push(`${n.message}; no events are shown`),[]}}async function nE(i,t,e,n){let s=i.filter(r=>r.kind==="frames"||r.kind==="contacts");try{for(let r=0;r<s.length;++r){let o=await ac(s[r]);s[r].kind==="frames"?t.frames.addChunk(o):t.contacts.addChunk(o),n((r+1)/s.length)}}catch(r){if(!(r instanceof fe))throw r;e.push(r.message)}t.frames.count<t.header.frames&&e.push(`the first ${t.frames.count} of ${t.header.frames} frames are shown`)}function iE(i,t){let e=new Bi(i);return t.meshes.map(n=>({vertices:Float32Array.from({length:3*n.vertices},()=>e.f32()),triangles:Uint32Array.from({length:3*n.triangles},()=>e.u32())}))}function sE(i,t){let e=t.events,n=i.f64(),s=i.f64(),r=new Float64Array(e);i.column(e,n,r,0,1);let o=f=>Float64Array.from({length:f},()=>i.varint()),a=o(3*e),l=o(3*e),c=o(3*e),{origin:h,position_step:d}=t;return Array.from({length:e},(f,g)=>({kind:Nd[c[3*g+2]]??"impact",time:r[g],bodyA:c[3*g],bodyB:c[3*g+1],point:h.map((y,m)=>y+a[3*g+m]*d),impulse:[0,1,2].map(y=>l[3*g+y]*s)})).sort((f,g)=>f.time-g.time)}var ls=13,o0=13,rE=["open","stick","slide","unknown"];function a0(i){let t=JSON.parse(i);if(t.type!=="status"&&t.type!=="error")throw new fe("the server sent a text of an unknown kind");return t}function l0(i,t){let e=new DataView(i),n=i.byteLength>=8?e.getUint32(0,!0):0;if(n===1)return aE(i,e);if(n===2){let s=e.getUint32(4,!0);if(8+s>i.byteLength)throw new fe("a file from the server is cut");return{name:new TextDecoder().decode(new Uint8Array(i,8,s)),bytes:new Uint8Array(i,8+s)}}if(n===3)return oE(i,e,t);throw new fe("the server sent bytes of an unknown kind")}function oE(i,t,e){if(i.byteLength<28)throw new fe("a history is cut");let[r,o,a,l]=[4,8,12,16].map(u=>t.getUint32(u,!0)),c=28+8*o*a;if(i.byteLength!==c+44*l)throw new fe("a history has not the length that it tells");let h=Array.from({length:o},(u,f)=>Float64Array.from({length:a},(g,y)=>t.getFloat64(28+8*(y*o+f),!0))),d=Array.from({length:l},(u,f)=>{let g=c+44*f,y=m=>[0,4,8].map(p=>t.getFloat32(g+m+p,!0));return{time:t.getFloat64(g,!0),kind:Nd[t.getUint32(g+8,!0)]??"impact",bodyA:t.getInt32(g+12,!0),bodyB:t.getInt32(g+16,!0),point:y(20).map((m,p)=>m+e[p]),impulse:y(32)}});return{generation:r,columns:h,events:d.sort((u,f)=>u.time-f.time),eventCount:t.getFloat64(20,!0)}}function aE(i,t){if(i.byteLength<28)throw new fe("a frame is cut");let[n,s,r,o]=[4,8,12,16].map(h=>t.getUint32(h,!0)),a=28+8*o,l=a+4*ls*s;if(i.byteLength!==l+4*o0*r)throw new fe("a frame has not the length that it tells");let c=h=>t.getFloat32(h,!0);return{generation:n,time:t.getFloat64(20,!0),series:Float64Array.from({length:o},(h,d)=>t.getFloat64(28+8*d,!0)),bodies:Float32Array.from({length:ls*s},(h,d)=>c(a+4*d)),contacts:Array.from({length:r},(h,d)=>{let u=l+4*o0*d,f=g=>[c(u+g),c(u+g+4),c(u+g+8)];return{bodyA:t.getUint32(u,!0),bodyB:t.getUint32(u+4,!0),mode:rE[t.getUint32(u+8,!0)]??"unknown",gap:c(u+12),point:f(16),normal:f(28),force:f(40)}})}}var lE=1e3,mc=class{constructor(t,e){this.origin=t;this.listener=e;this.connect()}send(t){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(t)),!0)}connect(){let t=new WebSocket(`ws://${location.host}/live${location.search}`);this.socket=t,t.binaryType="arraybuffer",t.addEventListener("open",()=>this.listener.connected(!0)),t.addEventListener("message",e=>this.take(e.data)),t.addEventListener("close",()=>{this.listener.connected(!1),window.setTimeout(()=>this.connect(),lE)})}take(t){try{if(typeof t=="string"){let n=a0(t);n.type==="status"?this.listener.status(n):this.listener.errors(n.messages);return}let e=l0(t,this.origin);"name"in e?this.listener.file(e):"columns"in e?this.listener.history(e):this.listener.frame(e)}catch(e){if(!(e instanceof fe))throw e;this.listener.errors([e.message])}}};var cE=4e6,hE=1024,uE=16,gc=class{constructor(t){this.moving=t;this.count=0;this.spacing=0;let e=t.length,n=Math.min(hE,Math.max(uE,Math.floor(cE/(ls*Math.max(1,e)))));this.rowTimes=new Float64Array(n),this.position=new Float32Array(3*e*n),this.velocity=new Float32Array(3*e*n),this.spin=new Float32Array(3*e*n),this.turns=new Float32Array(4*e*n)}get times(){return this.rowTimes.subarray(0,this.count)}add(t,e){this.count>0&&t<this.rowTimes[this.count-1]&&(this.count=0,this.spacing=0);let n=this.count-1,s=n>=0&&(t===this.rowTimes[n]||n>=1&&this.rowTimes[n]-this.rowTimes[n-1]<this.spacing);!s&&this.count===this.rowTimes.length&&this.halve(),s||++this.count,this.set(this.count-1,t,e)}orientation(t,e,n,s){let r=4*(t*this.moving.length+e);for(let o=0;o<4;++o)n[s+o]=this.turns[r+o]}set(t,e,n){this.rowTimes[t]=e;for(let s=0;s<this.moving.length;++s){let r=t*this.moving.length+s,o=n.subarray(ls*s,ls*(s+1));this.position.set(o.subarray(0,3),3*r),this.turns.set(o.subarray(3,7),4*r),this.velocity.set(o.subarray(7,10),3*r),this.spin.set(o.subarray(10,13),3*r)}}halve(){let t=this.moving.length,e=this.rowTimes[this.count-1]-this.rowTimes[0];this.count=Math.ceil(this.count/2);for(let n=1;n<this.count;++n){this.rowTimes[n]=this.rowTimes[2*n];for(let s of[this.position,this.velocity,this.spin])s.copyWithin(3*t*n,6*t*n,6*t*n+3*t);this.turns.copyWithin(4*t*n,8*t*n,8*t*n+4*t)}this.spacing=e/this.count}};var vc=class{constructor(t){this.kind="live";this.events=[];this.eventCount=0;this.header=t.header,this.meshes=t.meshes,this.moving=t.frames.moving,this.newest=la(t.header.bodies.length);let e=new bo(t);e.sample(t.times[0],this.newest),this.contacts=e.contactsAt(t.times[0]),this.time=t.times[0],this.times=t.times,this.series=t.series,this.frames=new gc(this.moving),this.frames.add(this.time,Float32Array.from(this.moving.flatMap(n=>this.numbersOf(n))))}get frameTimes(){return this.frames.times}take(t){let{position:e,orientation:n,velocity:s,spin:r}=this.newest;this.moving.forEach((o,a)=>{let l=t.bodies.subarray(ls*a,ls*(a+1));e.set(l.subarray(0,3),3*o),n.set(l.subarray(3,7),4*o),s.set(l.subarray(7,10),3*o),r.set(l.subarray(10,13),3*o)}),this.contacts=t.contacts,this.time=t.time,this.frames.add(t.time,t.bodies),this.onFrame?.()}remember({columns:t,events:e,eventCount:n}){this.series=new Map(this.header.series.map(({name:s},r)=>[s,t[r]??new Float64Array])),this.times=this.series.get("time")??new Float64Array,this.events=e,this.eventCount=n,this.onHistory?.()}sample(t,e){e.position.set(this.newest.position),e.orientation.set(this.newest.orientation),e.velocity.set(this.newest.velocity),e.spin.set(this.newest.spin)}contactsAt(){return this.contacts}numbersOf(t){let{position:e,orientation:n,velocity:s,spin:r}=this.newest,o=a=>[...a.subarray(3*t,3*t+3)];return[...o(e),...n.subarray(4*t,4*t+4),...o(s),...o(r)]}};var yc=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],c0=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],wo=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2];function h0(i,t,e){let n=1/0;for(let s of t){let[r,o,a,l]=s.q,c=[r,-o,-a,-l],h={from:Ne(c,yc(i.from,s.p)),direction:Ne(c,i.direction)};n=Math.min(n,dE(h,s,e))}return Number.isFinite(n)?n:void 0}function dE(i,t,e){let{key:n,scale:s}=ca(t);if(n==="plane")return 1/0;if(n==="sphere")return fE(i,s[0]);if(n==="box")return pE(i,s);let r=ha(n,e),o=r.getAttribute("position"),a=r.index,l=d=>{let u=a?a.getX(d):d;return[o.getX(u)*s[0],o.getY(u)*s[1],o.getZ(u)*s[2]]},c=1/0,h=a?a.count:o.count;for(let d=0;d<h;d+=3)c=Math.min(c,mE(i,l(d),l(d+1),l(d+2)));return r.dispose(),c}function fE({from:i,direction:t},e){let n=wo(i,t),s=n*n-wo(i,i)+e*e,r=-n-Math.sqrt(s);return r>0?r:1/0}function pE({from:i,direction:t},e){let n=0,s=1/0;for(let r=0;r<3;++r){let o=(-e[r]-i[r])/t[r],a=(e[r]-i[r])/t[r];Number.isNaN(o)||Number.isNaN(a)||(n=Math.max(n,Math.min(o,a)),s=Math.min(s,Math.max(o,a)))}return n>0&&n<=s?n:1/0}function mE({from:i,direction:t},e,n,s){let r=yc(n,e),o=yc(s,e),a=c0(t,o),l=wo(r,a),c=yc(i,e),h=c0(c,r),d=wo(c,a)/l,u=wo(t,h)/l,f=wo(o,h)/l;return d>=0&&u>=0&&d+u<=1&&f>0?f:1/0}var xc=(i,t)=>[i[0]*t,i[1]*t,i[2]*t],Od=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],Fd=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2];function gE(i,t){return Gn(i.from,xc(i.direction,Fd(Od(t,i.from),i.direction)))}function vE(i,t,e){let n=Fd(i.direction,e),s=Fd(Od(t,i.from),e)/n;return Number.isFinite(s)&&s>0?Gn(i.from,xc(i.direction,s)):void 0}function u0(i,t,e){let[n,s,r,o]=ki(i,t);return Ne([n,-s,-r,-o],Od(e,Ye(i.position,t)))}var _c=class{constructor(t,e,n,s){this.stage=t;this.view=e;this.source=n;this.send=s;this.tool="turn";this.hitSpeed=2;this.isTold=!0;t.addEventListener("pointerdown",r=>this.press(r),{capture:!0}),t.addEventListener("pointermove",r=>this.move(r));for(let r of["pointerup","pointercancel"])t.addEventListener(r,()=>this.release())}update(){let t=this.grip;if(!t)return;let{motion:e}=this.view,n=Gn(Ye(e.position,t.body),Ne(ki(e,t.body),t.point));this.view.showLine([n,t.target]),!this.isTold&&(this.isTold=!0,this.send({do:"pull",body:t.body,point:t.point,target:Gn(t.target,this.source.header.origin)}))}press(t){if(t.button!==0)return;let e=t.shiftKey?"pull":t.altKey?"hit":this.tool;if(e==="turn")return;let[n,s]=this.placeOf(t),r=this.view.pick(n,s);if(r<0||this.source.header.bodies[r].motion!=="dynamic")return;let o=this.view.rayAt(n,s),a=this.surfacePoint(o,r),l=u0(this.view.motion,r,a);if(this.view.canTurn=!1,e==="hit"){this.send({do:"push",body:r,point:l,impulse:xc(o.direction,this.source.header.bodies[r].mass*this.hitSpeed)});return}this.grip={body:r,point:l,target:a,normal:o.forward},this.isTold=!1,this.stage.setPointerCapture(t.pointerId)}move(t){if(!this.grip)return;let e=vE(this.view.rayAt(...this.placeOf(t)),this.grip.target,this.grip.normal);e&&(this.grip.target=e,this.isTold=!1)}release(){this.view.canTurn=!0,this.grip&&(this.grip=void 0,this.view.showLine(void 0),this.send({do:"release"}))}surfacePoint(t,e){let{motion:n}=this.view,[s,r,o,a]=ki(n,e),l={from:u0(n,e,t.from),direction:Ne([s,-r,-o,-a],t.direction)},c=h0(l,vs(this.source.header,e),this.source.meshes);return c===void 0?gE(t,Ye(n.position,e)):Gn(t.from,xc(t.direction,c))}placeOf(t){let e=this.view.canvas.getBoundingClientRect();return[t.clientX-e.left,t.clientY-e.top]}};var yE=100,bc=class extends _o{constructor(e,n){super(new vc(e),void 0,s0(e.header,aa(e.header,e.frames)),zg);this.generation=n;this.lost=F("p",{class:"problem",role:"alert",text:"No connection to the simulation: it was ended, or another page took its place."});this.stopped=F("p",{class:"problem",role:"alert"});this.runButton=Ce("\u25B6","Run or pause (space)",()=>this.toggle());this.clock=F("span",{class:"clock"});this.range={begin:0,end:0};let{source:s}=this;this.range.end=s.time,this.control=new fc(e.header,r=>this.send(r)),this.panel=new xo(s,this.shown,!1,{select:r=>this.select(r),follow:r=>this.follow(r),changed:()=>this.invalidate(),showDeepest:()=>{}},this.control.element),this.plots=new yo(s,()=>this.showEvent(void 0)),this.line=new Mo(this.range,s.events,e.header.output_interval,{seek:()=>this.showEvent(void 0),showEvent:r=>this.showEvent(r)}),this.runButton.id="run",this.speed=F("select",{title:"Simulated seconds a second","aria-label":"Speed",onchange:()=>this.send({do:"speed",value:Number(this.speed.value)})},...[...pr,100,1e3].map(r=>F("option",{value:r},_a(r)))),this.view&&(this.tools3d=new _c(this.stage,this.view,s,r=>this.send(r))),this.stopped.hidden=!0,this.element=F("div",{class:"app live"},this.head(),this.lost,this.stopped,F("div",{class:"middle"},this.stage,this.panel.element),this.bar(),this.plots.element,this.help),s.onFrame=()=>this.invalidate(),s.onHistory=()=>this.takeHistory(),this.link=new mc(e.header.origin,{status:r=>this.showStatus(r),frame:r=>r.generation===this.generation&&s.take(r),history:r=>r.generation===this.generation&&s.remember(r),file:({name:r,bytes:o})=>Dd(r,new Blob([o])),errors:r=>this.control.showErrors(r),connected:r=>this.lost.hidden=r})}send(e){this.control.showErrors(this.link.send(e)?[]:["The simulation cannot be reached; nothing was changed."])}toggle(){this.send({do:this.status?.running?"pause":"run"})}showEvent(e){this.setEvent(e===void 0?void 0:this.source.events[e]),this.invalidate()}get time(){return this.source.time}redrawTicks(){this.line.drawTicks()}nextImpact(e){let n=this.line.impactFrom(this.event?.time??this.source.time,e);n!==void 0&&this.showEvent(n)}takeHistory(){let{times:e}=this.source;this.event&&this.event.time>e[e.length-1]&&this.setEvent(void 0),this.range.end=e[e.length-1]??0,this.line.setEvents(this.source.events),this.plots.refresh(),this.invalidate()}showStatus(e){if(e.generation!==this.generation)return window.location.reload();this.status=e,this.control.update(e),this.runButton.textContent=e.running?"\u275A\u275A":"\u25B6",document.activeElement!==this.speed&&(this.speed.value=String(e.speed)),this.stopped.hidden=e.stopped==="",this.stopped.textContent=Ma(`${e.stopped}. Change something or reset.`),this.invalidate()}head(){let{header:e}=this.source;return F("header",{},F("h1",{text:e.scene}),F("span",{class:"about",text:`live \xB7 ${e.bodies.length} ${e.bodies.length===1?"body":"bodies"}`}),this.tools())}bar(){let e=F("input",{type:"range",min:.1,max:20,step:.1,value:2,title:"Speed that a hit gives [m/s]","aria-label":"Speed that a hit gives",oninput:()=>this.tools3d&&(this.tools3d.hitSpeed=Number(e.value))}),n=new Map,s=r=>{this.tools3d&&(this.tools3d.tool=r);for(let[o,a]of n)a.classList.toggle("on",o===r),a.setAttribute("aria-pressed",String(o===r))};return n.set("turn",Ce("Turn","Drag turns the camera",()=>s("turn"))),n.set("pull",Ce("Pull","Drag pulls a body (Shift and drag)",()=>s("pull"))),n.set("hit",Ce("Hit","A click hits a body along the line of sight (Alt and click)",()=>s("hit"))),s("turn"),F("div",{class:"transport"},F("div",{class:"buttons"},this.runButton,Ce("\u203A","One output interval on (\u2192)",()=>this.send({do:"step"})),Ce("|\u25C2","Back to t = 0 (Home)",()=>this.send({do:"reset"})),this.speed,...n.values(),e,Ce("Save state","Keep a checkpoint for rigor run --resume",()=>this.send({do:"save"})),Ce("Export page","Keep what was recorded since t = 0 as a page of its own",()=>this.send({do:"export"})),this.clock),this.line.element)}frame(e){if(requestAnimationFrame(o=>this.frame(o)),!this.isDirty)return;if(this.isDirty=!1,this.drawScene(),this.tools3d?.update(),e-this.lastNumbers<yE){this.isDirty=!0;return}this.lastNumbers=e;let{source:n}=this,s=this.status?.running?` \xB7 ${he(this.status.rate,2)}\xD7`:"";this.clock.textContent=`${qi(n.time,n.header.output_interval)} s${s}`;let r=Math.min(this.event?.time??n.time,this.range.end);this.line.update(r),this.plots.refreshBody(),this.plots.setTime(r),this.view&&this.panel.showBody(this.selected,this.view.motion,this.selected<0?[]:n.contactsAt(),this.view.followed)}keys(){return{" ":()=>this.toggle(),ArrowRight:()=>this.send({do:"step"}),Home:()=>this.send({do:"reset"}),"[":()=>this.nextImpact(-1),"]":()=>this.nextImpact(1)}}};var d0='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var f0=`:root {
  --is-dark: 0; --page: #f6f7f9; --box: #ffffff; --text: #1c2430; --quiet: #7b8694; --edge: #d5dae1; --grid: #e3e7ec;
  --accent: #0072b2; --impact: #cc5fa0; --stage: #e9edf2; --ground: #f4f6f8; --ground-line: #b4bdc8; --warn: #b34700;
  color-scheme: light;
}
@media (prefers-color-scheme: dark) { :root:not([data-theme="light"]) {
  --is-dark: 1; --page: #14181e; --box: #1c222a; --text: #e4e9ef; --quiet: #8e9aa8; --edge: #323b46; --grid: #2b333d;
  --accent: #56b4e9; --impact: #cc79a7; --stage: #171c23; --ground: #232a33; --ground-line: #46525f; --warn: #e69f00;
  color-scheme: dark;
} }
:root[data-theme="dark"] {
  --is-dark: 1; --page: #14181e; --box: #1c222a; --text: #e4e9ef; --quiet: #8e9aa8; --edge: #323b46; --grid: #2b333d;
  --accent: #56b4e9; --impact: #cc79a7; --stage: #171c23; --ground: #232a33; --ground-line: #46525f; --warn: #e69f00;
  color-scheme: dark;
}
* { box-sizing: border-box; }
[hidden] { display: none !important; }
body { margin: 0; background: var(--page); color: var(--text); font: 14px/1.4 system-ui, sans-serif; }
h1, h2, h3, p { margin: 0; }
h3 { font-size: 13px; }
small, .hint, .about { color: var(--quiet); font-weight: normal; font-size: 12px; }
button, select, input[type="search"] {
  font: inherit; color: inherit; background: var(--box); border: 1px solid var(--edge); border-radius: 5px; padding: 3px 8px; min-height: 30px;
}
button { cursor: pointer; }
button:hover { border-color: var(--accent); }
button.on { border-color: var(--accent); color: var(--accent); }
button.link { border: 0; background: none; color: var(--accent); padding: 0; min-height: 0; text-align: left; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
.dot { display: inline-block; width: 10px; height: 10px; border-radius: 50%; margin-right: 4px; }

.app { display: flex; flex-direction: column; min-height: 100vh; }
.app > header { display: flex; align-items: baseline; gap: 4px 12px; padding: 6px 12px; flex-wrap: wrap; }
.app > header h1 { font-size: 16px; overflow-wrap: anywhere; }
.tools { margin-left: auto; display: flex; gap: 4px; }
.problem { background: var(--warn); color: #fff; padding: 6px 12px; }
.middle { display: flex; height: max(320px, calc(100vh - 345px)); border-top: 1px solid var(--edge); border-bottom: 1px solid var(--edge); }
.stage { flex: 1; min-width: 0; position: relative; background: var(--stage); overflow: hidden; }
.stage canvas { display: block; touch-action: none; outline: none; }
.stage .hint { padding: 24px; }

.panel { width: 340px; overflow: auto; background: var(--box); border-left: 1px solid var(--edge); }
.event { padding: 8px 12px; border-bottom: 1px solid var(--edge); }
.tabs { display: flex; position: sticky; top: 0; z-index: 1; background: var(--box); border-bottom: 1px solid var(--edge); }
.tabs button { flex: 1; border: 0; border-radius: 0; border-bottom: 2px solid transparent; background: none; min-height: 36px; }
.tabs button[aria-selected="true"] { border-color: var(--accent); color: var(--accent); }
.tab { padding: 8px 12px; }
.panel input[type="search"] { width: 100%; }
.found { list-style: none; margin: 6px 0; padding: 0; max-height: 132px; overflow: auto; }
.found button { border: 0; background: none; width: 100%; text-align: left; min-height: 24px; padding: 1px 6px; overflow-wrap: anywhere; }
.found button:hover { background: var(--grid); }
.numbers h3 { display: flex; align-items: baseline; gap: 6px; overflow-wrap: anywhere; }
.numbers h3 button { margin-left: auto; min-height: 24px; padding: 0 8px; }
.panel table { border-collapse: collapse; width: 100%; font-size: 12px; font-variant-numeric: tabular-nums; }
.panel th { text-align: left; font-weight: normal; color: var(--quiet); padding: 2px 8px 2px 0; vertical-align: top; }
.panel td { padding: 2px 0; overflow-wrap: anywhere; }
.contacts td, .contacts th { padding-right: 6px; }
.show label { display: flex; align-items: center; gap: 4px; min-height: 28px; }
.show input[type="range"] { flex: 1; }
.legend { display: flex; flex-wrap: wrap; gap: 2px 12px; font-size: 12px; padding: 6px 0; }
.sound { color: #009e73; font-weight: 600; }
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
.plot { min-width: 0; min-height: 210px; background: var(--box); border: 1px solid var(--edge); border-radius: 6px; padding: 6px; overflow: hidden; }
.plot h3 { display: flex; align-items: baseline; gap: 4px; min-height: 24px; }
.plot h3 select { margin-left: auto; min-height: 22px; padding: 0 4px; font-size: 12px; font-weight: normal; }
.plot .hint { padding: 24px 8px; }
.uplot, .u-legend { font: 11px/1.3 system-ui, sans-serif !important; }
.u-legend { color: var(--text); font-variant-numeric: tabular-nums; }
.u-cursor-x { border-right: 1px dashed var(--quiet) !important; }
.now { position: absolute; top: 0; bottom: 0; left: 0; width: 1px; background: var(--accent); pointer-events: none; }

.comparison .middle { height: max(320px, calc(100vh - 385px)); }
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
.precision svg text { fill: var(--text); font: 11px/1.3 system-ui, sans-serif; }
.audits { margin: 4px 12px 12px; padding: 6px 10px; background: var(--box); border: 1px solid var(--edge); border-radius: 6px; min-width: 0; }
.audits h3 { padding: 2px 0; }
.audits .wide { overflow-x: auto; }
.audits table { border-collapse: collapse; font-size: 12px; font-variant-numeric: tabular-nums; }
.plot h3 select { min-width: 0; }
.audits th[scope="row"] { position: sticky; left: 0; background: var(--box); }
.audits th { text-align: left; font-weight: normal; padding: 2px 14px 2px 0; white-space: nowrap; }
.audits thead th { font-weight: 600; max-width: 24em; overflow: hidden; text-overflow: ellipsis; }
.audits td { padding: 2px 14px 2px 0; vertical-align: top; min-width: 8em; }
.audits tr.same th, .audits tr.same td { color: var(--quiet); }
.audits td.differs { color: var(--accent); font-weight: 600; }
.audits .only tr.same { display: none; }
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
  .panel { width: auto; max-height: 300px; border-left: 0; border-top: 1px solid var(--edge); }
  .app > header, .transport, .plots { padding-left: 8px; padding-right: 8px; }
  .about { flex-basis: 100%; order: 3; }
  .buttons button, .buttons select { min-width: 0; padding: 3px 7px; min-height: 36px; }
}

.control h3 { margin-top: 10px; }
.control label { display: flex; align-items: center; gap: 6px; min-height: 30px; }
.control .name { flex: 0 0 42%; overflow-wrap: anywhere; }
.control input[type="range"], .control input[type="text"], .control select { flex: 1; min-width: 0; }
.control output { flex: 0 0 78px; text-align: right; font-variant-numeric: tabular-nums; }
.control input[type="text"] { font: inherit; color: inherit; background: var(--box); border: 1px solid var(--edge); border-radius: 5px; padding: 3px 8px; }
.buttons input[type="range"] { width: 80px; }
`;function p0(){let i=new CSSStyleSheet;i.replaceSync(d0+f0),document.adoptedStyleSheets=[i]}async function bE(){p0();let i=F("progress",{max:1,value:0}),t=F("main",{class:"message",id:"message",role:"status"},F("p",{text:"Reading the simulation \u2026"}),i);document.body.append(t);try{let e=Number(document.querySelector('meta[name="rigor-blocks"]')?.content??0),n=await r0(jg(document),e,o=>i.value=o);t.remove();let s=document.querySelector('meta[name="rigor-live"]'),r=s?new bc(n.runs[0],Number(s.content)):new dc(n);document.body.append(r.element),r.begin(),Object.assign(window,{rigor:r})}catch(e){e instanceof fe||console.error(e),t.replaceChildren(F("h1",{text:"This page cannot be shown"}),F("p",{text:e instanceof Error?`${e.message}.`:String(e)}),F("p",{text:"The file was probably cut or changed on its way. Write it again with: rigor run SCENE -o page.html"})),document.body.append(t)}}document.addEventListener("DOMContentLoaded",()=>void bE());})();
