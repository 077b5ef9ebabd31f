/* of sources 6728a4ce9ae549e0 */
"use strict";(()=>{function D(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===!1||r===null||r===void 0||(s.startsWith("on")?n.addEventListener(s.slice(2),r):s==="class"?n.className=r:n.setAttribute(s,r===!0?"":String(r)));for(let s of e)s!==null&&s!==!1&&n.append(s);return n}var As=i=>D("kbd",{"aria-hidden":"true"},i);function Re(i,t){i.textContent!==t&&(i.textContent=t)}function xe(i,t,e=""){if(i==null||!Number.isFinite(i))return"–";let n=i.toFixed(t);return`${Number(n)===0?n.replace("-",""):n.replace("-","−")}${e}`}function wi(i){let t=i<0?"−":"",e=Math.abs(i),n=Math.floor(e/60);return`${t}${n}:${(e-60*n).toFixed(1).padStart(4,"0")}`}function pl(i){let t=i.getBoundingClientRect(),e=Math.min(window.devicePixelRatio||1,2),n=Math.max(Math.round(t.width*e),1),s=Math.max(Math.round(t.height*e),1),r=i.width!==n||i.height!==s;return r&&(i.width=n,i.height=s),{width:t.width,height:t.height,scale:e,changed:r}}var V_=4,H_=24;function Vo(i,t,e){let[n]=i.map(s=>({sysid:s.sysid,off:Math.hypot(s.x-t,s.y-e)})).sort((s,r)=>s.off-r.off);return n&&n.off<H_?n.sysid:null}function xu(i,t,e){let[[n,s],[r,o]]=[0,1].map(a=>[t[a],e[a]].sort((l,c)=>l-c));return i.filter(a=>a.x>=n&&a.x<=s&&a.y>=r&&a.y<=o).map(a=>a.sysid)}var ml=class{constructor(t,{places:e,take:n,pick:s}){this.button=D("button",{type:"button","aria-pressed":"false",title:"select the vehicles in a box: drag it over the picture (or drag with Shift held); b selects all that are in the picture",onclick:()=>this.arm(!this.armed)},"box"),this.armed=!1;let r=D("div",{class:"box"});r.hidden=!0,t.append(r);let o=null,a=h=>{let{left:u,top:d,width:f,height:p}=t.getBoundingClientRect();return[Math.min(Math.max(h.clientX-u,0),f),Math.min(Math.max(h.clientY-d,0),p)]},l=(h,u)=>Math.hypot(h[0]-u[0],h[1]-u[1])>V_;t.addEventListener("pointerdown",h=>{o||h.button!==0||!(h.shiftKey||this.armed)||(h.stopPropagation(),o={id:h.pointerId,from:a(h)},t.setPointerCapture(h.pointerId))},{capture:!0}),t.addEventListener("pointermove",h=>{if(h.pointerId!==o?.id)return;h.stopPropagation();let u=a(h);r.hidden=!l(o.from,u);let[d,f]=[0,1].map(p=>Math.min(o.from[p],u[p]));Object.assign(r.style,{left:`${d}px`,top:`${f}px`,width:`${Math.abs(u[0]-o.from[0])}px`,height:`${Math.abs(u[1]-o.from[1])}px`})},{capture:!0});let c=h=>{if(h.pointerId!==o?.id)return;h.stopPropagation();let[u,d]=[o.from,a(h)];o=null,r.hidden=!0,h.type==="pointerup"&&(l(u,d)?n(xu(e(),u,d),h.shiftKey):s(Vo(e(),d[0],d[1]),h),this.arm(!1))};t.addEventListener("pointerup",c,{capture:!0}),t.addEventListener("pointercancel",c,{capture:!0})}arm(t){this.armed=t,this.button.setAttribute("aria-pressed",String(t))}};var W_="uplot",X_="u-hz",q_="u-vt",Y_="u-title",$_="u-wrap",Z_="u-under",J_="u-over",K_="u-axis",Qs="u-off",j_="u-select",Q_="u-cursor-x",ty="u-cursor-y",ey="u-cursor-pt",ny="u-legend",iy="u-live",sy="u-inline",ry="u-series",oy="u-marker",op="u-label",ay="u-value",Wo="width",Xo="height";var ap="bottom",Nr="left",vu="right",Ou="#000",lp=Ou+"0",Su="mousemove",cp="mousedown",Mu="mouseup",hp="mouseenter",up="mouseleave",dp="dblclick",ly="resize",cy="scroll",fp="change",vl="dppxchange",Bu="--",Gr=typeof window<"u",Au=Gr?document:null,Fr=Gr?window:null,hy=Gr?navigator:null,De,gl;function Cu(){let i=devicePixelRatio;De!=i&&(De=i,gl&&Pu(fp,gl,Cu),gl=matchMedia(`(min-resolution: ${De-.001}dppx) and (max-resolution: ${De+.001}dppx)`),tr(fp,gl,Cu),Fr.dispatchEvent(new CustomEvent(vl)))}function ii(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Ru(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Je(i,t,e){i.style[t]=e+"px"}function Ti(i,t,e,n){let s=Au.createElement(i);return t!=null&&ii(s,t),e?.insertBefore(s,n),s}function gi(i,t){return Ti("div",i,t)}var pp=new WeakMap;function Vi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=pp.get(i);r!=o&&(i.style.transform=r,pp.set(i,r),t<0||e<0||t>n||e>s?ii(i,Qs):Ru(i,Qs))}var mp=new WeakMap;function gp(i,t,e){let n=t+e,s=mp.get(i);n!=s&&(mp.set(i,n),i.style.background=t,i.style.borderColor=e)}var _p=new WeakMap;function yp(i,t,e,n){let s=t+""+e,r=_p.get(i);s!=r&&(_p.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var ku={passive:!0},uy={...ku,capture:!0};function tr(i,t,e,n){t.addEventListener(i,e,n?uy:ku)}function Pu(i,t,e,n){t.removeEventListener(i,e,ku)}Gr&&Cu();function Ei(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:si((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function qp(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Yp=i=>i!=null,$p=i=>i!=null&&i>0,bl=qp(Yp),dy=qp($p);function fy(i,t,e,n=0,s=!1){let r=s?dy:bl,o=s?$p:Yp;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??We,l??-We]}function wl(i,t,e,n){let s=Sp(i),r=Sp(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?ns:Zp,a=s==1?si:_i,l=r==1?_i:si,c=a(o(xn(i))),h=l(o(xn(t))),u=Or(e,c),d=Or(e,h);return e==10&&(c<0&&(u=Xe(u,-c)),h<0&&(d=Xe(d,-h))),n||e==2?(i=u*s,t=d*r):(i=Qp(i,u),t=Tl(t,d)),[i,t]}function zu(i,t,e,n){let s=wl(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Gu=.1,xp={mode:3,pad:Gu},Yo={pad:0,soft:null,mode:0},py={min:Yo,max:Yo};function Sl(i,t,e,n){return El(e)?vp(i,t,e):(Yo.pad=e,Yo.soft=n?0:null,Yo.mode=n?3:0,vp(i,t,py))}function Ie(i,t){return i??t}function my(i,t,e){for(t=Ie(t,0),e=Ie(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function vp(i,t,e){let n=e.min,s=e.max,r=Ie(n.pad,0),o=Ie(s.pad,0),a=Ie(n.hard,-We),l=Ie(s.hard,We),c=Ie(n.soft,We),h=Ie(s.soft,-We),u=Ie(n.mode,0),d=Ie(s.mode,0),f=t-i,p=ns(f),x=Xn(xn(i),xn(t)),g=ns(x),m=xn(g-p);(f<1e-24||m>10)&&(f=0,(i==0||t==0)&&(f=1e-24,u==2&&c!=We&&(r=0),d==2&&h!=-We&&(o=0)));let _=f||x||1e3,M=ns(_),v=Or(10,si(M)),C=_*(f==0?i==0?.1:1:r),T=Xe(Qp(i-C,v/10),24),y=i>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:We,b=Xn(a,T<y&&i>=y?y:Ai(y,T)),U=_*(f==0?t==0?.1:1:o),P=Xe(Tl(t+U,v/10),24),R=t<=h&&(d==1||d==3&&P>=h||d==2&&P<=h)?h:-We,G=Ai(l,P>R&&t<=R?R:Xn(R,P));return b==G&&b==0&&(G=100),[b,G]}var gy=new Intl.NumberFormat(Gr?hy.language:"en-US"),Vu=i=>gy.format(i),ri=Math,xl=ri.PI,xn=ri.abs,si=ri.floor,yn=ri.round,_i=ri.ceil,Ai=ri.min,Xn=ri.max,Or=ri.pow,Sp=ri.sign,ns=ri.log10,Zp=ri.log2,_y=(i,t=1)=>ri.sinh(i)*t,bu=(i,t=1)=>ri.asinh(i/t),We=1/0;function Mp(i){return(ns((i^i>>31)-(i>>31))|0)+1}function Iu(i,t,e){return Ai(Xn(i,t),e)}function Jp(i){return typeof i=="function"}function Ae(i){return Jp(i)?i:()=>i}var yy=()=>{},Kp=i=>i,jp=(i,t)=>t,xy=i=>null,bp=i=>!0,wp=(i,t)=>i==t,vy=/\.\d*?(?=9{6,}|0{6,})/gm,er=i=>{if(em(i)||Rs.has(i))return i;let t=`${i}`,e=t.match(vy);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${er(s)}e${r}`}return Xe(i,n)};function Ks(i,t){return er(Xe(er(i/t))*t)}function Tl(i,t){return er(_i(er(i/t))*t)}function Qp(i,t){return er(si(er(i/t))*t)}function Xe(i,t=0){if(em(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return yn(n)/e}var Rs=new Map;function tm(i){return((""+i).split(".")[1]||"").length}function Zo(i,t,e,n){let s=[],r=n.map(tm);for(let o=t;o<e;o++){let a=xn(o),l=Xe(Or(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Xe(h,u);s.push(d),Rs.set(d,u)}}return s}var $o={},Hu=[],Br=[null,null],Cs=Array.isArray,em=Number.isInteger,Sy=i=>i===void 0;function Tp(i){return typeof i=="string"}function El(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function My(i){return i!=null&&typeof i=="object"}var by=Object.getPrototypeOf(Uint8Array),nm="__proto__";function kr(i,t=El){let e;if(Cs(i)){let n=i.find(s=>s!=null);if(Cs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=kr(i[s],t)}else e=i.slice()}else if(i instanceof by)e=i.slice();else if(t(i)){e={};for(let n in i)n!=nm&&(e[n]=kr(i[n],t))}else e=i;return e}function fn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=nm&&(El(i[s])?fn(i[s],kr(n[s])):i[s]=kr(n[s]))}return i}var wy=0,Ty=1,Ey=2;function Ay(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Cy(i,t){if(Iy(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Ly(o[0])||(o=Py(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[o][c]:Ty,f=[];for(let p=0;p<h.length;p++){let x=h[p],g=r.get(l[p]);x===null?d!=wy&&(u[g]=x,d==Ey&&f.push(g)):u[g]=x}Ay(u,f,s),n.push(u)}}return n}var Ry=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Py(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function Iy(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Ly(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Xn(1,si((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var im=["January","February","March","April","May","June","July","August","September","October","November","December"],sm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function rm(i){return i.slice(0,3)}var Dy=sm.map(rm),Ny=im.map(rm),Uy={MMMM:im,MMM:Ny,WWWW:sm,WWW:Dy};function Ho(i){return(i<10?"0":"")+i}function Fy(i){return(i<10?"00":i<100?"0":"")+i}var Oy={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Ho(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ho(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Ho(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ho(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ho(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Fy(i.getMilliseconds())};function Wu(i,t){t=t||Uy;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Oy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var By=new Intl.DateTimeFormat().resolvedOptions().timeZone;function ky(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==By?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var om=i=>i%1==0,Ml=[1,2,2.5,5],zy=Zo(10,-32,0,Ml),am=Zo(10,0,32,Ml),Gy=am.filter(om),js=zy.concat(am),Xu=`
`,lm="{YYYY}",Ep=Xu+lm,cm="{M}/{D}",qo=Xu+cm,_l=qo+"/{YY}",hm="{aa}",Vy="{h}:{mm}",Ur=Vy+hm,Ap=Xu+Ur,Cp=":{ss}",Oe=null;function um(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Zo(10,0,3,Ml).filter(om):Zo(10,-3,0,Ml)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,lm,Oe,Oe,Oe,Oe,Oe,Oe,1],[s*28,"{MMM}",Ep,Oe,Oe,Oe,Oe,Oe,1],[s,cm,Ep,Oe,Oe,Oe,Oe,Oe,1],[n,"{h}"+hm,_l,Oe,qo,Oe,Oe,Oe,1],[e,Ur,_l,Oe,qo,Oe,Oe,Oe,1],[t,Cp,_l+" "+Ur,Oe,qo+" "+Ur,Oe,Ap,Oe,1],[i,Cp+".{fff}",_l+" "+Ur,Oe,qo+" "+Ur,Oe,Ap,Oe,1]];function h(u){return(d,f,p,x,g,m)=>{let _=[],M=g>=o,v=g>=r&&g<o,C=u(p),T=Xe(C*i,3),y=wu(C.getFullYear(),M?0:C.getMonth(),v||M?1:C.getDate()),b=Xe(y*i,3);if(v||M){let U=v?g/r:0,P=M?g/o:0,R=T==b?T:Xe(wu(y.getFullYear()+P,y.getMonth()+U,1)*i,3),G=new Date(yn(R/i)),H=G.getFullYear(),N=G.getMonth();for(let W=0;R<=x;W++){let B=wu(H+P*W,N+U*W,1),k=B-u(Xe(B*i,3));R=Xe((+B+k)*i,3),R<=x&&_.push(R)}}else{let U=g>=s?s:g,P=si(p)-si(T),R=b+P+Tl(T-b,U);_.push(R);let G=u(R),H=G.getHours()+G.getMinutes()/e+G.getSeconds()/n,N=g/n,W=d.axes[f]._space,B=m/W;for(;R=Xe(R+g,i==1?0:3),!(R>x);)if(N>1){let k=si(Xe(H+N,6))%24,j=u(R).getHours()-k;j>1&&(j=-1),R-=j*n,H=(H+N)%24;let et=_[_.length-1];Xe((R-et)/g,3)*B>=.7&&_.push(R)}else _.push(R)}return _}}return[l,c,h]}var[Hy,Wy,Xy]=um(1),[qy,Yy,$y]=um(.001);Zo(2,-53,53,[1]);function Rp(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Pp(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,h,u,d,f;return n.map(p=>{let x=i(p),g=x.getFullYear(),m=x.getMonth(),_=x.getDate(),M=x.getHours(),v=x.getMinutes(),C=x.getSeconds(),T=g!=l&&a[2]||m!=c&&a[3]||_!=h&&a[4]||M!=u&&a[5]||v!=d&&a[6]||C!=f&&a[7]||a[1];return l=g,c=m,h=_,u=M,d=v,f=C,T(x)})}}function Zy(i,t){let e=Wu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function wu(i,t,e){return new Date(i,t,e)}function Ip(i,t){return t(i)}var Jy="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Lp(i,t){return(e,n,s,r)=>r==null?Bu:t(i(n))}function Ky(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function jy(i,t){return i.series[t].fill(i,t)}var Qy={show:!0,live:!0,isolate:!1,mount:yy,markers:{show:!0,width:2,stroke:Ky,fill:jy,dash:"solid"},idx:null,idxs:null,values:[]};function tx(i,t){let e=i.cursor.points,n=gi(),s=e.size(i,t);Je(n,Wo,s),Je(n,Xo,s);let r=s/-2;Je(n,"marginLeft",r),Je(n,"marginTop",r);let o=e.width(i,t,s);return o&&Je(n,"borderWidth",o),n}function ex(i,t){let e=i.series[t].points;return e._fill||e._stroke}function nx(i,t){let e=i.series[t].points;return e._stroke||e._fill}function ix(i,t){return i.series[t].points.size}var Tu=[0,0];function sx(i,t,e){return Tu[0]=t,Tu[1]=e,Tu}function yl(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Eu(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var rx={show:!0,x:!0,y:!0,lock:!1,move:sx,points:{one:!1,show:tx,size:ix,width:0,stroke:nx,fill:ex},bind:{mousedown:yl,mouseup:yl,click:yl,dblclick:yl,mousemove:Eu,mouseleave:Eu,mouseenter:Eu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},dm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},qu=fn({},dm,{filter:jp}),fm=fn({},qu,{size:10}),pm=fn({},dm,{show:!1}),Yu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',mm="bold "+Yu,gm=1.5,Dp={show:!0,scale:"x",stroke:Ou,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:mm,side:2,grid:qu,ticks:fm,border:pm,font:Yu,lineGap:gm,rotate:0},ox="Value",ax="Time",Np={show:!0,scale:"x",auto:!1,sorted:1,min:We,max:-We,idxs:[]};function lx(i,t,e,n,s){return t.map(r=>r==null?"":Vu(r))}function cx(i,t,e,n,s,r,o){let a=[],l=Rs.get(s)||0;e=o?e:Xe(Tl(e,s),l);for(let c=e;c<=n;c=Xe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Lu(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?ns:Zp,h=si(c(e));s=Or(l,h),l==10&&(s=js[Ei(s,js)]);let u=e,d=s*l;l==10&&(d=js[Ei(d,js)]);do a.push(u),u=u+s,l==10&&!Rs.has(u)&&(u=Xe(u,Rs.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=js[Ei(d,js)]));while(u<=n);return a}function hx(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Lu(i,t,Xn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Lu(i,t,Xn(l,-n),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}var _m=/./,ux=/[12357]/,dx=/[125]/,Up=/1/,Du=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function fx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?_m:l(7,o)-h>=c?ux:l(5,o)-h>=c?dx:Up;if(u==Up){let d=xn(l(1,o)-h);if(d<c)return Du(t.slice().reverse(),a.distr,u,_i(c/d)).reverse()}return Du(t,a.distr,u,1)}function px(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=xn(l(1,o)-l(2,o));return c<a?Du(t.slice().reverse(),3,_m,_i(a/c)).reverse():t}function mx(i,t,e,n){return n==null?Bu:t==null?"":Vu(t)}var Fp={show:!0,scale:"y",stroke:Ou,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:mm,side:3,grid:qu,ticks:fm,border:pm,font:Yu,lineGap:gm,rotate:0};function gx(i,t){let e=3+(i||1)*2;return Xe(e*t,3)}function _x(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=xn(o-r),l=i.series[t],c=a/(l.points.space*De);return n[1]-n[0]<=c}var Op={scale:null,auto:!0,sorted:0,min:We,max:-We},ym=(i,t,e,n,s)=>s,Bp={show:!0,auto:!0,sorted:0,gaps:ym,alpha:1,facets:[fn({},Op,{scale:"x"}),fn({},Op,{scale:"y"})]},kp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:ym,alpha:1,points:{show:_x,filter:null},values:null,min:We,max:-We,idxs:[],path:null,clip:null};function yx(i,t,e,n,s){return e/10}var xm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},xx=fn({},xm,{time:!1,ori:1}),zp={};function vm(i,t){let e=zp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(zp[i]=e)),e}var zr=1,Nu=2;function nr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,g=i.valToPosH,m=i.valToPosV;return h.ori==0?e(s,l,c,h,u,g,m,d,f,p,x,Cl,Vr,Pl,Mm,wm):e(s,l,c,h,u,m,g,f,d,x,p,Rl,Hr,Ju,bm,Tm)}function $u(i,t){let e=0,n=0,s=Ie(i.bands,Hu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function vx(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function is(i,t,e,n,s,r){return nr(i,t,(o,a,l,c,h,u,d,f,p,x,g)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),M=c.ori==0?Vr:Hr,v,C;_==1?(v=e,C=n):(v=n,C=e);let T=m(u(a[v],c,x,f)),y=m(d(l[v],h,g,p)),b=m(u(a[C],c,x,f)),U=m(d(r==1?h.max:h.min,h,g,p)),P=new Path2D(s);return M(P,b,U),M(P,T,U),M(P,T,y),P})}function Al(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Pl:Ju,l=e;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Sx(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Zu(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),x=u-s;f=o<=0&&x>=0&&x<l?r(i[x]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(i[m]):p,p>=f&&a.push([f,p])}return a}function Gp(i){return i==0?Kp:i==1?yn:t=>Ks(t,i)}function Sm(i){let t=i==0?Cl:Rl,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ai(c,a/2,l/2),h=Ai(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var Cl=(i,t,e)=>{i.moveTo(t,e)},Rl=(i,t,e)=>{i.moveTo(e,t)},Vr=(i,t,e)=>{i.lineTo(t,e)},Hr=(i,t,e)=>{i.lineTo(e,t)},Pl=Sm(0),Ju=Sm(1),Mm=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},bm=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},wm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Tm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function Em(i){return(t,e,n,s,r)=>nr(t,e,(o,a,l,c,h,u,d,f,p,x,g)=>{let{pxRound:m,points:_}=o,M,v;c.ori==0?(M=Cl,v=Mm):(M=Rl,v=bm);let C=Xe(_.width*De,3),T=(_.size-_.width)/2*De,y=Xe(T*2,3),b=new Path2D,U=new Path2D,{left:P,top:R,width:G,height:H}=t.bbox;Pl(U,P-y,R-y,G+y*2,H+y*2);let N=W=>{if(l[W]!=null){let B=m(u(a[W],c,x,f)),k=m(d(l[W],h,g,p));M(b,B+T,k),v(b,B,k,T,0,xl*2)}};if(r)r.forEach(N);else for(let W=n;W<=s;W++)N(W);return{stroke:C>0?b:null,fill:b,clip:U,flags:zr|Nu}})}function Am(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Mx=Am(Vr),bx=Am(Hr);function Cm(i){let t=Ie(i?.alignGaps,0);return(e,n,s,r)=>nr(e,n,(o,a,l,c,h,u,d,f,p,x,g)=>{[s,r]=bl(l,s,r);let m=o.pxRound,_=H=>m(u(H,c,x,f)),M=H=>m(d(H,h,g,p)),v,C;c.ori==0?(v=Vr,C=Mx):(v=Hr,C=bx);let T=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zr},b=y.stroke,U=!1;if(r-s>=x*4){let H=ht=>e.posToVal(ht,c.key,!0),N=null,W=null,B,k,lt,$=_(a[T==1?s:r]),j=_(a[s]),et=_(a[r]),ft=H(T==1?j+1:et-1);for(let ht=T==1?s:r;ht>=s&&ht<=r;ht+=T){let tt=a[ht],xt=(T==1?tt<ft:tt>ft)?$:_(tt),Lt=l[ht];xt==$?Lt!=null?(k=Lt,N==null?(v(b,xt,M(k)),B=N=W=k):k<N?N=k:k>W&&(W=k)):Lt===null&&(U=!0):(N!=null&&C(b,$,M(N),M(W),M(B),M(k)),Lt!=null?(k=Lt,v(b,xt,M(k)),N=W=B=k):(N=W=null,Lt===null&&(U=!0)),$=xt,ft=H($+T))}N!=null&&N!=W&&lt!=$&&C(b,$,M(N),M(W),M(B),M(k))}else for(let H=T==1?s:r;H>=s&&H<=r;H+=T){let N=l[H];N===null?U=!0:N!=null&&v(b,_(a[H]),M(N))}let[R,G]=$u(e,n);if(o.fill!=null||R!=0){let H=y.fill=new Path2D(b),N=o.fillTo(e,n,o.min,o.max,R),W=M(N),B=_(a[s]),k=_(a[r]);T==-1&&([k,B]=[B,k]),v(H,k,W),v(H,B,W)}if(!o.spanGaps){let H=[];U&&H.push(...Zu(a,l,s,r,T,_,t)),y.gaps=H=o.gaps(e,n,s,r,H),y.clip=Al(H,c.ori,f,p,x,g)}return G!=0&&(y.band=G==2?[is(e,n,s,r,b,-1),is(e,n,s,r,b,1)]:is(e,n,s,r,b,G)),y})}function wx(i){let t=Ie(i.align,1),e=Ie(i.ascDesc,!1),n=Ie(i.alignGaps,0),s=Ie(i.extend,!1);return(r,o,a,l)=>nr(r,o,(c,h,u,d,f,p,x,g,m,_,M)=>{[a,l]=bl(u,a,l);let v=c.pxRound,{left:C,width:T}=r.bbox,y=j=>v(p(j,d,_,g)),b=j=>v(x(j,f,M,m)),U=d.ori==0?Vr:Hr,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zr},R=P.stroke,G=d.dir*(d.ori==0?1:-1),H=b(u[G==1?a:l]),N=y(h[G==1?a:l]),W=N,B=N;s&&t==-1&&(B=C,U(R,B,H)),U(R,N,H);for(let j=G==1?a:l;j>=a&&j<=l;j+=G){let et=u[j];if(et==null)continue;let ft=y(h[j]),ht=b(et);t==1?U(R,ft,H):U(R,W,ht),U(R,ft,ht),H=ht,W=ft}let k=W;s&&t==1&&(k=C+T,U(R,k,H));let[lt,$]=$u(r,o);if(c.fill!=null||lt!=0){let j=P.fill=new Path2D(R),et=c.fillTo(r,o,c.min,c.max,lt),ft=b(et);U(j,k,ft),U(j,B,ft)}if(!c.spanGaps){let j=[];j.push(...Zu(h,u,a,l,G,y,n));let et=c.width*De/2,ft=e||t==1?et:-et,ht=e||t==-1?-et:et;j.forEach(tt=>{tt[0]+=ft,tt[1]+=ht}),P.gaps=j=c.gaps(r,o,a,l,j),P.clip=Al(j,d.ori,g,m,_,M)}return $!=0&&(P.band=$==2?[is(r,o,a,l,R,-1),is(r,o,a,l,R,1)]:is(r,o,a,l,R,$)),P})}function Vp(i,t,e,n,s,r,o=We){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=xn(i[l]-i[a]);h<c&&(c=h,o=xn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function Tx(i){i=i||$o;let t=Ie(i.size,[.6,We,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ae(s),o=1-t[0],a=Ie(t[1],We),l=Ie(t[2],1),c=Ie(i.disp,$o),h=Ie(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,x,g)=>nr(f,p,(m,_,M,v,C,T,y,b,U,P,R)=>{let G=m.pxRound,H=e,N=n*De,W=a*De,B=l*De,k,lt;v.ori==0?[k,lt]=r(f,p):[lt,k]=r(f,p);let $=v.dir*(v.ori==0?1:-1),j=v.ori==0?Pl:Ju,et=v.ori==0?h:(Mt,Xt,he,Tt,Fe,$t,Qt)=>{h(Mt,Xt,he,Fe,Tt,Qt,$t)},ft=Ie(f.bands,Hu).find(Mt=>Mt.series[0]==p),ht=ft!=null?ft.dir:0,tt=m.fillTo(f,p,m.min,m.max,ht),gt=G(y(tt,C,R,U)),xt,Lt,wt,Vt=P,ie=G(m.width*De),Jt=!1,se=null,ne=null,ot=null,vt=null;u!=null&&(ie==0||d!=null)&&(Jt=!0,se=u.values(f,p,x,g),ne=new Map,new Set(se).forEach(Mt=>{Mt!=null&&ne.set(Mt,new Path2D)}),ie>0&&(ot=d.values(f,p,x,g),vt=new Map,new Set(ot).forEach(Mt=>{Mt!=null&&vt.set(Mt,new Path2D)})));let{x0:yt,size:Bt}=c;if(yt!=null&&Bt!=null){H=1,_=yt.values(f,p,x,g),yt.unit==2&&(_=_.map(he=>f.posToVal(b+he*P,v.key,!0)));let Mt=Bt.values(f,p,x,g);Bt.unit==2?Lt=Mt[0]*P:Lt=T(Mt[0],v,P,b)-T(0,v,P,b),Vt=Vp(_,M,T,v,P,b,Vt),wt=Vt-Lt+N}else Vt=Vp(_,M,T,v,P,b,Vt),wt=Vt*o+N,Lt=Vt-wt;wt<1&&(wt=0),ie>=Lt/2&&(ie=0),wt<5&&(G=Kp);let Dt=wt>0,ee=Vt-wt-(Dt?ie:0);Lt=G(Iu(ee,B,W)),xt=(H==0?Lt/2:H==$?0:Lt)-H*$*((H==0?N/2:0)+(Dt?ie/2:0));let kt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},me=Jt?null:new Path2D,de=null;if(ft!=null)de=f.data[ft.series[1]];else{let{y0:Mt,y1:Xt}=c;Mt!=null&&Xt!=null&&(M=Xt.values(f,p,x,g),de=Mt.values(f,p,x,g))}let _e=k*Lt,O=lt*Lt;for(let Mt=$==1?x:g;Mt>=x&&Mt<=g;Mt+=$){let Xt=M[Mt];if(Xt==null)continue;if(de!=null){let Y=de[Mt]??0;if(Xt-Y==0)continue;gt=y(Y,C,R,U)}let he=v.distr!=2||c!=null?_[Mt]:Mt,Tt=T(he,v,P,b),Fe=y(Ie(Xt,tt),C,R,U),$t=G(Tt-xt),Qt=G(Xn(Fe,gt)),I=G(Ai(Fe,gt)),w=Qt-I;if(Xt!=null){let Y=Xt<0?O:_e,dt=Xt<0?_e:O;Jt?(ie>0&&ot[Mt]!=null&&j(vt.get(ot[Mt]),$t,I+si(ie/2),Lt,Xn(0,w-ie),Y,dt),se[Mt]!=null&&j(ne.get(se[Mt]),$t,I+si(ie/2),Lt,Xn(0,w-ie),Y,dt)):j(me,$t,I+si(ie/2),Lt,Xn(0,w-ie),Y,dt),et(f,p,Mt,$t-ie/2,I,Lt+ie,w)}}return ie>0?kt.stroke=Jt?vt:me:Jt||(kt._fill=m.width==0?m._fill:m._stroke??m._fill,kt.width=0),kt.fill=Jt?ne:me,kt})}function Ex(i,t){let e=Ie(t?.alignGaps,0);return(n,s,r,o)=>nr(n,s,(a,l,c,h,u,d,f,p,x,g,m)=>{[r,o]=bl(c,r,o);let _=a.pxRound,M=k=>_(d(k,h,g,p)),v=k=>_(f(k,u,m,x)),C,T,y;h.ori==0?(C=Cl,y=Vr,T=wm):(C=Rl,y=Hr,T=Tm);let b=h.dir*(h.ori==0?1:-1),U=M(l[b==1?r:o]),P=U,R=[],G=[];for(let k=b==1?r:o;k>=r&&k<=o;k+=b)if(c[k]!=null){let $=l[k],j=M($);R.push(P=j),G.push(v(c[k]))}let H={stroke:i(R,G,C,y,T,_),fill:null,clip:null,band:null,gaps:null,flags:zr},N=H.stroke,[W,B]=$u(n,s);if(a.fill!=null||W!=0){let k=H.fill=new Path2D(N),lt=a.fillTo(n,s,a.min,a.max,W),$=v(lt);y(k,P,$),y(k,U,$)}if(!a.spanGaps){let k=[];k.push(...Zu(l,c,r,o,b,M,e)),H.gaps=k=a.gaps(n,s,r,o,k),H.clip=Al(k,h.ori,p,x,g,m)}return B!=0&&(H.band=B==2?[is(n,s,r,o,N,-1),is(n,s,r,o,N,1)]:is(n,s,r,o,N,B)),H})}function Ax(i){return Ex(Cx,i)}function Cx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,t[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,i[d+1],t[d+1])}return a}var Uu=new Set;function Hp(){for(let i of Uu)i.syncRect(!0)}Gr&&(tr(ly,Fr,Hp),tr(cy,Fr,Hp,!0),tr(vl,Fr,()=>{vn.pxRatio=De}));var Rx=Cm(),Px=Em();function Wp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Fu(r,o,t,e))}function Ix(i,t){return i.map((e,n)=>n==0?{}:fn({},t,e))}function Fu(i,t,e,n){return fn({},t==0?e:n,i)}function Rm(i,t,e){return t==null?Br:[t,e]}var Lx=Rm;function Dx(i,t,e){return t==null?Br:Sl(t,e,Gu,!0)}function Pm(i,t,e,n){return t==null?Br:wl(t,e,i.scales[n].log,!1)}var Nx=Pm;function Im(i,t,e,n){return t==null?Br:zu(t,e,i.scales[n].log,!1)}var Ux=Im;function Fx(i,t,e,n,s){let r=Xn(Mp(i),Mp(t)),o=t-i,a=Ei(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Rs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Xp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=yn((e=+s)*De))+"px"),[i,t,e]}function Ox(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Xe(t[2]*De,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function vn(i,t,e){let n={mode:Ie(i.mode,1)},s=n.mode;function r(S,E,L,F){let q=E.valToPct(S);return F+L*(E.dir==-1?1-q:q)}function o(S,E,L,F){let q=E.valToPct(S);return F+L*(E.dir==-1?q:1-q)}function a(S,E,L,F){return E.ori==0?r(S,E,L,F):o(S,E,L,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=gi(W_);if(i.id!=null&&(c.id=i.id),ii(c,i.class),i.title){let S=gi(Y_,c);S.textContent=i.title}let h=Ti("canvas"),u=n.ctx=h.getContext("2d"),d=gi($_,c);tr("click",d,S=>{S.target===p&&(Ye!=Rr||je!=Pr)&&Dn.click(n,S)},!0);let f=n.under=gi(Z_,d);d.appendChild(h);let p=n.over=gi(J_,d);i=kr(i);let x=+Ie(i.pxAlign,1),g=Gp(x);(i.plugins||[]).forEach(S=>{S.opts&&(i=S.opts(n,i)||i)});let m=i.ms||.001,_=n.series=s==1?Wp(i.series||[],Np,kp,!1):Ix(i.series||[null],Bp),M=n.axes=Wp(i.axes||[],Dp,Fp,!0),v=n.scales={},C=n.bands=i.bands||[];C.forEach(S=>{S.fill=Ae(S.fill||null),S.dir=Ie(S.dir,-1)});let T=s==2?_[1].facets[0].scale:_[0].scale,y={axes:ts,series:be},b=(i.drawOrder||["axes","series"]).map(S=>y[S]);function U(S){let E=S.distr==3?L=>ns(L>0?L:S.clamp(n,L,S.min,S.max,S.key)):S.distr==4?L=>bu(L,S.asinh):S.distr==100?L=>S.fwd(L):L=>L;return L=>{let F=E(L),{_min:q,_max:K}=S,ct=K-q;return(F-q)/ct}}function P(S){let E=v[S];if(E==null){let L=(i.scales||$o)[S]||$o;if(L.from!=null){P(L.from);let F=fn({},v[L.from],L,{key:S});F.valToPct=U(F),v[S]=F}else{E=v[S]=fn({},S==T?xm:xx,L),E.key=S;let F=E.time,q=E.range,K=Cs(q);if((S!=T||s==2&&!F)&&(K&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?xp:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?xp:{mode:1,hard:q[1],soft:q[1]}},K=!1),!K&&El(q))){let ct=q;q=(pt,At,zt)=>At==null?Br:Sl(At,zt,ct)}E.range=Ae(q||(F?Lx:S==T?E.distr==3?Nx:E.distr==4?Ux:Rm:E.distr==3?Pm:E.distr==4?Im:Dx)),E.auto=Ae(K?!1:E.auto),E.clamp=Ae(E.clamp||yx),E._min=E._max=null,E.valToPct=U(E)}}}P("x"),P("y"),s==1&&_.forEach(S=>{P(S.scale)}),M.forEach(S=>{P(S.scale)});for(let S in i.scales)P(S);let R=v[T],G=R.distr,H,N;R.ori==0?(ii(c,X_),H=r,N=o):(ii(c,q_),H=o,N=r);let W={};for(let S in v){let E=v[S];(E.min!=null||E.max!=null)&&(W[S]={min:E.min,max:E.max},E.min=E.max=null)}let B=i.tzDate||(S=>new Date(yn(S/m))),k=i.fmtDate||Wu,lt=m==1?Xy(B):$y(B),$=Pp(B,Rp(m==1?Wy:Yy,k)),j=Lp(B,Ip(Jy,k)),et=[],ft=n.legend=fn({},Qy,i.legend),ht=n.cursor=fn({},rx,{drag:{y:s==2}},i.cursor),tt=ft.show,gt=ht.show,xt=ft.markers;ft.idxs=et,xt.width=Ae(xt.width),xt.dash=Ae(xt.dash),xt.stroke=Ae(xt.stroke),xt.fill=Ae(xt.fill);let Lt,wt,Vt,ie=[],Jt=[],se,ne=!1,ot={};if(ft.live){let S=_[1]?_[1].values:null;ne=S!=null,se=ne?S(n,1,0):{_:0};for(let E in se)ot[E]=Bu}if(tt)if(Lt=Ti("table",ny,c),Vt=Ti("tbody",null,Lt),ft.mount(n,Lt),ne){wt=Ti("thead",null,Lt,Vt);let S=Ti("tr",null,wt);Ti("th",null,S);for(var vt in se)Ti("th",op,S).textContent=vt}else ii(Lt,sy),ft.live&&ii(Lt,iy);let yt={show:!0},Bt={show:!1};function Dt(S,E){if(E==0&&(ne||!ft.live||s==2))return Br;let L=[],F=Ti("tr",ry,Vt,Vt.childNodes[E]);ii(F,S.class),S.show||ii(F,Qs);let q=Ti("th",null,F);if(xt.show){let pt=gi(oy,q);if(E>0){let At=xt.width(n,E);At&&(pt.style.border=At+"px "+xt.dash(n,E)+" "+xt.stroke(n,E)),pt.style.background=xt.fill(n,E)}}let K=gi(op,q);S.label instanceof HTMLElement?K.appendChild(S.label):K.textContent=S.label,E>0&&(xt.show||(K.style.color=S.width>0?xt.stroke(n,E):xt.fill(n,E)),kt("click",q,pt=>{if(ht._lock)return;ae(pt);let At=_.indexOf(S);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let zt=_.some((Gt,Wt)=>Wt>0&&Wt!=At&&Gt.show);_.forEach((Gt,Wt)=>{Wt>0&&Bi(Wt,zt?Wt==At?yt:Bt:yt,!0,dn.setSeries)})}else Bi(At,{show:!S.show},!0,dn.setSeries)},!1),le&&kt(hp,q,pt=>{ht._lock||(ae(pt),Bi(_.indexOf(S),Lr,!0,dn.setSeries))},!1));for(var ct in se){let pt=Ti("td",ay,F);pt.textContent="--",L.push(pt)}return[F,L]}let ee=new Map;function kt(S,E,L,F=!0){let q=ee.get(E)||{},K=ht.bind[S](n,E,L,F);K&&(tr(S,E,q[S]=K),ee.set(E,q))}function me(S,E,L){let F=ee.get(E)||{};for(let q in F)(S==null||q==S)&&(Pu(q,E,F[q]),delete F[q]);S==null&&ee.delete(E)}let de=0,_e=0,O=0,Mt=0,Xt=0,he=0,Tt=Xt,Fe=he,$t=O,Qt=Mt,I=0,w=0,Y=0,dt=0;n.bbox={};let at=!1,bt=!1,Et=!1,nt=!1,st=!1,mt=!1;function z(S,E,L){(L||S!=n.width||E!=n.height)&&rt(S,E),ye(!1),Et=!0,bt=!0,Fn()}function rt(S,E){n.width=de=O=S,n.height=_e=Mt=E,Xt=he=0,Ct(),Kt();let L=n.bbox;I=L.left=Ks(Xt*De,.5),w=L.top=Ks(he*De,.5),Y=L.width=Ks(O*De,.5),dt=L.height=Ks(Mt*De,.5)}let it=3;function Rt(){let S=!1,E=0;for(;!S;){E++;let L=Er(E),F=Oi(E);S=E==it||L&&F,S||(rt(n.width,n.height),bt=!0)}}function St({width:S,height:E}){z(S,E)}n.setSize=St;function Ct(){let S=!1,E=!1,L=!1,F=!1;M.forEach((q,K)=>{if(q.show&&q._show){let{side:ct,_size:pt}=q,At=ct%2,zt=q.label!=null?q.labelSize:0,Gt=pt+zt;Gt>0&&(At?(O-=Gt,ct==3?(Xt+=Gt,F=!0):L=!0):(Mt-=Gt,ct==0?(he+=Gt,S=!0):E=!0))}}),Ui[0]=S,Ui[1]=L,Ui[2]=E,Ui[3]=F,O-=Si[1]+Si[3],Xt+=Si[3],Mt-=Si[2]+Si[0],he+=Si[0]}function Kt(){let S=Xt+O,E=he+Mt,L=Xt,F=he;function q(K,ct){switch(K){case 1:return S+=ct,S-ct;case 2:return E+=ct,E-ct;case 3:return L-=ct,L+ct;case 0:return F-=ct,F+ct}}M.forEach((K,ct)=>{if(K.show&&K._show){let pt=K.side;K._pos=q(pt,K._size),K.label!=null&&(K._lpos=q(pt,K.labelSize))}})}if(ht.dataIdx==null){let S=ht.hover,E=S.skip=new Set(S.skip??[]);E.add(void 0);let L=S.prox=Ae(S.prox),F=S.bias??=0;ht.dataIdx=(q,K,ct,pt)=>{if(K==0)return ct;let At=ct,zt=L(q,K,ct,pt)??We,Gt=zt>=0&&zt<We,Wt=R.ori==0?O:Mt,pe=ht.left,Le=t[0],Pe=t[K];if(E.has(Pe[ct])){At=null;let Te=null,re=null,jt;if(F==0||F==-1)for(jt=ct;Te==null&&jt-- >0;)E.has(Pe[jt])||(Te=jt);if(F==0||F==1)for(jt=ct;re==null&&jt++<Pe.length;)E.has(Pe[jt])||(re=jt);if(Te!=null||re!=null)if(Gt){let Ze=Te==null?-1/0:H(Le[Te],R,Wt,0),rn=re==null?1/0:H(Le[re],R,Wt,0),Cn=pe-Ze,He=rn-pe;Cn<=He?Cn<=zt&&(At=Te):He<=zt&&(At=re)}else At=re==null?Te:Te==null?re:ct-Te<=re-ct?Te:re}else Gt&&xn(pe-H(Le[ct],R,Wt,0))>zt&&(At=null);return At}}let ae=S=>{ht.event=S};ht.idxs=et,ht._lock=!1;let ut=ht.points;ut.show=Ae(ut.show),ut.size=Ae(ut.size),ut.stroke=Ae(ut.stroke),ut.width=Ae(ut.width),ut.fill=Ae(ut.fill);let qt=n.focus=fn({},i.focus||{alpha:.3},ht.focus),le=qt.prox>=0,Nt=le&&ut.one,ge=[],qe=[],zn=[];function No(S,E){let L=ut.show(n,E);if(L instanceof HTMLElement)return ii(L,ey),ii(L,S.class),Vi(L,-10,-10,O,Mt),p.insertBefore(L,ge[E]),L}function br(S,E){if(s==1||E>0){let L=s==1&&v[S.scale].time,F=S.value;S.value=L?Tp(F)?Lp(B,Ip(F,k)):F||j:F||mx,S.label=S.label||(L?ax:ox)}if(Nt||E>0){S.width=S.width==null?1:S.width,S.paths=S.paths||Rx||xy,S.fillTo=Ae(S.fillTo||vx),S.pxAlign=+Ie(S.pxAlign,x),S.pxRound=Gp(S.pxAlign),S.stroke=Ae(S.stroke||null),S.fill=Ae(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let L=gx(Xn(1,S.width),1),F=S.points=fn({},{size:L,width:Xn(1,L*.2),stroke:S.stroke,space:L*2,paths:Px,_stroke:null,_fill:null},S.points);F.show=Ae(F.show),F.filter=Ae(F.filter),F.fill=Ae(F.fill),F.stroke=Ae(F.stroke),F.paths=Ae(F.paths),F.pxAlign=S.pxAlign}if(tt){let L=Dt(S,E);ie.splice(E,0,L[0]),Jt.splice(E,0,L[1]),ft.values.push(null)}if(gt){et.splice(E,0,null);let L=null;Nt?E==0&&(L=No(S,E)):E>0&&(L=No(S,E)),ge.splice(E,0,L),qe.splice(E,0,0),zn.splice(E,0,0)}An("addSeries",E)}function cu(S,E){E=E??_.length,S=s==1?Fu(S,E,Np,kp):Fu(S,E,{},Bp),_.splice(E,0,S),br(_[E],E)}n.addSeries=cu;function hl(S){if(_.splice(S,1),tt){ft.values.splice(S,1),Jt.splice(S,1);let E=ie.splice(S,1)[0];me(null,E.firstChild),E.remove()}gt&&(et.splice(S,1),ge.splice(S,1)[0].remove(),qe.splice(S,1),zn.splice(S,1)),An("delSeries",S)}n.delSeries=hl;let Ui=[!1,!1,!1,!1];function Ki(S,E){if(S._show=S.show,S.show){let L=S.side%2,F=v[S.scale];F==null&&(S.scale=L?_[1].scale:T,F=v[S.scale]);let q=F.time;S.size=Ae(S.size),S.space=Ae(S.space),S.rotate=Ae(S.rotate),Cs(S.incrs)&&S.incrs.forEach(ct=>{!Rs.has(ct)&&Rs.set(ct,tm(ct))}),S.incrs=Ae(S.incrs||(F.distr==2?Gy:q?m==1?Hy:qy:js)),S.splits=Ae(S.splits||(q&&F.distr==1?lt:F.distr==3?Lu:F.distr==4?hx:cx)),S.stroke=Ae(S.stroke),S.grid.stroke=Ae(S.grid.stroke),S.ticks.stroke=Ae(S.ticks.stroke),S.border.stroke=Ae(S.border.stroke);let K=S.values;S.values=Cs(K)&&!Cs(K[0])?Ae(K):q?Cs(K)?Pp(B,Rp(K,k)):Tp(K)?Zy(B,K):K||$:K||lx,S.filter=Ae(S.filter||(F.distr>=3&&F.log==10?fx:F.distr==3&&F.log==2?px:jp)),S.font=Xp(S.font),S.labelFont=Xp(S.labelFont),S._size=S.size(n,null,E,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(Ui[E]=!0,S._el=gi(K_,d))}}function ji(S,E,L,F){let[q,K,ct,pt]=L,At=E%2,zt=0;return At==0&&(pt||K)&&(zt=E==0&&!q||E==2&&!ct?yn(Dp.size/3):0),At==1&&(q||ct)&&(zt=E==1&&!K||E==3&&!pt?yn(Fp.size/2):0),zt}let Uo=n.padding=(i.padding||[ji,ji,ji,ji]).map(S=>Ae(Ie(S,ji))),Si=n._padding=Uo.map((S,E)=>S(n,E,Ui,0)),nn,an=null,ln=null,Fi=s==1?_[0].idxs:null,Qn=null,Ss=!1;function Fo(S,E){if(t=S??[],n.data=n._data=t,s==2){nn=0;for(let L=1;L<_.length;L++)nn+=t[L][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),Qn=t[0],nn=Qn.length;let L=t;if(G==2){L=t.slice();let F=L[0]=Array(nn);for(let q=0;q<nn;q++)F[q]=q}n._data=t=L}if(ye(!0),An("setData"),G==2&&(Et=!0),E!==!1){let L=R;L.auto(n,Ss)?Oo():ws(T,L.min,L.max),nt=nt||ht.left>=0,mt=!0,Fn()}}n.setData=Fo;function Oo(){Ss=!0;let S,E;s==1&&(nn>0?(an=Fi[0]=0,ln=Fi[1]=nn-1,S=t[0][an],E=t[0][ln],G==2?(S=an,E=ln):S==E&&(G==3?[S,E]=wl(S,S,R.log,!1):G==4?[S,E]=zu(S,S,R.log,!1):R.time?E=S+yn(86400/m):[S,E]=Sl(S,E,Gu,!0))):(an=Fi[0]=S=null,ln=Fi[1]=E=null)),ws(T,S,E)}let wr,Ms,Tr,A,X,Q,Z,J,Pt,Ut;function It(S,E,L,F,q,K){S??=lp,L??=Hu,F??="butt",q??=lp,K??="round",S!=wr&&(u.strokeStyle=wr=S),q!=Ms&&(u.fillStyle=Ms=q),E!=Tr&&(u.lineWidth=Tr=E),K!=X&&(u.lineJoin=X=K),F!=Q&&(u.lineCap=Q=F),L!=A&&u.setLineDash(A=L)}function Ft(S,E,L,F){E!=Ms&&(u.fillStyle=Ms=E),S!=Z&&(u.font=Z=S),L!=J&&(u.textAlign=J=L),F!=Pt&&(u.textBaseline=Pt=F)}function Zt(S,E,L,F,q=0){if(F.length>0&&S.auto(n,Ss)&&(E==null||E.min==null)){let K=Ie(an,0),ct=Ie(ln,F.length-1),pt=L.min==null?fy(F,K,ct,q,S.distr==3):[L.min,L.max];S.min=Ai(S.min,L.min=pt[0]),S.max=Xn(S.max,L.max=pt[1])}}let ue={min:null,max:null};function Me(){for(let F in v){let q=v[F];W[F]==null&&(q.min==null||W[T]!=null&&q.auto(n,Ss))&&(W[F]=ue)}for(let F in v){let q=v[F];W[F]==null&&q.from!=null&&W[q.from]!=null&&(W[F]=ue)}W[T]!=null&&ye(!0);let S={};for(let F in W){let q=W[F];if(q!=null){let K=S[F]=kr(v[F],My);if(q.min!=null)fn(K,q);else if(F!=T||s==2)if(nn==0&&K.from==null){let ct=K.range(n,null,null,F);K.min=ct[0],K.max=ct[1]}else K.min=We,K.max=-We}}if(nn>0){_.forEach((F,q)=>{if(s==1){let K=F.scale,ct=W[K];if(ct==null)return;let pt=S[K];if(q==0){let At=pt.range(n,pt.min,pt.max,K);pt.min=At[0],pt.max=At[1],an=Ei(pt.min,t[0]),ln=Ei(pt.max,t[0]),ln-an>1&&(t[0][an]<pt.min&&an++,t[0][ln]>pt.max&&ln--),F.min=Qn[an],F.max=Qn[ln]}else F.show&&F.auto&&Zt(pt,ct,F,t[q],F.sorted);F.idxs[0]=an,F.idxs[1]=ln}else if(q>0&&F.show&&F.auto){let[K,ct]=F.facets,pt=K.scale,At=ct.scale,[zt,Gt]=t[q],Wt=S[pt],pe=S[At];Wt!=null&&Zt(Wt,W[pt],K,zt,K.sorted),pe!=null&&Zt(pe,W[At],ct,Gt,ct.sorted),F.min=ct.min,F.max=ct.max}});for(let F in S){let q=S[F],K=W[F];if(q.from==null&&(K==null||K.min==null)){let ct=q.range(n,q.min==We?null:q.min,q.max==-We?null:q.max,F);q.min=ct[0],q.max=ct[1]}}}for(let F in S){let q=S[F];if(q.from!=null){let K=S[q.from];if(K.min==null)q.min=q.max=null;else{let ct=q.range(n,K.min,K.max,F);q.min=ct[0],q.max=ct[1]}}}let E={},L=!1;for(let F in S){let q=S[F],K=v[F];if(K.min!=q.min||K.max!=q.max){K.min=q.min,K.max=q.max;let ct=K.distr;K._min=ct==3?ns(K.min):ct==4?bu(K.min,K.asinh):ct==100?K.fwd(K.min):K.min,K._max=ct==3?ns(K.max):ct==4?bu(K.max,K.asinh):ct==100?K.fwd(K.max):K.max,E[F]=L=!0}}if(L){_.forEach((F,q)=>{s==2?q>0&&E.y&&(F._paths=null):E[F.scale]&&(F._paths=null)});for(let F in E)Et=!0,An("setScale",F);gt&&ht.left>=0&&(nt=mt=!0)}for(let F in W)W[F]=null}function Yt(S){let E=Iu(an-1,0,nn-1),L=Iu(ln+1,0,nn-1);for(;S[E]==null&&E>0;)E--;for(;S[L]==null&&L<nn-1;)L++;return[E,L]}function be(){if(nn>0){let S=_.some(E=>E._focus)&&Ut!=qt.alpha;S&&(u.globalAlpha=Ut=qt.alpha),_.forEach((E,L)=>{if(L>0&&E.show&&(tn(L,!1),tn(L,!0),E._paths==null)){let F=Ut;Ut!=E.alpha&&(u.globalAlpha=Ut=E.alpha);let q=s==2?[0,t[L][0].length-1]:Yt(t[L]);E._paths=E.paths(n,L,q[0],q[1]),Ut!=F&&(u.globalAlpha=Ut=F)}}),_.forEach((E,L)=>{if(L>0&&E.show){let F=Ut;Ut!=E.alpha&&(u.globalAlpha=Ut=E.alpha),E._paths!=null&&ke(L,!1);{let q=E._paths!=null?E._paths.gaps:null,K=E.points.show(n,L,an,ln,q),ct=E.points.filter(n,L,K,q);(K||ct)&&(E.points._paths=E.points.paths(n,L,an,ln,ct),ke(L,!0))}Ut!=F&&(u.globalAlpha=Ut=F),An("drawSeries",L)}}),S&&(u.globalAlpha=Ut=1)}}function tn(S,E){let L=E?_[S].points:_[S];L._stroke=L.stroke(n,S),L._fill=L.fill(n,S)}function ke(S,E){let L=E?_[S].points:_[S],{stroke:F,fill:q,clip:K,flags:ct,_stroke:pt=L._stroke,_fill:At=L._fill,_width:zt=L.width}=L._paths;zt=Xe(zt*De,3);let Gt=null,Wt=zt%2/2;E&&At==null&&(At=zt>0?"#fff":pt);let pe=L.pxAlign==1&&Wt>0;if(pe&&u.translate(Wt,Wt),!E){let Le=I-zt/2,Pe=w-zt/2,Te=Y+zt,re=dt+zt;Gt=new Path2D,Gt.rect(Le,Pe,Te,re)}E?Ht(pt,zt,L.dash,L.cap,At,F,q,ct,K):ze(S,pt,zt,L.dash,L.cap,At,F,q,ct,Gt,K),pe&&u.translate(-Wt,-Wt)}function ze(S,E,L,F,q,K,ct,pt,At,zt,Gt){let Wt=!1;At!=0&&C.forEach((pe,Le)=>{if(pe.series[0]==S){let Pe=_[pe.series[1]],Te=t[pe.series[1]],re=(Pe._paths||$o).band;Cs(re)&&(re=pe.dir==1?re[0]:re[1]);let jt,Ze=null;Pe.show&&re&&my(Te,an,ln)?(Ze=pe.fill(n,Le)||K,jt=Pe._paths.clip):re=null,Ht(E,L,F,q,Ze,ct,pt,At,zt,Gt,jt,re),Wt=!0}}),Wt||Ht(E,L,F,q,K,ct,pt,At,zt,Gt)}let _n=zr|Nu;function Ht(S,E,L,F,q,K,ct,pt,At,zt,Gt,Wt){It(S,E,L,F,q),(At||zt||Wt)&&(u.save(),At&&u.clip(At),zt&&u.clip(zt)),Wt?(pt&_n)==_n?(u.clip(Wt),Gt&&u.clip(Gt),Ee(q,ct),cn(S,K,E)):pt&Nu?(Ee(q,ct),u.clip(Wt),cn(S,K,E)):pt&zr&&(u.save(),u.clip(Wt),Gt&&u.clip(Gt),Ee(q,ct),u.restore(),cn(S,K,E)):(Ee(q,ct),cn(S,K,E)),(At||zt||Wt)&&u.restore()}function cn(S,E,L){L>0&&(E instanceof Map?E.forEach((F,q)=>{u.strokeStyle=wr=q,u.stroke(F)}):E!=null&&S&&u.stroke(E))}function Ee(S,E){E instanceof Map?E.forEach((L,F)=>{u.fillStyle=Ms=F,u.fill(L)}):E!=null&&S&&u.fill(E)}function Qi(S,E,L,F){let q=M[S],K;if(F<=0)K=[0,0];else{let ct=q._space=q.space(n,S,E,L,F),pt=q._incrs=q.incrs(n,S,E,L,F,ct);K=Fx(E,L,pt,F,ct)}return q._found=K}function hn(S,E,L,F,q,K,ct,pt,At,zt){let Gt=ct%2/2;x==1&&u.translate(Gt,Gt),It(pt,ct,At,zt,pt),u.beginPath();let Wt,pe,Le,Pe,Te=q+(F==0||F==3?-K:K);L==0?(pe=q,Pe=Te):(Wt=q,Le=Te);for(let re=0;re<S.length;re++)E[re]!=null&&(L==0?Wt=Le=S[re]:pe=Pe=S[re],u.moveTo(Wt,pe),u.lineTo(Le,Pe));u.stroke(),x==1&&u.translate(-Gt,-Gt)}function Er(S){let E=!0;return M.forEach((L,F)=>{if(!L.show)return;let q=v[L.scale];if(q.min==null){L._show&&(E=!1,L._show=!1,ye(!1));return}else L._show||(E=!1,L._show=!0,ye(!1));let K=L.side,ct=K%2,{min:pt,max:At}=q,[zt,Gt]=Qi(F,pt,At,ct==0?O:Mt);if(Gt==0)return;let Wt=q.distr==2,pe=L._splits=L.splits(n,F,pt,At,zt,Gt,Wt),Le=q.distr==2?pe.map(jt=>Qn[jt]):pe,Pe=q.distr==2?Qn[pe[1]]-Qn[pe[0]]:zt,Te=L._values=L.values(n,L.filter(n,Le,F,Gt,Pe),F,Gt,Pe);L._rotate=K==2?L.rotate(n,Te,F,Gt):0;let re=L._size;L._size=_i(L.size(n,Te,F,S)),re!=null&&L._size!=re&&(E=!1)}),E}function Oi(S){let E=!0;return Uo.forEach((L,F)=>{let q=L(n,F,Ui,S);q!=Si[F]&&(E=!1),Si[F]=q}),E}function ts(){for(let S=0;S<M.length;S++){let E=M[S];if(!E.show||!E._show)continue;let L=E.side,F=L%2,q,K,ct=E.stroke(n,S),pt=L==0||L==3?-1:1,[At,zt]=E._found;if(E.label!=null){let Hn=E.labelGap*pt,ni=yn((E._lpos+Hn)*De);Ft(E.labelFont[0],ct,"center",L==2?"top":ap),u.save(),F==1?(q=K=0,u.translate(ni,yn(w+dt/2)),u.rotate((L==3?-xl:xl)/2)):(q=yn(I+Y/2),K=ni);let Js=Jp(E.label)?E.label(n,S,At,zt):E.label;u.fillText(Js,q,K),u.restore()}if(zt==0)continue;let Gt=v[E.scale],Wt=F==0?Y:dt,pe=F==0?I:w,Le=E._splits,Pe=Gt.distr==2?Le.map(Hn=>Qn[Hn]):Le,Te=Gt.distr==2?Qn[Le[1]]-Qn[Le[0]]:At,re=E.ticks,jt=E.border,Ze=re.show?re.size:0,rn=yn(Ze*De),Cn=yn((E.alignTo==2?E._size-Ze-E.gap:E.gap)*De),He=E._rotate*-xl/180,on=g(E._pos*De),ti=(rn+Cn)*pt,Vn=on+ti;K=F==0?Vn:0,q=F==1?Vn:0;let pi=E.font[0],Mi=E.align==1?Nr:E.align==2?vu:He>0?Nr:He<0?vu:F==0?"center":L==3?vu:Nr,zi=He||F==1?"middle":L==2?"top":ap;Ft(pi,ct,Mi,zi);let ei=E.font[1]*E.lineGap,mi=Le.map(Hn=>g(a(Hn,Gt,Wt,pe))),bi=E._values;for(let Hn=0;Hn<bi.length;Hn++){let ni=bi[Hn];if(ni!=null){F==0?q=mi[Hn]:K=mi[Hn],ni=""+ni;let Js=ni.indexOf(`
`)==-1?[ni]:ni.split(/\n/gm);for(let Wn=0;Wn<Js.length;Wn++){let rp=Js[Wn];He?(u.save(),u.translate(q,K+Wn*ei),u.rotate(He),u.fillText(rp,0,0),u.restore()):u.fillText(rp,q,K+Wn*ei)}}}re.show&&hn(mi,re.filter(n,Pe,S,zt,Te),F,L,on,rn,Xe(re.width*De,3),re.stroke(n,S),re.dash,re.cap);let Gi=E.grid;Gi.show&&hn(mi,Gi.filter(n,Pe,S,zt,Te),F,F==0?2:1,F==0?w:I,F==0?dt:Y,Xe(Gi.width*De,3),Gi.stroke(n,S),Gi.dash,Gi.cap),jt.show&&hn([on],[1],F==0?1:0,F==0?1:2,F==1?w:I,F==1?dt:Y,Xe(jt.width*De,3),jt.stroke(n,S),jt.dash,jt.cap)}An("drawAxes")}function ye(S){_.forEach((E,L)=>{L>0&&(E._paths=null,S&&(s==1?(E.min=null,E.max=null):E.facets.forEach(F=>{F.min=null,F.max=null})))})}let sn=!1,Gn=!1,Ge=[];function un(){Gn=!1;for(let S=0;S<Ge.length;S++)An(...Ge[S]);Ge.length=0}function Fn(){sn||(Ry(Gf),sn=!0)}function ul(S,E=!1){sn=!0,Gn=E,S(n),Gf(),E&&Ge.length>0&&queueMicrotask(un)}n.batch=ul;function Gf(){if(at&&(Me(),at=!1),Et&&(Rt(),Et=!1),bt){if(Je(f,Nr,Xt),Je(f,"top",he),Je(f,Wo,O),Je(f,Xo,Mt),Je(p,Nr,Xt),Je(p,"top",he),Je(p,Wo,O),Je(p,Xo,Mt),Je(d,Wo,de),Je(d,Xo,_e),h.width=yn(de*De),h.height=yn(_e*De),M.forEach(({_el:S,_show:E,_size:L,_pos:F,side:q})=>{if(S!=null)if(E){let K=q===3||q===0?L:0,ct=q%2==1;Je(S,ct?"left":"top",F-K),Je(S,ct?"width":"height",L),Je(S,ct?"top":"left",ct?he:Xt),Je(S,ct?"height":"width",ct?Mt:O),Ru(S,Qs)}else ii(S,Qs)}),wr=Ms=Tr=X=Q=Z=J=Pt=A=null,Ut=1,zo(!0),Xt!=Tt||he!=Fe||O!=$t||Mt!=Qt){ye(!1);let S=O/$t,E=Mt/Qt;if(gt&&!nt&&ht.left>=0){ht.left*=S,ht.top*=E,Ar&&Vi(Ar,yn(ht.left),0,O,Mt),Cr&&Vi(Cr,0,yn(ht.top),O,Mt);for(let L=0;L<ge.length;L++){let F=ge[L];F!=null&&(qe[L]*=S,zn[L]*=E,Vi(F,_i(qe[L]),_i(zn[L]),O,Mt))}}if($e.show&&!st&&$e.left>=0&&$e.width>0){$e.left*=S,$e.width*=S,$e.top*=E,$e.height*=E;for(let L in mu)Je(Ir,L,$e[L])}Tt=Xt,Fe=he,$t=O,Qt=Mt}An("setSize"),bt=!1}de>0&&_e>0&&(u.clearRect(0,0,h.width,h.height),An("drawClear"),b.forEach(S=>S()),An("draw")),$e.show&&st&&(dl($e),st=!1),gt&&nt&&(Zs(null,!0,!1),nt=!1),ft.show&&ft.live&&mt&&(fu(),mt=!1),l||(l=!0,n.status=1,An("ready")),Ss=!1,sn=!1}n.redraw=(S,E)=>{Et=E||!1,S!==!1?ws(T,R.min,R.max):Fn()};function hu(S,E){let L=v[S];if(L.from==null){if(nn==0){let F=L.range(n,E.min,E.max,S);E.min=F[0],E.max=F[1]}if(E.min>E.max){let F=E.min;E.min=E.max,E.max=F}if(nn>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;S==T&&L.distr==2&&nn>0&&(E.min=Ei(E.min,t[0]),E.max=Ei(E.max,t[0]),E.min==E.max&&E.max++),W[S]=E,at=!0,Fn()}}n.setScale=hu;let uu,du,Ar,Cr,Vf,Hf,Rr,Pr,Wf,Xf,Ye,je,bs=!1,Dn=ht.drag,Tn=Dn.x,En=Dn.y;gt&&(ht.x&&(uu=gi(Q_,p)),ht.y&&(du=gi(ty,p)),R.ori==0?(Ar=uu,Cr=du):(Ar=du,Cr=uu),Ye=ht.left,je=ht.top);let $e=n.select=fn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ir=$e.show?gi(j_,$e.over?p:f):null;function dl(S,E){if($e.show){for(let L in S)$e[L]=S[L],L in mu&&Je(Ir,L,S[L]);E!==!1&&An("setSelect")}}n.setSelect=dl;function P_(S){if(_[S].show)tt&&Ru(ie[S],Qs);else if(tt&&ii(ie[S],Qs),gt){let L=Nt?ge[0]:ge[S];L!=null&&Vi(L,-10,-10,O,Mt)}}function ws(S,E,L){hu(S,{min:E,max:L})}function Bi(S,E,L,F){E.focus!=null&&U_(S),E.show!=null&&_.forEach((q,K)=>{K>0&&(S==K||S==null)&&(q.show=E.show,P_(K),s==2?(ws(q.facets[0].scale,null,null),ws(q.facets[1].scale,null,null)):ws(q.scale,null,null),Fn())}),L!==!1&&An("setSeries",S,E),F&&Go("setSeries",n,S,E)}n.setSeries=Bi;function I_(S,E){fn(C[S],E)}function L_(S,E){S.fill=Ae(S.fill||null),S.dir=Ie(S.dir,-1),E=E??C.length,C.splice(E,0,S)}function D_(S){S==null?C.length=0:C.splice(S,1)}n.addBand=L_,n.setBand=I_,n.delBand=D_;function N_(S,E){_[S].alpha=E,gt&&ge[S]!=null&&(ge[S].style.opacity=E),tt&&ie[S]&&(ie[S].style.opacity=E)}let es,Ts,$s,Lr={focus:!0};function U_(S){if(S!=$s){let E=S==null,L=qt.alpha!=1;_.forEach((F,q)=>{if(s==1||q>0){let K=E||q==0||q==S;F._focus=E?null:K,L&&N_(q,K?1:qt.alpha)}}),$s=S,L&&Fn()}}tt&&le&&kt(up,Lt,S=>{ht._lock||(ae(S),$s!=null&&Bi(null,Lr,!0,dn.setSeries))});function ki(S,E,L){let F=v[E];L&&(S=S/De-(F.ori==1?he:Xt));let q=O;F.ori==1&&(q=Mt,S=q-S),F.dir==-1&&(S=q-S);let K=F._min,ct=F._max,pt=S/q,At=K+(ct-K)*pt,zt=F.distr;return zt==3?Or(10,At):zt==4?_y(At,F.asinh):zt==100?F.bwd(At):At}function F_(S,E){let L=ki(S,T,E);return Ei(L,t[0],an,ln)}n.valToIdx=S=>Ei(S,t[0]),n.posToIdx=F_,n.posToVal=ki,n.valToPos=(S,E,L)=>v[E].ori==0?r(S,v[E],L?Y:O,L?I:0):o(S,v[E],L?dt:Mt,L?w:0),n.setCursor=(S,E,L)=>{Ye=S.left,je=S.top,Zs(null,E,L)};function qf(S,E){Je(Ir,Nr,$e.left=S),Je(Ir,Wo,$e.width=E)}function Yf(S,E){Je(Ir,"top",$e.top=S),Je(Ir,Xo,$e.height=E)}let Bo=R.ori==0?qf:Yf,ko=R.ori==1?qf:Yf;function O_(){if(tt&&ft.live)for(let S=s==2?1:0;S<_.length;S++){if(S==0&&ne)continue;let E=ft.values[S],L=0;for(let F in E)Jt[S][L++].firstChild.nodeValue=E[F]}}function fu(S,E){if(S!=null&&(S.idxs?S.idxs.forEach((L,F)=>{et[F]=L}):Sy(S.idx)||et.fill(S.idx),ft.idx=et[0]),tt&&ft.live){for(let L=0;L<_.length;L++)(L>0||s==1&&!ne)&&B_(L,et[L]);O_()}mt=!1,E!==!1&&An("setLegend")}n.setLegend=fu;function B_(S,E){let L=_[S],F=S==0&&G==2?Qn:t[S],q;ne?q=L.values(n,S,E)??ot:(q=L.value(n,E==null?null:F[E],S,E),q=q==null?ot:{_:q}),ft.values[S]=q}function Zs(S,E,L){Wf=Ye,Xf=je,[Ye,je]=ht.move(n,Ye,je),ht.left=Ye,ht.top=je,gt&&(Ar&&Vi(Ar,yn(Ye),0,O,Mt),Cr&&Vi(Cr,0,yn(je),O,Mt));let F,q=an>ln;es=We,Ts=null;let K=R.ori==0?O:Mt,ct=R.ori==1?O:Mt;if(Ye<0||nn==0||q){F=ht.idx=null;for(let pt=0;pt<_.length;pt++){let At=ge[pt];At!=null&&Vi(At,-10,-10,O,Mt)}le&&Bi(null,Lr,!0,S==null&&dn.setSeries),ft.live&&(et.fill(F),mt=!0)}else{let pt,At,zt;s==1&&(pt=R.ori==0?Ye:je,At=ki(pt,T),F=ht.idx=Ei(At,t[0],an,ln),zt=H(t[0][F],R,K,0));let Gt=-10,Wt=-10,pe=0,Le=0,Pe=!0,Te="",re="";for(let jt=s==2?1:0;jt<_.length;jt++){let Ze=_[jt],rn=et[jt],Cn=rn==null?null:s==1?t[jt][rn]:t[jt][1][rn],He=ht.dataIdx(n,jt,F,At),on=He==null?null:s==1?t[jt][He]:t[jt][1][He];if(mt=mt||on!=Cn||He!=rn,et[jt]=He,jt>0&&Ze.show){let ti=He==null?-10:He==F?zt:H(s==1?t[0][He]:t[jt][0][He],R,K,0),Vn=on==null?-10:N(on,s==1?v[Ze.scale]:v[Ze.facets[1].scale],ct,0);if(le&&on!=null){let pi=R.ori==1?Ye:je,Mi=xn(qt.dist(n,jt,He,Vn,pi));if(Mi<es){let zi=qt.bias;if(zi!=0){let ei=ki(pi,Ze.scale),mi=on>=0?1:-1,bi=ei>=0?1:-1;bi==mi&&(bi==1?zi==1?on>=ei:on<=ei:zi==1?on<=ei:on>=ei)&&(es=Mi,Ts=jt)}else es=Mi,Ts=jt}}if(mt||Nt){let pi,Mi;R.ori==0?(pi=ti,Mi=Vn):(pi=Vn,Mi=ti);let zi,ei,mi,bi,Gi,Hn,ni=!0,Js=ut.bbox;if(Js!=null){ni=!1;let Wn=Js(n,jt);mi=Wn.left,bi=Wn.top,zi=Wn.width,ei=Wn.height}else mi=pi,bi=Mi,zi=ei=ut.size(n,jt);if(Hn=ut.fill(n,jt),Gi=ut.stroke(n,jt),Nt)jt==Ts&&es<=qt.prox&&(Gt=mi,Wt=bi,pe=zi,Le=ei,Pe=ni,Te=Hn,re=Gi);else{let Wn=ge[jt];Wn!=null&&(qe[jt]=mi,zn[jt]=bi,yp(Wn,zi,ei,ni),gp(Wn,Hn,Gi),Vi(Wn,_i(mi),_i(bi),O,Mt))}}}}if(Nt){let jt=qt.prox,Ze=$s==null?es<=jt:es>jt||Ts!=$s;if(mt||Ze){let rn=ge[0];rn!=null&&(qe[0]=Gt,zn[0]=Wt,yp(rn,pe,Le,Pe),gp(rn,Te,re),Vi(rn,_i(Gt),_i(Wt),O,Mt))}}}if($e.show&&bs)if(S!=null){let[pt,At]=dn.scales,[zt,Gt]=dn.match,[Wt,pe]=S.cursor.sync.scales,Le=S.cursor.drag;if(Tn=Le._x,En=Le._y,Tn||En){let{left:Pe,top:Te,width:re,height:jt}=S.select,Ze=S.scales[Wt].ori,rn=S.posToVal,Cn,He,on,ti,Vn,pi=pt!=null&&zt(pt,Wt),Mi=At!=null&&Gt(At,pe);pi&&Tn?(Ze==0?(Cn=Pe,He=re):(Cn=Te,He=jt),on=v[pt],ti=H(rn(Cn,Wt),on,K,0),Vn=H(rn(Cn+He,Wt),on,K,0),Bo(Ai(ti,Vn),xn(Vn-ti))):Bo(0,K),Mi&&En?(Ze==1?(Cn=Pe,He=re):(Cn=Te,He=jt),on=v[At],ti=N(rn(Cn,pe),on,ct,0),Vn=N(rn(Cn+He,pe),on,ct,0),ko(Ai(ti,Vn),xn(Vn-ti))):ko(0,ct)}else gu()}else{let pt=xn(Wf-Vf),At=xn(Xf-Hf);if(R.ori==1){let pe=pt;pt=At,At=pe}Tn=Dn.x&&pt>=Dn.dist,En=Dn.y&&At>=Dn.dist;let zt=Dn.uni;zt!=null?Tn&&En&&(Tn=pt>=zt,En=At>=zt,!Tn&&!En&&(At>pt?En=!0:Tn=!0)):Dn.x&&Dn.y&&(Tn||En)&&(Tn=En=!0);let Gt,Wt;Tn&&(R.ori==0?(Gt=Rr,Wt=Ye):(Gt=Pr,Wt=je),Bo(Ai(Gt,Wt),xn(Wt-Gt)),En||ko(0,ct)),En&&(R.ori==1?(Gt=Rr,Wt=Ye):(Gt=Pr,Wt=je),ko(Ai(Gt,Wt),xn(Wt-Gt)),Tn||Bo(0,K)),!Tn&&!En&&(Bo(0,0),ko(0,0))}if(Dn._x=Tn,Dn._y=En,S==null){if(L){if(sp!=null){let[pt,At]=dn.scales;dn.values[0]=pt!=null?ki(R.ori==0?Ye:je,pt):null,dn.values[1]=At!=null?ki(R.ori==1?Ye:je,At):null}Go(Su,n,Ye,je,O,Mt,F)}if(le){let pt=L&&dn.setSeries,At=qt.prox;$s==null?es<=At&&Bi(Ts,Lr,!0,pt):es>At?Bi(null,Lr,!0,pt):Ts!=$s&&Bi(Ts,Lr,!0,pt)}}mt&&(ft.idx=F,fu()),E!==!1&&An("setCursor")}let Es=null;Object.defineProperty(n,"rect",{get(){return Es==null&&zo(!1),Es}});function zo(S=!1){S?Es=null:(Es=p.getBoundingClientRect(),An("syncRect",Es))}function $f(S,E,L,F,q,K,ct){ht._lock||bs&&S!=null&&S.movementX==0&&S.movementY==0||(pu(S,E,L,F,q,K,ct,!1,S!=null),S!=null?Zs(null,!0,!0):Zs(E,!0,!1))}function pu(S,E,L,F,q,K,ct,pt,At){if(Es==null&&zo(!1),ae(S),S!=null)L=S.clientX-Es.left,F=S.clientY-Es.top;else{if(L<0||F<0){Ye=-10,je=-10;return}let[zt,Gt]=dn.scales,Wt=E.cursor.sync,[pe,Le]=Wt.values,[Pe,Te]=Wt.scales,[re,jt]=dn.match,Ze=E.axes[0].side%2==1,rn=R.ori==0?O:Mt,Cn=R.ori==1?O:Mt,He=Ze?K:q,on=Ze?q:K,ti=Ze?F:L,Vn=Ze?L:F;if(Pe!=null?L=re(zt,Pe)?a(pe,v[zt],rn,0):-10:L=rn*(ti/He),Te!=null?F=jt(Gt,Te)?a(Le,v[Gt],Cn,0):-10:F=Cn*(Vn/on),R.ori==1){let pi=L;L=F,F=pi}}At&&(E==null||E.cursor.event.type==Su)&&((L<=1||L>=O-1)&&(L=Ks(L,O)),(F<=1||F>=Mt-1)&&(F=Ks(F,Mt))),pt?(Vf=L,Hf=F,[Rr,Pr]=ht.move(n,L,F)):(Ye=L,je=F)}let mu={width:0,height:0,left:0,top:0};function gu(){dl(mu,!1)}let Zf,Jf,Kf,jf;function Qf(S,E,L,F,q,K,ct){bs=!0,Tn=En=Dn._x=Dn._y=!1,pu(S,E,L,F,q,K,ct,!0,!1),S!=null&&(kt(Mu,Au,tp,!1),Go(cp,n,Rr,Pr,O,Mt,null));let{left:pt,top:At,width:zt,height:Gt}=$e;Zf=pt,Jf=At,Kf=zt,jf=Gt}function tp(S,E,L,F,q,K,ct){bs=Dn._x=Dn._y=!1,pu(S,E,L,F,q,K,ct,!1,!0);let{left:pt,top:At,width:zt,height:Gt}=$e,Wt=zt>0||Gt>0,pe=Zf!=pt||Jf!=At||Kf!=zt||jf!=Gt;if(Wt&&pe&&dl($e),Dn.setScale&&Wt&&pe){let Le=pt,Pe=zt,Te=At,re=Gt;if(R.ori==1&&(Le=At,Pe=Gt,Te=pt,re=zt),Tn&&ws(T,ki(Le,T),ki(Le+Pe,T)),En)for(let jt in v){let Ze=v[jt];jt!=T&&Ze.from==null&&Ze.min!=We&&ws(jt,ki(Te+re,jt),ki(Te,jt))}gu()}else ht.lock&&(ht._lock=!ht._lock,Zs(E,!0,S!=null));S!=null&&(me(Mu,Au),Go(Mu,n,Ye,je,O,Mt,null))}function k_(S,E,L,F,q,K,ct){if(ht._lock)return;ae(S);let pt=bs;if(bs){let At=!0,zt=!0,Gt=10,Wt,pe;R.ori==0?(Wt=Tn,pe=En):(Wt=En,pe=Tn),Wt&&pe&&(At=Ye<=Gt||Ye>=O-Gt,zt=je<=Gt||je>=Mt-Gt),Wt&&At&&(Ye=Ye<Rr?0:O),pe&&zt&&(je=je<Pr?0:Mt),Zs(null,!0,!0),bs=!1}Ye=-10,je=-10,et.fill(null),Zs(null,!0,!0),pt&&(bs=pt)}function ep(S,E,L,F,q,K,ct){ht._lock||(ae(S),Oo(),gu(),S!=null&&Go(dp,n,Ye,je,O,Mt,null))}function np(){M.forEach(Ox),z(n.width,n.height,!0)}tr(vl,Fr,np);let Dr={};Dr.mousedown=Qf,Dr.mousemove=$f,Dr.mouseup=tp,Dr.dblclick=ep,Dr.setSeries=(S,E,L,F)=>{let q=dn.match[2];L=q(n,E,L),L!=-1&&Bi(L,F,!0,!1)},gt&&(kt(cp,p,Qf),kt(Su,p,$f),kt(hp,p,S=>{ae(S),zo(!1)}),kt(up,p,k_),kt(dp,p,ep),Uu.add(n),n.syncRect=zo);let fl=n.hooks=i.hooks||{};function An(S,E,L){Gn?Ge.push([S,E,L]):S in fl&&fl[S].forEach(F=>{F.call(null,n,E,L)})}(i.plugins||[]).forEach(S=>{for(let E in S.hooks)fl[E]=(fl[E]||[]).concat(S.hooks[E])});let ip=(S,E,L)=>L,dn=fn({key:null,setSeries:!1,filters:{pub:bp,sub:bp},scales:[T,_[1]?_[1].scale:null],match:[wp,wp,ip],values:[null,null]},ht.sync);dn.match.length==2&&dn.match.push(ip),ht.sync=dn;let sp=dn.key,_u=vm(sp);function Go(S,E,L,F,q,K,ct){dn.filters.pub(S,E,L,F,q,K,ct)&&_u.pub(S,E,L,F,q,K,ct)}_u.sub(n);function z_(S,E,L,F,q,K,ct){dn.filters.sub(S,E,L,F,q,K,ct)&&Dr[S](null,E,L,F,q,K,ct)}n.pub=z_;function G_(){_u.unsub(n),Uu.delete(n),ee.clear(),Pu(vl,Fr,np),c.remove(),Lt?.remove(),An("destroy")}n.destroy=G_;function yu(){An("init",i,t),Fo(t||i.data,!1),W[T]?hu(T,W[T]):Oo(),st=$e.show&&($e.width>0||$e.height>0),nt=mt=!0,z(i.width,i.height)}return _.forEach(br),M.forEach(Ki),e?e instanceof HTMLElement?(e.appendChild(c),yu()):e(n,yu):yu(),n}vn.assign=fn;vn.fmtNum=Vu;vn.rangeNum=Sl;vn.rangeLog=wl;vn.rangeAsinh=zu;vn.orient=nr;vn.pxRatio=De;vn.join=Cy;vn.fmtDate=Wu,vn.tzDate=ky;vn.sync=vm;{vn.addGap=Sx,vn.clipGaps=Al;let i=vn.paths={points:Em};i.linear=Cm,i.stepped=wx,i.bars=Tx,i.spline=Ax}var Lm=matchMedia("(prefers-color-scheme: dark)"),Ps={light:["#000"],dark:["#fff"],sources:{light:[],dark:[]},alarm:{light:"#000",dark:"#fff"}},Il=new Map,Dm=!1,Nm=new Set;function Um(i){Ps=i}function Ll(i){Il.clear();for(let t of i)Il.set(t.sysid,{index:t.colour,role:t.role})}function Dl(i){Nm.add(i)}var Ku=()=>Nm.forEach(i=>i());Lm.addEventListener("change",Ku);function ju(i){Dm=i,Ku()}function Bx(){let i=document.documentElement.dataset.theme;return i==="light"||i==="dark"?i:"auto"}function ir(){let i=Jo()?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem("skytender-theme",i)}catch{}Ku()}function Fm(){try{let i=localStorage.getItem("skytender-theme");(i==="light"||i==="dark")&&(document.documentElement.dataset.theme=i)}catch{}}function Jo(){if(Dm)return!1;let i=Bx();return i==="auto"?Lm.matches:i==="dark"}function we(){return Jo()?{dark:!0,ink:"#e6e9ed",soft:"#a3adb8",grid:"#2b323a",paper:"#12161b",faint:"#1d232a",solid:"#7d8894",band:"rgba(86,180,233,.25)",crowd:"rgba(163,173,184,.35)",bad:"#ff9d7a",warn:"#f0c860",good:"#5fd3ac"}:{dark:!1,ink:"#1b1f24",soft:"#57606a",grid:"#dfe4e9",paper:"#ffffff",faint:"#f3f5f7",solid:"#6b7682",band:"rgba(0,114,178,.18)",crowd:"rgba(87,96,106,.3)",bad:"#a52a00",warn:"#7a5200",good:"#00664b"}}function pn(i){let t=Il.get(i);if(t?.role==="target")return we().ink;let e=Jo()?Ps.dark:Ps.light;return e[(t?.index??i-1)%e.length]}var Nl=()=>Jo()?Ps.alarm.dark:Ps.alarm.light;function Ul(i){let t=Il.get(i);if(t?.role==="target")return[2,3];if(t?.role==="tanker")return[8,3];let e=Ps.light.length;return[[],[6,4],[2,3],[6,3,2,3]][Math.floor((t?.index??i-1)/e)%4]}function Fl(i){let t=Jo()?Ps.sources.dark:Ps.sources.light;return t[i%t.length]}var kx=165,zx=52,Om=9,Gx=[.1,.2,.5,1,2,5,10,20,50,100,200,500,1e3,2e3,5e3,1e4,2e4,5e4],Ol=class{constructor(){this.zoom=null,this.now_s=0,this.end_s=1,this.begin_s=0,this.charts=new Set,this.seek=()=>{},this.point=()=>{}}get range(){return this.zoom??[this.begin_s,Math.max(this.end_s,this.begin_s+.001)]}setZoom(t){this.zoom=t;let[e,n]=this.range;for(let s of this.charts)for(let r of s.plots)r.setScale("x",{min:e,max:n})}setNow(t){if(this.now_s!==t){this.now_s=t;for(let e of this.charts)e.showNow()}}};function Vx(i){return Array.from(i,t=>Number.isNaN(t)?null:t)}var Wr=class{constructor(t,e,n){this.div=t,this.time=e,this.label=n,this.plots=[],this.key="",this.figure=null,this.nows=[],e.charts.add(this)}draw(t,e,n=this.div.clientWidth){if(n<=0)return;this.figure=t;let s=t.panels.map(o=>this.#t(o,e)),r=JSON.stringify([n,we().dark,we().paper,s.map(o=>o.series.map(a=>[a.label,a.stroke,a.dash]))]);r!==this.key&&this.#e(s,r,n),this.plots.forEach((o,a)=>{o.setData(s[a].data,!1);let[l,c]=this.time.range;o.batch(()=>{o.setScale("y",s[a].range()),o.setScale("x",{min:l,max:c})})}),this.div.dataset.lines=String(s.reduce((o,a)=>o+a.series.length-1,0)),this.showNow()}#t(t,e){let{soft:n}=we(),s=[{}],r=[],o=(d,f)=>{s.push({spanGaps:!1,points:{show:!1},width:1.6,...f}),r.push([Array.from(d.x),Vx(d.y)])};t.band&&(o(t.band.least,{label:"least",stroke:"transparent"}),o(t.band.greatest,{label:"greatest",stroke:"transparent"}),o(t.band.median,{label:`median of ${t.band.count}`,stroke:n,dash:[2,3]}));for(let d of t.lines){let f=d.id;e.has(f)&&o(d,{label:this.label(f),stroke:pn(f),dash:Ul(f)})}t.own.forEach((d,f)=>o(d,{label:d.label,stroke:Fl(f)}));let a=r.length?vn.join(r):[[this.time.begin_s,this.time.end_s]],[l,c]=[1/0,-1/0];for(let[,d]of r)for(let f of d)f!==null&&(f<l&&(l=f),f>c&&(c=f));for(let d of t.limits)l=Math.min(l,d.y),c=Math.max(c,d.y);t.zero&&(l=Math.min(l,0)),l>c&&([l,c]=[0,1]);let h=Math.max((c-l)*.06,10**-t.digits);return{panel:t,series:s,data:a,range:()=>t.range?{min:t.range[0],max:t.range[1]}:{min:t.zero&&l>=0?0:l-h,max:c+h}}}#e(t,e,n){this.key=e,this.close(),this.div.replaceChildren();let{soft:s,grid:r,band:o}=we();t.forEach(({panel:a,series:l},c)=>{let h=D("div",{class:"now"}),u=D("div",{class:"tip",hidden:!0}),d=D("p",{class:"panel-title"},a.title,a.unit?` (${a.unit})`:""),f=D("div",{class:"panel"});this.div.append(d,f);let p=c===t.length-1,x="11px system-ui, sans-serif",g=new vn({width:n,height:kx+(p?18:0),series:l,legend:{show:!1},padding:[6,10,0,0],scales:{x:{time:!1,range:(m,_,M)=>[_,M]},y:{range:(m,_,M)=>[_,M]}},axes:[{stroke:s,font:x,grid:{stroke:r,width:1},ticks:{show:!1},incrs:Gx,size:22,label:p?"session time (s)":void 0,labelFont:x,labelSize:18,labelGap:0},{stroke:s,font:x,grid:{stroke:r,width:1},ticks:{show:!1},size:zx,space:28}],bands:a.band?[{series:[2,1],fill:o}]:[],cursor:{sync:{key:"skytender",setSeries:!1},y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!1},bind:{dblclick:()=>()=>(this.time.setZoom(null),null)}},hooks:{drawClear:[m=>this.#i(m)],draw:[m=>this.#s(m,a)],setSelect:[m=>{m.select.width<8||(this.time.setZoom([m.posToVal(m.select.left,"x"),m.posToVal(m.select.left+m.select.width,"x")]),m.setSelect({left:0,top:0,width:0,height:0},!1))}],setCursor:[m=>this.#n(m,a,u)]}},l.map(()=>[]),f);g.over.append(h,u),g.over.addEventListener("click",()=>{g.select.width<8&&g.cursor.left!==void 0&&g.cursor.left>=0&&this.time.seek(g.posToVal(g.cursor.left,"x"))}),this.plots.push(g),this.nows.push(h)})}#i(t){let{ctx:e}=t,{left:n,top:s,width:r,height:o}=t.bbox;e.save(),e.beginPath(),e.rect(n,s,r,o),e.clip(),e.globalAlpha=.13;for(let a of this.figure?.spans??[]){let[l,c]=[t.valToPos(a.from,"x",!0),t.valToPos(a.to,"x",!0)];e.fillStyle=pn(a.id),e.fillRect(l,s,c-l,o)}e.restore()}#s(t,e){let{ctx:n}=t,{left:s,top:r,width:o,height:a}=t.bbox,{ink:l,soft:c,bad:h,paper:u}=we(),d=vn.pxRatio;n.save(),n.beginPath(),n.rect(s,r,o,a),n.clip(),n.font=`${11*d}px system-ui, sans-serif`,n.lineWidth=d;let f=(x,g,m,_)=>{n.lineWidth=3*d,n.strokeStyle=u,n.strokeText(x,g,m),n.fillStyle=_,n.fillText(x,g,m),n.lineWidth=d};for(let x of e.limits){let g=t.valToPos(x.y,"y",!0);n.setLineDash([6*d,4*d]),n.strokeStyle=l,n.beginPath(),n.moveTo(s,g),n.lineTo(s+o,g),n.stroke(),n.setLineDash([]),n.textAlign="right",f(x.label,s+o-4*d,g<r+14*d?g+13*d:g-4*d,c)}n.textAlign="left";let p=-1/0;for(let x of this.figure?.marks??[]){let g=t.valToPos(x.t_s,"x",!0);n.setLineDash([2*d,3*d]),n.strokeStyle=x.bad?h:c,n.beginPath(),n.moveTo(g,r),n.lineTo(g,r+a),n.stroke(),n.setLineDash([]),!(g-p<34*d)&&(p=g,f(x.label,g+3*d,r+12*d,x.bad?h:x.id!==void 0?pn(x.id):c))}n.restore()}#n(t,e,n){let{left:s,idx:r}=t.cursor,o=t.over.matches(":hover");if(o&&this.time.point(s===void 0||s<0?null:t.posToVal(s,"x")),s===void 0||s<0||r===null||r===void 0||!o)return void(n.hidden=!0);let a=t.posToVal(s,"x"),l=[];for(let u=1;u<t.series.length;u+=1){if(t.series[u].stroke==="transparent")continue;let d=t.data[u],f=r;for(;f>0&&d[f]===void 0;)f-=1;let p=d[f];if(p==null)continue;let x=D("i",{class:"swatch"}),g=t.series[u].stroke;x.style.background=String(typeof g=="function"?g(t,u):g),l.push({value:p,row:D("div",{},x,`${t.series[u].label}: ${xe(p,e.digits)} ${e.unit}`)})}let c=l.length-Om;n.replaceChildren(D("b",{},`${a.toFixed(1)} s`),...l.slice(0,Om).map(u=>u.row),c>0?`and ${c} more`:"");for(let u of this.figure?.marks??[])Math.abs(t.valToPos(u.t_s,"x")-s)<5&&n.append(D("div",{},u.text??`${u.id===void 0?u.label:`${this.label(u.id)} is next`}, ${u.t_s.toFixed(1)} s`));n.hidden=!1;let h=s>t.over.clientWidth/2;n.style.left=h?"":`${s+12}px`,n.style.right=h?`${t.over.clientWidth-s+12}px`:""}showNow(){this.plots.forEach((t,e)=>{let n=t.valToPos(this.time.now_s,"x"),s=Number.isFinite(n)&&n>=0&&n<=t.over.clientWidth;this.nows[e].hidden=!s,s&&(this.nows[e].style.transform=`translateX(${n}px)`)})}close(){for(let t of this.plots)t.destroy();this.plots=[],this.nows=[]}},Bm=["on the way","in formation","transfer"];function km(i,t,e){let[n,s]=[e.begin_s,Math.max(e.end_s,e.begin_s+.001)],r=c=>`${(100*(c-n)/(s-n)).toFixed(2)}%`,o=t.rows.map(c=>{let h=D("div",{class:"track"});for(let u of t.bars.filter(d=>d.row===c)){let d=`${Bm[u.stage]} ${u.from.toFixed(1)} to ${u.to.toFixed(1)} s, ${u.text}`,f=D("button",{type:"button",class:`bar stage${u.stage}`,title:d,"aria-label":`${c}: ${d}`,onclick:()=>e.seek(u.from)});f.style.left=r(u.from),f.style.width=`max(3px, ${r(n+u.to-u.from)})`,h.append(f)}return D("div",{class:"row"},D("span",{class:"row-name"},c),h)}),a=D("p",{class:"small soft key"},...Bm.map((c,h)=>D("span",{},D("i",{class:`swatch stage${h}`}),c))),l=D("div",{class:"row"},D("span",{class:"row-name"},"session time (s)"),D("div",{class:"ends"},D("span",{},n.toFixed(0)),D("span",{},s.toFixed(0))));i.replaceChildren(a,...o,l),i.classList.add("bars"),i.dataset.lines=String(t.bars.length)}function zm(i,t,e,n){let s=[["initial","initial_j",0],["received","received_j",0],["drawn","drawn_j",1],["given","given_j",1],["remaining","remaining_j",1]],r=t.rows.filter(h=>e.has(h.id)),o=Math.max(...r.map(h=>h.initial_j+h.received_j),1),a=r.flatMap(h=>[0,1].map(u=>{let d=D("div",{class:"track stack"});return s.forEach(([f,p,x],g)=>{let m=h[String(p)];if(x!==u||!(m>0))return;let _=`${f} ${(m/1e3).toFixed(1)} kJ`,M=D("span",{class:"bar",title:_,role:"img","aria-label":_});M.style.width=`${(100*m/o).toFixed(2)}%`,M.style.background=Fl(g),d.append(M)}),D("div",{class:"row"},D("span",{class:"row-name"},u?"went":`${n(h.id)}: came`),d)})),l=s.map(([h],u)=>{let d=D("i",{class:"swatch"});return d.style.background=Fl(u),D("span",{},d,String(h))}),c=D("div",{class:"row"},D("span",{class:"row-name"},"energy (kJ)"),D("div",{class:"ends"},D("span",{},"0"),D("span",{},(o/1e3).toFixed(0))));i.replaceChildren(D("p",{class:"small soft key"},...l),...a,c),i.classList.add("bars"),i.dataset.lines=String(i.querySelectorAll(".bar").length)}var ss=["n","e","d","heading","roll","pitch","speed","height","battery","power","target","v","lost"],Hx=new Set(["heading","roll","pitch"]),Wx=4e3,Xx=6e6,qx=.09,Gm=6e3,Yx=600;function $x(i){let[t,e,n]=i.p_ned??[NaN,NaN,NaN],s=i.battery===null?NaN:100*i.battery;return[t,e,n,i.heading_rad,i.roll_rad,i.pitch_rad,i.speed_m_s,i.height_m??NaN,s,i.power_w??NaN,i.target_m??NaN,i.v??NaN,i.lost]}var Ko=class{constructor(){this.t_s=[],this.rows=[],this.last=""}take(t,e){let{mode:n,stage:s,state:r,alive:o,armed:a,landed:l,note:c,trouble:h,severity:u,condition:d,figure:f,urgency:p,autopilot:x}=e,g={mode:n,stage:s,state:r,alive:o,armed:a,landed:l,note:c,trouble:h,severity:u,condition:d,figure:f,urgency:p,autopilot:x},m=JSON.stringify(g);m!==this.last&&(this.t_s.length&&t<=this.t_s[this.t_s.length-1]||(this.last=m,this.t_s.push(t),this.rows.push(g)))}at(t){let e=qn(this.t_s,t);return this.rows[Math.max(e,0)]??{}}};function qn(i,t,e=i.length){let n=0,s=e;for(;n<s;){let r=n+s>>1;i[r]<=t?n=r+1:s=r}return n-1}var Xr=class i{session=null;worlds=[];newest=null;events=[];count=0;capacity=256;spacing_s=qx;t_s=new Float64Array(this.capacity);share=new Float32Array(this.capacity);columns=new Map;words=new Map;traffic=new Map;ghosts=[];version=0;clear(){Object.assign(this,new i,{version:this.version+1})}get first_s(){return this.count?this.t_s[0]:0}get last_s(){return this.count?this.t_s[this.count-1]:0}begin(t){if(this.session=t,t.source==="replay")return;let e=this.worlds.length?this.newest?.t_s??0:-1/0;for(;this.worlds.length&&this.worlds[this.worlds.length-1].t_s>=e;)this.worlds.pop();this.worlds.push({t_s:e,session:t}),this.worlds.length>Yx&&(this.worlds=this.worlds.filter((n,s)=>s%2===0))}sessionAt(t){let e=qn(this.worlds.map(n=>n.t_s),t);return this.worlds[Math.max(e,0)]?.session??this.session}tell(t){t.length&&(this.events.push(...t),this.events.length>Gm&&this.events.splice(0,this.events.length-Gm))}take(t){this.newest=t;let e=t.t_s;for(let r of t.vehicles){let o=this.words.get(r.sysid);o||this.words.set(r.sysid,o=new Ko),o.take(e,r)}let n=qn(this.t_s,e,this.count),s=r=>r>=0&&r<this.count&&Math.abs(this.t_s[r]-e)<this.spacing_s;s(n)||s(n+1)||(this.#s(),this.#t(n+1,t),this.version+=1)}#t(t,e){let n=t<this.count,s=(a,l)=>{n&&a.copyWithin(t+1,t,this.count),a[t]=l};s(this.t_s,e.t_s),s(this.share,e.competition.share??NaN);let r=new Set;for(let a of e.vehicles){r.add(a.sysid);let l=this.#e(a.sysid);$x(a).forEach((c,h)=>s(l[ss[h]],c))}for(let[a,l]of this.columns)if(!r.has(a))for(let c of ss)s(l[c],NaN);let o=new Set;for(let a of e.traffic){o.add(a.callsign);let l=this.#i(a.callsign);a.p_ned.forEach((c,h)=>s(l[h],c))}for(let[a,l]of this.traffic)if(!o.has(a))for(let c of l)s(c,NaN);this.count+=1}#e(t){let e=this.columns.get(t);if(!e){e={};for(let n of ss)e[n]=new Float32Array(this.capacity).fill(NaN);this.columns.set(t,e)}return e}#i(t){let e=this.traffic.get(t);return e||(e=[0,1,2].map(()=>new Float32Array(this.capacity).fill(NaN)),this.traffic.set(t,e)),e}#s(){if(this.count<this.capacity)return;let t=Math.min(Wx,Math.max(256,Xx/(ss.length*Math.max(this.columns.size,1))));if(2*this.capacity<=t){this.capacity*=2,this.#n(n=>{let s=new n.constructor(this.capacity).fill(NaN);return s.set(n),s});return}let e=this.count>>1;this.#n(n=>{for(let s=0;s<e;s+=1)n[s]=n[2*s];return n}),this.count=e,this.spacing_s=Math.max(2*this.spacing_s,.9*(this.last_s-this.first_s)/Math.max(e,1))}#n(t){this.t_s=t(this.t_s),this.share=t(this.share);for(let e of this.columns.values())for(let n of ss)e[n]=t(e[n]);for(let e of this.traffic.values())e.forEach((n,s)=>e[s]=t(n))}at(t){let e=this.newest;if(!e||!this.count)return e;let n=Math.max(qn(this.t_s,t,this.count),0),s=Math.min(n+1,this.count-1),r=this.t_s[s]-this.t_s[n],o=r>0?Math.min(Math.max((t-this.t_s[n])/r,0),1):0,a=(_,M=!1)=>{let v=_[n],C=_[s];return Number.isNaN(C)||Number.isNaN(v)?o<.5?v:C:(M&&(C=v+Math.atan2(Math.sin(C-v),Math.cos(C-v))),v+o*(C-v))},l=_=>Number.isNaN(_)?null:_,c=new Map((this.session?.vehicles??[]).map(_=>[_.sysid,_])),h=[];for(let[_,M]of this.columns){let v=c.get(_),C={};for(let b of ss)C[b]=l(a(M[b],Hx.has(b)));let T=v?.capacity_j??null,y=C.battery===null?null:C.battery/100;h.push({sysid:_,role:v?.role??"",label:v?.label??String(_),autopilot:null,alive:!0,stage:"",mode:"",armed:!0,landed:!1,state:"",note:"",trouble:[],severity:0,condition:"",figure:"",urgency:0,...this.words.get(_)?.at(t),p_ned:C.n===null?null:[C.n,C.e,C.d],v_ned:[0,0,0],speed_m_s:C.speed??0,height_m:C.height,heading_rad:C.heading??0,roll_rad:C.roll??0,pitch_rad:C.pitch??0,aim_ned:null,margin_m:null,age_s:0,heard_s:null,lost:C.lost??0,lost_share:null,target_m:C.target,battery:y,remaining_j:y!==null&&T!==null?y*T:null,power_w:C.power,endurance_s:null,energy_source:"",v:C.v,tau:null})}h.sort((_,M)=>_.sysid-M.sysid);let{services:u,history:d,refuelled:f}=this.#r(t);for(let _ of h){if(_.state)continue;let M=u.find(v=>v.receiver===_.sysid||v.tanker===_.sysid);_.state=M?M.tanker===_.sysid?"serves":M.phase==="transfer"?"served":"waits":""}let p=[];for(let[_,M]of this.traffic){let v=M.map(C=>a(C));v.some(Number.isNaN)||p.push({callsign:_,p_ned:v,v_ned:[0,0,0],age_s:0})}let x=Object.fromEntries(h.filter(_=>_.v!==null).map(_=>[_.sysid,_.v])),g=l(this.share[n]),m=Object.keys(x).sort((_,M)=>Number(x[M])-Number(x[_]));return{...e,t_s:t,vehicles:h,traffic:p,events:[],inspected:{},competition:{...e.competition,v:x,tau:{},share:g,leader:g===null||!m.length?null:Number(m[0]),runner_up:m.length>1?Number(m[1]):null},services:u,history:d,refuelled:f,goal:{...e.goal,pursue_held_s:null,broken:e.goal.broken.filter(_=>_.t_s===null||_.t_s<=t)}}}#r(t){let e=this.newest,n=e.history.filter(a=>a.end_s!==null&&a.end_s<=t),s=e.history.filter(a=>a.decided_at_s<=t&&(a.end_s===null||a.end_s>t)),r=e.services.filter(a=>a.decided_at_s<=t);return{services:[...s.map(a=>({receiver:a.receiver,tanker:a.tanker,base:a.base,by:a.by,energy_j:0,decided_at_s:a.decided_at_s,phase:a.start_s!==null&&a.start_s<=t?"transfer":"join",joined_at_s:a.joined_at_s!==null&&a.joined_at_s<=t?a.joined_at_s:null,rendezvous_ned:null,bids:{},why:""})),...r],history:n,refuelled:n.filter(a=>a.energy_j>0).length}}};var Bl=null;function Zx(){if(Bl!==null)return Bl;let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info"),e=i&&t?String(i.getParameter(t.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),Bl=!i||/swiftshader|llvmpipe|softpipe|software/i.test(e),Bl}function sr(i){return i.getContext("2d",{willReadFrequently:Zx()})}var qr=i=>i/16*Number.parseFloat(getComputedStyle(document.documentElement).fontSize);var Qu={dead:"✕",silent:"⌀",failing:"▲",low:"◔",warned:"△",landed:"▼"},Hm=i=>Qu[i.condition||(i.landed?"landed":"")]??"",Jx=3,kl=2*Math.PI;function Vm(i,t,e,n,s){i.beginPath(),i.moveTo(t,e-.8*s*n),i.lineTo(t+n,e+.8*s*n),i.lineTo(t-n,e+.8*s*n),i.closePath()}function zl(i,t,e,n,s){let{ink:r,paper:o,soft:a}=we(),[l,c]=[1.5*s,Math.max(.35*s,2)];i.setLineDash([]);let h=(d,f)=>{for(let[p,x]of[[o,f+Jx],[d,f]])i.strokeStyle=p,i.lineWidth=x,i.stroke()},u=(d,f)=>{h(f,.75*c),i.fillStyle=d,i.fill()};if(t.condition==="dead"||t.condition==="silent"){let d=.75*l;i.beginPath(),t.condition==="silent"?i.arc(e,n,l,0,kl):(i.moveTo(e-d,n-d),i.lineTo(e+d,n+d)),i.moveTo(e-d,n+d),i.lineTo(e+d,n-d),h(Nl(),c)}else if(t.condition==="failing"||t.condition==="warned"){let d=t.condition==="failing";Vm(i,e,n-2.3*s,(d?1.3:.9)*s,1),u(d?Nl():o,d?Nl():r)}else t.condition==="low"&&(i.beginPath(),i.arc(e,n,1.1*l,0,kl),h(a,1),i.beginPath(),i.arc(e,n,1.1*l,-kl/4,kl*(Math.min(Math.max(t.battery??0,.02),1)-.25)),h(r,1.3*c));t.landed&&t.condition!=="dead"&&(Vm(i,e,n+2.2*s,.9*s,-1),u(r,r))}var Kx=1e5,jx=300,Yr=i=>i?.plans??[];function Wm(i){return Yr(i).flatMap(e=>[...e.items.flatMap(n=>n.p_ned?[n.p_ned]:[]),...e.rally_ned,...e.home_ned?[e.home_ned]:[],...e.fence.flatMap(n=>n.outline_ne)]).filter(([e,n])=>Math.hypot(e,n)<Kx).map(([e,n])=>[e,n])}var jo=i=>i.sysid===null?we().ink:pn(i.sysid),Xm=i=>i.items.filter(t=>t.flown&&t.p_ned);function qm(i){return Yr(i).flatMap(t=>{let e=Xm(t).map(n=>n.p_ned);return[{points:t.home_ned&&e.length?[t.home_ned,...e]:e,colour:jo(t)},...t.fence.map(n=>({points:n.outline_ne.map(([s,r])=>[s,r,0]),colour:n.inside?we().good:we().bad})),...t.rally_ned.map(([n,s,r])=>({points:[[n,s,0],[n,s,r]],colour:we().good}))]})}function Ym(i,t,e,n,s){let{good:r,bad:o,paper:a,ink:l}=we();i.save(),i.font="600 10px system-ui, sans-serif",i.textAlign="center",i.textBaseline="middle";for(let c of Yr(t)){for(let p of c.fence)i.strokeStyle=i.fillStyle=p.inside?r:o,i.lineWidth=1.8,i.setLineDash([10,4]),i.beginPath(),p.outline_ne.forEach(([x,g],m)=>i[m?"lineTo":"moveTo"](n(g),s(x))),i.globalAlpha=p.inside?.04:.1,i.fill(),i.globalAlpha=.9,i.stroke();i.globalAlpha=1,i.strokeStyle=jo(c),i.lineWidth=1.6,i.setLineDash([8,5]),i.beginPath();let h=Xm(c),[u]=h;c.home_ned&&u&&i.moveTo(n(c.home_ned[1]),s(c.home_ned[0])),h.forEach(({p_ned:[p,x]},g)=>i[g||c.home_ned?"lineTo":"moveTo"](n(x),s(p))),i.stroke(),i.setLineDash([]);let d=$m(c,e);for(let p of c.items.slice(0,jx)){if(!p.p_ned)continue;let[x,g]=[n(p.p_ned[1]),s(p.p_ned[0])];i.beginPath(),p.flown?i.arc(x,g,8,0,2*Math.PI):i.rect(x-7,g-7,14,14),i.fillStyle=p.number===d?jo(c):a,i.fill(),i.stroke(),i.fillStyle=p.number===d?a:l,i.fillText(String(p.number),x,g)}let f=c.rally_ned.map(p=>["R",p,r]);c.home_ned&&f.push(["H",c.home_ned,jo(c)]);for(let[p,[x,g],m]of f)i.beginPath(),[[0,-10],[10,0],[0,10],[-10,0]].forEach(([_,M],v)=>i[v?"lineTo":"moveTo"](n(g)+_,s(x)+M)),i.closePath(),i.fillStyle=a,i.fill(),i.strokeStyle=i.fillStyle=m,i.stroke(),i.fillText(p,n(g),s(x)),i.strokeStyle=jo(c)}i.restore()}var $m=(i,t)=>i.sysid===null?void 0:t.vehicles.find(e=>e.sysid===i.sysid)?.mission_item,td=(i,t,e)=>i?[`${i} ${i===1?t:e}`]:[];function Zm(i,t,e){let n=Yr(t),s=n.map(a=>$m(a,e)),r=JSON.stringify([n,s]);if(i.dataset.key===r)return;i.dataset.key=r;let o=new Set([...i.querySelectorAll("details[open]")].map(a=>a.getAttribute("data-source")));i.replaceChildren(...n.map((a,l)=>{let c=[...td(a.items.length,"item","items"),...td(a.fence.length,"fence area","fence areas"),...td(a.rally_ned.length,"rally point","rally points")],h=a.items.map(p=>D("tr",{class:p.number===s[l]?"chosen":"","aria-current":p.number===s[l]?"step":null},...[String(p.number),p.command,p.height_m===null?"":`${xe(p.height_m,1)} m`,p.above===null?"":`above ${p.above}`,p.p_ned?`${xe(p.p_ned[0],1)}, ${xe(p.p_ned[1],1)}`:"",p.about].map((x,g)=>D("td",{class:[1,3,5].includes(g)?"word":""},x)))),u=["","command","height","","north, east m","parameters"].map((p,x)=>D(p?"th":"td",{scope:p?"col":null,class:[1,3,5].includes(x)?"word":""},p)),d=h.length?[D("div",{class:"scroll",tabindex:0,role:"region","aria-label":`mission of ${a.source}`},D("table",{},D("thead",{},D("tr",{},...u)),D("tbody",{},...h)))]:[],f=D("details",{"data-source":a.source},D("summary",{},D("b",{},a.source),`: ${c.join(", ")||"nothing"}`),...d,...a.left_out.map(p=>D("p",{class:"warn small"},p)));return f.open=i.childElementCount?o.has(a.source):n.length===1,f}))}var Qx=.08,ed=40,tv=150,ev=[1,2,5];function Gl(i){let t=10**Math.floor(Math.log10(i));return t*Math.max(...ev.filter(e=>e*t<=i*1.0001),1)}var Jm=new WeakMap;function Qo(i){let t=Jm.get(i);if(t&&t.version===i.version&&t.session===i.session)return t.found;let e=nv(i);return Jm.set(i,{version:i.version,session:i.session,found:e}),e}function nv(i){let[t,e,n,s]=[1/0,-1/0,1/0,-1/0],r=(a,l)=>{Number.isNaN(a)||(t=Math.min(t,a),e=Math.max(e,a),n=Math.min(n,l),s=Math.max(s,l))};for(let a of[i,...i.ghosts]){let l=Math.max(Math.floor(a.count/100),1);for(let c of a.columns.values()){for(let h=0;h<a.count;h+=l)r(c.n[h],c.e[h]);a.count&&r(c.n[a.count-1],c.e[a.count-1])}}let o=i.worlds.length?i.worlds.map(a=>a.session):[i.session];for(let a of o.flatMap(l=>l?.obstacles??[])){r(a.centre_ned[0],a.centre_ned[1]);for(let[l,c]of a.outline_ne)r(l,c)}for(let a of i.session?.bases??[])r(a.p_ned[0],a.p_ned[1]);for(let a of o.flatMap(l=>l?.vehicles??[]))for(let[l,c]of a.path_ned)r(l,c);for(let[a,l]of Wm(i.session))r(a,l);return t>e?null:[[t,e],[n,s]]}var $r=class{constructor(t,e,n=!1){this.canvas=t,this.still=n,this.view=null,this.follow=!1,this.places=[],this.dirty=!0,this.tiles=null;let s=new Map,r=0;t.addEventListener("pointerdown",a=>{t.setPointerCapture(a.pointerId),s.set(a.pointerId,{x:a.offsetX,y:a.offsetY}),r=0}),t.addEventListener("pointermove",a=>{let l=s.get(a.pointerId);if(!l)return;let c={x:a.offsetX,y:a.offsetY},h=[...s].find(([u])=>u!==a.pointerId)?.[1];if(h){let u=d=>Math.hypot(d.x-h.x,d.y-h.y);this.zoom(u(l)/Math.max(u(c),1),(c.x+h.x)/2,(c.y+h.y)/2)}else this.pan(c.x-l.x,c.y-l.y);r+=Math.hypot(c.x-l.x,c.y-l.y),s.set(a.pointerId,c)});let o=a=>{s.delete(a.pointerId),!(a.type!=="pointerup"||r>4)&&e(Vo(this.places,a.offsetX,a.offsetY),a)};t.addEventListener("pointerup",o),t.addEventListener("pointercancel",o),t.addEventListener("wheel",a=>{a.preventDefault(),this.zoom(Math.exp(a.deltaY*.0015),a.offsetX,a.offsetY)},{passive:!1}),t.addEventListener("keydown",a=>{let l={ArrowLeft:[40,0],ArrowRight:[-40,0],ArrowUp:[0,40],ArrowDown:[0,-40]}[a.key];if(l)this.pan(l[0],l[1]);else if(a.key==="+"||a.key==="-")this.zoom(a.key==="+"?.8:1.25);else if(a.key==="0")this.whole();else return;a.preventDefault(),a.stopPropagation()})}whole(){this.view=null,this.follow=!1,this.dirty=!0}pan(t,e){this.frame&&(this.view??={n:this.frame.n,e:this.frame.e,m:this.frame.m},this.follow=!1,this.view.e-=t/this.frame.perMetre,this.view.n+=e/this.frame.perMetre,this.dirty=!0)}zoom(t,e,n){let s=this.frame;if(!s)return;this.view??={n:s.n,e:s.e,m:s.m};let r=Math.min(Math.max(this.view.m*t,1),1e6),o=1-r/this.view.m;e!==void 0&&n!==void 0&&(this.view.e+=o*(e-s.width/2)/s.perMetre,this.view.n-=o*(n-s.height/2)/s.perMetre),this.view.m=r,this.dirty=!0}draw(t,e,{chosen:n,selected:s,paths:r,until_s:o,trail_s:a,shown:l=null,ghosts:c=[]}){let{width:h,height:u,scale:d}=pl(this.canvas),f=sr(this.canvas),p=we();f.setTransform(d,0,0,d,0,0),f.fillStyle=p.paper,f.fillRect(0,0,h,u);let x=Qo(t);if(!x)return;let g=this.follow&&n!==null?e.vehicles.find(W=>W.sysid===n)?.p_ned:null,[[m,_],[M,v]]=x,C=Math.max((_-m)/u,(v-M)/h,2/Math.min(h,u))*(1+2*Qx),T={n:(m+_)/2,e:(M+v)/2,m:C*Math.min(h,u)},y=this.view??T;g&&(this.view={n:g[0],e:g[1],m:Math.min(y.m,Math.max(T.m/3,12))},this.view.m<y.m&&y!==T&&(this.view.m=y.m));let{n:b,e:U,m:P}=this.view??T,R=Math.min(h,u)/P;this.frame={n:b,e:U,m:P,perMetre:R,width:h,height:u};let G=W=>h/2+(W-U)*R,H=W=>u/2-(W-b)*R,N=t.session?.origin;this.tiles&&N&&this.tiles.draw(f,N,this.frame,G,H,p),this.#e(f,G,H,R,h,u),this.#i(f,t.sessionAt(e.t_s),G,H,R),Ym(f,t.session,e,G,H),r&&this.#s(f,t,G,H,o,a,n,l),this.#r(f,t,e,G,H);for(let W of c)this.#l(f,W,G,H,o,r);this.#a(f,t,e,G,H,R,n,s),this.#c(f,R,h,u),this.#t(f,t,h)}#t(t,e,n){let s=e.session?.wind;if(!s)return;let{ink:r}=we(),[o,a]=[n-20,64];t.save(),t.translate(o,a),t.rotate((s.from_deg+180)*Math.PI/180),t.strokeStyle=r,t.lineWidth=2,t.beginPath(),[[0,14],[0,-14]].forEach(([l,c],h)=>t[h?"lineTo":"moveTo"](l,c)),[[-5,-7],[0,-14],[5,-7]].forEach(([l,c],h)=>t[h?"lineTo":"moveTo"](l,c)),t.stroke(),t.restore()}#e(t,e,n,s,r,o){let a=this.frame,l=Gl(110/s)||1,{grid:c,soft:h}=we();t.lineWidth=1,t.strokeStyle=c,t.fillStyle=h,t.font="11px system-ui, sans-serif";let u=l<1?1:0,d=Math.ceil((a.e-r/2/s)/l)*l;t.beginPath();for(let p=d;e(p)<r;p+=l)t.moveTo(e(p),0),t.lineTo(e(p),o);let f=Math.ceil((a.n-o/2/s)/l)*l;for(let p=f;n(p)>0;p+=l)t.moveTo(0,n(p)),t.lineTo(r,n(p));t.stroke(),t.textAlign="center";for(let p=d;e(p)<r-30;p+=l)e(p)>40&&t.fillText(`E ${xe(p,u)}`,e(p),o-5);t.textAlign="left";for(let p=f;n(p)>24;p+=l)n(p)<o-24&&t.fillText(`N ${xe(p,u)}`,5,n(p)-3)}#i(t,e,n,s,r){let{solid:o,soft:a,crowd:l}=we();t.strokeStyle=o,t.fillStyle=l,t.lineWidth=1.2;for(let c of e?.obstacles??[])if(t.beginPath(),c.outline_ne.length)c.outline_ne.forEach(([h,u],d)=>t[d?"lineTo":"moveTo"](n(u),s(h))),t.fill(),t.stroke();else{let[h,u]=[n(c.centre_ned[1]),s(c.centre_ned[0])];t.moveTo(h-5,u-5),t.lineTo(h+5,u+5),t.moveTo(h+5,u-5),t.lineTo(h-5,u+5),t.stroke()}t.setLineDash([6,5]),t.strokeStyle=a;for(let c of e?.vehicles??[])t.beginPath(),c.path_ned.forEach(([h,u],d)=>t[d?"lineTo":"moveTo"](n(u),s(h))),t.stroke();t.setLineDash([]),t.font="12px system-ui, sans-serif",t.fillStyle=a;for(let c of e?.bases??[]){let[h,u]=[n(c.p_ned[1]),s(c.p_ned[0])];t.strokeStyle=a,t.lineWidth=2,t.strokeRect(h-6,u-6,12,12),t.fillText(`base ${c.name}`,h+9,u+4)}}#s(t,e,n,s,r,o,a,l){let c=e.columns.size>ed,h=qn(e.t_s,r+1e-6,e.count)+1,u=qn(e.t_s,r-o,e.count)+1,{soft:d}=we();t.lineJoin="round";let f=c?0:3;for(let[p,x]of e.columns){if(l&&!l.has(p)&&!c)continue;let g=p===a||(l?.has(p)??!1);t.globalAlpha=g||!c?a===null||g?.95:.45:.35,t.strokeStyle=pn(p),t.lineWidth=g?2.4:1.4,t.setLineDash(c?[]:Ul(p));let m=g||!c?0:u;this.#n(t,x.e,x.n,m,h,Math.max(Math.floor((h-m)/(g||!c?2e3:tv)),1),n,s);let _=x.n.findIndex(M=>!Number.isNaN(M));!f||_<0||_>=h||(t.setLineDash([]),t.beginPath(),t.arc(n(x.e[_]),s(x.n[_]),f,0,2*Math.PI),t.stroke())}t.globalAlpha=.9,t.strokeStyle=d,t.setLineDash([2,4]);for(let[p,x]of e.traffic.values())this.#n(t,x,p,0,h,Math.max(Math.floor(h/500),1),n,s);t.setLineDash([]),t.globalAlpha=1}#n(t,e,n,s,r,o,a,l){t.beginPath();let c=!1;for(let h=s;h<r;h=h+o<r||h===r-1?h+o:r-1){if(Number.isNaN(n[h])){c=!1;continue}t[c?"lineTo":"moveTo"](a(e[h]),l(n[h])),c=!0}t.stroke()}#r(t,e,n,s,r){let o=new Map(n.vehicles.map(c=>[c.sysid,c.p_ned])),a=new Map((e.session?.bases??[]).map(c=>[c.name,c.p_ned])),{warn:l}=we();for(let c of n.services){let h=c.tanker!==null?o.get(c.tanker):a.get(c.base??""),u=o.get(c.receiver);!h||!u||(t.strokeStyle=l,t.lineWidth=c.phase==="transfer"?4:1.5,t.setLineDash(c.phase==="transfer"?[]:[4,4]),t.beginPath(),t.moveTo(s(h[1]),r(h[0])),t.lineTo(s(u[1]),r(u[0])),t.stroke())}t.setLineDash([])}#a(t,e,n,s,r,o,a,l){let c=we(),h=e.session?.ring_m??null,u=n.vehicles.length>ed,d=qr(u?5:8);this.places=[];for(let x of n.vehicles){if(!x.p_ned)continue;let[g,m]=[s(x.p_ned[1]),r(x.p_ned[0])];this.places.push({sysid:x.sysid,x:g,y:m}),x.role==="target"&&h!==null&&(t.strokeStyle=c.soft,t.lineWidth=1,t.setLineDash([3,4]),t.beginPath(),t.arc(g,m,h*o,0,2*Math.PI),t.stroke(),t.setLineDash([])),t.fillStyle=pn(x.sysid),t.strokeStyle=c.paper,t.lineWidth=1.5,t.save(),t.translate(g,m),t.rotate(x.heading_rad),t.beginPath(),x.role==="tanker"?t.rect(-d,-d,2*d,2*d):x.role==="target"?[[0,-1.3],[1.1,0],[0,1.3],[-1.1,0]].forEach(([_,M],v)=>t[v?"lineTo":"moveTo"](_*d,M*d)):[[0,-1.5],[1,1.1],[0,.6],[-1,1.1]].forEach(([_,M],v)=>t[v?"lineTo":"moveTo"](_*d,M*d)),t.closePath(),t.fill(),t.stroke(),t.restore(),zl(t,x,g,m,d),l.has(x.sysid)&&(t.strokeStyle=c.ink,t.lineWidth=x.sysid===a?2.5:1.5,t.beginPath(),t.arc(g,m,d+8,0,2*Math.PI),t.stroke())}for(let x of n.traffic){let[g,m]=[s(x.p_ned[1]),r(x.p_ned[0])];t.strokeStyle=c.warn,t.lineWidth=2,t.beginPath(),[[0,-8],[8,6],[-8,6],[0,-8]].forEach(([_,M],v)=>t[v?"lineTo":"moveTo"](g+_,m+M)),t.stroke(),this.#o(t,x.callsign,g,m,c.warn,[])}let f=this.places.map(x=>[x.x-d,x.y-d,x.x+d,x.y+d]),p=n.vehicles.filter(x=>!u||x.sysid===a||x.severity>1||x.role!=="pursuer");p.sort((x,g)=>+(g.sysid===a)-+(x.sysid===a)||g.severity-x.severity),t.font=`600 ${qr(12)}px system-ui, sans-serif`,t.lineJoin="round";for(let x of p.slice(0,ed))x.p_ned&&this.#o(t,String(x.sysid),s(x.p_ned[1]),r(x.p_ned[0]),c.ink,f)}#l(t,e,n,s,r,o){let{soft:a,paper:l}=we(),c=qn(e.t_s,r+1e-6,e.count)+1;if(t.strokeStyle=a,t.lineWidth=1.2,t.setLineDash([5,3]),o)for(let{e:h,n:u}of e.columns.values())this.#n(t,h,u,0,c,Math.max(Math.floor(c/500),1),n,s);t.setLineDash([]),t.font="11px system-ui, sans-serif";for(let h of e.at(r)?.vehicles??[]){if(!h.p_ned)continue;let[u,d]=[n(h.p_ned[1]),s(h.p_ned[0])];t.beginPath(),t.arc(u,d,6,0,2*Math.PI),t.fillStyle=l,t.fill(),t.stroke(),this.#o(t,`(${h.sysid})`,u,d,a,[])}}#o(t,e,n,s,r,o){let a=t.measureText(e).width;for(let[l,c]of[[11,-6],[-11-a,-6],[-a/2,-14],[-a/2,22],[11,14],[-11-a,14]]){let h=[n+l,s+c-10,n+l+a,s+c+3];if(!o.some(u=>h[0]<u[2]&&h[2]>u[0]&&h[1]<u[3]&&h[3]>u[1])){o.push(h),t.lineWidth=3,t.strokeStyle=we().paper,t.strokeText(e,n+l,s+c),t.fillStyle=r,t.fillText(e,n+l,s+c);return}}}#c(t,e,n,s){let{ink:r,paper:o}=we(),a=Gl(Math.min(160,.4*n)/e),[l,c]=[n-14,s-24],h=l-a*e;for(let[u,d]of[[o,6],[r,2]])t.strokeStyle=u,t.lineWidth=d,t.beginPath(),t.moveTo(h,c-5),t.lineTo(h,c),t.lineTo(l,c),t.lineTo(l,c-5),t.stroke();t.fillStyle=r,t.textAlign="right",t.font="12px system-ui, sans-serif",t.fillText(`${a} m`,l,c-9),t.textAlign="center",t.font="700 13px system-ui, sans-serif",t.fillText("N",n-20,34),t.beginPath(),[[0,-14],[5,0],[0,-4],[-5,0]].forEach(([u,d],f)=>t[f?"lineTo":"moveTo"](n-20+u,20+d)),t.fill(),t.textAlign="left"}};var Vl=class{constructor(t,e){this.orders=t,this.send=e,this.notices=D("div",{class:"notices",role:"status","aria-live":"polite"}),this.dialog=D("dialog",{class:"ask","aria-labelledby":"ask-question"}),document.body.append(this.notices,this.dialog)}notice(t,e=""){let n=D("p",{class:e},t);for(this.notices.append(n);this.notices.children.length>4;)this.notices.firstChild?.remove();setTimeout(()=>n.remove(),e==="bad"?12e3:6e3)}askMany(t,e,n,s,r,o){if(this.dialog.open)return;let a=(r()?.vehicles??[]).filter(d=>e.includes(d.sysid)),l=a.filter(d=>!nd(d)).map(d=>d.sysid),c=`${t.name[0].toUpperCase()}${t.name.slice(1)} ${n?"all ":""}${a.length} vehicles?`,h=n?"":e.join(", "),u=D("button",{type:"submit",value:"yes",class:"primary"},"Yes");u.disabled=!l.length,this.dialog.replaceChildren(D("form",{method:"dialog"},D("h2",{id:"ask-question"},c),h?D("p",{},h):null,t.means?D("p",{class:"soft"},t.means):null,...Km(a,nd,d=>`${d} of them cannot:`,"bad",s),...Km(a,iv,d=>`${d} ${d===1?"takes":"take"} the order, but:`,"warn",s),...sv(a,o),D("p",{class:"buttons"},u,D("button",{type:"submit",value:"no"},"No")))),this.dialog.returnValue="no",this.dialog.onclose=()=>{if(this.dialog.returnValue!=="yes")return;let d=[],f=l.length;this.notice(`${t.name} ${l.length} vehicles: sent`);for(let p of l)this.send({command:t.command,sysid:p},(x,g)=>{if(x||d.push(g||`${s(p)}: not taken`),f-=1,f)return;let m=`${t.name}: ${l.length-d.length} of ${l.length} obey.`;this.notice([m,...d].join(" "),d.length?"bad":"good")})},this.dialog.showModal(),(l.length?u:this.dialog.querySelector("button[value=no]"))?.focus()}ask(t,e,n,s){if(this.dialog.open)return;if(t.of_vehicle&&e===null)return void this.notice("No vehicle is chosen: choose one in the table, on the map or by its id.","bad");let r=t.command==="pause"&&s()?.phase==="paused",o=r?"Go on with the session?":t.question.replace("{}",e===null?"":n(e)),a=()=>s()?.vehicles.find(x=>x.sysid===e),l=D("p",{class:"soft"}),c=()=>{let x=t.of_vehicle?a():void 0;Re(l,[x?rv(x):"",t.means].filter(Boolean).join(". "))},h=t.command==="retarget"?(s()?.vehicles??[]).filter(x=>x.role==="target"):[];if(t.command==="retarget"&&!h.length)return void this.notice("There is no target.","bad");let u=D("select",{"aria-label":"target"},...h.map(x=>D("option",{value:x.sysid},x.label))),d=D("button",{type:"submit",value:"yes",class:"primary"},"Yes"),f=D("form",{method:"dialog"},D("h2",{id:"ask-question"},o),l,h.length?D("p",{},u):null,D("p",{class:"buttons"},d,D("button",{type:"submit",value:"no"},"No")));this.dialog.replaceChildren(f),this.dialog.returnValue="no",this.dialog.onclose=()=>{if(clearInterval(p),this.dialog.returnValue!=="yes")return;let x={command:r?"resume":t.command};t.of_vehicle&&(x.sysid=e),h.length&&(x.target=Number(u.value));let g=t.of_vehicle&&e!==null?`${t.name} ${n(e)}`:r?"resume":t.name;this.notice(`${g}: sent`),this.send(x,(m,_)=>this.notice(`${g}: ${_||(m?"taken":"not taken")}`,m?"good":"bad"))},c();let p=setInterval(c,500);this.dialog.showModal(),d.focus()}};function nd(i){return i.alive?i.heard_s===null?"has not sent any telemetry yet.":"":"is dead."}function iv(i){return nd(i)?"":i.condition==="silent"?`is silent (${i.figure}) and may not hear it.`:i.armed?i.landed?"has landed and stays there.":i.note.startsWith("taken by")?`is ${i.note} already (${i.mode}).`:i.condition==="failing"&&i.trouble.includes(i.mode)?`is in ${i.mode} by its own failsafe, which the order would end.`:"":"is on the ground and stays there."}function Km(i,t,e,n,s){let r=i.flatMap(o=>t(o)?[`${s(o.sysid)} ${t(o)}`]:[]);return r.length?[D("p",{class:n},e(r.length)),D("ul",{class:`${n} refusing`,tabindex:0},...r.map(o=>D("li",{},o)))]:[]}function id(i){if(!i)return"by its own parameters";let t=i.down_after_s?`, level after ${i.level_after_s.toFixed(0)} s, down after ${i.down_after_s.toFixed(0)} s`:"";return`straight home at ${i.return_m.toFixed(1)} m above it${t}`}function sv(i,t){let e=new Map;for(let{sysid:s}of i){let r=id(t.get(s));e.set(r,[...e.get(r)??[],s])}let n=[...e].map(([s,r])=>D("tr",{},D("th",{scope:"row"},r.join(", ")),D("td",{class:"word"},s)));return n.length?[D("div",{class:"scroll plan-b",tabindex:0,role:"region","aria-label":"plan B"},D("table",{},D("caption",{},"Plan B, how each comes home by itself"),D("tbody",{},...n)))]:[]}function rv(i){let t=i.battery===null?"":`, battery ${(100*i.battery).toFixed(0)} %`,e=i.height_m===null?"":`, ${i.height_m.toFixed(1)} m high`;return`${i.mode||i.state||"mode not known"}${e}${t}`}var ov=300,av=.35;function sd(i,t,e){i.dataset.key!==t&&(i.dataset.key=t,i.replaceChildren(...e()))}function Qm(i,t,e){let{competition:n,services:s,history:r}=t,o=Object.keys(n.v).map(Number).sort((l,c)=>n.v[c]-n.v[l]||l-c).slice(0,12),a=JSON.stringify([o.map(l=>n.v[l].toFixed(2)),n.leader,n.share?.toFixed(2),s,r.length]);sd(i,a,()=>{let l=[];if(o.length){let c=n.share===null?"":`, ${xe(100*n.share,0)} % (${xe(100*n.threshold,0)} % needed to win)`;l.push(D("p",{},n.leader===null?"No vehicle leads yet.":D("b",{},`${e(n.leader)} leads`),c));for(let h of o){let u=D("span",{class:"bar"});u.style.width=`${Math.min(Math.max(100*n.v[h],0),100)}%`,u.style.background=pn(h),l.push(D("div",{class:"row"},D("span",{class:"row-name"},e(h)),D("div",{class:"track stack"},u),D("span",{class:"value"},xe(n.v[h],2))))}}else l.push(D("p",{class:"soft"},"No vehicle competes at this time."));for(let c of s){let h=c.tanker===null?`base ${c.base}`:e(c.tanker),u=c.phase==="transfer"?`${xe(c.energy_j/1e3,1)} kJ so far`:c.joined_at_s===null?"on the way":"in formation";l.push(D("div",{class:"service"},D("b",{},`${h} → ${e(c.receiver)}: ${c.phase}`),` ${u}`,D("p",{class:"small soft"},c.why||`decided at ${c.decided_at_s.toFixed(1)} s by ${c.by}`)))}if(r.length){let c=[...r].reverse().slice(0,12).map(u=>D("tr",{},...[e(u.receiver),u.tanker===null?`base ${u.base}`:e(u.tanker),u.by,xe(u.decided_at_s,1),xe(u.end_s,1),xe(u.energy_j/1e3,1),u.reason].map((d,f)=>D("td",{class:[0,1,2,6].includes(f)?"word":""},d)))),h=["receiver","by","decided by","decided s","done s","kJ","ended"];l.push(D("div",{class:"scroll",tabindex:0,role:"region","aria-label":"refuellings"},D("table",{},D("caption",{},`${r.length} refuellings have ended`),D("thead",{},D("tr",{},...h.map((u,d)=>D("th",{scope:"col",class:[0,1,2,6].includes(d)?"word":""},u)))),D("tbody",{},...c))))}return l})}function lv(i){let t=[],e={critical:0,warning:1,info:2};for(let n of i){let s=t[t.length-1];s&&s.head.sysid===n.sysid&&n.t_s-s.head.t_s<=av&&e[n.level]>=2&&s.head.level==="info"?s.more.push(n):t.push({head:n,more:[]})}return t}var Hl=class{constructor(t,e){this.go=e,this.search=D("input",{type:"search",placeholder:"search events","aria-label":"search events",oninput:()=>this.again()}),this.level=D("select",{"aria-label":"level of events",onchange:()=>this.again()},D("option",{value:"info"},"all"),D("option",{value:"warning"},"warnings and errors")),this.list=D("ol",{class:"events"}),t.append(D("div",{class:"tools"},this.search,this.level),D("div",{class:"scroll",tabindex:0,role:"region","aria-label":"list of events"},this.list)),this.key=""}again(){this.key="",this.last&&this.show(this.last.events,this.last.until_s,this.last.label)}show(t,e,n){this.last={events:t,until_s:e,label:n};let s=t.length;for(;s>0&&t[s-1].t_s>e+.05;)s-=1;let r=`${s} ${t.length?t[Math.max(s-1,0)]?.text:""}`;if(r===this.key)return;this.key=r;let o=this.search.value.trim().toLowerCase(),a=this.level.value==="warning",l=[];for(let h=s-1;h>=0&&l.length<ov;h-=1){let u=t[h];a&&u.level==="info"||o&&!`${jm(u,n)} ${u.text}`.toLowerCase().includes(o)||l.push(u)}let c=lv(l.reverse()).reverse().map(({head:h,more:u})=>{let d=x=>[D("time",{},wi(x.t_s)),D("span",{class:"who"},jm(x,n)),D("span",{},x.text)],f=D("li",{class:h.level}),p=D("button",{type:"button",class:"link","aria-label":`go to ${wi(h.t_s)}`,onclick:()=>this.go(h)},...d(h));return f.append(p),u.length&&f.append(D("details",{},D("summary",{},`and ${u.length} more`),...u.map(x=>D("p",{},...d(x))))),f});this.list.replaceChildren(...c.length?c:[D("li",{class:"soft"},"No events.")])}};function jm(i,t){return i.sysid===0?"session":i.sysid===255?"traffic":t(i.sysid)}function rd(i,t,e,n){let s=t.vehicles.find(l=>l.sysid===e);if(!s){sd(i,"none",()=>[D("p",{class:"soft"},"Choose a vehicle in the table or in the picture.")]);return}let r=l=>xe(l*180/Math.PI,0,"°"),o=[["state",[s.state,s.stage].filter(Boolean).join(", ")||"–"],["mode",s.mode||"–"],["autopilot",s.autopilot??"–"],["armed",s.armed?s.landed?"armed, landed":"armed, in the air":"disarmed"],["battery",s.battery===null?"–":`${xe(100*s.battery,1)} %${s.remaining_j===null?"":`, ${xe(s.remaining_j/1e3,1)} kJ`}`],...(s.batteries??[]).map(l=>[`battery ${l.id}${l.function?`, ${l.function}`:""}`,`${l.share===null?"–":`${xe(100*l.share,0)} %`}${l.voltage_v===null?"":`, ${xe(l.voltage_v,1)} V`}`]),["power",xe(s.power_w,0," W")],["lasts",s.endurance_s===null?"–":wi(s.endurance_s)],["north, east",s.p_ned?`${xe(s.p_ned[0],1)}, ${xe(s.p_ned[1],1)} m`:"–"],["height",xe(s.height_m,1," m")],["speed",xe(s.speed_m_s,2," m/s")],["heading",r((s.heading_rad+2*Math.PI)%(2*Math.PI))],["roll, pitch",`${r(s.roll_rad)}, ${r(s.pitch_rad)}`],["to its target",xe(s.target_m,2," m")],["competition",s.v===null?"does not compete":`v ${xe(s.v,2)}${s.tau===null?"":`, τ ${xe(s.tau,2)}`}`],["link",`${s.lost} frames lost${s.lost_share===null?"":`, ${xe(100*s.lost_share,1)} % lately`}`],["position's age",xe(s.age_s,1," s")],...(n?.vehicles??[]).flatMap(l=>l.sysid===e&&l.plan_b?[["plan B",id(l.plan_b)]]:[])],a=`${s.sysid} ${s.trouble.join("|")} ${s.note} ${o.map(([l])=>l).join("|")}`;sd(i,a,()=>[D("h3",{},s.label),...s.trouble.map(l=>D("p",{class:s.severity>1?"bad":"warn"},l)),s.note?D("p",{class:"soft"},s.note):"",D("dl",{class:"facts"},...o.map(([l])=>D("div",{},D("dt",{},l),D("dd"))))]),i.querySelectorAll("dd").forEach((l,c)=>Re(l,o[c][1]))}var Vs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Og=0,Vd=1,Bg=2;var $a=1,kg=2,To=3,Ws=0,Zn=1,fi=2,gr=0,Eo=1,Hd=2,Wd=3,Xd=4,zg=5;var _r=100,Gg=101,Vg=102,Hg=103,Wg=104,Xg=200,qg=201,Yg=202,$g=203,qd=204,Yd=205,Zg=206,Jg=207,Kg=208,jg=209,Qg=210,t0=211,e0=212,n0=213,i0=214,yc=0,xc=1,vc=2,ho=3,Sc=4,Mc=5,bc=6,wc=7,nh=0,s0=1,r0=2,$i=0,$d=1,Zd=2,Jd=3,Kd=4,jd=5,Qd=6,tf=7;var ef=300,yr=301,Ao=302,ih=303,sh=304,Tc=1e3,Wi=1001,Ec=1002,In=1003,o0=1004;var Za=1005;var $n=1006,rh=1007;var _s=1008;var Kn=1009,nf=1010,sf=1011,Co=1012,oh=1013,Li=1014,vi=1015,Di=1016,ah=1017,lh=1018,xr=1020,rf=35902,of=35899,af=1021,lf=1022,Ni=1023,ds=1026,ys=1027,ch=1028,hh=1029,Xs=1030,uh=1031;var dh=1033,Ja=33776,Ka=33777,ja=33778,Qa=33779,fh=35840,ph=35841,mh=35842,gh=35843,_h=36196,yh=37492,xh=37496,vh=37488,Sh=37489,tl=37490,Mh=37491,bh=37808,wh=37809,Th=37810,Eh=37811,Ah=37812,Ch=37813,Rh=37814,Ph=37815,Ih=37816,Lh=37817,Dh=37818,Nh=37819,Uh=37820,Fh=37821,Oh=36492,Bh=36494,kh=36495,zh=36283,Gh=36284,el=36285,Vh=36286;var fa=2300,Ac=2301,gc=2302,Id=2303,Ld=2400,Dd=2401,Nd=2402;var a0=3200;var Hh=0,l0=1,xs="",li="srgb",pa="srgb-linear",ma="linear",Be="srgb";var _c=7680;var c0=519,h0=512,u0=513,d0=514,cf=515,f0=516,p0=517,hf=518,uf=519,m0=35044;var df="300 es",xi=2e3,uo=2001;function cv(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function hv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ga(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function g0(){let i=ga("canvas");return i.style.display="block",i}var tg={},fo=null;function ff(...i){let t="THREE."+i.shift();fo?fo("log",t,...i):console.log(t,...i)}function _0(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function te(...i){i=_0(i);let t="THREE."+i.shift();if(fo)fo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ce(...i){i=_0(i);let t="THREE."+i.shift();if(fo)fo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function la(...i){let t=i.join(" ");t in tg||(tg[t]=!0,te(...i))}function y0(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var x0={[yc]:yc,[vc]:bc,[Sc]:Sc,[ho]:Mc,[xc]:xc,[bc]:vc,[wc]:wc,[Mc]:ho},Ii=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],eg=1234567,ca=Math.PI/180,po=180/Math.PI;function vr(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]+"-"+On[t&255]+On[t>>8&255]+"-"+On[t>>16&15|64]+On[t>>24&255]+"-"+On[e&63|128]+On[e>>8&255]+"-"+On[e>>16&255]+On[e>>24&255]+On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]).toLowerCase()}function ve(i,t,e){return Math.max(t,Math.min(e,i))}function pf(i,t){return(i%t+t)%t}function uv(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function dv(i,t,e){return i!==t?(e-i)/(t-i):0}function ha(i,t,e){return(1-e)*i+e*t}function fv(i,t,e,n){return ha(i,t,1-Math.exp(-e*n))}function pv(i,t=1){return t-Math.abs(pf(i,t*2)-t)}function mv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function gv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function _v(i,t){return i+Math.floor(Math.random()*(t-i+1))}function yv(i,t){return i+Math.random()*(t-i)}function xv(i){return i*(.5-Math.random())}function vv(i){i!==void 0&&(eg=i);let t=eg+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Sv(i){return i*ca}function Mv(i){return i*po}function bv(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function wv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function mf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Tv(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:te("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function gf(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function v0(i,t){if(t.constructor===Float32Array)return i;let e=gf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function S0(i,t){if(t.constructor===Float32Array)return i;let e=gf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Wh={DEG2RAD:ca,RAD2DEG:po,generateUUID:vr,clamp:ve,euclideanModulo:pf,mapLinear:uv,inverseLerp:dv,lerp:ha,damp:fv,pingpong:pv,smoothstep:mv,smootherstep:gv,randInt:_v,randFloat:yv,randFloatSpread:xv,seededRandom:vv,degToRad:Sv,radToDeg:Mv,isPowerOfTwo:bv,ceilPowerOfTwo:wv,floorPowerOfTwo:mf,setQuaternionFromProperEuler:Tv,normalize:S0,denormalize:v0},_t=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ln=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let g=l*d+c*f+h*p+u*x;g<0&&(d=-d,f=-f,p=-p,x=-x,g=-g);let m=1-a;if(g<.9995){let _=Math.acos(g),M=Math.sin(_);m=Math.sin(m*_)/M,a=Math.sin(a*_)/M,l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+x*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+x*a;let _=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=_,c*=_,h*=_,u*=_}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-a*f,t[e+2]=c*p+h*f+a*d-l*u,t[e+3]=h*p-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:te("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ve(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(ng.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(ng.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return od.copy(this).projectOnVector(t),this.sub(od)}reflect(t){return this.sub(od.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},od=new V,ng=new Ln,fe=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],g=s[3],m=s[6],_=s[1],M=s[4],v=s[7],C=s[2],T=s[5],y=s[8];return r[0]=o*x+a*_+l*C,r[3]=o*g+a*M+l*T,r[6]=o*m+a*v+l*y,r[1]=c*x+h*_+u*C,r[4]=c*g+h*M+u*T,r[7]=c*m+h*v+u*y,r[2]=d*x+f*_+p*C,r[5]=d*g+f*M+p*T,r[8]=d*m+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return la("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ad.makeScale(t,e)),this}rotate(t){return la("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ad.makeRotation(-t)),this}translate(t,e){return la("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ad.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ad=new fe,ig=new fe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sg=new fe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ev(){let i={enabled:!0,workingColorSpace:pa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Be&&(s.r=us(s.r),s.g=us(s.g),s.b=us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Be&&(s.r=co(s.r),s.g=co(s.g),s.b=co(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===xs?ma:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[pa]:{primaries:t,whitePoint:n,transfer:ma,toXYZ:ig,fromXYZ:sg,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:li},outputColorSpaceConfig:{drawingBufferColorSpace:li}},[li]:{primaries:t,whitePoint:n,transfer:Be,toXYZ:ig,fromXYZ:sg,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:li}}}),i}var Ce=Ev();function us(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function co(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Zr,Cc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Zr===void 0&&(Zr=ga("canvas")),Zr.width=t.width,Zr.height=t.height;let s=Zr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Zr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ga("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=us(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(us(e[n]/255)*255):e[n]=us(e[n]);return{data:e,width:t.width,height:t.height}}else return te("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Av=0,mo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Av++}),this.uuid=vr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ld(s[o].image)):r.push(ld(s[o]))}else r=ld(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function ld(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Cc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(te("Texture: Unable to serialize Texture."),{})}var Cv=0,cd=new V,Jn=class i extends Ii{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Wi,s=Wi,r=$n,o=_s,a=Ni,l=Kn,c=i.DEFAULT_ANISOTROPY,h=xs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Cv++}),this.uuid=vr(),this.name="",this.source=new mo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new _t(0,0),this.repeat=new _t(1,1),this.center=new _t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new fe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(cd).x}get height(){return this.source.getSize(cd).y}get depth(){return this.source.getSize(cd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){te(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==ef)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Tc:t.x=t.x-Math.floor(t.x);break;case Wi:t.x=t.x<0?0:1;break;case Ec:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Tc:t.y=t.y-Math.floor(t.y);break;case Wi:t.y=t.y<0?0:1;break;case Ec:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=ef;Jn.DEFAULT_ANISOTROPY=1;var Qe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(c+1)/2,v=(f+1)/2,C=(m+1)/2,T=(h+d)/4,y=(u+x)/4,b=(p+g)/4;return M>v&&M>C?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=T/n,r=y/n):v>C?v<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),n=T/s,r=b/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=y/r,s=b/r),this.set(n,s,r,e),this}let _=Math.sqrt((g-p)*(g-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(u-x)/_,this.z=(d-h)/_,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this.w=ve(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this.w=ve(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Rc=class extends Ii{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:$n,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Qe(0,0,t,e),this.scissorTest=!1,this.viewport=new Qe(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:$n,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new mo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},hi=class extends Rc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},_a=class extends Jn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Pc=class extends Jn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ne=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g)}set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=p,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Jr.setFromMatrixColumn(t,0).length(),r=1/Jr.setFromMatrixColumn(t,1).length(),o=1/Jr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d-x*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Rv,t,Pv)}lookAt(t,e,n){let s=this.elements;return oi.subVectors(t,e),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Is.crossVectors(n,oi),Is.lengthSq()===0&&(Math.abs(n.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Is.crossVectors(n,oi)),Is.normalize(),Wl.crossVectors(oi,Is),s[0]=Is.x,s[4]=Wl.x,s[8]=oi.x,s[1]=Is.y,s[5]=Wl.y,s[9]=oi.y,s[2]=Is.z,s[6]=Wl.z,s[10]=oi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],g=n[10],m=n[14],_=n[3],M=n[7],v=n[11],C=n[15],T=s[0],y=s[4],b=s[8],U=s[12],P=s[1],R=s[5],G=s[9],H=s[13],N=s[2],W=s[6],B=s[10],k=s[14],lt=s[3],$=s[7],j=s[11],et=s[15];return r[0]=o*T+a*P+l*N+c*lt,r[4]=o*y+a*R+l*W+c*$,r[8]=o*b+a*G+l*B+c*j,r[12]=o*U+a*H+l*k+c*et,r[1]=h*T+u*P+d*N+f*lt,r[5]=h*y+u*R+d*W+f*$,r[9]=h*b+u*G+d*B+f*j,r[13]=h*U+u*H+d*k+f*et,r[2]=p*T+x*P+g*N+m*lt,r[6]=p*y+x*R+g*W+m*$,r[10]=p*b+x*G+g*B+m*j,r[14]=p*U+x*H+g*k+m*et,r[3]=_*T+M*P+v*N+C*lt,r[7]=_*y+M*R+v*W+C*$,r[11]=_*b+M*G+v*B+C*j,r[15]=_*U+M*H+v*k+C*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],x=t[7],g=t[11],m=t[15],_=l*f-c*d,M=a*f-c*u,v=a*d-l*u,C=o*f-c*h,T=o*d-l*h,y=o*u-a*h;return e*(x*_-g*M+m*v)-n*(p*_-g*C+m*T)+s*(p*M-x*C+m*y)-r*(p*v-x*T+g*y)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],g=t[14],m=t[15],_=e*a-n*o,M=e*l-s*o,v=e*c-r*o,C=n*l-s*a,T=n*c-r*a,y=s*c-r*l,b=h*x-u*p,U=h*g-d*p,P=h*m-f*p,R=u*g-d*x,G=u*m-f*x,H=d*m-f*g,N=_*H-M*G+v*R+C*P-T*U+y*b;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return t[0]=(a*H-l*G+c*R)*W,t[1]=(s*G-n*H-r*R)*W,t[2]=(x*y-g*T+m*C)*W,t[3]=(d*T-u*y-f*C)*W,t[4]=(l*P-o*H-c*U)*W,t[5]=(e*H-s*P+r*U)*W,t[6]=(g*v-p*y-m*M)*W,t[7]=(h*y-d*v+f*M)*W,t[8]=(o*G-a*P+c*b)*W,t[9]=(n*P-e*G-r*b)*W,t[10]=(p*T-x*v+m*_)*W,t[11]=(u*v-h*T-f*_)*W,t[12]=(a*U-o*R-l*b)*W,t[13]=(e*R-n*U+s*b)*W,t[14]=(x*M-p*C-g*_)*W,t[15]=(h*C-u*M+d*_)*W,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,g=o*u,m=a*u,_=l*c,M=l*h,v=l*u,C=n.x,T=n.y,y=n.z;return s[0]=(1-(x+m))*C,s[1]=(f+v)*C,s[2]=(p-M)*C,s[3]=0,s[4]=(f-v)*T,s[5]=(1-(d+m))*T,s[6]=(g+_)*T,s[7]=0,s[8]=(p+M)*y,s[9]=(g-_)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Jr.set(s[0],s[1],s[2]).length(),a=Jr.set(s[4],s[5],s[6]).length(),l=Jr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ci.copy(this);let c=1/o,h=1/a,u=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=h,Ci.elements[5]*=h,Ci.elements[6]*=h,Ci.elements[8]*=u,Ci.elements[9]*=u,Ci.elements[10]*=u,e.setFromRotationMatrix(Ci),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=xi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===xi)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===uo)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=xi,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===xi)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===uo)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Jr=new V,Ci=new Ne,Rv=new V(0,0,0),Pv=new V(1,1,1),Is=new V,Wl=new V,oi=new V,rg=new Ne,og=new Ln,fs=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ve(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ve(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ve(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ve(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:te("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return rg.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rg,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return og.setFromEuler(this),this.setFromQuaternion(og,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};fs.DEFAULT_ORDER="XYZ";var ya=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Iv=0,ag=new V,Kr=new Ln,rs=new Ne,Xl=new V,ta=new V,Lv=new V,Dv=new Ln,lg=new V(1,0,0),cg=new V(0,1,0),hg=new V(0,0,1),ug={type:"added"},Nv={type:"removed"},jr={type:"childadded",child:null},hd={type:"childremoved",child:null},Nn=class i extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Iv++}),this.uuid=vr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new V,e=new fs,n=new Ln,s=new V(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ne},normalMatrix:{value:new fe}}),this.matrix=new Ne,this.matrixWorld=new Ne,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ya,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Kr.setFromAxisAngle(t,e),this.quaternion.multiply(Kr),this}rotateOnWorldAxis(t,e){return Kr.setFromAxisAngle(t,e),this.quaternion.premultiply(Kr),this}rotateX(t){return this.rotateOnAxis(lg,t)}rotateY(t){return this.rotateOnAxis(cg,t)}rotateZ(t){return this.rotateOnAxis(hg,t)}translateOnAxis(t,e){return ag.copy(t).applyQuaternion(this.quaternion),this.position.add(ag.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(lg,t)}translateY(t){return this.translateOnAxis(cg,t)}translateZ(t){return this.translateOnAxis(hg,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(rs.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Xl.copy(t):Xl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ta.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?rs.lookAt(ta,Xl,this.up):rs.lookAt(Xl,ta,this.up),this.quaternion.setFromRotationMatrix(rs),s&&(rs.extractRotation(s.matrixWorld),Kr.setFromRotationMatrix(rs),this.quaternion.premultiply(Kr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ce("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(ug),jr.child=t,this.dispatchEvent(jr),jr.child=null):ce("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Nv),hd.child=t,this.dispatchEvent(hd),hd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),rs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),rs.multiply(t.parent.matrixWorld)),t.applyMatrix4(rs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(ug),jr.child=t,this.dispatchEvent(jr),jr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ta,t,Lv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ta,Dv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new V(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var hs=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Uv={type:"move"},go=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new hs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new hs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new hs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let g=e.getJointPose(x,n),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Uv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new hs;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},M0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ls={h:0,s:0,l:0},ql={h:0,s:0,l:0};function ud(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var oe=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=li){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ce.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Ce.workingColorSpace){return this.r=t,this.g=e,this.b=n,Ce.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Ce.workingColorSpace){if(t=pf(t,1),e=ve(e,0,1),n=ve(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=ud(o,r,t+1/3),this.g=ud(o,r,t),this.b=ud(o,r,t-1/3)}return Ce.colorSpaceToWorking(this,s),this}setStyle(t,e=li){function n(r){r!==void 0&&parseFloat(r)<1&&te("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:te("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);te("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=li){let n=M0[t.toLowerCase()];return n!==void 0?this.setHex(n,e):te("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=us(t.r),this.g=us(t.g),this.b=us(t.b),this}copyLinearToSRGB(t){return this.r=co(t.r),this.g=co(t.g),this.b=co(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=li){return Ce.workingToColorSpace(Bn.copy(this),t),Math.round(ve(Bn.r*255,0,255))*65536+Math.round(ve(Bn.g*255,0,255))*256+Math.round(ve(Bn.b*255,0,255))}getHexString(t=li){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ce.workingColorSpace){Ce.workingToColorSpace(Bn.copy(this),e);let n=Bn.r,s=Bn.g,r=Bn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Ce.workingColorSpace){return Ce.workingToColorSpace(Bn.copy(this),e),t.r=Bn.r,t.g=Bn.g,t.b=Bn.b,t}getStyle(t=li){Ce.workingToColorSpace(Bn.copy(this),t);let e=Bn.r,n=Bn.g,s=Bn.b;return t!==li?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ls),this.setHSL(Ls.h+t,Ls.s+e,Ls.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ls),t.getHSL(ql);let n=ha(Ls.h,ql.h,e),s=ha(Ls.s,ql.s,e),r=ha(Ls.l,ql.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Bn=new oe;oe.NAMES=M0;var xa=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new fs,this.environmentIntensity=1,this.environmentRotation=new fs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ri=new V,os=new V,dd=new V,as=new V,Qr=new V,to=new V,dg=new V,fd=new V,pd=new V,md=new V,gd=new Qe,_d=new Qe,yd=new Qe,Fs=class i{constructor(t=new V,e=new V,n=new V){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ri.subVectors(t,e),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ri.subVectors(s,e),os.subVectors(n,e),dd.subVectors(t,e);let o=Ri.dot(Ri),a=Ri.dot(os),l=Ri.dot(dd),c=os.dot(os),h=os.dot(dd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,as)===null?!1:as.x>=0&&as.y>=0&&as.x+as.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,as)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,as.x),l.addScaledVector(o,as.y),l.addScaledVector(a,as.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return gd.setScalar(0),_d.setScalar(0),yd.setScalar(0),gd.fromBufferAttribute(t,e),_d.fromBufferAttribute(t,n),yd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(gd,r.x),o.addScaledVector(_d,r.y),o.addScaledVector(yd,r.z),o}static isFrontFacing(t,e,n,s){return Ri.subVectors(n,e),os.subVectors(t,e),Ri.cross(os).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ri.subVectors(this.c,this.b),os.subVectors(this.a,this.b),Ri.cross(os).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Qr.subVectors(s,n),to.subVectors(r,n),fd.subVectors(t,n);let l=Qr.dot(fd),c=to.dot(fd);if(l<=0&&c<=0)return e.copy(n);pd.subVectors(t,s);let h=Qr.dot(pd),u=to.dot(pd);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Qr,o);md.subVectors(t,r);let f=Qr.dot(md),p=to.dot(md);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(to,a);let g=h*p-f*u;if(g<=0&&u-h>=0&&f-p>=0)return dg.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(dg,a);let m=1/(g+x+d);return o=x*m,a=d*m,e.copy(n).addScaledVector(Qr,o).addScaledVector(to,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Xi=class{constructor(t=new V(1/0,1/0,1/0),e=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Pi):Pi.fromBufferAttribute(r,o),Pi.applyMatrix4(t.matrixWorld),this.expandByPoint(Pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Yl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Yl.copy(n.boundingBox)),Yl.applyMatrix4(t.matrixWorld),this.union(Yl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pi),Pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ea),$l.subVectors(this.max,ea),eo.subVectors(t.a,ea),no.subVectors(t.b,ea),io.subVectors(t.c,ea),Ds.subVectors(no,eo),Ns.subVectors(io,no),rr.subVectors(eo,io);let e=[0,-Ds.z,Ds.y,0,-Ns.z,Ns.y,0,-rr.z,rr.y,Ds.z,0,-Ds.x,Ns.z,0,-Ns.x,rr.z,0,-rr.x,-Ds.y,Ds.x,0,-Ns.y,Ns.x,0,-rr.y,rr.x,0];return!xd(e,eo,no,io,$l)||(e=[1,0,0,0,1,0,0,0,1],!xd(e,eo,no,io,$l))?!1:(Zl.crossVectors(Ds,Ns),e=[Zl.x,Zl.y,Zl.z],xd(e,eo,no,io,$l))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ls),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ls=[new V,new V,new V,new V,new V,new V,new V,new V],Pi=new V,Yl=new Xi,eo=new V,no=new V,io=new V,Ds=new V,Ns=new V,rr=new V,ea=new V,$l=new V,Zl=new V,or=new V;function xd(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){or.fromArray(i,r);let a=s.x*Math.abs(or.x)+s.y*Math.abs(or.y)+s.z*Math.abs(or.z),l=t.dot(or),c=e.dot(or),h=n.dot(or);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var mn=new V,Jl=new _t,Fv=0,Pn=class extends Ii{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Fv++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=m0,this.updateRanges=[],this.gpuType=vi,this.version=0,this._normalizationScale=t!==void 0?gf(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Jl.fromBufferAttribute(this,e),Jl.applyMatrix3(t),this.setXY(e,Jl.x,Jl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):v0(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):S0(t,this.array)}};var va=class extends Pn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Sa=class extends Pn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ve=class extends Pn{constructor(t,e,n){super(new Float32Array(t),e,n)}},Ov=new Xi,na=new V,vd=new V,ps=class{constructor(t=new V,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Ov.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;na.subVectors(t,this.center);let e=na.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(na,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(vd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(na.copy(t.center).add(vd)),this.expandByPoint(na.copy(t.center).sub(vd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Bv=0,yi=new Ne,Sd=new Nn,so=new V,ai=new Xi,ia=new Xi,Rn=new V,gn=class i extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Bv++}),this.uuid=vr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(cv(t)?Sa:va)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new fe().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return yi.makeRotationFromQuaternion(t),this.applyMatrix4(yi),this}rotateX(t){return yi.makeRotationX(t),this.applyMatrix4(yi),this}rotateY(t){return yi.makeRotationY(t),this.applyMatrix4(yi),this}rotateZ(t){return yi.makeRotationZ(t),this.applyMatrix4(yi),this}translate(t,e,n){return yi.makeTranslation(t,e,n),this.applyMatrix4(yi),this}scale(t,e,n){return yi.makeScale(t,e,n),this.applyMatrix4(yi),this}lookAt(t){return Sd.lookAt(t),Sd.updateMatrix(),this.applyMatrix4(Sd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(so).negate(),this.translate(so.x,so.y,so.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ve(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&te("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Xi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ce('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ps);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(t){let n=this.boundingSphere.center;if(ai.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(ai.min,ia.min),ai.expandByPoint(Rn),Rn.addVectors(ai.max,ia.max),ai.expandByPoint(Rn)):(ai.expandByPoint(ia.min),ai.expandByPoint(ia.max))}ai.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Rn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Rn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Rn.fromBufferAttribute(a,c),l&&(so.fromBufferAttribute(t,c),Rn.add(so)),s=Math.max(s,n.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ce('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ce("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new V,l[U]=new V;let h=new V,u=new V,d=new V,f=new _t,p=new _t,x=new _t,g=new V,m=new V;function _(U,P,R){c[U]=c[P]=c[R]=1,h.fromBufferAttribute(n,U),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,R),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,R),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let G=1/(p.x*x.y-x.x*p.y);isFinite(G)&&(g.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(G),m.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(G),a[U].add(g),a[P].add(g),a[R].add(g),l[U].add(m),l[P].add(m),l[R].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let U=0,P=M.length;U<P;++U){let R=M[U],G=R.start,H=R.count;for(let N=G,W=G+H;N<W;N+=3)_(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let v=new V,C=new V,T=new V,y=new V;function b(U){T.fromBufferAttribute(s,U),y.copy(T);let P=a[U];v.copy(P),v.sub(T.multiplyScalar(T.dot(P))).normalize(),C.crossVectors(y,P);let G=C.dot(l[U])<0?-1:1;o.setXYZW(U,v.x,v.y,v.z,G)}for(let U=0,P=n.count;U<P;++U)c[U]&&b(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Pn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new V,r=new V,o=new V,a=new V,l=new V,c=new V,h=new V,u=new V;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,g),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Rn.fromBufferAttribute(t,e),Rn.normalize(),t.setXYZ(e,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let m=0;m<h;m++)d[p++]=c[f++]}return new Pn(d,h,u)}if(this.index===null)return te("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Md=new V,kv=new V,zv=new fe,ci=class{constructor(t=new V(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Md.subVectors(n,e).cross(kv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Md),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||zv.getNormalMatrix(t),s=this.coplanarPoint(Md).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Gv=0,ms=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Gv++}),this.uuid=vr(),this.name="",this.type="Material",this.blending=Eo,this.side=Ws,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=qd,this.blendDst=Yd,this.blendEquation=_r,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new oe(0,0,0),this.blendAlpha=0,this.depthFunc=ho,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=c0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=_c,this.stencilZFail=_c,this.stencilZPass=_c,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){te(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new oe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new ci().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new _t().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new _t().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var cs=new V,bd=new V,Kl=new V,jl=new V,hr=class{constructor(t=new V,e=new V(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,cs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=cs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(cs.copy(this.origin).addScaledVector(this.direction,e),cs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){bd.copy(t).add(e).multiplyScalar(.5),Kl.copy(e).sub(t).normalize(),jl.copy(this.origin).sub(bd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Kl),a=jl.dot(this.direction),l=-jl.dot(Kl),c=jl.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(bd).addScaledVector(Kl,d),f}intersectSphere(t,e){if(t.radius<0)return null;cs.subVectors(t.center,this.origin);let n=cs.dot(this.direction),s=cs.dot(cs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,cs)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,g=e.z-o.z,m=n.x-o.x,_=n.y-o.y,M=n.z-o.z,v=Math.abs(l),C=Math.abs(c),T=Math.abs(h),y,b,U,P,R,G,H,N,W,B,k,lt;if(v>=C&&v>=T?(U=l,G=u,W=p,lt=m,l>=0?(y=c,b=h,P=d,R=f,H=x,N=g,B=_,k=M):(y=h,b=c,P=f,R=d,H=g,N=x,B=M,k=_)):C>=T?(U=c,G=d,W=x,lt=_,c>=0?(y=h,b=l,P=f,R=u,H=g,N=p,B=M,k=m):(y=l,b=h,P=u,R=f,H=p,N=g,B=m,k=M)):(U=h,G=f,W=g,lt=M,h>=0?(y=l,b=c,P=u,R=d,H=p,N=x,B=m,k=_):(y=c,b=l,P=d,R=u,H=x,N=p,B=_,k=m)),U===0)return null;let $=y/U,j=b/U,et=1/U,ft=P-$*G,ht=R-j*G,tt=H-$*W,gt=N-j*W,xt=B-$*lt,Lt=k-j*lt,wt=xt*gt-Lt*tt,Vt=ft*Lt-ht*xt,ie=tt*ht-gt*ft;if(s){if(wt<0||Vt<0||ie<0)return null}else if((wt<0||Vt<0||ie<0)&&(wt>0||Vt>0||ie>0))return null;let Jt=wt+Vt+ie;if(Jt===0)return null;let se=et*(wt*G+Vt*W+ie*lt);return(Jt>0?se<0:se>0)?null:this.at(se/Jt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ma=class extends ms{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fs,this.combine=nh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fg=new Ne,ar=new hr,Ql=new ps,pg=new V,tc=new V,ec=new V,nc=new V,wd=new V,ic=new V,mg=new V,sc=new V,Sn=class extends Nn{constructor(t=new gn,e=new Ma){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){ic.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(wd.fromBufferAttribute(u,t),o?ic.addScaledVector(wd,h):ic.addScaledVector(wd.sub(e),h))}e.add(ic)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ql.copy(n.boundingSphere),Ql.applyMatrix4(r),ar.copy(t.ray).recast(t.near),!(Ql.containsPoint(ar.origin)===!1&&(ar.intersectSphere(Ql,pg)===null||ar.origin.distanceToSquared(pg)>(t.far-t.near)**2))&&(fg.copy(r).invert(),ar.copy(t.ray).applyMatrix4(fg),!(n.boundingBox!==null&&ar.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,ar)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),M=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let v=_,C=M;v<C;v+=3){let T=a.getX(v),y=a.getX(v+1),b=a.getX(v+2);s=rc(this,m,t,n,c,h,u,T,y,b),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let _=a.getX(g),M=a.getX(g+1),v=a.getX(g+2);s=rc(this,o,t,n,c,h,u,_,M,v),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),M=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let v=_,C=M;v<C;v+=3){let T=v,y=v+1,b=v+2;s=rc(this,m,t,n,c,h,u,T,y,b),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let _=g,M=g+1,v=g+2;s=rc(this,o,t,n,c,h,u,_,M,v),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Vv(i,t,e,n,s,r,o,a){let l;if(t.side===Zn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Ws,a),l===null)return null;sc.copy(a),sc.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(sc);return c<e.near||c>e.far?null:{distance:c,point:sc.clone(),object:i}}function rc(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,tc),i.getVertexPosition(l,ec),i.getVertexPosition(c,nc);let h=Vv(i,t,e,n,tc,ec,nc,mg);if(h){let u=new V;Fs.getBarycoord(mg,tc,ec,nc,u),s&&(h.uv=Fs.getInterpolatedAttribute(s,a,l,c,u,new _t)),r&&(h.uv1=Fs.getInterpolatedAttribute(r,a,l,c,u,new _t)),o&&(h.normal=Fs.getInterpolatedAttribute(o,a,l,c,u,new V),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new V,materialIndex:0};Fs.getNormal(tc,ec,nc,d.normal),h.face=d,h.barycoord=u}return h}var ba=class extends Jn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=In,h=In,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var _o=class extends Pn{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},ro=new Ne,gg=new Ne,oc=[],_g=new Xi,Hv=new Ne,sa=new Sn,ra=new ps,wa=class extends Sn{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new _o(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Hv)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Xi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,ro),_g.copy(t.boundingBox).applyMatrix4(ro),this.boundingBox.union(_g)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ps),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,ro),ra.copy(t.boundingSphere).applyMatrix4(ro),this.boundingSphere.union(ra)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(sa.geometry=this.geometry,sa.material=this.material,sa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ra.copy(this.boundingSphere),ra.applyMatrix4(n),t.ray.intersectsSphere(ra)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,ro),gg.multiplyMatrices(n,ro),sa.matrixWorld=gg,sa.raycast(t,oc);for(let o=0,a=oc.length;o<a;o++){let l=oc[o];l.instanceId=r,l.object=this,e.push(l)}oc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new _o(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new ba(new Float32Array(s*this.count),s,this.count,ch,vi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},lr=new ps,Wv=new _t(.5,.5),ac=new V,Os=class{constructor(t=new ci,e=new ci,n=new ci,s=new ci,r=new ci,o=new ci){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=xi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],g=r[10],m=r[11],_=r[12],M=r[13],v=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,m-p,C-_).normalize(),s[1].setComponents(c+o,f+h,m+p,C+_).normalize(),s[2].setComponents(c+a,f+u,m+x,C+M).normalize(),s[3].setComponents(c-a,f-u,m-x,C-M).normalize(),n)s[4].setComponents(l,d,g,v).normalize(),s[5].setComponents(c-l,f-d,m-g,C-v).normalize();else if(s[4].setComponents(c-l,f-d,m-g,C-v).normalize(),e===xi)s[5].setComponents(c+l,f+d,m+g,C+v).normalize();else if(e===uo)s[5].setComponents(l,d,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),lr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),lr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(lr)}intersectsSprite(t){lr.center.set(0,0,0);let e=Wv.distanceTo(t.center);return lr.radius=.7071067811865476+e,lr.applyMatrix4(t.matrixWorld),this.intersectsSphere(lr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(ac.x=s.normal.x>0?t.max.x:t.min.x,ac.y=s.normal.y>0?t.max.y:t.min.y,ac.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ac)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},yg=new Ne,Ic=class i{constructor(){this.coordinateSystem=xi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];yg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Os),n[s].setFromProjectionMatrix(yg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Os),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Bs=class extends ms{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new oe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Lc=new V,Dc=new V,xg=new Ne,oa=new hr,lc=new ps,Td=new V,vg=new V,Ta=class extends Nn{constructor(t=new gn,e=new Bs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Lc.fromBufferAttribute(e,s-1),Dc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Lc.distanceTo(Dc);t.setAttribute("lineDistance",new Ve(n,1))}else te("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),lc.copy(n.boundingSphere),lc.applyMatrix4(s),lc.radius+=r,t.ray.intersectsSphere(lc)===!1)return;xg.copy(s).invert(),oa.copy(t.ray).applyMatrix4(xg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=h.getX(x),_=h.getX(x+1),M=cc(this,t,oa,l,m,_,x);M&&e.push(M)}if(this.isLineLoop){let x=h.getX(p-1),g=h.getX(f),m=cc(this,t,oa,l,x,g,p-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=cc(this,t,oa,l,x,x+1,x);m&&e.push(m)}if(this.isLineLoop){let x=cc(this,t,oa,l,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function cc(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(Lc.fromBufferAttribute(a,s),Dc.fromBufferAttribute(a,r),e.distanceSqToSegment(Lc,Dc,Td,vg)>n)return;Td.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Td);if(!(c<t.near||c>t.far))return{distance:c,point:vg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Sg=new V,Mg=new V,ur=class extends Ta{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Sg.fromBufferAttribute(e,s),Mg.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Sg.distanceTo(Mg);t.setAttribute("lineDistance",new Ve(n,1))}else te("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ea=class extends Jn{constructor(t=[],e=yr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var gs=class extends Jn{constructor(t,e,n=Li,s,r,o,a=In,l=In,c,h=ds,u=1){if(h!==ds&&h!==ys)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new mo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Aa=class extends gs{constructor(t,e=Li,n=yr,s,r,o=In,a=In,l,c=ds){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ca=class extends Jn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},qi=class i extends gn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ve(c,3)),this.setAttribute("normal",new Ve(h,3)),this.setAttribute("uv",new Ve(u,2));function p(x,g,m,_,M,v,C,T,y,b,U){let P=v/y,R=C/b,G=v/2,H=C/2,N=T/2,W=y+1,B=b+1,k=0,lt=0,$=new V;for(let j=0;j<B;j++){let et=j*R-H;for(let ft=0;ft<W;ft++){let ht=ft*P-G;$[x]=ht*_,$[g]=et*M,$[m]=N,c.push($.x,$.y,$.z),$[x]=0,$[g]=0,$[m]=T>0?1:-1,h.push($.x,$.y,$.z),u.push(ft/y),u.push(1-j/b),k+=1}}for(let j=0;j<b;j++)for(let et=0;et<y;et++){let ft=d+et+W*j,ht=d+et+W*(j+1),tt=d+(et+1)+W*(j+1),gt=d+(et+1)+W*j;l.push(ft,ht,gt),l.push(ht,tt,gt),lt+=6}a.addGroup(f,lt,U),f+=lt,d+=k}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var dr=class i extends gn{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],g=n/2,m=0;_(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new Ve(u,3)),this.setAttribute("normal",new Ve(d,3)),this.setAttribute("uv",new Ve(f,2));function _(){let v=new V,C=new V,T=0,y=(e-t)/n;for(let b=0;b<=r;b++){let U=[],P=b/r,R=P*(e-t)+t;for(let G=0;G<=s;G++){let H=G/s,N=H*l+a,W=Math.sin(N),B=Math.cos(N);C.x=R*W,C.y=-P*n+g,C.z=R*B,u.push(C.x,C.y,C.z),v.set(W,y,B).normalize(),d.push(v.x,v.y,v.z),f.push(H,1-P),U.push(p++)}x.push(U)}for(let b=0;b<s;b++)for(let U=0;U<r;U++){let P=x[U][b],R=x[U+1][b],G=x[U+1][b+1],H=x[U][b+1];(t>0||U!==0)&&(h.push(P,R,H),T+=3),(e>0||U!==r-1)&&(h.push(R,G,H),T+=3)}c.addGroup(m,T,0),m+=T}function M(v){let C=p,T=new _t,y=new V,b=0,U=v===!0?t:e,P=v===!0?1:-1;for(let G=1;G<=s;G++)u.push(0,g*P,0),d.push(0,P,0),f.push(.5,.5),p++;let R=p;for(let G=0;G<=s;G++){let N=G/s*l+a,W=Math.cos(N),B=Math.sin(N);y.x=U*B,y.y=g*P,y.z=U*W,u.push(y.x,y.y,y.z),d.push(0,P,0),T.x=W*.5+.5,T.y=B*.5*P+.5,f.push(T.x,T.y),p++}for(let G=0;G<s;G++){let H=C+G,N=R+G;v===!0?h.push(N,N+1,H):h.push(N+1,N,H),b+=3}c.addGroup(m,b,v===!0?1:2),m+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},fr=class i extends dr{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Nc=class i extends gn{constructor(t=[],e=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:n,detail:s};let r=[],o=[];a(s),c(n),h(),this.setAttribute("position",new Ve(r,3)),this.setAttribute("normal",new Ve(r.slice(),3)),this.setAttribute("uv",new Ve(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(_){let M=new V,v=new V,C=new V;for(let T=0;T<e.length;T+=3)f(e[T+0],M),f(e[T+1],v),f(e[T+2],C),l(M,v,C,_)}function l(_,M,v,C){let T=C+1,y=[];for(let b=0;b<=T;b++){y[b]=[];let U=_.clone().lerp(v,b/T),P=M.clone().lerp(v,b/T),R=T-b;for(let G=0;G<=R;G++)G===0&&b===T?y[b][G]=U:y[b][G]=U.clone().lerp(P,G/R)}for(let b=0;b<T;b++)for(let U=0;U<2*(T-b)-1;U++){let P=Math.floor(U/2);U%2===0?(d(y[b][P+1]),d(y[b+1][P]),d(y[b][P])):(d(y[b][P+1]),d(y[b+1][P+1]),d(y[b+1][P]))}}function c(_){let M=new V;for(let v=0;v<r.length;v+=3)M.x=r[v+0],M.y=r[v+1],M.z=r[v+2],M.normalize().multiplyScalar(_),r[v+0]=M.x,r[v+1]=M.y,r[v+2]=M.z}function h(){let _=new V;for(let M=0;M<r.length;M+=3){_.x=r[M+0],_.y=r[M+1],_.z=r[M+2];let v=g(_)/2/Math.PI+.5,C=m(_)/Math.PI+.5;o.push(v,1-C)}p(),u()}function u(){for(let _=0;_<o.length;_+=6){let M=o[_+0],v=o[_+2],C=o[_+4],T=Math.max(M,v,C),y=Math.min(M,v,C);T>.9&&y<.1&&(M<.2&&(o[_+0]+=1),v<.2&&(o[_+2]+=1),C<.2&&(o[_+4]+=1))}}function d(_){r.push(_.x,_.y,_.z)}function f(_,M){let v=_*3;M.x=t[v+0],M.y=t[v+1],M.z=t[v+2]}function p(){let _=new V,M=new V,v=new V,C=new V,T=new _t,y=new _t,b=new _t;for(let U=0,P=0;U<r.length;U+=9,P+=6){_.set(r[U+0],r[U+1],r[U+2]),M.set(r[U+3],r[U+4],r[U+5]),v.set(r[U+6],r[U+7],r[U+8]),T.set(o[P+0],o[P+1]),y.set(o[P+2],o[P+3]),b.set(o[P+4],o[P+5]),C.copy(_).add(M).add(v).divideScalar(3);let R=g(C);x(T,P+0,_,R),x(y,P+2,M,R),x(b,P+4,v,R)}}function x(_,M,v,C){C<0&&_.x===1&&(o[M]=_.x-1),v.x===0&&v.z===0&&(o[M]=C/2/Math.PI+.5)}function g(_){return Math.atan2(_.z,-_.x)}function m(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.vertices,t.indices,t.radius,t.detail)}};var ui=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){te("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new _t:new V);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new V,s=[],r=[],o=[],a=new V,l=new Ne;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new V)}r[0]=new V,o[0]=new V;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(ve(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(ve(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},yo=class extends ui{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new _t){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Uc=class extends yo{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function _f(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var bg=new V,wg=new V,Ed=new _f,Ad=new _f,Cd=new _f,Fc=class extends ui{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new V){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(wg.subVectors(s[0],s[1]).add(s[0]),c=wg);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(bg.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=bg),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),x=Math.pow(u.distanceToSquared(d),f),g=Math.pow(d.distanceToSquared(h),f);x<1e-4&&(x=1),p<1e-4&&(p=x),g<1e-4&&(g=x),Ed.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,x,g),Ad.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,x,g),Cd.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,x,g)}else this.curveType==="catmullrom"&&(Ed.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),Ad.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Cd.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(Ed.calc(l),Ad.calc(l),Cd.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new V().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Tg(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function Xv(i,t){let e=1-i;return e*e*t}function qv(i,t){return 2*(1-i)*i*t}function Yv(i,t){return i*i*t}function ua(i,t,e,n){return Xv(i,t)+qv(i,e)+Yv(i,n)}function $v(i,t){let e=1-i;return e*e*e*t}function Zv(i,t){let e=1-i;return 3*e*e*i*t}function Jv(i,t){return 3*(1-i)*i*i*t}function Kv(i,t){return i*i*i*t}function da(i,t,e,n,s){return $v(i,t)+Zv(i,e)+Jv(i,n)+Kv(i,s)}var Ra=class extends ui{constructor(t=new _t,e=new _t,n=new _t,s=new _t){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new _t){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(da(t,s.x,r.x,o.x,a.x),da(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Oc=class extends ui{constructor(t=new V,e=new V,n=new V,s=new V){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new V){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(da(t,s.x,r.x,o.x,a.x),da(t,s.y,r.y,o.y,a.y),da(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Pa=class extends ui{constructor(t=new _t,e=new _t){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new _t){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new _t){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Bc=class extends ui{constructor(t=new V,e=new V){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new V){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new V){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Ia=class extends ui{constructor(t=new _t,e=new _t,n=new _t){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new _t){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ua(t,s.x,r.x,o.x),ua(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},kc=class extends ui{constructor(t=new V,e=new V,n=new V){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new V){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ua(t,s.x,r.x,o.x),ua(t,s.y,r.y,o.y),ua(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},La=class extends ui{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new _t){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(Tg(a,l.x,c.x,h.x,u.x),Tg(a,l.y,c.y,h.y,u.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new _t().fromArray(s))}return this}},Ud=Object.freeze({__proto__:null,ArcCurve:Uc,CatmullRomCurve3:Fc,CubicBezierCurve:Ra,CubicBezierCurve3:Oc,EllipseCurve:yo,LineCurve:Pa,LineCurve3:Bc,QuadraticBezierCurve:Ia,QuadraticBezierCurve3:kc,SplineCurve:La}),zc=class extends ui{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Ud[n](e,t))}return this}getPoint(t,e){let n=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(e.push(h),n=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(new Ud[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},Da=class extends zc{constructor(t){super(),this.type="Path",this.currentPoint=new _t,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let n=new Pa(this.currentPoint.clone(),new _t(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){let r=new Ia(this.currentPoint.clone(),new _t(t,e),new _t(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){let a=new Ra(this.currentPoint.clone(),new _t(t,e),new _t(n,s),new _t(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),n=new La(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){let c=new yo(t,e,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},xo=class extends Da{constructor(t){super(t),this.uuid=vr(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let n=0,s=this.holes.length;n<s;n++)e[n]=this.holes[n].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,n=this.holes.length;e<n;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(new Da().fromJSON(s))}return this}};function jv(i,t,e=2){let n=t&&t.length,s=n?t[0]*e:i.length,r=b0(i,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=iS(i,t,r,e)),i.length>80*e){a=i[0],l=i[1];let h=a,u=l;for(let d=e;d<s;d+=e){let f=i[d],p=i[d+1];f<a&&(a=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return Na(r,o,e,a,l,c,0),o}function b0(i,t,e,n,s){let r;if(s===pS(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=Eg(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=Eg(o/n|0,i[o],i[o+1],r);return r&&vo(r,r.next)&&(Fa(r),r=r.next),r}function pr(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(vo(e,e.next)||en(e.prev,e,e.next)===0)){if(Fa(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function Na(i,t,e,n,s,r,o){if(!i)return;!o&&r&&lS(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?tS(i,n,s,r):Qv(i)){t.push(l.i,i.i,c.i),Fa(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=eS(pr(i),t),Na(i,t,e,n,s,r,2)):o===2&&nS(i,t,e,n,s,r):Na(pr(i),t,e,n,s,r,1);break}}}function Qv(i){let t=i.prev,e=i,n=i.next;if(en(t,e,n)>=0)return!1;let s=t.x,r=e.x,o=n.x,a=t.y,l=e.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),p=n.next;for(;p!==t;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&aa(s,a,r,l,o,c,p.x,p.y)&&en(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function tS(i,t,e,n){let s=i.prev,r=i,o=i.next;if(en(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),p=Math.min(h,u,d),x=Math.max(a,l,c),g=Math.max(h,u,d),m=Fd(f,p,t,e,n),_=Fd(x,g,t,e,n),M=i.prevZ,v=i.nextZ;for(;M&&M.z>=m&&v&&v.z<=_;){if(M.x>=f&&M.x<=x&&M.y>=p&&M.y<=g&&M!==s&&M!==o&&aa(a,h,l,u,c,d,M.x,M.y)&&en(M.prev,M,M.next)>=0||(M=M.prevZ,v.x>=f&&v.x<=x&&v.y>=p&&v.y<=g&&v!==s&&v!==o&&aa(a,h,l,u,c,d,v.x,v.y)&&en(v.prev,v,v.next)>=0))return!1;v=v.nextZ}for(;M&&M.z>=m;){if(M.x>=f&&M.x<=x&&M.y>=p&&M.y<=g&&M!==s&&M!==o&&aa(a,h,l,u,c,d,M.x,M.y)&&en(M.prev,M,M.next)>=0)return!1;M=M.prevZ}for(;v&&v.z<=_;){if(v.x>=f&&v.x<=x&&v.y>=p&&v.y<=g&&v!==s&&v!==o&&aa(a,h,l,u,c,d,v.x,v.y)&&en(v.prev,v,v.next)>=0)return!1;v=v.nextZ}return!0}function eS(i,t){let e=i;do{let n=e.prev,s=e.next.next;!vo(n,s)&&T0(n,e,e.next,s)&&Ua(n,s)&&Ua(s,n)&&(t.push(n.i,e.i,s.i),Fa(e),Fa(e.next),e=i=s),e=e.next}while(e!==i);return pr(e)}function nS(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&uS(o,a)){let l=E0(o,a);o=pr(o,o.next),l=pr(l,l.next),Na(o,t,e,n,s,r,0),Na(l,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function iS(i,t,e,n){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*n,l=r<o-1?t[r+1]*n:i.length,c=b0(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(hS(c))}s.sort(sS);for(let r=0;r<s.length;r++)e=rS(s[r],e);return e}function sS(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function rS(i,t){let e=oS(i,t);if(!e)return t;let n=E0(e,i);return pr(n,n.next),pr(e,e.next)}function oS(i,t){let e=t,n=i.x,s=i.y,r=-1/0,o;if(vo(i,e))return e;do{if(vo(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let u=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(u<=n&&u>r&&(r=u,o=e.x<e.next.x?e:e.next,u===n))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;e=o;do{if(n>=e.x&&e.x>=l&&n!==e.x&&w0(s<c?n:r,s,l,c,s<c?r:n,s,e.x,e.y)){let u=Math.abs(s-e.y)/(n-e.x);Ua(e,i)&&(u<h||u===h&&(e.x>o.x||e.x===o.x&&aS(o,e)))&&(o=e,h=u)}e=e.next}while(e!==a);return o}function aS(i,t){return en(i.prev,i,t.prev)<0&&en(t.next,i,i.next)<0}function lS(i,t,e,n){let s=i;do s.z===0&&(s.z=Fd(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,cS(s)}function cS(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function Fd(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function hS(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function w0(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function aa(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&w0(i,t,e,n,s,r,o,a)}function uS(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!dS(i,t)&&(Ua(i,t)&&Ua(t,i)&&fS(i,t)&&(en(i.prev,i,t.prev)||en(i,t.prev,t))||vo(i,t)&&en(i.prev,i,i.next)>0&&en(t.prev,t,t.next)>0)}function en(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function vo(i,t){return i.x===t.x&&i.y===t.y}function T0(i,t,e,n){let s=uc(en(i,t,e)),r=uc(en(i,t,n)),o=uc(en(e,n,i)),a=uc(en(e,n,t));return!!(s!==r&&o!==a||s===0&&hc(i,e,t)||r===0&&hc(i,n,t)||o===0&&hc(e,i,n)||a===0&&hc(e,t,n))}function hc(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function uc(i){return i>0?1:i<0?-1:0}function dS(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&T0(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function Ua(i,t){return en(i.prev,i,i.next)<0?en(i,t,i.next)>=0&&en(i,i.prev,t)>=0:en(i,t,i.prev)<0||en(i,i.next,t)<0}function fS(i,t){let e=i,n=!1,s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function E0(i,t){let e=Od(i.i,i.x,i.y),n=Od(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function Eg(i,t,e,n){let s=Od(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function Fa(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function Od(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function pS(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var Bd=class{static triangulate(t,e,n=2){return jv(t,e,n)}},cr=class i{static area(t){let e=t.length,n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return i.area(t)<0}static triangulateShape(t,e){let n=[],s=[],r=[];Ag(t),Cg(n,t);let o=t.length;e.forEach(Ag);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,Cg(n,e[l]);let a=Bd.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function Ag(i){let t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function Cg(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}var Oa=class i extends gn{constructor(t=new xo([new _t(.5,.5),new _t(-.5,.5),new _t(-.5,-.5),new _t(.5,-.5)]),e={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:t,options:e},t=Array.isArray(t)?t:[t];let n=this,s=[],r=[];for(let a=0,l=t.length;a<l;a++){let c=t[a];o(c)}this.setAttribute("position",new Ve(s,3)),this.setAttribute("uv",new Ve(r,2)),this.computeVertexNormals();function o(a){let l=[],c=e.curveSegments!==void 0?e.curveSegments:12,h=e.steps!==void 0?e.steps:1,u=e.depth!==void 0?e.depth:1,d=e.bevelEnabled!==void 0?e.bevelEnabled:!0,f=e.bevelThickness!==void 0?e.bevelThickness:.2,p=e.bevelSize!==void 0?e.bevelSize:f-.1,x=e.bevelOffset!==void 0?e.bevelOffset:0,g=e.bevelSegments!==void 0?e.bevelSegments:3,m=e.extrudePath,_=e.UVGenerator!==void 0?e.UVGenerator:mS,M,v=!1,C,T,y,b;if(m){M=m.getSpacedPoints(h),v=!0,d=!1;let ot=m.isCatmullRomCurve3?m.closed:!1;C=m.computeFrenetFrames(h,ot),T=new V,y=new V,b=new V}d||(g=0,f=0,p=0,x=0);let U=a.extractPoints(c),P=U.shape,R=U.holes;if(!cr.isClockWise(P)){P=P.reverse();for(let ot=0,vt=R.length;ot<vt;ot++){let yt=R[ot];cr.isClockWise(yt)&&(R[ot]=yt.reverse())}}function H(ot){let yt=10000000000000001e-36,Bt=ot[0];for(let Dt=1;Dt<=ot.length;Dt++){let ee=Dt%ot.length,kt=ot[ee],me=kt.x-Bt.x,de=kt.y-Bt.y,_e=me*me+de*de,O=Math.max(Math.abs(kt.x),Math.abs(kt.y),Math.abs(Bt.x),Math.abs(Bt.y)),Mt=yt*O*O;if(_e<=Mt){ot.splice(ee,1),Dt--;continue}Bt=kt}}H(P),R.forEach(H);let N=R.length,W=P;for(let ot=0;ot<N;ot++){let vt=R[ot];P=P.concat(vt)}function B(ot,vt,yt){return vt||ce("ExtrudeGeometry: vec does not exist"),ot.clone().addScaledVector(vt,yt)}let k=P.length;function lt(ot,vt,yt){let Bt,Dt,ee,kt=ot.x-vt.x,me=ot.y-vt.y,de=yt.x-ot.x,_e=yt.y-ot.y,O=kt*kt+me*me,Mt=kt*_e-me*de;if(Math.abs(Mt)>Number.EPSILON){let Xt=Math.sqrt(O),he=Math.sqrt(de*de+_e*_e),Tt=vt.x-me/Xt,Fe=vt.y+kt/Xt,$t=yt.x-_e/he,Qt=yt.y+de/he,I=(($t-Tt)*_e-(Qt-Fe)*de)/(kt*_e-me*de);Bt=Tt+kt*I-ot.x,Dt=Fe+me*I-ot.y;let w=Bt*Bt+Dt*Dt;if(w<=2)return new _t(Bt,Dt);ee=Math.sqrt(w/2)}else{let Xt=!1;kt>Number.EPSILON?de>Number.EPSILON&&(Xt=!0):kt<-Number.EPSILON?de<-Number.EPSILON&&(Xt=!0):Math.sign(me)===Math.sign(_e)&&(Xt=!0),Xt?(Bt=-me,Dt=kt,ee=Math.sqrt(O)):(Bt=kt,Dt=me,ee=Math.sqrt(O/2))}return new _t(Bt/ee,Dt/ee)}let $=[];for(let ot=0,vt=W.length,yt=vt-1,Bt=ot+1;ot<vt;ot++,yt++,Bt++)yt===vt&&(yt=0),Bt===vt&&(Bt=0),$[ot]=lt(W[ot],W[yt],W[Bt]);let j=[],et,ft=$.concat();for(let ot=0,vt=N;ot<vt;ot++){let yt=R[ot];et=[];for(let Bt=0,Dt=yt.length,ee=Dt-1,kt=Bt+1;Bt<Dt;Bt++,ee++,kt++)ee===Dt&&(ee=0),kt===Dt&&(kt=0),et[Bt]=lt(yt[Bt],yt[ee],yt[kt]);j.push(et),ft=ft.concat(et)}let ht;if(g===0)ht=cr.triangulateShape(W,R);else{let ot=[],vt=[];for(let yt=0;yt<g;yt++){let Bt=yt/g,Dt=f*Math.cos(Bt*Math.PI/2),ee=p*Math.sin(Bt*Math.PI/2)+x;for(let kt=0,me=W.length;kt<me;kt++){let de=B(W[kt],$[kt],ee);Vt(de.x,de.y,-Dt),Bt===0&&ot.push(de)}for(let kt=0,me=N;kt<me;kt++){let de=R[kt];et=j[kt];let _e=[];for(let O=0,Mt=de.length;O<Mt;O++){let Xt=B(de[O],et[O],ee);Vt(Xt.x,Xt.y,-Dt),Bt===0&&_e.push(Xt)}Bt===0&&vt.push(_e)}}ht=cr.triangulateShape(ot,vt)}let tt=ht.length,gt=p+x;for(let ot=0;ot<k;ot++){let vt=d?B(P[ot],ft[ot],gt):P[ot];v?(y.copy(C.normals[0]).multiplyScalar(vt.x),T.copy(C.binormals[0]).multiplyScalar(vt.y),b.copy(M[0]).add(y).add(T),Vt(b.x,b.y,b.z)):Vt(vt.x,vt.y,0)}for(let ot=1;ot<=h;ot++)for(let vt=0;vt<k;vt++){let yt=d?B(P[vt],ft[vt],gt):P[vt];v?(y.copy(C.normals[ot]).multiplyScalar(yt.x),T.copy(C.binormals[ot]).multiplyScalar(yt.y),b.copy(M[ot]).add(y).add(T),Vt(b.x,b.y,b.z)):Vt(yt.x,yt.y,u/h*ot)}for(let ot=g-1;ot>=0;ot--){let vt=ot/g,yt=f*Math.cos(vt*Math.PI/2),Bt=p*Math.sin(vt*Math.PI/2)+x;for(let Dt=0,ee=W.length;Dt<ee;Dt++){let kt=B(W[Dt],$[Dt],Bt);Vt(kt.x,kt.y,u+yt)}for(let Dt=0,ee=R.length;Dt<ee;Dt++){let kt=R[Dt];et=j[Dt];for(let me=0,de=kt.length;me<de;me++){let _e=B(kt[me],et[me],Bt);v?Vt(_e.x,_e.y+M[h-1].y,M[h-1].x+yt):Vt(_e.x,_e.y,u+yt)}}}xt(),Lt();function xt(){let ot=s.length/3;if(d){let vt=0,yt=k*vt;for(let Bt=0;Bt<tt;Bt++){let Dt=ht[Bt];ie(Dt[2]+yt,Dt[1]+yt,Dt[0]+yt)}vt=h+g*2,yt=k*vt;for(let Bt=0;Bt<tt;Bt++){let Dt=ht[Bt];ie(Dt[0]+yt,Dt[1]+yt,Dt[2]+yt)}}else{for(let vt=0;vt<tt;vt++){let yt=ht[vt];ie(yt[2],yt[1],yt[0])}for(let vt=0;vt<tt;vt++){let yt=ht[vt];ie(yt[0]+k*h,yt[1]+k*h,yt[2]+k*h)}}n.addGroup(ot,s.length/3-ot,0)}function Lt(){let ot=s.length/3,vt=0;wt(W,vt),vt+=W.length;for(let yt=0,Bt=R.length;yt<Bt;yt++){let Dt=R[yt];wt(Dt,vt),vt+=Dt.length}n.addGroup(ot,s.length/3-ot,1)}function wt(ot,vt){let yt=ot.length;for(;--yt>=0;){let Bt=yt,Dt=yt-1;Dt<0&&(Dt=ot.length-1);for(let ee=0,kt=h+g*2;ee<kt;ee++){let me=k*ee,de=k*(ee+1),_e=vt+Bt+me,O=vt+Dt+me,Mt=vt+Dt+de,Xt=vt+Bt+de;Jt(_e,O,Mt,Xt)}}}function Vt(ot,vt,yt){l.push(ot),l.push(vt),l.push(yt)}function ie(ot,vt,yt){se(ot),se(vt),se(yt);let Bt=s.length/3,Dt=_.generateTopUV(n,s,Bt-3,Bt-2,Bt-1);ne(Dt[0]),ne(Dt[1]),ne(Dt[2])}function Jt(ot,vt,yt,Bt){se(ot),se(vt),se(Bt),se(vt),se(yt),se(Bt);let Dt=s.length/3,ee=_.generateSideWallUV(n,s,Dt-6,Dt-3,Dt-2,Dt-1);ne(ee[0]),ne(ee[1]),ne(ee[3]),ne(ee[1]),ne(ee[2]),ne(ee[3])}function se(ot){s.push(l[ot*3+0]),s.push(l[ot*3+1]),s.push(l[ot*3+2])}function ne(ot){r.push(ot.x),r.push(ot.y)}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes,n=this.parameters.options;return gS(e,n,t)}static fromJSON(t,e){let n=[];for(let r=0,o=t.shapes.length;r<o;r++){let a=e[t.shapes[r]];n.push(a)}let s=t.options.extrudePath;return s!==void 0&&(t.options.extrudePath=new Ud[s.type]().fromJSON(s)),new i(n,t.options)}},mS={generateTopUV:function(i,t,e,n,s){let r=t[e*3],o=t[e*3+1],a=t[n*3],l=t[n*3+1],c=t[s*3],h=t[s*3+1];return[new _t(r,o),new _t(a,l),new _t(c,h)]},generateSideWallUV:function(i,t,e,n,s,r){let o=t[e*3],a=t[e*3+1],l=t[e*3+2],c=t[n*3],h=t[n*3+1],u=t[n*3+2],d=t[s*3],f=t[s*3+1],p=t[s*3+2],x=t[r*3],g=t[r*3+1],m=t[r*3+2];return Math.abs(a-h)<Math.abs(o-c)?[new _t(o,1-l),new _t(c,1-u),new _t(d,1-p),new _t(x,1-m)]:[new _t(a,1-l),new _t(h,1-u),new _t(f,1-p),new _t(g,1-m)]}};function gS(i,t,e){if(e.shapes=[],Array.isArray(i))for(let n=0,s=i.length;n<s;n++){let r=i[n];e.shapes.push(r.uuid)}else e.shapes.push(i.uuid);return e.options=Object.assign({},t),t.extrudePath!==void 0&&(e.options.extrudePath=t.extrudePath.toJSON()),e}var So=class i extends Nc{constructor(t=1,e=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new i(t.radius,t.detail)}},mr=class i extends gn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],p=[],x=[],g=[];for(let m=0;m<h;m++){let _=m*d-o;for(let M=0;M<c;M++){let v=M*u-r;p.push(v,-_,0),x.push(0,0,1),g.push(M/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let M=_+c*m,v=_+c*(m+1),C=_+1+c*(m+1),T=_+1+c*m;f.push(M,v,T),f.push(v,C,T)}this.setIndex(f),this.setAttribute("position",new Ve(p,3)),this.setAttribute("normal",new Ve(x,3)),this.setAttribute("uv",new Ve(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ba=class i extends gn{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new V,d=new V,f=[],p=[],x=[],g=[];for(let m=0;m<=n;m++){let _=[],M=m/n,v=o+M*a,C=t*Math.cos(v),T=Math.sqrt(t*t-C*C),y=0;m===0&&o===0?y=.5/e:m===n&&l===Math.PI&&(y=-.5/e);for(let b=0;b<=e;b++){let U=b/e,P=s+U*r;u.x=-T*Math.cos(P),u.y=C,u.z=T*Math.sin(P),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),g.push(U+y,1-M),_.push(c++)}h.push(_)}for(let m=0;m<n;m++)for(let _=0;_<e;_++){let M=h[m][_+1],v=h[m][_],C=h[m+1][_],T=h[m+1][_+1];(m!==0||o>0)&&f.push(M,v,T),(m!==n-1||l<Math.PI)&&f.push(v,C,T)}this.setIndex(f),this.setAttribute("position",new Ve(p,3)),this.setAttribute("normal",new Ve(x,3)),this.setAttribute("uv",new Ve(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function Sr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Rg(s))s.isRenderTargetTexture?(te("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Rg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function kn(i){let t={};for(let e=0;e<i.length;e++){let n=Sr(i[e]);for(let s in n)t[s]=n[s]}return t}function Rg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function _S(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function yf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ce.workingColorSpace}var A0={clone:Sr,merge:kn},yS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,xS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Yi=class extends ms{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=yS,this.fragmentShader=xS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Sr(t.uniforms),this.uniformsGroups=_S(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new oe().setHex(s.value);break;case"v2":this.uniforms[n].value=new _t().fromArray(s.value);break;case"v3":this.uniforms[n].value=new V().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Qe().fromArray(s.value);break;case"m3":this.uniforms[n].value=new fe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ne().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Gc=class extends Yi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Mo=class extends ms{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new oe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Hh,this.normalScale=new _t(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fs,this.combine=nh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Vc=class extends ms{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=a0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Hc=class extends ms{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function oo(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function dc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ks=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Wc=class extends ks{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ld,endingEnd:Ld}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Dd:r=t,a=2*e-n;break;case Nd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Dd:o=t,l=2*n-e;break;case Nd:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),x=p*p,g=x*p,m=-d*g+2*d*x-d*p,_=(1+d)*g+(-1.5-2*d)*x+(-.5+d)*p+1,M=(-1-f)*g+(1.5+f)*x+.5*p,v=f*g-f*x;for(let C=0;C!==a;++C)r[C]=m*o[h+C]+_*o[c+C]+M*o[l+C]+v*o[u+C];return r}},Xc=class extends ks{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},qc=class extends ks{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Yc=class extends ks{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),x=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],g=o[l+p],m=f*d+p*2,_=u[m],M=u[m+1],v=t*d+p*2,C=h[v],T=h[v+1],y=SS(n,e,_,C,s);r[p]=C0(y,x,M,T,g)}return r}};function C0(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function vS(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function SS(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=C0(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=vS(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var di=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=oo(e,this.TimeBufferType),this.values=oo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:oo(t.times,Array),values:oo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),dc(t.settings)&&(n.settings={inTangents:oo(t.settings.inTangents,Array),outTangents:oo(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new qc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Xc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Wc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Yc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case fa:e=this.InterpolantFactoryMethodDiscrete;break;case Ac:e=this.InterpolantFactoryMethodLinear;break;case gc:e=this.InterpolantFactoryMethodSmooth;break;case Id:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return te("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return fa;case this.InterpolantFactoryMethodLinear:return Ac;case this.InterpolantFactoryMethodSmooth:return gc;case this.InterpolantFactoryMethodBezier:return Id}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;dc(this.settings)&&(Pg(this.settings.inTangents,t),Pg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;dc(this.settings)&&(Ig(this.settings.inTangents,t),Ig(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ce("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ce("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ce("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ce("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&hv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ce("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===gc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=e[u+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,dc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Pg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Ig(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}di.prototype.ValueTypeName="";di.prototype.TimeBufferType=Float32Array;di.prototype.ValueBufferType=Float32Array;di.prototype.DefaultInterpolation=Ac;var zs=class extends di{constructor(t,e,n){super(t,e,n)}};zs.prototype.ValueTypeName="bool";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=fa;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var $c=class extends di{constructor(t,e,n,s){super(t,e,n,s)}};$c.prototype.ValueTypeName="color";var Zc=class extends di{constructor(t,e,n,s){super(t,e,n,s)}};Zc.prototype.ValueTypeName="number";var Jc=class extends ks{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Ln.slerpFlat(r,0,o,c-a,o,c,l);return r}},ka=class extends di{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Jc(this.times,this.values,this.getValueSize(),t)}};ka.prototype.ValueTypeName="quaternion";ka.prototype.InterpolantFactoryMethodSmooth=void 0;var Gs=class extends di{constructor(t,e,n){super(t,e,n)}};Gs.prototype.ValueTypeName="string";Gs.prototype.ValueBufferType=Array;Gs.prototype.DefaultInterpolation=fa;Gs.prototype.InterpolantFactoryMethodLinear=void 0;Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var Kc=class extends di{constructor(t,e,n,s){super(t,e,n,s)}};Kc.prototype.ValueTypeName="vector";var jc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},R0=new jc,Qc=class{constructor(t){this.manager=t!==void 0?t:R0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Qc.DEFAULT_MATERIAL_NAME="__DEFAULT";var za=class extends Nn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new oe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Rd=new Ne,Lg=new V,Dg=new V,th=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new _t(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new Ne,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Os,this._frameExtents=new _t(1,1),this._viewportCount=1,this._viewports=[new Qe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Lg.setFromMatrixPosition(t.matrixWorld),e.position.copy(Lg),Dg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Dg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Rd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Rd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===uo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Rd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},fc=new V,pc=new Ln,Hi=new V,Ga=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ne,this.projectionMatrix=new Ne,this.projectionMatrixInverse=new Ne,this.coordinateSystem=xi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(fc,pc,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fc,pc,Hi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(fc,pc,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fc,pc,Hi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Us=new V,Ng=new _t,Ug=new _t,Yn=class extends Ga{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=po*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ca*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return po*2*Math.atan(Math.tan(ca*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Us.x,Us.y).multiplyScalar(-t/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Us.x,Us.y).multiplyScalar(-t/Us.z)}getViewSize(t,e){return this.getViewBounds(t,Ng,Ug),e.subVectors(Ug,Ng)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ca*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Va=class extends Ga{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},kd=class extends th{constructor(){super(new Va(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ha=class extends za{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new kd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Wa=class extends za{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var ao=-90,lo=1,bo=class extends Nn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Yn(ao,lo,t,e);s.layers=this.layers,this.add(s);let r=new Yn(ao,lo,t,e);r.layers=this.layers,this.add(r);let o=new Yn(ao,lo,t,e);o.layers=this.layers,this.add(o);let a=new Yn(ao,lo,t,e);a.layers=this.layers,this.add(a);let l=new Yn(ao,lo,t,e);l.layers=this.layers,this.add(l);let c=new Yn(ao,lo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===xi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===uo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},eh=class extends Yn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var xf="\\[\\]\\.:\\/",MS=new RegExp("["+xf+"]","g"),vf="[^"+xf+"]",bS="[^"+xf.replace("\\.","")+"]",wS=/((?:WC+[\/:])*)/.source.replace("WC",vf),TS=/(WCOD+)?/.source.replace("WCOD",bS),ES=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",vf),AS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",vf),CS=new RegExp("^"+wS+TS+ES+AS+"$"),RS=["material","materials","bones","map"],zd=class{constructor(t,e,n){let s=n||Ke.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ke=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(MS,"")}static parseTrackName(t){let e=CS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);RS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){te("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ce("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ce("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ce("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ce("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ce("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ce("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ke.Composite=zd;Ke.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ke.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ke.prototype.GetterByBindingType=[Ke.prototype._getValue_direct,Ke.prototype._getValue_array,Ke.prototype._getValue_arrayElement,Ke.prototype._getValue_toArray];Ke.prototype.SetterByBindingTypeAndVersioning=[[Ke.prototype._setValue_direct,Ke.prototype._setValue_direct_setNeedsUpdate,Ke.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_array,Ke.prototype._setValue_array_setNeedsUpdate,Ke.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_arrayElement,Ke.prototype._setValue_arrayElement_setNeedsUpdate,Ke.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_fromArray,Ke.prototype._setValue_fromArray_setNeedsUpdate,Ke.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var zE=new Float32Array(1);var wo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ve(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ve(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Gd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Xa=class extends ur{constructor(t=10,e=10,n=4473924,s=8947848){n=new oe(n),s=new oe(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let d=0,f=0,p=-a;d<=e;d++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let x=d===r?n:s;x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3}let h=new gn;h.setAttribute("position",new Ve(l,3)),h.setAttribute("color",new Ve(c,3));let u=new Bs({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Fg=new V,mc,Pd,qa=class extends Nn{constructor(t=new V(0,0,1),e=new V(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",mc===void 0&&(mc=new gn,mc.setAttribute("position",new Ve([0,0,0,0,1,0],3)),Pd=new fr(.5,1,5,1),Pd.translate(0,-.5,0)),this.position.copy(e),this.line=new Ta(mc,new Bs({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Sn(Pd,new Ma({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(t),this.setLength(n,r,o)}setDirection(t){if(t.y>.99999)this.quaternion.set(0,0,0,1);else if(t.y<-.99999)this.quaternion.set(1,0,0,0);else{Fg.set(t.z,0,-t.x).normalize();let e=Math.acos(t.y);this.quaternion.setFromAxisAngle(Fg,e)}}setLength(t,e=t*.2,n=e*.2){this.line.scale.set(1,Math.max(1e-4,t-e),1),this.line.updateMatrix(),this.cone.scale.set(n,e,n),this.cone.position.y=t,this.cone.updateMatrix()}setColor(t){this.line.material.color.set(t),this.cone.material.color.set(t)}copy(t){return super.copy(t,!1),this.line.copy(t.line),this.cone.copy(t.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var Ya=class extends Ii{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Sf(i,t,e,n){let s=PS(n);switch(e){case af:return i*t;case ch:return i*t/s.components*s.byteLength;case hh:return i*t/s.components*s.byteLength;case Xs:return i*t*2/s.components*s.byteLength;case uh:return i*t*2/s.components*s.byteLength;case lf:return i*t*3/s.components*s.byteLength;case Ni:return i*t*4/s.components*s.byteLength;case dh:return i*t*4/s.components*s.byteLength;case Ja:case Ka:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case ja:case Qa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ph:case gh:return Math.max(i,16)*Math.max(t,8)/4;case fh:case mh:return Math.max(i,8)*Math.max(t,8)/2;case _h:case yh:case vh:case Sh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case xh:case tl:case Mh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case bh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case wh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Th:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Eh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Ah:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Ch:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Rh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ph:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Ih:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Lh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Dh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Nh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Uh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Fh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Oh:case Bh:case kh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case zh:case Gh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case el:case Vh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function PS(i){switch(i){case Kn:case nf:return{byteLength:1,components:1};case Co:case sf:case Di:return{byteLength:2,components:1};case ah:case lh:return{byteLength:2,components:4};case Li:case oh:case vi:return{byteLength:4,components:1};case rf:case of:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?te("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function K0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function OS(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var BS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,kS=`#ifdef USE_ALPHAHASH
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
#endif`,zS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,GS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,VS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,HS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,WS=`#ifdef USE_AOMAP
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
#endif`,XS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,qS=`#ifdef USE_BATCHING
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
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,YS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,$S=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ZS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,JS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,KS=`#ifdef USE_IRIDESCENCE
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
#endif`,jS=`#ifdef USE_BUMPMAP
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
#endif`,QS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,tM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,eM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,nM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,iM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,sM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,rM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,oM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,aM=`#define PI 3.141592653589793
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
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
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
} // validated`,lM=`vec3 transformedNormal = objectNormal;
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
#endif`,cM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,hM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,uM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,dM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,fM="gl_FragColor = linearToOutputTexel( gl_FragColor );",pM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,mM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,gM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,_M=`#ifdef USE_ENVMAP
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
#endif`,yM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,xM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,vM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,SM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,MM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,bM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,wM=`#ifdef USE_GRADIENTMAP
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
}`,TM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,EM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,AM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,CM=`uniform bool receiveShadow;
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
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
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
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
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
#endif
#include <lightprobes_pars_fragment>`,RM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,PM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,IM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,LM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,DM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,NM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
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
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
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
#endif`,UM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
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
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
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
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
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
		return 0.5 / max( gv + gl, EPSILON );
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
		float roughness = max( material.clearcoatRoughness, 0.045 );
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
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
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
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
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
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
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
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
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
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,FM=`
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
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
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
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,OM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,BM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,kM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,zM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,GM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,VM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,HM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,WM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,XM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,qM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,YM=`#if defined( USE_POINTS_UV )
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
#endif`,$M=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ZM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,JM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,KM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,jM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,QM=`#ifdef USE_MORPHTARGETS
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
#endif`,tb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,eb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#ifdef DOUBLE_SIDED
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
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,nb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,ib=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,sb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,rb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,ob=`#ifdef USE_NORMALMAP
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
#endif`,ab=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,lb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,cb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,hb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,ub=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,db=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,fb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,pb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,mb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,gb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,_b=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,yb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,xb=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
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
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,vb=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
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
#endif`,Sb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
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
#endif`,Mb=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
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
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
}`,bb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,wb=`#ifdef USE_SKINNING
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
#endif`,Tb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Eb=`#ifdef USE_SKINNING
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
#endif`,Ab=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Cb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Rb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Pb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Ib=`#ifdef USE_TRANSMISSION
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
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Lb=`#ifdef USE_TRANSMISSION
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
#endif`,Db=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,Nb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,Ub=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
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
#endif`,Fb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Ob=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Bb=`uniform sampler2D t2D;
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
}`,kb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,zb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Gb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Vb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Hb=`#include <common>
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
}`,Wb=`#if DEPTH_PACKING == 3200
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Xb=`#define DISTANCE
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
}`,qb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Yb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,$b=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Zb=`uniform float scale;
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
}`,Jb=`uniform vec3 diffuse;
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
}`,Kb=`#include <common>
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
}`,jb=`uniform vec3 diffuse;
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
}`,Qb=`#define LAMBERT
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
}`,tw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,ew=`#define MATCAP
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
}`,nw=`#define MATCAP
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
}`,iw=`#define NORMAL
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
}`,sw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
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
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,rw=`#define PHONG
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
}`,ow=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,aw=`#define STANDARD
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
}`,lw=`#define STANDARD
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
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
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
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
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
}`,cw=`#define TOON
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
}`,hw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
}`,uw=`uniform float size;
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
}`,dw=`uniform vec3 diffuse;
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
}`,fw=`#include <common>
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
}`,pw=`uniform vec3 color;
uniform float opacity;
#include <common>
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
	#include <premultiplied_alpha_fragment>
}`,mw=`uniform float rotation;
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
}`,gw=`uniform vec3 diffuse;
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
}`,Se={alphahash_fragment:BS,alphahash_pars_fragment:kS,alphamap_fragment:zS,alphamap_pars_fragment:GS,alphatest_fragment:VS,alphatest_pars_fragment:HS,aomap_fragment:WS,aomap_pars_fragment:XS,batching_pars_vertex:qS,batching_vertex:YS,begin_vertex:$S,beginnormal_vertex:ZS,bsdfs:JS,iridescence_fragment:KS,bumpmap_pars_fragment:jS,clipping_planes_fragment:QS,clipping_planes_pars_fragment:tM,clipping_planes_pars_vertex:eM,clipping_planes_vertex:nM,color_fragment:iM,color_pars_fragment:sM,color_pars_vertex:rM,color_vertex:oM,common:aM,defaultnormal_vertex:lM,displacementmap_pars_vertex:cM,displacementmap_vertex:hM,emissivemap_fragment:uM,emissivemap_pars_fragment:dM,colorspace_fragment:fM,colorspace_pars_fragment:pM,envmap_fragment:mM,envmap_common_pars_fragment:gM,envmap_pars_fragment:_M,envmap_pars_vertex:yM,envmap_physical_pars_fragment:RM,envmap_vertex:xM,fog_vertex:vM,fog_pars_vertex:SM,fog_fragment:MM,fog_pars_fragment:bM,gradientmap_pars_fragment:wM,lightmap_pars_fragment:TM,lights_lambert_fragment:EM,lights_lambert_pars_fragment:AM,lights_pars_begin:CM,lights_toon_fragment:PM,lights_toon_pars_fragment:IM,lights_phong_fragment:LM,lights_phong_pars_fragment:DM,lights_physical_fragment:NM,lights_physical_pars_fragment:UM,lights_fragment_begin:FM,lights_fragment_maps:OM,lights_fragment_end:BM,lightprobes_pars_fragment:kM,logdepthbuf_fragment:zM,logdepthbuf_pars_fragment:GM,logdepthbuf_pars_vertex:VM,logdepthbuf_vertex:HM,map_fragment:WM,map_pars_fragment:XM,map_particle_fragment:qM,map_particle_pars_fragment:YM,metalnessmap_fragment:$M,metalnessmap_pars_fragment:ZM,morphinstance_vertex:JM,morphcolor_vertex:KM,morphnormal_vertex:jM,morphtarget_pars_vertex:QM,morphtarget_vertex:tb,normal_fragment_begin:eb,normal_fragment_maps:nb,normal_pars_fragment:ib,normal_pars_vertex:sb,normal_vertex:rb,normalmap_pars_fragment:ob,clearcoat_normal_fragment_begin:ab,clearcoat_normal_fragment_maps:lb,clearcoat_pars_fragment:cb,iridescence_pars_fragment:hb,opaque_fragment:ub,packing:db,premultiplied_alpha_fragment:fb,project_vertex:pb,dithering_fragment:mb,dithering_pars_fragment:gb,roughnessmap_fragment:_b,roughnessmap_pars_fragment:yb,shadowmap_pars_fragment:xb,shadowmap_pars_vertex:vb,shadowmap_vertex:Sb,shadowmask_pars_fragment:Mb,skinbase_vertex:bb,skinning_pars_vertex:wb,skinning_vertex:Tb,skinnormal_vertex:Eb,specularmap_fragment:Ab,specularmap_pars_fragment:Cb,tonemapping_fragment:Rb,tonemapping_pars_fragment:Pb,transmission_fragment:Ib,transmission_pars_fragment:Lb,uv_pars_fragment:Db,uv_pars_vertex:Nb,uv_vertex:Ub,worldpos_vertex:Fb,background_vert:Ob,background_frag:Bb,backgroundCube_vert:kb,backgroundCube_frag:zb,cube_vert:Gb,cube_frag:Vb,depth_vert:Hb,depth_frag:Wb,distance_vert:Xb,distance_frag:qb,equirect_vert:Yb,equirect_frag:$b,linedashed_vert:Zb,linedashed_frag:Jb,meshbasic_vert:Kb,meshbasic_frag:jb,meshlambert_vert:Qb,meshlambert_frag:tw,meshmatcap_vert:ew,meshmatcap_frag:nw,meshnormal_vert:iw,meshnormal_frag:sw,meshphong_vert:rw,meshphong_frag:ow,meshphysical_vert:aw,meshphysical_frag:lw,meshtoon_vert:cw,meshtoon_frag:hw,points_vert:uw,points_frag:dw,shadow_vert:fw,shadow_frag:pw,sprite_vert:mw,sprite_frag:gw},Ot={common:{diffuse:{value:new oe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new fe},alphaMap:{value:null},alphaMapTransform:{value:new fe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new fe}},envmap:{envMap:{value:null},envMapRotation:{value:new fe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new fe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new fe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new fe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new fe},normalScale:{value:new _t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new fe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new fe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new fe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new fe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new oe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new oe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new fe},alphaTest:{value:0},uvTransform:{value:new fe}},sprite:{diffuse:{value:new oe(16777215)},opacity:{value:1},center:{value:new _t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new fe},alphaMap:{value:null},alphaMapTransform:{value:new fe},alphaTest:{value:0}}},Ji={basic:{uniforms:kn([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.fog]),vertexShader:Se.meshbasic_vert,fragmentShader:Se.meshbasic_frag},lambert:{uniforms:kn([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new oe(0)},envMapIntensity:{value:1}}]),vertexShader:Se.meshlambert_vert,fragmentShader:Se.meshlambert_frag},phong:{uniforms:kn([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new oe(0)},specular:{value:new oe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Se.meshphong_vert,fragmentShader:Se.meshphong_frag},standard:{uniforms:kn([Ot.common,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.roughnessmap,Ot.metalnessmap,Ot.fog,Ot.lights,{emissive:{value:new oe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Se.meshphysical_vert,fragmentShader:Se.meshphysical_frag},toon:{uniforms:kn([Ot.common,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.gradientmap,Ot.fog,Ot.lights,{emissive:{value:new oe(0)}}]),vertexShader:Se.meshtoon_vert,fragmentShader:Se.meshtoon_frag},matcap:{uniforms:kn([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,{matcap:{value:null}}]),vertexShader:Se.meshmatcap_vert,fragmentShader:Se.meshmatcap_frag},points:{uniforms:kn([Ot.points,Ot.fog]),vertexShader:Se.points_vert,fragmentShader:Se.points_frag},dashed:{uniforms:kn([Ot.common,Ot.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Se.linedashed_vert,fragmentShader:Se.linedashed_frag},depth:{uniforms:kn([Ot.common,Ot.displacementmap]),vertexShader:Se.depth_vert,fragmentShader:Se.depth_frag},normal:{uniforms:kn([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,{opacity:{value:1}}]),vertexShader:Se.meshnormal_vert,fragmentShader:Se.meshnormal_frag},sprite:{uniforms:kn([Ot.sprite,Ot.fog]),vertexShader:Se.sprite_vert,fragmentShader:Se.sprite_frag},background:{uniforms:{uvTransform:{value:new fe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Se.background_vert,fragmentShader:Se.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new fe}},vertexShader:Se.backgroundCube_vert,fragmentShader:Se.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Se.cube_vert,fragmentShader:Se.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Se.equirect_vert,fragmentShader:Se.equirect_frag},distance:{uniforms:kn([Ot.common,Ot.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Se.distance_vert,fragmentShader:Se.distance_frag},shadow:{uniforms:kn([Ot.lights,Ot.fog,{color:{value:new oe(0)},opacity:{value:1}}]),vertexShader:Se.shadow_vert,fragmentShader:Se.shadow_frag}};Ji.physical={uniforms:kn([Ji.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new fe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new fe},clearcoatNormalScale:{value:new _t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new fe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new fe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new fe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new fe},sheen:{value:0},sheenColor:{value:new oe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new fe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new fe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new fe},transmissionSamplerSize:{value:new _t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new fe},attenuationDistance:{value:0},attenuationColor:{value:new oe(0)},specularColor:{value:new oe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new fe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new fe},anisotropyVector:{value:new _t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new fe}}]),vertexShader:Se.meshphysical_vert,fragmentShader:Se.meshphysical_frag};var Xh={r:0,b:0,g:0},_w=new Ne,j0=new fe;j0.set(-1,0,0,0,1,0,0,0,1);function yw(i,t,e,n,s,r){let o=new oe(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(_){let M=_.isScene===!0?_.background:null;if(M&&M.isTexture){let v=_.backgroundBlurriness>0;M=t.get(M,v)}return M}function p(_){let M=!1,v=f(_);v===null?g(o,a):v&&v.isColor&&(g(v,1),M=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(_,M){let v=f(M);v&&v.isCubeTexture?(c===void 0&&(c=new Sn(new qi(1,1,1),new Yi({name:"BackgroundCubeMaterial",uniforms:Sr(Ji.backgroundCube.uniforms),vertexShader:Ji.backgroundCube.vertexShader,fragmentShader:Ji.backgroundCube.fragmentShader,side:Zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,T,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(_w.makeRotationFromEuler(M.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(j0),c.material.toneMapped=Ce.getTransfer(v.colorSpace)!==Be,(h!==v||u!==v.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=v,u=v.version,d=i.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Sn(new mr(2,2),new Yi({name:"BackgroundMaterial",uniforms:Sr(Ji.background.uniforms),vertexShader:Ji.background.vertexShader,fragmentShader:Ji.background.fragmentShader,side:Ws,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=Ce.getTransfer(v.colorSpace)!==Be,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(h!==v||u!==v.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=v,u=v.version,d=i.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,M){_.getRGB(Xh,yf(i)),e.buffers.color.setClear(Xh.r,Xh.g,Xh.b,M,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,M=1){o.set(_),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:x,dispose:m}}function xw(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(R,G,H,N,W){let B=!1,k=u(R,N,H,G);r!==k&&(r=k,c(r.object)),B=f(R,N,H,W),B&&p(R,N,H,W),W!==null&&t.update(W,i.ELEMENT_ARRAY_BUFFER),(B||o)&&(o=!1,v(R,G,H,N),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(W).buffer))}function l(){return i.createVertexArray()}function c(R){return i.bindVertexArray(R)}function h(R){return i.deleteVertexArray(R)}function u(R,G,H,N){let W=N.wireframe===!0,B=n[G.id];B===void 0&&(B={},n[G.id]=B);let k=R.isInstancedMesh===!0?R.id:0,lt=B[k];lt===void 0&&(lt={},B[k]=lt);let $=lt[H.id];$===void 0&&($={},lt[H.id]=$);let j=$[W];return j===void 0&&(j=d(l()),$[W]=j),j}function d(R){let G=[],H=[],N=[];for(let W=0;W<e;W++)G[W]=0,H[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:H,attributeDivisors:N,object:R,attributes:{},index:null}}function f(R,G,H,N){let W=r.attributes,B=G.attributes,k=0,lt=H.getAttributes();for(let $ in lt)if(lt[$].location>=0){let et=W[$],ft=B[$];if(ft===void 0&&($==="instanceMatrix"&&R.instanceMatrix&&(ft=R.instanceMatrix),$==="instanceColor"&&R.instanceColor&&(ft=R.instanceColor)),et===void 0||et.attribute!==ft||ft&&et.data!==ft.data)return!0;k++}return r.attributesNum!==k||r.index!==N}function p(R,G,H,N){let W={},B=G.attributes,k=0,lt=H.getAttributes();for(let $ in lt)if(lt[$].location>=0){let et=B[$];et===void 0&&($==="instanceMatrix"&&R.instanceMatrix&&(et=R.instanceMatrix),$==="instanceColor"&&R.instanceColor&&(et=R.instanceColor));let ft={};ft.attribute=et,et&&et.data&&(ft.data=et.data),W[$]=ft,k++}r.attributes=W,r.attributesNum=k,r.index=N}function x(){let R=r.newAttributes;for(let G=0,H=R.length;G<H;G++)R[G]=0}function g(R){m(R,0)}function m(R,G){let H=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;H[R]=1,N[R]===0&&(i.enableVertexAttribArray(R),N[R]=1),W[R]!==G&&(i.vertexAttribDivisor(R,G),W[R]=G)}function _(){let R=r.newAttributes,G=r.enabledAttributes;for(let H=0,N=G.length;H<N;H++)G[H]!==R[H]&&(i.disableVertexAttribArray(H),G[H]=0)}function M(R,G,H,N,W,B,k){k===!0?i.vertexAttribIPointer(R,G,H,W,B):i.vertexAttribPointer(R,G,H,N,W,B)}function v(R,G,H,N){x();let W=N.attributes,B=H.getAttributes(),k=G.defaultAttributeValues;for(let lt in B){let $=B[lt];if($.location>=0){let j=W[lt];if(j===void 0&&(lt==="instanceMatrix"&&R.instanceMatrix&&(j=R.instanceMatrix),lt==="instanceColor"&&R.instanceColor&&(j=R.instanceColor)),j!==void 0){let et=j.normalized,ft=j.itemSize,ht=t.get(j);if(ht===void 0)continue;let tt=ht.buffer,gt=ht.type,xt=ht.bytesPerElement,Lt=gt===i.INT||gt===i.UNSIGNED_INT||j.gpuType===oh;if(j.isInterleavedBufferAttribute){let wt=j.data,Vt=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,ie=j.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let Jt=0;Jt<$.locationSize;Jt++)m($.location+Jt,wt.meshPerAttribute);R.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let Jt=0;Jt<$.locationSize;Jt++)g($.location+Jt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Jt=0;Jt<$.locationSize;Jt++)M($.location+Jt,ft/$.locationSize,gt,et,Vt*xt,(ie+ft/$.locationSize*Jt)*xt,Lt)}else{if(j.isInstancedBufferAttribute){for(let wt=0;wt<$.locationSize;wt++)m($.location+wt,j.meshPerAttribute);R.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let wt=0;wt<$.locationSize;wt++)g($.location+wt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let wt=0;wt<$.locationSize;wt++)M($.location+wt,ft/$.locationSize,gt,et,ft*xt,ft/$.locationSize*wt*xt,Lt)}}else if(k!==void 0){let et=k[lt];if(et!==void 0)switch(et.length){case 2:i.vertexAttrib2fv($.location,et);break;case 3:i.vertexAttrib3fv($.location,et);break;case 4:i.vertexAttrib4fv($.location,et);break;default:i.vertexAttrib1fv($.location,et)}}}}_()}function C(){U();for(let R in n){let G=n[R];for(let H in G){let N=G[H];for(let W in N){let B=N[W];for(let k in B)h(B[k].object),delete B[k];delete N[W]}}delete n[R]}}function T(R){if(n[R.id]===void 0)return;let G=n[R.id];for(let H in G){let N=G[H];for(let W in N){let B=N[W];for(let k in B)h(B[k].object),delete B[k];delete N[W]}}delete n[R.id]}function y(R){for(let G in n){let H=n[G];for(let N in H){let W=H[N];if(W[R.id]===void 0)continue;let B=W[R.id];for(let k in B)h(B[k].object),delete B[k];delete W[R.id]}}}function b(R){for(let G in n){let H=n[G],N=R.isInstancedMesh===!0?R.id:0,W=H[N];if(W!==void 0){for(let B in W){let k=W[B];for(let lt in k)h(k[lt].object),delete k[lt];delete W[B]}delete H[N],Object.keys(H).length===0&&delete n[G]}}}function U(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:T,releaseStatesOfObject:b,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:g,disableUnusedAttributes:_}}function vw(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Sw(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ni&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let b=y===Di&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Kn&&y!==vi&&!b&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(te("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&te("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&te("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),_=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:_,maxVaryings:M,maxFragmentUniforms:v,maxSamples:C,samples:T}}function Mw(i){let t=this,e=null,n=0,s=!1,r=!1,o=new ci,a=new fe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,g=u.clipShadows,m=i.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):c();else{let _=r?0:n,M=_*4,v=m.clippingState||null;l.value=v,v=h(p,d,M,f);for(let C=0;C!==M;++C)v[C]=e[C];m.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,g=null;if(x!==0){if(g=l.value,p!==!0||g===null){let m=f+x*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<m)&&(g=new Float32Array(m));for(let M=0,v=f;M!==x;++M,v+=4)o.copy(u[M]).applyMatrix4(_,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}var sl=class extends hi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Ea(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new qi(5,5,5),r=new Yi({name:"CubemapFromEquirect",uniforms:Sr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Zn,blending:gr});r.uniforms.tEquirect.value=e;let o=new Sn(s,r),a=e.minFilter;return e.minFilter===_s&&(e.minFilter=$n),new bo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},P0=256,bw=3,ww=20,Q0=256,t_=16,Tw=3,Ew=new V,Aw=new oe,Yh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new bo(1,10,null),this._boxMesh=new Sn(new qi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=Ew}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(Aw));let g=new bo(n,s,h);return g.position.copy(a),g.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=D0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=L0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(P0,mf(t))}_fromTexture(t,e){t.mapping===yr||t.mapping===Ao?this._setSize(t.image.length===0?P0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=I0(t,!1,!1),n=Math.log2(t)-bw;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=I0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===yr||t.mapping===Ao?(this._cubemapMaterial===null&&(this._cubemapMaterial=D0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=L0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Cw(),this._integrationMaterial=Rw());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/t_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Tw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Q0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Pw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function I0(i,t,e){return new sl(i,{minFilter:_s,generateMipmaps:t,type:Di,colorSpace:pa,depthBuffer:e})}function rl(i,t,e){return new Yi({name:i,uniforms:t,vertexShader:Se.cube_vert,fragmentShader:e,side:Zn,blending:gr,depthTest:!1,depthWrite:!1})}function Cw(){return rl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Q0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Rw(){return rl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:t_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Pw(){return rl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ww}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function L0(){return rl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function D0(){return rl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Iw(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===ih||f===sh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new sl(p.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===ih||f===sh,x=f===yr||f===Ao;if(p||x){let g=e.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new Yh(i)),g=p?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let _=d.image;return p&&_&&_.height>0||x&&_&&l(_)?(n===null&&(n=new Yh(i)),g=p?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===ih?d.mapping=yr:f===sh&&(d.mapping=Ao),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function Lw(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&la("WebGLRenderer: "+n+" extension not supported."),s}}}function Dw(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let g in x)t.update(x[g],i.ARRAY_BUFFER)}function u(p){let x=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let _=x!==null?x.array.length:g.array.length/3-1,M=g.count>=65535?Sa:va,v=new M(Math.ceil(_/3)*6,1),C=v.array;if(x!==null){let y=x.array;m=x.version;for(let b=0,U=0;b<_;b+=3){let P=y[b+0],R=y[b+1],G=y[b+2];C[U++]=P,C[U++]=R,C[U++]=R,C[U++]=G,C[U++]=G,C[U++]=P}}else{m=g.version;for(let y=0,b=0;y<_;y+=3){let U=y+0,P=y+1,R=y+2;C[b++]=U,C[b++]=P,C[b++]=P,C[b++]=R,C[b++]=R,C[b++]=U}}v.version=m;let T=r.get(p);T&&t.remove(T),r.set(p,v)}function d(p){let x=r.get(p);if(x){let g=p.index;g!==null&&x.version<g.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function Nw(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let g=0;g<f;g++)x+=d[g];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Uw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ce("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Fw(i,t,e){let n=new WeakMap,s=new Qe;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let U=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),x===!0&&(M=3);let v=a.attributes.position.count*M,C=1;v>t.maxTextureSize&&(C=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let T=new Float32Array(v*C*4*u),y=new _a(T,v,C,u);y.type=vi,y.needsUpdate=!0;let b=M*4;for(let P=0;P<u;P++){let R=g[P],G=m[P],H=_[P],N=v*C*4*P;for(let W=0;W<R.count;W++){let B=W*b;f===!0&&(s.fromBufferAttribute(R,W),T[N+B+0]=s.x,T[N+B+1]=s.y,T[N+B+2]=s.z,T[N+B+3]=0),p===!0&&(s.fromBufferAttribute(G,W),T[N+B+4]=s.x,T[N+B+5]=s.y,T[N+B+6]=s.z,T[N+B+7]=0),x===!0&&(s.fromBufferAttribute(H,W),T[N+B+8]=s.x,T[N+B+9]=s.y,T[N+B+10]=s.z,T[N+B+11]=H.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new _t(v,C)},n.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function Ow(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Bw={[$d]:"LINEAR_TONE_MAPPING",[Zd]:"REINHARD_TONE_MAPPING",[Jd]:"CINEON_TONE_MAPPING",[Kd]:"ACES_FILMIC_TONE_MAPPING",[Qd]:"AGX_TONE_MAPPING",[tf]:"NEUTRAL_TONE_MAPPING",[jd]:"CUSTOM_TONE_MAPPING"};function kw(i,t,e,n,s,r){let o=new hi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new gn;h.setAttribute("position",new Ve([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ve([0,2,0,0,2,0],2));let u=new Gc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Sn(h,u),f=new Va(-1,1,1,-1,0,1),p=null,x=null,g=!1,m,_=null,M=[],v=!1;this.setSize=function(C,T){o.setSize(C,T),a!==null&&a.setSize(C,T),l!==null&&l.setSize(C,T);for(let y=0;y<M.length;y++){let b=M[y];b.setSize&&b.setSize(C,T)}},this.setEffects=function(C){M=C,v=M.length>0&&M[0].isRenderPass===!0;let T=o.width,y=o.height;M.length>0&&a===null&&(a=new hi(T,y,{type:Di,depthBuffer:!1,stencilBuffer:!1}),l=new hi(T,y,{type:Di,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&M.some(U=>U.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new gs(T,y),r===!0&&(c.format=ys,c.type=xr)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let U=0;U<M.length;U++){let P=M[U];P.setSize&&P.setSize(T,y),b&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,T){if(g||C.toneMapping===$i&&M.length===0)return!1;if(_=T,T!==null){let y=T.width,b=T.height;(o.width!==y||o.height!==b)&&this.setSize(y,b)}return v===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=$i,!0},this.hasRenderPass=function(){return v},this.end=function(C,T){C.toneMapping=m,g=!0;let y=o,b=a;for(let U=0;U<M.length;U++){let P=M[U];P.enabled!==!1&&(P.render(C,b,y,T),P.needsSwap!==!1&&(y=b,b=b===a?l:a))}if(p!==C.outputColorSpace||x!==C.toneMapping){p=C.outputColorSpace,x=C.toneMapping,u.defines={},Ce.getTransfer(p)===Be&&(u.defines.SRGB_TRANSFER="");let U=Bw[x];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,C.setRenderTarget(_),C.render(d,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var e_=new Jn,n_=new gs(1,1),i_=new Aa(1),s_=new _a,r_=new Pc,o_=new Ea,N0=[],U0=[],F0=new Float32Array(16),O0=new Float32Array(9),B0=new Float32Array(4);function Po(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=N0[s];if(r===void 0&&(r=new Float32Array(s),N0[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Mn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function bn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Zh(i,t){let e=U0[t];e===void 0&&(e=new Int32Array(t),U0[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function zw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function Gw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2fv(this.addr,t),bn(e,t)}}function Vw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Mn(e,t))return;i.uniform3fv(this.addr,t),bn(e,t)}}function Hw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4fv(this.addr,t),bn(e,t)}}function Ww(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;B0.set(n),i.uniformMatrix2fv(this.addr,!1,B0),bn(e,n)}}function Xw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;O0.set(n),i.uniformMatrix3fv(this.addr,!1,O0),bn(e,n)}}function qw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;F0.set(n),i.uniformMatrix4fv(this.addr,!1,F0),bn(e,n)}}function Yw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function $w(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2iv(this.addr,t),bn(e,t)}}function Zw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3iv(this.addr,t),bn(e,t)}}function Jw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4iv(this.addr,t),bn(e,t)}}function Kw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function jw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2uiv(this.addr,t),bn(e,t)}}function Qw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3uiv(this.addr,t),bn(e,t)}}function t1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4uiv(this.addr,t),bn(e,t)}}function Jh(i){return i.version===0&&(i.compareFunction=uf,i.needsUpdate=!0),i}function e1(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Jh(n_):r=e_,e.setTexture2D(t||r,s)}function n1(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||r_,s)}function i1(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Jh(i_):r=o_,e.setTextureCube(t||r,s)}function s1(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||s_,s)}function r1(i){switch(i){case 5126:return zw;case 35664:return Gw;case 35665:return Vw;case 35666:return Hw;case 35674:return Ww;case 35675:return Xw;case 35676:return qw;case 5124:case 35670:return Yw;case 35667:case 35671:return $w;case 35668:case 35672:return Zw;case 35669:case 35673:return Jw;case 5125:return Kw;case 36294:return jw;case 36295:return Qw;case 36296:return t1;case 35678:case 36198:case 36298:case 36306:case 35682:return e1;case 35679:case 36299:case 36307:return n1;case 35680:case 36300:case 36308:case 36293:return i1;case 36289:case 36303:case 36311:case 36292:return s1}}function o1(i,t){i.uniform1fv(this.addr,t)}function a1(i,t){let e=Po(t,this.size,2);i.uniform2fv(this.addr,e)}function l1(i,t){let e=Po(t,this.size,3);i.uniform3fv(this.addr,e)}function c1(i,t){let e=Po(t,this.size,4);i.uniform4fv(this.addr,e)}function h1(i,t){let e=Po(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function u1(i,t){let e=Po(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function d1(i,t){let e=Po(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function f1(i,t){i.uniform1iv(this.addr,t)}function p1(i,t){i.uniform2iv(this.addr,t)}function m1(i,t){i.uniform3iv(this.addr,t)}function g1(i,t){i.uniform4iv(this.addr,t)}function _1(i,t){i.uniform1uiv(this.addr,t)}function y1(i,t){i.uniform2uiv(this.addr,t)}function x1(i,t){i.uniform3uiv(this.addr,t)}function v1(i,t){i.uniform4uiv(this.addr,t)}function S1(i,t,e){let n=this.cache,s=t.length,r=Zh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Jh(n_):o=e_;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function M1(i,t,e){let n=this.cache,s=t.length,r=Zh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||r_,r[o])}function b1(i,t,e){let n=this.cache,s=t.length,r=Zh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Jh(i_):o=o_;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function w1(i,t,e){let n=this.cache,s=t.length,r=Zh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||s_,r[o])}function T1(i){switch(i){case 5126:return o1;case 35664:return a1;case 35665:return l1;case 35666:return c1;case 35674:return h1;case 35675:return u1;case 35676:return d1;case 5124:case 35670:return f1;case 35667:case 35671:return p1;case 35668:case 35672:return m1;case 35669:case 35673:return g1;case 5125:return _1;case 36294:return y1;case 36295:return x1;case 36296:return v1;case 35678:case 36198:case 36298:case 36306:case 35682:return S1;case 35679:case 36299:case 36307:return M1;case 35680:case 36300:case 36308:case 36293:return b1;case 36289:case 36303:case 36311:case 36292:return w1}}var wf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=r1(e.type)}},Tf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=T1(e.type)}},Ef=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Mf=/(\w+)(\])?(\[|\.)?/g;function k0(i,t){i.seq.push(t),i.map[t.id]=t}function E1(i,t,e){let n=i.name,s=n.length;for(Mf.lastIndex=0;;){let r=Mf.exec(n),o=Mf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){k0(e,c===void 0?new wf(a,i,t):new Tf(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new Ef(a),k0(e,u)),e=u}}}var Ro=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);E1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function z0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var A1=37297,C1=0;function R1(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var G0=new fe;function P1(i){Ce._getMatrix(G0,Ce.workingColorSpace,i);let t=`mat3( ${G0.elements.map(e=>e.toFixed(4))} )`;switch(Ce.getTransfer(i)){case ma:return[t,"LinearTransferOETF"];case Be:return[t,"sRGBTransferOETF"];default:return te("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function V0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+R1(i.getShaderSource(t),a)}else return r}function I1(i,t){let e=P1(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var L1={[$d]:"Linear",[Zd]:"Reinhard",[Jd]:"Cineon",[Kd]:"ACESFilmic",[Qd]:"AgX",[tf]:"Neutral",[jd]:"Custom"};function D1(i,t){let e=L1[t];return e===void 0?(te("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var qh=new V;function N1(){Ce.getLuminanceCoefficients(qh);let i=qh.x.toFixed(4),t=qh.y.toFixed(4),e=qh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function U1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(il).join(`
`)}function F1(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function O1(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function il(i){return i!==""}function H0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function W0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var B1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Af(i){return i.replace(B1,k1)}function k1(i,t){let e=Se[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Af(e)}var z1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function X0(i){return i.replace(z1,G1)}function G1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function q0(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var V1={[$a]:"SHADOWMAP_TYPE_PCF",[To]:"SHADOWMAP_TYPE_VSM"};function H1(i){return V1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var W1={[Ao]:"ENVMAP_MODE_REFRACTION"};function X1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":W1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var q1={[nh]:"ENVMAP_BLENDING_MULTIPLY",[s0]:"ENVMAP_BLENDING_MIX",[r0]:"ENVMAP_BLENDING_ADD"};function Y1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":q1[i.combine]||"ENVMAP_BLENDING_NONE"}function $1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=H1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=X1(e),u=Y1(e),d=U1(e),f=F1(r),p=s.createProgram(),x,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(il).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(il).join(`
`),g.length>0&&(g+=`
`)):(x=[q0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(il).join(`
`),g=[q0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==$i?"#define TONE_MAPPING":"",e.toneMapping!==$i?Se.tonemapping_pars_fragment:"",e.toneMapping!==$i?D1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Se.colorspace_pars_fragment,I1("linearToOutputTexel",e.outputColorSpace),N1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(il).join(`
`)),o=Af(o),o=H0(o,e),o=W0(o,e),a=Af(a),a=H0(a,e),a=W0(a,e),o=X0(o),a=X0(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===df?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===df?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=m+x+o,M=m+g+a,v=z0(s,s.VERTEX_SHADER,_),C=z0(s,s.FRAGMENT_SHADER,M);s.attachShader(p,v),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(P){if(i.debug.checkShaderErrors){let R=s.getProgramInfoLog(p)||"",G=s.getShaderInfoLog(v)||"",H=s.getShaderInfoLog(C)||"",N=R.trim(),W=G.trim(),B=H.trim(),k=!0,lt=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(k=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,v,C);else{let $=V0(s,v,"vertex"),j=V0(s,C,"fragment");ce("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+$+`
`+j)}else N!==""?te("WebGLProgram: Program Info Log:",N):(W===""||B==="")&&(lt=!1);lt&&(P.diagnostics={runnable:k,programLog:N,vertexShader:{log:W,prefix:x},fragmentShader:{log:B,prefix:g}})}s.deleteShader(v),s.deleteShader(C),y=new Ro(s,p),b=O1(s,p)}let y;this.getUniforms=function(){return y===void 0&&T(this),y};let b;this.getAttributes=function(){return b===void 0&&T(this),b};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,A1)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=C1++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=C,this}var Z1=0,Cf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Rf(t),e.set(t,n)),n}},Rf=class{constructor(t){this.id=Z1++,this.code=t,this.usedTimes=0}};function J1(i){return i===Xs||i===tl||i===el}function K1(i,t,e,n,s,r){let o=new ya,a=new Cf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,b,U,P,R,G){let H=P.fog,N=R.geometry,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,B=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,k=t.get(y.envMap||W,B),lt=d[y.type],$=n.precision;y.precision!==null&&($=n.getMaxPrecision(y.precision),$!==y.precision&&te("WebGLProgram.getParameters:",y.precision,"not supported, using",$,"instead."));let j=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,et=j!==void 0?j.length:0,ft=0;N.morphAttributes.position!==void 0&&(ft=1),N.morphAttributes.normal!==void 0&&(ft=2),N.morphAttributes.color!==void 0&&(ft=3);let ht,tt,gt,xt;if(lt){let Nt=Ji[lt];ht=Nt.vertexShader,tt=Nt.fragmentShader}else{ht=y.vertexShader,tt=y.fragmentShader;let Nt=a.getVertexShaderStage(y),ge=a.getFragmentShaderStage(y);a.update(y,Nt,ge),gt=Nt.id,xt=ge.id}let Lt=i.getRenderTarget(),wt=i.state.buffers.depth.getReversed(),Vt=R.isInstancedMesh===!0,ie=R.isBatchedMesh===!0,Jt=!!y.map,se=!!y.matcap,ne=!!k,ot=ne&&k.isPMREMTexture===!0,vt=!!y.aoMap,yt=!!y.lightMap,Bt=!!y.bumpMap&&y.wireframe===!1,Dt=!!y.normalMap,ee=!!y.displacementMap,kt=!!y.emissiveMap,me=!!y.metalnessMap,de=!!y.roughnessMap,_e=y.anisotropy>0,O=y.clearcoat>0,Mt=y.diffuseRoughness>0,Xt=y.dispersion>0,he=y.retroreflectivity>0,Tt=y.iridescence>0,Fe=y.sheen>0,$t=y.transmission>0,Qt=_e&&!!y.anisotropyMap,I=O&&!!y.clearcoatMap,w=O&&!!y.clearcoatNormalMap,Y=O&&!!y.clearcoatRoughnessMap,dt=Mt&&!!y.diffuseRoughnessMap,at=Tt&&!!y.iridescenceMap,bt=Tt&&!!y.iridescenceThicknessMap,Et=Fe&&!!y.sheenColorMap,nt=Fe&&!!y.sheenRoughnessMap,st=!!y.specularMap,mt=!!y.specularColorMap,z=!!y.specularIntensityMap,rt=$t&&!!y.transmissionMap,it=$t&&!!y.thicknessMap,Rt=!!y.gradientMap,St=!!y.alphaMap,Ct=y.alphaTest>0,Kt=!!y.alphaHash,ae=!!y.extensions,ut=$i;y.toneMapped&&(Lt===null||Lt.isXRRenderTarget===!0)&&(ut=i.toneMapping);let qt=ot?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,le={shaderID:lt,shaderType:y.type,shaderName:y.name,vertexShader:ht,fragmentShader:tt,defines:y.defines,customVertexShaderID:gt,customFragmentShaderID:xt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:$,batching:ie,batchingColor:ie&&R._colorsTexture!==null,instancing:Vt,instancingColor:Vt&&R.instanceColor!==null,instancingMorph:Vt&&R.morphTexture!==null,outputColorSpace:Lt===null?i.outputColorSpace:Lt.isXRRenderTarget===!0?Lt.texture.colorSpace:Ce.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Jt,matcap:se,envMap:ne,envMapMode:ne&&k.mapping,envMapPMREM:ot,envMapMaxLod:ot?qt.length-1:null,envMapSize:ot?qt[0].width:null,aoMap:vt,lightMap:yt,bumpMap:Bt,normalMap:Dt,displacementMap:ee,emissiveMap:kt,normalMapObjectSpace:Dt&&y.normalMapType===l0,normalMapTangentSpace:Dt&&y.normalMapType===Hh,packedNormalMap:Dt&&y.normalMapType===Hh&&J1(y.normalMap.format),metalnessMap:me,roughnessMap:de,anisotropy:_e,anisotropyMap:Qt,clearcoat:O,clearcoatMap:I,clearcoatNormalMap:w,clearcoatRoughnessMap:Y,diffuseRoughness:Mt,diffuseRoughnessMap:dt,dispersion:Xt,retroreflection:he,iridescence:Tt,iridescenceMap:at,iridescenceThicknessMap:bt,sheen:Fe,sheenColorMap:Et,sheenRoughnessMap:nt,specularMap:st,specularColorMap:mt,specularIntensityMap:z,transmission:$t,transmissionMap:rt,thicknessMap:it,gradientMap:Rt,opaque:y.transparent===!1&&y.blending===Eo&&y.alphaToCoverage===!1,alphaMap:St,alphaTest:Ct,alphaHash:Kt,combine:y.combine,mapUv:Jt&&f(y.map.channel),aoMapUv:vt&&f(y.aoMap.channel),lightMapUv:yt&&f(y.lightMap.channel),bumpMapUv:Bt&&f(y.bumpMap.channel),normalMapUv:Dt&&f(y.normalMap.channel),displacementMapUv:ee&&f(y.displacementMap.channel),emissiveMapUv:kt&&f(y.emissiveMap.channel),metalnessMapUv:me&&f(y.metalnessMap.channel),roughnessMapUv:de&&f(y.roughnessMap.channel),anisotropyMapUv:Qt&&f(y.anisotropyMap.channel),clearcoatMapUv:I&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:dt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:bt&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:Et&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:nt&&f(y.sheenRoughnessMap.channel),specularMapUv:st&&f(y.specularMap.channel),specularColorMapUv:mt&&f(y.specularColorMap.channel),specularIntensityMapUv:z&&f(y.specularIntensityMap.channel),transmissionMapUv:rt&&f(y.transmissionMap.channel),thicknessMapUv:it&&f(y.thicknessMap.channel),alphaMapUv:St&&f(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Dt||_e),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:R.isPoints===!0&&!!N.attributes.uv&&(Jt||St),fog:!!H,useFog:y.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&Dt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:wt,skinning:R.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:ft,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:G.filter(Nt=>Nt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:ut,decodeVideoTexture:Jt&&y.map.isVideoTexture===!0&&Ce.getTransfer(y.map.colorSpace)===Be,decodeVideoTextureEmissive:kt&&y.emissiveMap.isVideoTexture===!0&&Ce.getTransfer(y.emissiveMap.colorSpace)===Be,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===fi,flipSided:y.side===Zn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:ae&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ae&&y.extensions.multiDraw===!0||ie)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return le.vertexUv1s=l.has(1),le.vertexUv2s=l.has(2),le.vertexUv3s=l.has(3),l.clear(),le}function x(y){let b=[];if(y.shaderID?b.push(y.shaderID):(b.push(y.customVertexShaderID),b.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)b.push(U),b.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(g(b,y),m(b,y),b.push(i.outputColorSpace)),b.push(y.customProgramCacheKey),b.join()}function g(y,b){y.push(b.precision),y.push(b.outputColorSpace),y.push(b.envMapMode),y.push(b.envMapPMREM),y.push(b.envMapMaxLod),y.push(b.envMapSize),y.push(b.mapUv),y.push(b.alphaMapUv),y.push(b.lightMapUv),y.push(b.aoMapUv),y.push(b.bumpMapUv),y.push(b.normalMapUv),y.push(b.displacementMapUv),y.push(b.emissiveMapUv),y.push(b.metalnessMapUv),y.push(b.roughnessMapUv),y.push(b.anisotropyMapUv),y.push(b.clearcoatMapUv),y.push(b.clearcoatNormalMapUv),y.push(b.clearcoatRoughnessMapUv),y.push(b.diffuseRoughnessMapUv),y.push(b.iridescenceMapUv),y.push(b.iridescenceThicknessMapUv),y.push(b.sheenColorMapUv),y.push(b.sheenRoughnessMapUv),y.push(b.specularMapUv),y.push(b.specularColorMapUv),y.push(b.specularIntensityMapUv),y.push(b.transmissionMapUv),y.push(b.thicknessMapUv),y.push(b.combine),y.push(b.fogExp2),y.push(b.sizeAttenuation),y.push(b.morphTargetsCount),y.push(b.numSunLights),y.push(b.numDirLights),y.push(b.numPointLights),y.push(b.numSpotLights),y.push(b.numSpotLightMaps),y.push(b.numHemiLights),y.push(b.numRectAreaLights),y.push(b.numSunLightShadows),y.push(b.numDirLightShadows),y.push(b.numPointLightShadows),y.push(b.numSpotLightShadows),y.push(b.numSpotLightShadowsWithMaps),y.push(b.numLightProbes),y.push(b.numLightProbeGrids),y.push(b.shadowMapType),y.push(b.toneMapping),y.push(b.numClippingPlanes),y.push(b.numClipIntersection),y.push(b.depthPacking)}function m(y,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let b=d[y.type],U;if(b){let P=Ji[b];U=A0.clone(P.uniforms)}else U=y.uniforms;return U}function M(y,b){let U=h.get(b);return U!==void 0?++U.usedTimes:(U=new $1(i,b,y,s),c.push(U),h.set(b,U)),U}function v(y){if(--y.usedTimes===0){let b=c.indexOf(y);c[b]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function C(y){a.remove(y)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:M,releaseProgram:v,releaseShaderCache:C,programs:c,dispose:T}}function j1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Q1(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Y0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function $0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,g,m){let _=i[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:m},i[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=x,_.renderOrder=d.renderOrder,_.z=g,_.group=m),t++,_}function l(d,f,p,x,g,m,_){_.reversedDepth===!0&&(g=-g);let M=a(d,f,p,x,g,m);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):e.push(M)}function c(d,f,p,x,g,m){let _=a(d,f,p,x,g,m);p.transmission>0?n.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function h(d,f){e.length>1&&e.sort(d||Q1),n.length>1&&n.sort(f||Y0),s.length>1&&s.sort(f||Y0)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function tT(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new $0,i.set(n,[o])):s>=r.length?(o=new $0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function eT(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new V,color:new oe};break;case"SpotLight":e={position:new V,direction:new V,color:new oe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new V,color:new oe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new V,skyColor:new oe,groundColor:new oe};break;case"RectAreaLight":e={color:new oe,position:new V,halfWidth:new V,halfHeight:new V};break}return i[t.id]=e,e}}}function nT(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var iT=0;function sT(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function rT(i){let t=new eT,e=nT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new V);let s=new V,r=new Ne,o=new Ne;function a(c){let h=0,u=0,d=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let f=0,p=0,x=0,g=0,m=0,_=0,M=0,v=0,C=0,T=0,y=0,b=0,U=0,P=0;c.sort(sT);for(let G=0,H=c.length;G<H;G++){let N=c[G],W=N.color,B=N.intensity,k=N.distance,lt=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Xs?lt=N.shadow.map.texture:lt=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=W.r*B,u+=W.g*B,d+=W.b*B;else if(N.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(N.sh.coefficients[$],B);P++}else if(N.isSunLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,et=e.get(N);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[p]=et,n.sunShadowMap[p]=lt;let ft=j.getViewportCount();for(let ht=0;ht<ft;ht++)n.sunShadowMatrix[x+ht]=j.getMatrix(ht),n.sunShadowCascade[x+ht]=j._cascadeData[ht];x+=ft,p++}n.sun[f]=$,f++}else if(N.isDirectionalLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,et=e.get(N);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,n.directionalShadow[g]=et,n.directionalShadowMap[g]=lt,n.directionalShadowMatrix[g]=N.shadow.matrix,C++}n.directional[g]=$,g++}else if(N.isSpotLight){let $=t.get(N);$.position.setFromMatrixPosition(N.matrixWorld),$.color.copy(W).multiplyScalar(B),$.distance=k,$.coneCos=Math.cos(N.angle),$.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),$.decay=N.decay,n.spot[_]=$;let j=N.shadow;if(N.map&&(n.spotLightMap[b]=N.map,b++,j.updateMatrices(N),N.castShadow&&U++),n.spotLightMatrix[_]=j.matrix,N.castShadow){let et=e.get(N);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,n.spotShadow[_]=et,n.spotShadowMap[_]=lt,y++}_++}else if(N.isRectAreaLight){let $=t.get(N);$.color.copy(W).multiplyScalar(B),$.halfWidth.set(N.width*.5,0,0),$.halfHeight.set(0,N.height*.5,0),n.rectArea[M]=$,M++}else if(N.isPointLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),$.distance=N.distance,$.decay=N.decay,N.castShadow){let j=N.shadow,et=e.get(N);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,et.shadowCameraNear=j.camera.near,et.shadowCameraFar=j.camera.far,n.pointShadow[m]=et,n.pointShadowMap[m]=lt,n.pointShadowMatrix[m]=N.shadow.matrix,T++}n.point[m]=$,m++}else if(N.isHemisphereLight){let $=t.get(N);$.skyColor.copy(N.color).multiplyScalar(B),$.groundColor.copy(N.groundColor).multiplyScalar(B),n.hemi[v]=$,v++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ot.LTC_FLOAT_1,n.rectAreaLTC2=Ot.LTC_FLOAT_2):(n.rectAreaLTC1=Ot.LTC_HALF_1,n.rectAreaLTC2=Ot.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let R=n.hash;(R.sunLength!==f||R.directionalLength!==g||R.pointLength!==m||R.spotLength!==_||R.rectAreaLength!==M||R.hemiLength!==v||R.numSunShadows!==p||R.numDirectionalShadows!==C||R.numPointShadows!==T||R.numSpotShadows!==y||R.numSpotMaps!==b||R.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=g,n.spot.length=_,n.rectArea.length=M,n.point.length=m,n.hemi.length=v,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+b-U,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=P,R.sunLength=f,R.directionalLength=g,R.pointLength=m,R.spotLength=_,R.rectAreaLength=M,R.hemiLength=v,R.numSunShadows=p,R.numDirectionalShadows=C,R.numPointShadows=T,R.numSpotShadows=y,R.numSpotMaps=b,R.numLightProbes=P,n.version=iT++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,g=0,m=h.matrixWorldInverse;for(let _=0,M=c.length;_<M;_++){let v=c[_];if(v.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(m),u++}else if(v.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),d++}else if(v.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),p++}else if(v.isRectAreaLight){let C=n.rectArea[x];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(v.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(v.width*.5,0,0),C.halfHeight.set(0,v.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),x++}else if(v.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(m),f++}else if(v.isHemisphereLight){let C=n.hemi[g];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function Z0(i){let t=new rT(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function oT(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Z0(i),t.set(s,[a])):r>=o.length?(a=new Z0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var aT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,lT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,cT=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],hT=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],J0=new Ne,nl=new V,bf=new V;function uT(i,t,e){let n=new Os,s=new _t,r=new _t,o=new Qe,a=new Vc,l=new Hc,c={},h=e.maxTextureSize,u={[Ws]:Zn,[Zn]:Ws,[fi]:fi},d=new Yi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new _t},radius:{value:4}},vertexShader:aT,fragmentShader:lT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new gn;p.setAttribute("position",new Pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Sn(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=$a;let m=this.type;this.render=function(T,y,b){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===kg&&(te("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=$a);let U=i.getRenderTarget(),P=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),G=i.state;G.setBlending(gr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let H=m!==this.type;H&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=T.length;N<W;N++){let B=T[N],k=B.shadow;if(k===void 0){te("WebGLShadowMap:",B,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let lt=k.getFrameExtents();s.multiply(lt),r.copy(k.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/lt.x),s.x=r.x*lt.x,k.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/lt.y),s.y=r.y*lt.y,k.mapSize.y=r.y));let $=i.state.buffers.depth.getReversed();if(k.camera._reversedDepth=$,k.map===null||H===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===To){if(B.isPointLight){te("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new hi(s.x,s.y,{format:Xs,type:Di,minFilter:$n,magFilter:$n,generateMipmaps:!1}),k.map.texture.name=B.name+".shadowMap",k.map.depthTexture=new gs(s.x,s.y,vi),k.map.depthTexture.name=B.name+".shadowMapDepth",k.map.depthTexture.format=ds,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=In,k.map.depthTexture.magFilter=In}else B.isPointLight?(k.map=new sl(s.x),k.map.depthTexture=new Aa(s.x,Li)):(k.map=new hi(s.x,s.y),k.map.depthTexture=new gs(s.x,s.y,Li)),k.map.depthTexture.name=B.name+".shadowMap",k.map.depthTexture.format=ds,this.type===$a?(k.map.depthTexture.compareFunction=$?hf:cf,k.map.depthTexture.minFilter=$n,k.map.depthTexture.magFilter=$n):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=In,k.map.depthTexture.magFilter=In);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let j=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();B.isPointLight!==!0&&k.updateMatrices(B,b);let et=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:b.layers;for(let ft=0;ft<j;ft++){let ht=k.getCamera(ft);if(B.isPointLight){let tt=k.camera,gt=k.matrix,xt=B.distance||tt.far;xt!==tt.far&&(tt.far=xt,tt.updateProjectionMatrix()),nl.setFromMatrixPosition(B.matrixWorld),tt.position.copy(nl),bf.copy(tt.position),bf.add(cT[ft]),tt.up.copy(hT[ft]),tt.lookAt(bf),tt.updateMatrixWorld(),gt.makeTranslation(-nl.x,-nl.y,-nl.z),J0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),k._frustum.setFromProjectionMatrix(J0,tt.coordinateSystem,tt.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)i.setRenderTarget(k.map,ft),i.clear();else{ft===0&&(i.setRenderTarget(k.map),i.clear());let tt=k.getViewport(ft);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),G.viewport(o)}n=k.getFrustum(ft),v(y,b,ht,B,et,this.type)}k.isPointLightShadow!==!0&&this.type===To&&_(k,b),k.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(U,P,R)};function _(T,y){let b=t.update(x);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new hi(s.x,s.y,{format:Xs,type:Di}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(y,null,b,d,x,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(y,null,b,f,x,null)}function M(T,y,b,U){let P=null,R=b.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(R!==void 0)P=R;else if(P=b.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let G=P.uuid,H=y.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let W=N[H];W===void 0&&(W=P.clone(),N[H]=W,y.addEventListener("dispose",C)),P=W}if(P.visible=y.visible,P.wireframe=y.wireframe,U===To?P.side=y.shadowSide!==null?y.shadowSide:y.side:P.side=y.shadowSide!==null?y.shadowSide:u[y.side],P.alphaMap=y.alphaMap,P.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,P.map=y.map,P.clipShadows=y.clipShadows,P.clippingPlanes=y.clippingPlanes,P.clipIntersection=y.clipIntersection,P.displacementMap=y.displacementMap,P.displacementScale=y.displacementScale,P.displacementBias=y.displacementBias,P.wireframeLinewidth=y.wireframeLinewidth,P.linewidth=y.linewidth,b.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let G=i.properties.get(P);G.light=b}return P}function v(T,y,b,U,P,R){if(T.visible===!1)return;if(T.layers.test(P)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&R===To)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,T.matrixWorld);let N=t.update(T),W=T.material;if(Array.isArray(W)){let B=N.groups;for(let k=0,lt=B.length;k<lt;k++){let $=B[k],j=W[$.materialIndex];if(j&&j.visible){let et=M(T,j,U,R);T.onBeforeShadow(i,T,y,b,N,et,$),i.renderBufferDirect(b,null,N,et,T,$),T.onAfterShadow(i,T,y,b,N,et,$)}}}else if(W.visible){let B=M(T,W,U,R);T.onBeforeShadow(i,T,y,b,N,B,null),i.renderBufferDirect(b,null,N,B,T,null),T.onAfterShadow(i,T,y,b,N,B,null)}}let H=T.children;for(let N=0,W=H.length;N<W;N++)v(H[N],y,b,U,P,R)}function C(T){T.target.removeEventListener("dispose",C);for(let b in c){let U=c[b],P=T.target.uuid;P in U&&(U[P].dispose(),delete U[P])}}}function dT(i,t){function e(){let z=!1,rt=new Qe,it=null,Rt=new Qe(0,0,0,0);return{setMask:function(St){it!==St&&!z&&(i.colorMask(St,St,St,St),it=St)},setLocked:function(St){z=St},setClear:function(St,Ct,Kt,ae,ut){ut===!0&&(St*=ae,Ct*=ae,Kt*=ae),rt.set(St,Ct,Kt,ae),Rt.equals(rt)===!1&&(i.clearColor(St,Ct,Kt,ae),Rt.copy(rt))},reset:function(){z=!1,it=null,Rt.set(-1,0,0,0)}}}function n(){let z=!1,rt=!1,it=null,Rt=null,St=null;return{setReversed:function(Ct){if(rt!==Ct){let Kt=t.get("EXT_clip_control");Ct?Kt.clipControlEXT(Kt.LOWER_LEFT_EXT,Kt.ZERO_TO_ONE_EXT):Kt.clipControlEXT(Kt.LOWER_LEFT_EXT,Kt.NEGATIVE_ONE_TO_ONE_EXT),rt=Ct;let ae=St;St=null,this.setClear(ae)}},getReversed:function(){return rt},setTest:function(Ct){Ct?wt(i.DEPTH_TEST):Vt(i.DEPTH_TEST)},setMask:function(Ct){it!==Ct&&!z&&(i.depthMask(Ct),it=Ct)},setFunc:function(Ct){if(rt&&(Ct=x0[Ct]),Rt!==Ct){switch(Ct){case yc:i.depthFunc(i.NEVER);break;case xc:i.depthFunc(i.ALWAYS);break;case vc:i.depthFunc(i.LESS);break;case ho:i.depthFunc(i.LEQUAL);break;case Sc:i.depthFunc(i.EQUAL);break;case Mc:i.depthFunc(i.GEQUAL);break;case bc:i.depthFunc(i.GREATER);break;case wc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Rt=Ct}},setLocked:function(Ct){z=Ct},setClear:function(Ct){St!==Ct&&(St=Ct,rt&&(Ct=1-Ct),i.clearDepth(Ct))},reset:function(){z=!1,it=null,Rt=null,St=null,rt=!1}}}function s(){let z=!1,rt=null,it=null,Rt=null,St=null,Ct=null,Kt=null,ae=null,ut=null;return{setTest:function(qt){z||(qt?wt(i.STENCIL_TEST):Vt(i.STENCIL_TEST))},setMask:function(qt){rt!==qt&&!z&&(i.stencilMask(qt),rt=qt)},setFunc:function(qt,le,Nt){(it!==qt||Rt!==le||St!==Nt)&&(i.stencilFunc(qt,le,Nt),it=qt,Rt=le,St=Nt)},setOp:function(qt,le,Nt){(Ct!==qt||Kt!==le||ae!==Nt)&&(i.stencilOp(qt,le,Nt),Ct=qt,Kt=le,ae=Nt)},setLocked:function(qt){z=qt},setClear:function(qt){ut!==qt&&(i.clearStencil(qt),ut=qt)},reset:function(){z=!1,rt=null,it=null,Rt=null,St=null,Ct=null,Kt=null,ae=null,ut=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,g=!1,m=null,_=null,M=null,v=null,C=null,T=null,y=null,b=new oe(0,0,0),U=0,P=!1,R=null,G=null,H=null,N=null,W=null,B=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,lt=0,$=i.getParameter(i.VERSION);$.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec($)[1]),k=lt>=1):$.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),k=lt>=2);let j=null,et={},ft=i.getParameter(i.SCISSOR_BOX),ht=i.getParameter(i.VIEWPORT),tt=new Qe().fromArray(ft),gt=new Qe().fromArray(ht);function xt(z,rt,it,Rt){let St=new Uint8Array(4),Ct=i.createTexture();i.bindTexture(z,Ct),i.texParameteri(z,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(z,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Kt=0;Kt<it;Kt++)z===i.TEXTURE_3D||z===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,Rt,0,i.RGBA,i.UNSIGNED_BYTE,St):i.texImage2D(rt+Kt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,St);return Ct}let Lt={};Lt[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),Lt[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Lt[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(i.DEPTH_TEST),o.setFunc(ho),Bt(!1),Dt(Vd),wt(i.CULL_FACE),vt(gr);function wt(z){h[z]!==!0&&(i.enable(z),h[z]=!0)}function Vt(z){h[z]!==!1&&(i.disable(z),h[z]=!1)}function ie(z,rt){return d[z]!==rt?(i.bindFramebuffer(z,rt),d[z]=rt,z===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=rt),z===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Jt(z,rt){let it=p,Rt=!1;if(z){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let St=z.textures;if(it.length!==St.length||it[0]!==i.COLOR_ATTACHMENT0){for(let Ct=0,Kt=St.length;Ct<Kt;Ct++)it[Ct]=i.COLOR_ATTACHMENT0+Ct;it.length=St.length,Rt=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,Rt=!0);Rt&&i.drawBuffers(it)}function se(z){return x!==z?(i.useProgram(z),x=z,!0):!1}let ne={[_r]:i.FUNC_ADD,[Gg]:i.FUNC_SUBTRACT,[Vg]:i.FUNC_REVERSE_SUBTRACT};ne[Hg]=i.MIN,ne[Wg]=i.MAX;let ot={[Xg]:i.ZERO,[qg]:i.ONE,[Yg]:i.SRC_COLOR,[qd]:i.SRC_ALPHA,[Qg]:i.SRC_ALPHA_SATURATE,[Kg]:i.DST_COLOR,[Zg]:i.DST_ALPHA,[$g]:i.ONE_MINUS_SRC_COLOR,[Yd]:i.ONE_MINUS_SRC_ALPHA,[jg]:i.ONE_MINUS_DST_COLOR,[Jg]:i.ONE_MINUS_DST_ALPHA,[t0]:i.CONSTANT_COLOR,[e0]:i.ONE_MINUS_CONSTANT_COLOR,[n0]:i.CONSTANT_ALPHA,[i0]:i.ONE_MINUS_CONSTANT_ALPHA};function vt(z,rt,it,Rt,St,Ct,Kt,ae,ut,qt){if(z===gr){g===!0&&(Vt(i.BLEND),g=!1);return}if(g===!1&&(wt(i.BLEND),g=!0),z!==zg){if(z!==m||qt!==P){if((_!==_r||C!==_r)&&(i.blendEquation(i.FUNC_ADD),_=_r,C=_r),qt)switch(z){case Eo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Hd:i.blendFunc(i.ONE,i.ONE);break;case Wd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Xd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ce("WebGLState: Invalid blending: ",z);break}else switch(z){case Eo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Hd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Wd:ce("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Xd:ce("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ce("WebGLState: Invalid blending: ",z);break}M=null,v=null,T=null,y=null,b.set(0,0,0),U=0,m=z,P=qt}return}St=St||rt,Ct=Ct||it,Kt=Kt||Rt,(rt!==_||St!==C)&&(i.blendEquationSeparate(ne[rt],ne[St]),_=rt,C=St),(it!==M||Rt!==v||Ct!==T||Kt!==y)&&(i.blendFuncSeparate(ot[it],ot[Rt],ot[Ct],ot[Kt]),M=it,v=Rt,T=Ct,y=Kt),(ae.equals(b)===!1||ut!==U)&&(i.blendColor(ae.r,ae.g,ae.b,ut),b.copy(ae),U=ut),m=z,P=!1}function yt(z,rt){z.side===fi?Vt(i.CULL_FACE):wt(i.CULL_FACE);let it=z.side===Zn;rt&&(it=!it),Bt(it),z.blending===Eo&&z.transparent===!1?vt(gr):vt(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Rt=z.stencilWrite;a.setTest(Rt),Rt&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),kt(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?wt(i.SAMPLE_ALPHA_TO_COVERAGE):Vt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Bt(z){R!==z&&(z?i.frontFace(i.CW):i.frontFace(i.CCW),R=z)}function Dt(z){z!==Og?(wt(i.CULL_FACE),z!==G&&(z===Vd?i.cullFace(i.BACK):z===Bg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Vt(i.CULL_FACE),G=z}function ee(z){z!==H&&(k&&i.lineWidth(z),H=z)}function kt(z,rt,it){z?(wt(i.POLYGON_OFFSET_FILL),(N!==rt||W!==it)&&(N=rt,W=it,o.getReversed()&&(rt=-rt,it=-it),i.polygonOffset(rt,it))):Vt(i.POLYGON_OFFSET_FILL)}function me(z){z?wt(i.SCISSOR_TEST):Vt(i.SCISSOR_TEST)}function de(z){z===void 0&&(z=i.TEXTURE0+B-1),j!==z&&(i.activeTexture(z),j=z)}function _e(z,rt,it){it===void 0&&(j===null?it=i.TEXTURE0+B-1:it=j);let Rt=et[it];Rt===void 0&&(Rt={type:void 0,texture:void 0},et[it]=Rt),(Rt.type!==z||Rt.texture!==rt)&&(j!==it&&(i.activeTexture(it),j=it),i.bindTexture(z,rt||Lt[z]),Rt.type=z,Rt.texture=rt)}function O(){let z=et[j];z!==void 0&&z.type!==void 0&&(i.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Mt(){try{i.compressedTexImage2D(...arguments)}catch(z){ce("WebGLState:",z)}}function Xt(){try{i.compressedTexImage3D(...arguments)}catch(z){ce("WebGLState:",z)}}function he(){try{i.texSubImage2D(...arguments)}catch(z){ce("WebGLState:",z)}}function Tt(){try{i.texSubImage3D(...arguments)}catch(z){ce("WebGLState:",z)}}function Fe(){try{i.compressedTexSubImage2D(...arguments)}catch(z){ce("WebGLState:",z)}}function $t(){try{i.compressedTexSubImage3D(...arguments)}catch(z){ce("WebGLState:",z)}}function Qt(){try{i.texStorage2D(...arguments)}catch(z){ce("WebGLState:",z)}}function I(){try{i.texStorage3D(...arguments)}catch(z){ce("WebGLState:",z)}}function w(){try{i.texImage2D(...arguments)}catch(z){ce("WebGLState:",z)}}function Y(){try{i.texImage3D(...arguments)}catch(z){ce("WebGLState:",z)}}function dt(z){return u[z]!==void 0?u[z]:i.getParameter(z)}function at(z,rt){u[z]!==rt&&(i.pixelStorei(z,rt),u[z]=rt)}function bt(z){tt.equals(z)===!1&&(i.scissor(z.x,z.y,z.z,z.w),tt.copy(z))}function Et(z){gt.equals(z)===!1&&(i.viewport(z.x,z.y,z.z,z.w),gt.copy(z))}function nt(z,rt){let it=c.get(rt);it===void 0&&(it=new WeakMap,c.set(rt,it));let Rt=it.get(z);Rt===void 0&&(Rt=i.getUniformBlockIndex(rt,z.name),i.uniformBlockBinding(rt,Rt,Rt),it.set(z,Rt))}function st(z,rt,it){let St=c.get(rt).get(z);l[St]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,St,it),l[St]=it)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,et={},d={},l={},f=new WeakMap,p=[],x=null,g=!1,m=null,_=null,M=null,v=null,C=null,T=null,y=null,b=new oe(0,0,0),U=0,P=!1,R=null,G=null,H=null,N=null,W=null,tt.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:Vt,bindFramebuffer:ie,drawBuffers:Jt,useProgram:se,setBlending:vt,setMaterial:yt,setFlipSided:Bt,setCullFace:Dt,setLineWidth:ee,setPolygonOffset:kt,setScissorTest:me,activeTexture:de,bindTexture:_e,unbindTexture:O,compressedTexImage2D:Mt,compressedTexImage3D:Xt,texImage2D:w,texImage3D:Y,pixelStorei:at,getParameter:dt,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Qt,texStorage3D:I,texSubImage2D:he,texSubImage3D:Tt,compressedTexSubImage2D:Fe,compressedTexSubImage3D:$t,scissor:bt,viewport:Et,reset:mt}}function fT(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new _t,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(I=>p.delete(I)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(I,w){return g?new OffscreenCanvas(I,w):ga("canvas")}function _(I,w,Y){let dt=1,at=Qt(I);if((at.width>Y||at.height>Y)&&(dt=Y/Math.max(at.width,at.height)),dt<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let bt=Math.floor(dt*at.width),Et=Math.floor(dt*at.height);d===void 0&&(d=m(bt,Et));let nt=w?m(bt,Et):d;return nt.width=bt,nt.height=Et,nt.getContext("2d").drawImage(I,0,0,bt,Et),te("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+bt+"x"+Et+")."),nt}else return"data"in I&&te("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),I;return I}function M(I){return I.generateMipmaps}function v(I){i.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(I,w,Y,dt,at,bt=!1){if(I!==null){if(i[I]!==void 0)return i[I];te("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let Et;dt&&(Et=t.get("EXT_texture_norm16"),Et||te("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=w;if(w===i.RED&&(Y===i.FLOAT&&(nt=i.R32F),Y===i.HALF_FLOAT&&(nt=i.R16F),Y===i.UNSIGNED_BYTE&&(nt=i.R8),Y===i.UNSIGNED_SHORT&&Et&&(nt=Et.R16_EXT),Y===i.SHORT&&Et&&(nt=Et.R16_SNORM_EXT)),w===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.R8UI),Y===i.UNSIGNED_SHORT&&(nt=i.R16UI),Y===i.UNSIGNED_INT&&(nt=i.R32UI),Y===i.BYTE&&(nt=i.R8I),Y===i.SHORT&&(nt=i.R16I),Y===i.INT&&(nt=i.R32I)),w===i.RG&&(Y===i.FLOAT&&(nt=i.RG32F),Y===i.HALF_FLOAT&&(nt=i.RG16F),Y===i.UNSIGNED_BYTE&&(nt=i.RG8),Y===i.UNSIGNED_SHORT&&Et&&(nt=Et.RG16_EXT),Y===i.SHORT&&Et&&(nt=Et.RG16_SNORM_EXT)),w===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RG8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RG16UI),Y===i.UNSIGNED_INT&&(nt=i.RG32UI),Y===i.BYTE&&(nt=i.RG8I),Y===i.SHORT&&(nt=i.RG16I),Y===i.INT&&(nt=i.RG32I)),w===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),Y===i.UNSIGNED_INT&&(nt=i.RGB32UI),Y===i.BYTE&&(nt=i.RGB8I),Y===i.SHORT&&(nt=i.RGB16I),Y===i.INT&&(nt=i.RGB32I)),w===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),Y===i.UNSIGNED_INT&&(nt=i.RGBA32UI),Y===i.BYTE&&(nt=i.RGBA8I),Y===i.SHORT&&(nt=i.RGBA16I),Y===i.INT&&(nt=i.RGBA32I)),w===i.RGB&&(Y===i.UNSIGNED_SHORT&&Et&&(nt=Et.RGB16_EXT),Y===i.SHORT&&Et&&(nt=Et.RGB16_SNORM_EXT),Y===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),Y===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),w===i.RGBA){let st=bt?ma:Ce.getTransfer(at);Y===i.FLOAT&&(nt=i.RGBA32F),Y===i.HALF_FLOAT&&(nt=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(nt=st===Be?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT&&Et&&(nt=Et.RGBA16_EXT),Y===i.SHORT&&Et&&(nt=Et.RGBA16_SNORM_EXT),Y===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function y(I,w){let Y;return I?w===null||w===Li||w===xr?Y=i.DEPTH24_STENCIL8:w===vi?Y=i.DEPTH32F_STENCIL8:w===Co&&(Y=i.DEPTH24_STENCIL8,te("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Li||w===xr?Y=i.DEPTH_COMPONENT24:w===vi?Y=i.DEPTH_COMPONENT32F:w===Co&&(Y=i.DEPTH_COMPONENT16),Y}function b(I,w){return M(I)===!0||I.isFramebufferTexture&&I.minFilter!==In&&I.minFilter!==$n?Math.log2(Math.max(w.width,w.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?w.mipmaps.length:1}function U(I){let w=new WeakRef(I);n.get(I).__ref=w,p.add(w),x.register(I,w,w)}function P(I){let w=n.get(I).__ref;w!==void 0&&(p.delete(w),x.unregister(w))}function R(I){H(I.target)}function G(I){N(I.target)}function H(I){I.removeEventListener("dispose",R),P(I),B(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&u.delete(I)}function N(I){I.removeEventListener("dispose",G),P(I),lt(I)}function W(){for(let I of p){let w=I.deref();w!==void 0&&(w.isRenderTarget===!0?N(w):H(w))}p.clear(),u.clear()}function B(I){let w=n.get(I);if(w.__webglInit===void 0)return;let Y=I.source,dt=f.get(Y);if(dt){let at=dt[w.__cacheKey];at.usedTimes--,at.usedTimes===0&&k(I),Object.keys(dt).length===0&&f.delete(Y)}n.remove(I)}function k(I){let w=n.get(I);i.deleteTexture(w.__webglTexture);let Y=I.source,dt=f.get(Y);delete dt[w.__cacheKey],o.memory.textures--}function lt(I){let w=n.get(I);w.__depthDisposeCallback&&w.__depthDisposeCallback();let Y=I.depthTexture;if(Y&&Y.renderTarget===I&&H(Y),I.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(w.__webglFramebuffer[at]))for(let bt=0;bt<w.__webglFramebuffer[at].length;bt++)i.deleteFramebuffer(w.__webglFramebuffer[at][bt]);else i.deleteFramebuffer(w.__webglFramebuffer[at]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[at])}else{if(Array.isArray(w.__webglFramebuffer))for(let at=0;at<w.__webglFramebuffer.length;at++)i.deleteFramebuffer(w.__webglFramebuffer[at]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let at=0;at<w.__webglColorRenderbuffer.length;at++)w.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[at]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let dt=I.textures;for(let at=0,bt=dt.length;at<bt;at++){let Et=n.get(dt[at]);Et.__webglTexture&&(i.deleteTexture(Et.__webglTexture),o.memory.textures--),n.remove(dt[at])}n.remove(I)}let $=0;function j(){$=0}function et(){return $}function ft(I){$=I}function ht(){let I=$;return I>=s.maxTextures&&te("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,I}function tt(I){let w=[];return w.push(I.wrapS),w.push(I.wrapT),w.push(I.wrapR||0),w.push(I.magFilter),w.push(I.minFilter),w.push(I.anisotropy),w.push(I.internalFormat),w.push(I.format),w.push(I.type),w.push(I.generateMipmaps),w.push(I.mipmapsAutoUpdate),w.push(I.premultiplyAlpha),w.push(I.flipY),w.push(I.unpackAlignment),w.push(I.colorSpace),w.join()}function gt(I,w){let Y=n.get(I);if(I.isVideoTexture&&Fe(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&Y.__version!==I.version){let dt=I.image;if(dt===null)te("WebGLRenderer: Texture marked for update but no image data found.");else if(dt.complete===!1)te("WebGLRenderer: Texture marked for update but image is incomplete");else{yt(Y,I,w);return}}else I.isExternalTexture&&(Y.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+w)}function xt(I,w){let Y=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&Y.__version!==I.version){yt(Y,I,w);return}else I.isExternalTexture&&(Y.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+w)}function Lt(I,w){let Y=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&Y.__version!==I.version){yt(Y,I,w);return}e.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+w)}function wt(I,w){let Y=n.get(I);if(I.version>0&&Y.__version!==I.version){Bt(Y,I,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+w)}let Vt={[Tc]:i.REPEAT,[Wi]:i.CLAMP_TO_EDGE,[Ec]:i.MIRRORED_REPEAT},ie={[In]:i.NEAREST,[o0]:i.NEAREST_MIPMAP_NEAREST,[Za]:i.NEAREST_MIPMAP_LINEAR,[$n]:i.LINEAR,[rh]:i.LINEAR_MIPMAP_NEAREST,[_s]:i.LINEAR_MIPMAP_LINEAR},Jt={[h0]:i.NEVER,[uf]:i.ALWAYS,[u0]:i.LESS,[cf]:i.LEQUAL,[d0]:i.EQUAL,[hf]:i.GEQUAL,[f0]:i.GREATER,[p0]:i.NOTEQUAL};function se(I,w){if(w.type===vi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===$n||w.magFilter===rh||w.magFilter===Za||w.magFilter===_s||w.minFilter===$n||w.minFilter===rh||w.minFilter===Za||w.minFilter===_s)&&te("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,Vt[w.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,Vt[w.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,Vt[w.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,ie[w.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,ie[w.minFilter]),w.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Jt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===In||w.minFilter!==Za&&w.minFilter!==_s||w.type===vi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");i.texParameterf(I,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function ne(I,w){let Y=!1;I.__webglInit===void 0&&(I.__webglInit=!0,w.addEventListener("dispose",R),U(w));let dt=w.source,at=f.get(dt);at===void 0&&(at={},f.set(dt,at));let bt=tt(w);if(bt!==I.__cacheKey){at[bt]===void 0&&(at[bt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),at[bt].usedTimes++;let Et=at[I.__cacheKey];Et!==void 0&&(at[I.__cacheKey].usedTimes--,Et.usedTimes===0&&k(w)),I.__cacheKey=bt,I.__webglTexture=at[bt].texture}return Y}function ot(I,w,Y){return Math.floor(Math.floor(I/Y)/w)}function vt(I,w,Y,dt){let bt=I.updateRanges;if(bt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,Y,dt,w.data);else{bt.sort((z,rt)=>z.start-rt.start);let Et=0;for(let z=1;z<bt.length;z++){let rt=bt[Et],it=bt[z],Rt=rt.start+rt.count,St=ot(it.start,w.width,4),Ct=ot(rt.start,w.width,4);it.start<=Rt+1&&St===Ct&&ot(it.start+it.count-1,w.width,4)===St?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++Et,bt[Et]=it)}bt.length=Et+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let z=0,rt=bt.length;z<rt;z++){let it=bt[z],Rt=Math.floor(it.start/4),St=Math.ceil(it.count/4),Ct=Rt%w.width,Kt=Math.floor(Rt/w.width),ae=St,ut=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,Ct),e.pixelStorei(i.UNPACK_SKIP_ROWS,Kt),e.texSubImage2D(i.TEXTURE_2D,0,Ct,Kt,ae,ut,Y,dt,w.data)}I.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function yt(I,w,Y){let dt=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(dt=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(dt=i.TEXTURE_3D);let at=ne(I,w),bt=w.source;e.bindTexture(dt,I.__webglTexture,i.TEXTURE0+Y);let Et=n.get(bt);if(bt.version!==Et.__version||at===!0){if(e.activeTexture(i.TEXTURE0+Y),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ut=Ce.getPrimaries(Ce.workingColorSpace),qt=w.colorSpace===xs?null:Ce.getPrimaries(w.colorSpace),le=w.colorSpace===xs||ut===qt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,le)}e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let st=_(w.image,!1,s.maxTextureSize);st=$t(w,st);let mt=r.convert(w.format,w.colorSpace),z=r.convert(w.type),rt=T(w.internalFormat,mt,z,w.normalized,w.colorSpace,w.isVideoTexture);se(dt,w);let it,Rt=w.mipmaps,St=w.isVideoTexture!==!0,Ct=Et.__version===void 0||at===!0,Kt=bt.dataReady,ae=b(w,st);if(w.isDepthTexture)rt=y(w.format===ys,w.type),Ct&&(St?e.texStorage2D(i.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,mt,z,null));else if(w.isDataTexture)if(Rt.length>0){St&&Ct&&e.texStorage2D(i.TEXTURE_2D,ae,rt,Rt[0].width,Rt[0].height);for(let ut=0,qt=Rt.length;ut<qt;ut++)it=Rt[ut],St?Kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,z,it.data):e.texImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,mt,z,it.data);w.generateMipmaps=!1}else St?(Ct&&e.texStorage2D(i.TEXTURE_2D,ae,rt,st.width,st.height),Kt&&vt(w,st,mt,z)):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,mt,z,st.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){St&&Ct&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ae,rt,Rt[0].width,Rt[0].height,st.depth);for(let ut=0,qt=Rt.length;ut<qt;ut++)if(it=Rt[ut],w.format!==Ni)if(mt!==null)if(St){if(Kt)if(w.layerUpdates.size>0){let le=Sf(it.width,it.height,w.format,w.type);for(let Nt of w.layerUpdates){let ge=it.data.subarray(Nt*le/it.data.BYTES_PER_ELEMENT,(Nt+1)*le/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,Nt,it.width,it.height,1,mt,ge)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,mt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ut,rt,it.width,it.height,st.depth,0,it.data,0,0);else te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else St?Kt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,mt,z,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ut,rt,it.width,it.height,st.depth,0,mt,z,it.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{St&&Ct&&e.texStorage2D(i.TEXTURE_2D,ae,rt,Rt[0].width,Rt[0].height);for(let ut=0,qt=Rt.length;ut<qt;ut++)it=Rt[ut],w.format!==Ni?mt!==null?St?Kt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,it.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):St?Kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,z,it.data):e.texImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,mt,z,it.data)}else if(w.isDataArrayTexture)if(St){if(Ct&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ae,rt,st.width,st.height,st.depth),Kt)if(w.layerUpdates.size>0){let ut=Sf(st.width,st.height,w.format,w.type);for(let qt of w.layerUpdates){let le=st.data.subarray(qt*ut/st.data.BYTES_PER_ELEMENT,(qt+1)*ut/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,qt,st.width,st.height,1,mt,z,le)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,z,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,z,st.data);else if(w.isData3DTexture)St?(Ct&&e.texStorage3D(i.TEXTURE_3D,ae,rt,st.width,st.height,st.depth),Kt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,z,st.data)):e.texImage3D(i.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,z,st.data);else if(w.isFramebufferTexture){if(Ct)if(St)e.texStorage2D(i.TEXTURE_2D,ae,rt,st.width,st.height);else{let ut=st.width,qt=st.height;for(let le=0;le<ae;le++)e.texImage2D(i.TEXTURE_2D,le,rt,ut,qt,0,mt,z,null),ut>>=1,qt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let ut=i.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),st.parentNode!==ut){ut.appendChild(st),u.add(w),ut.onpaint=qt=>{let le=qt.changedElements;for(let Nt of u)le.includes(Nt.image)&&(Nt.needsUpdate=!0)},ut.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let le=i.RGBA,Nt=i.RGBA,ge=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,le,Nt,ge,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Rt.length>0){if(St&&Ct){let ut=Qt(Rt[0]);e.texStorage2D(i.TEXTURE_2D,ae,rt,ut.width,ut.height)}for(let ut=0,qt=Rt.length;ut<qt;ut++)it=Rt[ut],St?Kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,mt,z,it):e.texImage2D(i.TEXTURE_2D,ut,rt,mt,z,it);w.generateMipmaps=!1}else if(St){if(Ct){let ut=Qt(st);e.texStorage2D(i.TEXTURE_2D,ae,rt,ut.width,ut.height)}Kt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,z,st)}else e.texImage2D(i.TEXTURE_2D,0,rt,mt,z,st);M(w)&&w.mipmapsAutoUpdate===!0&&v(dt),Et.__version=bt.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function Bt(I,w,Y){if(w.image.length!==6)return;let dt=ne(I,w),at=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+Y);let bt=n.get(at);if(at.version!==bt.__version||dt===!0){e.activeTexture(i.TEXTURE0+Y);let Et=Ce.getPrimaries(Ce.workingColorSpace),nt=w.colorSpace===xs?null:Ce.getPrimaries(w.colorSpace),st=w.colorSpace===xs||Et===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=w.isCompressedTexture||w.image[0].isCompressedTexture,z=w.image[0]&&w.image[0].isDataTexture,rt=[];for(let Nt=0;Nt<6;Nt++)!mt&&!z?rt[Nt]=_(w.image[Nt],!0,s.maxCubemapSize):rt[Nt]=z?w.image[Nt].image:w.image[Nt],rt[Nt]=$t(w,rt[Nt]);let it=rt[0],Rt=r.convert(w.format,w.colorSpace),St=r.convert(w.type),Ct=T(w.internalFormat,Rt,St,w.normalized,w.colorSpace),Kt=w.isVideoTexture!==!0,ae=bt.__version===void 0||dt===!0,ut=at.dataReady,qt=b(w,it);se(i.TEXTURE_CUBE_MAP,w);let le;if(w.isDepthTexture){if(Ct=y(w.format===ys,w.type),ae)if(Kt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ct,it.width,it.height);else for(let Nt=0;Nt<6;Nt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Ct,it.width,it.height,0,Rt,St,null)}else if(mt){Kt&&ae&&e.texStorage2D(i.TEXTURE_CUBE_MAP,qt,Ct,it.width,it.height);for(let Nt=0;Nt<6;Nt++){le=rt[Nt].mipmaps;for(let ge=0;ge<le.length;ge++){let qe=le[ge];w.format!==Ni?Rt!==null?Kt?ut&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge,0,0,qe.width,qe.height,Rt,qe.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge,Ct,qe.width,qe.height,0,qe.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge,0,0,qe.width,qe.height,Rt,St,qe.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge,Ct,qe.width,qe.height,0,Rt,St,qe.data)}}}else{if(le=w.mipmaps,Kt&&ae){le.length>0&&qt++;let Nt=Qt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,qt,Ct,Nt.width,Nt.height)}for(let Nt=0;Nt<6;Nt++)if(z){Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,0,0,rt[Nt].width,rt[Nt].height,Rt,St,rt[Nt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Ct,rt[Nt].width,rt[Nt].height,0,Rt,St,rt[Nt].data);for(let ge=0;ge<le.length;ge++){let zn=le[ge].image[Nt].image;Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge+1,0,0,zn.width,zn.height,Rt,St,zn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge+1,Ct,zn.width,zn.height,0,Rt,St,zn.data)}}else{Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,0,0,Rt,St,rt[Nt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Ct,Rt,St,rt[Nt]);for(let ge=0;ge<le.length;ge++){let qe=le[ge];Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge+1,0,0,Rt,St,qe.image[Nt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge+1,Ct,Rt,St,qe.image[Nt])}}}M(w)&&w.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),bt.__version=at.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function Dt(I,w,Y,dt,at,bt){let Et=r.convert(Y.format,Y.colorSpace),nt=r.convert(Y.type),st=T(Y.internalFormat,Et,nt,Y.normalized,Y.colorSpace),mt=n.get(w),z=n.get(Y);if(z.__renderTarget=w,!mt.__hasExternalTextures){let rt=Math.max(1,w.width>>bt),it=Math.max(1,w.height>>bt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,bt,st,rt,it,w.depth,0,Et,nt,null):e.texImage2D(at,bt,st,rt,it,0,Et,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,I),Tt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,dt,at,z.__webglTexture,0,he(w)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,dt,at,z.__webglTexture,bt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ee(I,w,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,I),w.depthBuffer){let dt=w.depthTexture,at=dt&&dt.isDepthTexture?dt.type:null,bt=y(w.stencilBuffer,at),Et=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Tt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,he(w),bt,w.width,w.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,he(w),bt,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,bt,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Et,i.RENDERBUFFER,I)}else{let dt=w.textures;for(let at=0;at<dt.length;at++){let bt=dt[at],Et=r.convert(bt.format,bt.colorSpace),nt=r.convert(bt.type),st=T(bt.internalFormat,Et,nt,bt.normalized,bt.colorSpace);Tt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,he(w),st,w.width,w.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,he(w),st,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,st,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function kt(I,w,Y){let dt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,I),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(w.depthTexture);at.__renderTarget=w;let bt=dt?w.depthTexture.image[0]:w.depthTexture.image;(!at.__webglTexture||bt.width!==w.width||bt.height!==w.height)&&(bt.width=w.width,bt.height=w.height,w.depthTexture.needsUpdate=!0),dt?wt(w.depthTexture,0):gt(w.depthTexture,0);let Et=at.__webglTexture,nt=he(w),st=dt?i.TEXTURE_CUBE_MAP_POSITIVE_X+Y:i.TEXTURE_2D,mt=w.depthTexture.format===ys?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===ds)Tt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,Et,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,Et,0);else if(w.depthTexture.format===ys)Tt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,Et,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,Et,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function me(I){let w=n.get(I),Y=I.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==I.depthTexture){let dt=I.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),dt){let at=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,dt.removeEventListener("dispose",at)};dt.addEventListener("dispose",at),w.__depthDisposeCallback=at}w.__boundDepthTexture=dt}if(I.depthTexture&&!w.__autoAllocateDepthBuffer)if(Y)for(let dt=0;dt<6;dt++)kt(w.__webglFramebuffer[dt],I,dt);else I.texture.mipmaps.length>0?kt(w.__webglFramebuffer[0],I,0):kt(w.__webglFramebuffer,I,0);else if(Y){w.__webglDepthbuffer=[];for(let dt=0;dt<6;dt++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[dt]),w.__webglDepthbuffer[dt]===void 0)w.__webglDepthbuffer[dt]=i.createRenderbuffer(),ee(w.__webglDepthbuffer[dt],I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,bt=w.__webglDepthbuffer[dt];i.bindRenderbuffer(i.RENDERBUFFER,bt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,bt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),ee(w.__webglDepthbuffer,I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,bt=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,bt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,bt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function de(I,w,Y){let dt=n.get(I);w!==void 0&&Dt(dt.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&me(I)}function _e(I){let w=I.texture,Y=n.get(I),dt=n.get(w);I.addEventListener("dispose",G),U(I);let at=I.textures,bt=I.isWebGLCubeRenderTarget===!0,Et=at.length>1;if(Et||(dt.__webglTexture===void 0&&(dt.__webglTexture=i.createTexture()),dt.__version=w.version,o.memory.textures++),bt){Y.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0){Y.__webglFramebuffer[nt]=[];for(let st=0;st<w.mipmaps.length;st++)Y.__webglFramebuffer[nt][st]=i.createFramebuffer()}else Y.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(w.mipmaps.length>0){Y.__webglFramebuffer=[];for(let nt=0;nt<w.mipmaps.length;nt++)Y.__webglFramebuffer[nt]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(Et)for(let nt=0,st=at.length;nt<st;nt++){let mt=n.get(at[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Tt(I)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];Y.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[nt]);let mt=r.convert(st.format,st.colorSpace),z=r.convert(st.type),rt=T(st.internalFormat,mt,z,st.normalized,st.colorSpace,I.isXRRenderTarget===!0),it=he(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,rt,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,Y.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),ee(Y.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(bt){e.bindTexture(i.TEXTURE_CUBE_MAP,dt.__webglTexture),se(i.TEXTURE_CUBE_MAP,w);for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Dt(Y.__webglFramebuffer[nt][st],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Dt(Y.__webglFramebuffer[nt],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);M(w)?v(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(Et){for(let nt=0,st=at.length;nt<st;nt++){let mt=at[nt],z=n.get(mt),rt=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(rt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,z.__webglTexture),se(rt,mt),Dt(Y.__webglFramebuffer,I,mt,i.COLOR_ATTACHMENT0+nt,rt,0),M(mt)&&v(rt)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(nt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,dt.__webglTexture),se(nt,w),w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Dt(Y.__webglFramebuffer[st],I,w,i.COLOR_ATTACHMENT0,nt,st);else Dt(Y.__webglFramebuffer,I,w,i.COLOR_ATTACHMENT0,nt,0);M(w)?v(nt):w.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&me(I)}function O(I){let w=I.textures;for(let Y=0,dt=w.length;Y<dt;Y++){let at=w[Y];if(M(at)&&at.mipmapsAutoUpdate===!0){let bt=C(I),Et=n.get(at).__webglTexture;e.bindTexture(bt,Et),v(bt),e.unbindTexture()}}}let Mt=[];function Xt(I){if(I.samples>0){if(Tt(I)===!1){let w=I.textures,Y=I.width,dt=I.height,at=i.COLOR_BUFFER_BIT,bt=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Et=n.get(I),nt=w.length>1;if(nt)for(let mt=0;mt<w.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Et.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Et.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Et.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Et.__webglFramebuffer);for(let mt=0;mt<w.length;mt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Et.__webglColorRenderbuffer[mt]);let z=n.get(w[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,z,0)}i.blitFramebuffer(0,0,Y,dt,0,0,Y,dt,at,i.NEAREST),l===!0&&(Mt.length=0,Mt.push(i.COLOR_ATTACHMENT0+mt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Mt.push(bt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Mt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<w.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,Et.__webglColorRenderbuffer[mt]);let z=n.get(w[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Et.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,z,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Et.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let w=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function he(I){return Math.min(s.maxSamples,I.samples)}function Tt(I){let w=n.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Fe(I){let w=o.render.frame;h.get(I)!==w&&(h.set(I,w),I.update())}function $t(I,w){let Y=I.colorSpace,dt=I.format,at=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||Y!==pa&&Y!==xs&&(Ce.getTransfer(Y)===Be?(dt!==Ni||at!==Kn)&&te("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ce("WebGLTextures: Unsupported texture color space:",Y)),w}function Qt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=ht,this.resetTextureUnits=j,this.getTextureUnits=et,this.setTextureUnits=ft,this.setTexture2D=gt,this.setTexture2DArray=xt,this.setTexture3D=Lt,this.setTextureCube=wt,this.rebindTextures=de,this.setupRenderTarget=_e,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Xt,this.setupDepthRenderbuffer=me,this.setupFrameBufferTexture=Dt,this.useMultisampledRTT=Tt,this.dispose=W}function pT(i,t){function e(n,s=xs){let r,o=Ce.getTransfer(s);if(n===Kn)return i.UNSIGNED_BYTE;if(n===ah)return i.UNSIGNED_SHORT_4_4_4_4;if(n===lh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===rf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===of)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===nf)return i.BYTE;if(n===sf)return i.SHORT;if(n===Co)return i.UNSIGNED_SHORT;if(n===oh)return i.INT;if(n===Li)return i.UNSIGNED_INT;if(n===vi)return i.FLOAT;if(n===Di)return i.HALF_FLOAT;if(n===af)return i.ALPHA;if(n===lf)return i.RGB;if(n===Ni)return i.RGBA;if(n===ds)return i.DEPTH_COMPONENT;if(n===ys)return i.DEPTH_STENCIL;if(n===ch)return i.RED;if(n===hh)return i.RED_INTEGER;if(n===Xs)return i.RG;if(n===uh)return i.RG_INTEGER;if(n===dh)return i.RGBA_INTEGER;if(n===Ja||n===Ka||n===ja||n===Qa)if(o===Be)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ja)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ja)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ka)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ja)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===fh||n===ph||n===mh||n===gh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===fh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ph)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===mh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===gh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===_h||n===yh||n===xh||n===vh||n===Sh||n===tl||n===Mh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===_h||n===yh)return o===Be?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===xh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===vh)return r.COMPRESSED_R11_EAC;if(n===Sh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===tl)return r.COMPRESSED_RG11_EAC;if(n===Mh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===bh||n===wh||n===Th||n===Eh||n===Ah||n===Ch||n===Rh||n===Ph||n===Ih||n===Lh||n===Dh||n===Nh||n===Uh||n===Fh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===bh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===wh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Th)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Eh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Ah)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ch)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Rh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ph)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ih)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Lh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Dh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Nh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Uh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Fh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Oh||n===Bh||n===kh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Oh)return o===Be?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Bh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===kh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===zh||n===Gh||n===el||n===Vh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===zh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Gh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===el)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Vh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===xr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var mT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,gT=`
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

}`,Pf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Ca(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Yi({vertexShader:mT,fragmentShader:gT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Sn(new mr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},If=class extends Ii{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",g=new Pf,m={},_=e.getContextAttributes(),M=null,v=null,C=[],T=[],y=new _t,b=null,U=null,P=new Yn;P.viewport=new Qe;let R=new Yn;R.viewport=new Qe;let G=[P,R],H=new eh,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let gt=C[tt];return gt===void 0&&(gt=new go,C[tt]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(tt){let gt=C[tt];return gt===void 0&&(gt=new go,C[tt]=gt),gt.getGripSpace()},this.getHand=function(tt){let gt=C[tt];return gt===void 0&&(gt=new go,C[tt]=gt),gt.getHandSpace()};function B(tt){let gt=T.indexOf(tt.inputSource);if(gt===-1)return;let xt=C[gt];xt!==void 0&&(xt.update(tt.inputSource,tt.frame,c||o),xt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function k(){s.removeEventListener("select",B),s.removeEventListener("selectstart",B),s.removeEventListener("selectend",B),s.removeEventListener("squeeze",B),s.removeEventListener("squeezestart",B),s.removeEventListener("squeezeend",B),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<C.length;tt++){let gt=T[tt];gt!==null&&(T[tt]=null,C[tt].disconnect(gt))}N=null,W=null,g.reset();for(let tt in m)delete m[tt];if(t.setRenderTarget(M),f=null,d=null,u=null,s=null,v=null,ht.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(y.width,y.height,!1),U!==null){let tt=U.camera;tt.fov=U.fov,tt.zoom=U.zoom,tt.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&te("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,n.isPresenting===!0&&te("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",B),s.addEventListener("selectstart",B),s.addEventListener("selectend",B),s.addEventListener("squeeze",B),s.addEventListener("squeezestart",B),s.addEventListener("squeezeend",B),s.addEventListener("end",k),s.addEventListener("inputsourceschange",lt),_.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Lt=null,wt=null;_.depth&&(wt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=_.stencil?ys:ds,Lt=_.stencil?xr:Li);let Vt={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Vt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new hi(d.textureWidth,d.textureHeight,{format:Ni,type:Kn,depthTexture:new gs(d.textureWidth,d.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new hi(f.framebufferWidth,f.framebufferHeight,{format:Ni,type:Kn,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ht.setContext(s),ht.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function lt(tt){for(let gt=0;gt<tt.removed.length;gt++){let xt=tt.removed[gt],Lt=T.indexOf(xt);Lt>=0&&(T[Lt]=null,C[Lt].disconnect(xt))}for(let gt=0;gt<tt.added.length;gt++){let xt=tt.added[gt],Lt=T.indexOf(xt);if(Lt===-1){for(let Vt=0;Vt<C.length;Vt++)if(Vt>=T.length){T.push(xt),Lt=Vt;break}else if(T[Vt]===null){T[Vt]=xt,Lt=Vt;break}if(Lt===-1)break}let wt=C[Lt];wt&&wt.connect(xt)}}function $(tt,gt){gt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(gt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let gt=tt.near,xt=tt.far;g.texture!==null&&(g.depthNear>0&&(gt=g.depthNear),g.depthFar>0&&(xt=g.depthFar)),H.near=R.near=P.near=gt,H.far=R.far=P.far=xt,(N!==H.near||W!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),N=H.near,W=H.far),H.layers.mask=tt.layers.mask|6,P.layers.mask=H.layers.mask&-5,R.layers.mask=H.layers.mask&-3;let Lt=tt.parent,wt=H.cameras;$(H,Lt);for(let Vt=0;Vt<wt.length;Vt++)$(wt[Vt],Lt);H.projectionMatrix.copy(P.projectionMatrix),H.projectionMatrixInverse.copy(P.projectionMatrixInverse),U===null&&tt.isPerspectiveCamera&&(U={camera:tt,fov:tt.fov,zoom:tt.zoom}),j(tt,H,Lt)};function j(tt,gt,xt){xt===null?tt.matrix.copy(gt.matrixWorld):(tt.matrix.copy(xt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(gt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(gt.projectionMatrix),tt.projectionMatrixInverse.copy(gt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=po*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(H)},this.getCameraTexture=function(tt){return m[tt]};let et=null;function ft(tt,gt){if(h=gt.getViewerPose(c||o),p=gt,h!==null){let xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Lt=!1;xt.length!==H.cameras.length&&(H.cameras.length=0,Lt=!0);for(let Jt=0;Jt<xt.length;Jt++){let se=xt[Jt],ne=null;if(f!==null)ne=f.getViewport(se);else{let vt=u.getViewSubImage(d,se);ne=vt.viewport,Jt===0&&(t.setRenderTargetTextures(v,vt.colorTexture,vt.depthStencilTexture),t.setRenderTarget(v))}let ot=G[Jt];ot===void 0&&(ot=new Yn,ot.layers.enable(Jt),ot.viewport=new Qe,G[Jt]=ot),ot.matrix.fromArray(se.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(se.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ne.x,ne.y,ne.width,ne.height),Jt===0&&(H.matrix.copy(ot.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Lt===!0&&H.cameras.push(ot)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Jt=u.getDepthInformation(xt[0]);Jt&&Jt.isValid&&Jt.texture&&g.init(Jt,s.renderState)}if(wt&&wt.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Jt=0;Jt<xt.length;Jt++){let se=xt[Jt].camera;if(se){let ne=m[se];ne||(ne=new Ca,m[se]=ne);let ot=u.getCameraImage(se);ne.sourceTexture=ot}}}}for(let xt=0;xt<C.length;xt++){let Lt=T[xt],wt=C[xt];Lt!==null&&wt!==void 0&&wt.update(Lt,gt,c||o)}et&&et(tt,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),p=null}let ht=new K0;ht.setAnimationLoop(ft),this.setAnimationLoop=function(tt){et=tt},this.dispose=function(){}}},_T=new Ne,a_=new fe;a_.set(-1,0,0,0,1,0,0,0,1);function yT(i,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,yf(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,_,M,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,v)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,_,M):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Zn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Zn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let _=t.get(m),M=_.envMap,v=_.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(_T.makeRotationFromEuler(v)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(a_),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,_,M){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*_,g.scale.value=M*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,_){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Zn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let _=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function xT(i,t,e,n){let s={},r={};function o(_,M){let v=M.program;n.uniformBlockBinding(_,v,s[_.id])}function a(_,M){let v=s[_.id];v===void 0&&(p(_),v=l(_),s[_.id]=v,_.addEventListener("dispose",g));let C=M.program;n.updateUBOMapping(_,C);let T=t.render.frame;r[_.id]!==T&&(c(_),r[_.id]=T)}function l(_){let M=i.createBuffer(),v=_.__size,C=_.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,v,C),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(_){let M=s[_.id],v=_.uniforms,C=_.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let T=0,y=v.length;T<y;T++){let b=v[T];if(Array.isArray(b))for(let U=0,P=b.length;U<P;U++)h(b[U],T,U,C);else h(b,T,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(_,M,v,C){if(d(_,M,v,C)===!0){let T=_.__offset,y=_.value;if(Array.isArray(y)){let b=0;for(let U=0;U<y.length;U++){let P=y[U],R=x(P,!0);u(P,_.__data,b),b+=R.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,_.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,_.__data)}}function u(_,M,v){typeof _=="number"||typeof _=="boolean"?M[v]=_:_.isMatrix3?(M[v]=_.elements[0],M[v+1]=_.elements[1],M[v+2]=_.elements[2],M[v+3]=0,M[v+4]=_.elements[3],M[v+5]=_.elements[4],M[v+6]=_.elements[5],M[v+7]=0,M[v+8]=_.elements[6],M[v+9]=_.elements[7],M[v+10]=_.elements[8],M[v+11]=0):ArrayBuffer.isView(_)?M.set(_.subarray(0,M.length-v),v):_.toArray(M,v)}function d(_,M,v,C){let T=_.value,y=M+"_"+v;if(Array.isArray(T)){C[y]===void 0&&(C[y]=[]);let b=C[y],U=!1;for(let P=0;P<T.length;P++)f(T[P],b,P)===!0&&(U=!0);return U}return f(T,C,y)}function f(_,M,v){if(M[v]===void 0)return typeof _=="number"||typeof _=="boolean"?M[v]=_:ArrayBuffer.isView(_)?M[v]=_.slice():M[v]=_.clone(),!0;{let C=M[v];if(typeof _=="number"||typeof _=="boolean"){if(C!==_)return M[v]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(C.equals(_)===!1)return C.copy(_),!0}}return!1}function p(_){let M=_.uniforms,v=0,C=16;for(let y=0,b=M.length;y<b;y++){let U=Array.isArray(M[y])?M[y]:[M[y]];for(let P=0,R=U.length;P<R;P++){let G=U[P],H=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(M[y])||Array.isArray(G.value),W=v;for(let k=0,lt=H.length;k<lt;k++){let $=H[k],j=x($,N),et=v%C,ft=et%j.boundary,ht=et+ft;v+=ft,ht!==0&&C-ht<j.storage&&(v+=C-ht),k===0&&(W=v),v+=j.storage}let B=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new B((v-W)/Float32Array.BYTES_PER_ELEMENT),G.__offset=W}}let T=v%C;return T>0&&(v+=C-T),_.__size=v,_.__cache={},this}function x(_,M){let v={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(v.boundary=4,v.storage=4):_.isVector2?(v.boundary=8,v.storage=8):_.isVector3||_.isColor?(v.boundary=16,v.storage=12):_.isVector4?(v.boundary=16,v.storage=16):_.isMatrix3?(v.boundary=16,v.storage=48):_.isMatrix4?(v.boundary=16,v.storage=64):_.isTexture?te("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(v.boundary=16,v.storage=_.byteLength):te("WebGLRenderer: Unsupported uniform value type.",_),M===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(_){let M=_.target;M.removeEventListener("dispose",g),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function m(){for(let _ in s)i.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var vT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Zi=null;function ST(){return Zi===null&&(Zi=new ba(vT,16,16,Xs,Di),Zi.name="DFG_LUT",Zi.minFilter=$n,Zi.magFilter=$n,Zi.wrapS=Wi,Zi.wrapT=Wi,Zi.generateMipmaps=!1,Zi.needsUpdate=!0),Zi}var $h=class{constructor(t={}){let{canvas:e=g0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Kn}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,g=new Set([dh,uh,hh]),m=new Set([Kn,Li,Co,xr,ah,lh]),_=new Uint32Array(4),M=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},C=null,T=null,y=[],b=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=$i,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,R=!1,G=null,H=null,N=null,W=null;this._outputColorSpace=li;let B=0,k=0,lt=null,$=-1,j=null,et=new Qe,ft=new Qe,ht=null,tt=new oe(0),gt=0,xt=e.width,Lt=e.height,wt=1,Vt=null,ie=null,Jt=new Qe(0,0,xt,Lt),se=new Qe(0,0,xt,Lt),ne=!1,ot=new Os,vt=new Ic,yt=!1,Bt=!1,Dt=new Ne,ee=new V,kt=new Qe,me={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},de=!1;function _e(){return lt===null?wt:1}let O=n;function Mt(A,X){return e.getContext(A,X)}let Xt,he,Tt,Fe,$t,Qt,I,w,Y,dt,at,bt,Et,nt,st,mt,z,rt,it,Rt,St,Ct,Kt;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",qt,!1),e.addEventListener("webglcontextrestored",le,!1),e.addEventListener("webglcontextcreationerror",Nt,!1),O===null){let X="webgl2";if(O=Mt(X,A),O===null)throw Mt(X)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ae()}catch(A){throw e.removeEventListener("webglcontextlost",qt,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Nt,!1),ce("WebGLRenderer: "+A.message),A}function ae(){Xt=new Lw(O),Xt.init(),St=new pT(O,Xt),he=new Sw(O,Xt,t,St),Tt=new dT(O,Xt),he.reversedDepthBuffer&&d&&Tt.buffers.depth.setReversed(!0),H=O.createFramebuffer(),N=O.createFramebuffer(),W=O.createFramebuffer(),Fe=new Uw(O),$t=new j1,Qt=new fT(O,Xt,Tt,$t,he,St,Fe),I=new Iw(P),w=new OS(O),Ct=new xw(O,w),Y=new Dw(O,w,Fe,Ct),dt=new Ow(O,Y,w,Ct,Fe),rt=new Fw(O,he,Qt),st=new Mw($t),at=new K1(P,I,Xt,he,Ct,st),bt=new yT(P,$t),Et=new tT,nt=new oT(Xt),z=new yw(P,I,Tt,dt,p,l),mt=new uT(P,dt,he),Kt=new xT(O,Fe,he,Tt),it=new vw(O,Xt,Fe),Rt=new Nw(O,Xt,Fe),Fe.programs=at.programs,P.capabilities=he,P.extensions=Xt,P.properties=$t,P.renderLists=Et,P.shadowMap=mt,P.state=Tt,P.info=Fe}x!==Kn&&(U=new kw(x,e.width,e.height,a,s,r));let ut=new If(P,O);this.xr=ut,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let A=Xt.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Xt.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(A){A!==void 0&&(wt=A,this.setSize(xt,Lt,!1))},this.getSize=function(A){return A.set(xt,Lt)},this.setSize=function(A,X,Q=!0){if(ut.isPresenting){te("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=A,Lt=X,e.width=Math.floor(A*wt),e.height=Math.floor(X*wt),Q===!0&&(e.style.width=A+"px",e.style.height=X+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,A,X)},this.getDrawingBufferSize=function(A){return A.set(xt*wt,Lt*wt).floor()},this.setDrawingBufferSize=function(A,X,Q){xt=A,Lt=X,wt=Q,e.width=Math.floor(A*Q),e.height=Math.floor(X*Q),this.setViewport(0,0,A,X)},this.setEffects=function(A){if(x===Kn){ce("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let X=0;X<A.length;X++)if(A[X].isOutputPass===!0){te("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(et)},this.getViewport=function(A){return A.copy(Jt)},this.setViewport=function(A,X,Q,Z){A.isVector4?Jt.set(A.x,A.y,A.z,A.w):Jt.set(A,X,Q,Z),Tt.viewport(et.copy(Jt).multiplyScalar(_e()).round())},this.getScissor=function(A){return A.copy(se)},this.setScissor=function(A,X,Q,Z){A.isVector4?se.set(A.x,A.y,A.z,A.w):se.set(A,X,Q,Z),Tt.scissor(ft.copy(se).multiplyScalar(_e()).round())},this.getScissorTest=function(){return ne},this.setScissorTest=function(A){Tt.setScissorTest(ne=A)},this.setOpaqueSort=function(A){Vt=A},this.setTransparentSort=function(A){ie=A},this.getClearColor=function(A){return A.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(A=!0,X=!0,Q=!0){let Z=0;if(A){let J=!1;if(lt!==null){let Pt=lt.texture.format;J=g.has(Pt)}if(J){let Pt=lt.texture.type,Ut=m.has(Pt),It=z.getClearColor(),Ft=z.getClearAlpha(),Zt=It.r,ue=It.g,Me=It.b;Ut?(_[0]=Zt,_[1]=ue,_[2]=Me,_[3]=Ft,O.clearBufferuiv(O.COLOR,0,_)):(M[0]=Zt,M[1]=ue,M[2]=Me,M[3]=Ft,O.clearBufferiv(O.COLOR,0,M))}else Z|=O.COLOR_BUFFER_BIT}X&&(Z|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Z|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&O.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),G=A},this.dispose=function(){e.removeEventListener("webglcontextlost",qt,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Nt,!1),z.dispose(),Et.dispose(),nt.dispose(),Qt.dispose(),$t.dispose(),I.dispose(),dt.dispose(),Y.dispose(),Ct.dispose(),Kt.dispose(),at.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",hl),ut.removeEventListener("sessionend",Ui),Ki.stop()};function qt(A){A.preventDefault(),ff("WebGLRenderer: Context Lost."),R=!0}function le(){ff("WebGLRenderer: Context Restored."),R=!1;let A=Fe.autoReset,X=mt.enabled,Q=mt.autoUpdate,Z=mt.needsUpdate,J=mt.type;ae(),Fe.autoReset=A,mt.enabled=X,mt.autoUpdate=Q,mt.needsUpdate=Z,mt.type=J}function Nt(A){ce("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ge(A){let X=A.target;X.removeEventListener("dispose",ge),qe(X)}function qe(A){zn(A),$t.remove(A)}function zn(A){let X=$t.get(A).programs;X!==void 0&&(X.forEach(function(Q){at.releaseProgram(Q)}),A.isShaderMaterial&&at.releaseShaderCache(A))}this.renderBufferDirect=function(A,X,Q,Z,J,Pt){X===null&&(X=me);let Ut=J.isMesh&&J.matrixWorld.determinantAffine()<0,It=Oo(A,X,Q,Z,J);Tt.setMaterial(Z,Ut);let Ft=Q.index,Zt=1;if(Z.wireframe===!0){if(Ft=Y.getWireframeAttribute(Q),Ft===void 0)return;Zt=2}let ue=Q.drawRange,Me=Q.attributes.position,Yt=ue.start*Zt,be=(ue.start+ue.count)*Zt;Pt!==null&&(Yt=Math.max(Yt,Pt.start*Zt),be=Math.min(be,(Pt.start+Pt.count)*Zt)),Ft!==null?(Yt=Math.max(Yt,0),be=Math.min(be,Ft.count)):Me!=null&&(Yt=Math.max(Yt,0),be=Math.min(be,Me.count));let tn=be-Yt;if(tn<0||tn===1/0)return;Ct.setup(J,Z,It,Q,Ft);let ke,ze=it;if(Ft!==null&&(ke=w.get(Ft),ze=Rt,ze.setIndex(ke)),J.isMesh)Z.wireframe===!0?(Tt.setLineWidth(Z.wireframeLinewidth*_e()),ze.setMode(O.LINES)):ze.setMode(O.TRIANGLES);else if(J.isLine){let _n=Z.linewidth;_n===void 0&&(_n=1),Tt.setLineWidth(_n*_e()),J.isLineSegments?ze.setMode(O.LINES):J.isLineLoop?ze.setMode(O.LINE_LOOP):ze.setMode(O.LINE_STRIP)}else J.isPoints?ze.setMode(O.POINTS):J.isSprite&&ze.setMode(O.TRIANGLES);if(J.isBatchedMesh)if(Xt.get("WEBGL_multi_draw"))ze.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let _n=J._multiDrawStarts,Ht=J._multiDrawCounts,cn=J._multiDrawCount,Ee=Ft?w.get(Ft).bytesPerElement:1,Qi=$t.get(Z).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)Qi.setValue(O,"_gl_DrawID",hn),ze.render(_n[hn]/Ee,Ht[hn])}else if(J.isInstancedMesh)ze.renderInstances(Yt,tn,J.count);else if(Q.isInstancedBufferGeometry){let _n=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ht=Math.min(Q.instanceCount,_n);ze.renderInstances(Yt,tn,Ht)}else ze.render(Yt,tn)};function No(A,X,Q,Z){G!==null&&A.isNodeMaterial&&G.setObject(Z,A),yt===!0&&st.setState(A,Q,!1),A.transparent===!0&&A.side===fi&&A.forceSinglePass===!1?(A.side=Zn,A.needsUpdate=!0,Fi(A,X,Z),A.side=Ws,A.needsUpdate=!0,Fi(A,X,Z),A.side=fi):Fi(A,X,Z)}this.compile=function(A,X,Q=null){Q===null&&(Q=A),G!==null&&G.renderStart(A,X,Q),T=nt.get(Q),T.init(X),b.push(T),Q.traverseVisible(function(J){J.isLight&&J.layers.test(X.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),A!==Q&&A.traverseVisible(function(J){J.isLight&&J.layers.test(X.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),T.setupLights(),G!==null&&G.updateLights(T.state.lightsArray),Bt=this.localClippingEnabled,yt=st.init(this.clippingPlanes,Bt),yt===!0&&st.setGlobalState(this.clippingPlanes,X),G!==null&&mt.render(T.state.shadowsArray,Q,X);let Z=new Set;return A.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Pt=J.material;if(Pt)if(Array.isArray(Pt))for(let Ut=0;Ut<Pt.length;Ut++){let It=Pt[Ut];No(It,Q,X,J),Z.add(It)}else No(Pt,Q,X,J),Z.add(Pt)}),T=b.pop(),G!==null&&G.renderEnd(),Z},this.compileAsync=function(A,X,Q=null){let Z=this.compile(A,X,Q);return new Promise(J=>{function Pt(){if(Z.forEach(function(Ut){let Ft=$t.get(Ut).currentProgram;(Ft===void 0||Ft.isReady())&&Z.delete(Ut)}),Z.size===0){J(A);return}setTimeout(Pt,10)}Xt.get("KHR_parallel_shader_compile")!==null?Pt():setTimeout(Pt,10)})};let br=null;function cu(A){br&&br(A)}function hl(){Ki.stop()}function Ui(){Ki.start()}let Ki=new K0;Ki.setAnimationLoop(cu),typeof self<"u"&&Ki.setContext(self),this.setAnimationLoop=function(A){br=A,ut.setAnimationLoop(A),A===null?Ki.stop():Ki.start()},ut.addEventListener("sessionstart",hl),ut.addEventListener("sessionend",Ui),this.render=function(A,X){if(X!==void 0&&X.isCamera!==!0){ce("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(R===!0)return;G!==null&&G.renderStart(A,X);let Q=ut.enabled===!0&&ut.isPresenting===!0,Z=U!==null&&(lt===null||Q)&&U.begin(P,lt);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),X.parent===null&&X.matrixWorldAutoUpdate===!0&&X.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(X),X=ut.getCamera()),A.isScene===!0&&A.onBeforeRender(P,A,X,lt),T=nt.get(A,b.length),T.init(X),T.state.textureUnits=Qt.getTextureUnits(),b.push(T),Dt.multiplyMatrices(X.projectionMatrix,X.matrixWorldInverse),X.isArrayCamera?vt.setFromArrayCamera(X):ot.setFromProjectionMatrix(Dt,xi,X.reversedDepth),Bt=this.localClippingEnabled,yt=st.init(this.clippingPlanes,Bt),C=Et.get(A,y.length),C.init(),y.push(C),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let Ut=P.xr.getDepthSensingMesh();Ut!==null&&ji(Ut,X,-1/0,P.sortObjects)}ji(A,X,0,P.sortObjects),C.finish(),G!==null&&G.updateLights(T.state.lightsArray),P.sortObjects===!0&&C.sort(Vt,ie),de=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,de&&z.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),yt===!0&&st.beginShadows();let J=T.state.shadowsArray;if(mt.render(J,A,X),yt===!0&&st.endShadows(),(Z&&U.hasRenderPass())===!1){let Ut=C.opaque,It=C.transmissive;if(T.setupLights(),X.isArrayCamera){let Ft=X.cameras;if(It.length>0)for(let Zt=0,ue=Ft.length;Zt<ue;Zt++){let Me=Ft[Zt];Si(Ut,It,A,Me)}de&&z.render(A);for(let Zt=0,ue=Ft.length;Zt<ue;Zt++){let Me=Ft[Zt];Uo(C,A,Me,Me.viewport)}}else It.length>0&&Si(Ut,It,A,X),de&&z.render(A),Uo(C,A,X)}lt!==null&&k===0&&(Qt.updateMultisampleRenderTarget(lt),Qt.updateRenderTargetMipmap(lt)),Z&&U.end(P),A.isScene===!0&&A.onAfterRender(P,A,X),Ct.resetDefaultState(),$=-1,j=null,b.pop(),b.length>0?(T=b[b.length-1],Qt.setTextureUnits(T.state.textureUnits),yt===!0&&st.setGlobalState(P.clippingPlanes,T.state.camera)):T=null,y.pop(),y.length>0?C=y[y.length-1]:C=null,G!==null&&G.renderEnd()};function ji(A,X,Q,Z){if(A.visible===!1)return;if(A.layers.test(X.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(X);else if(A.isLight)T.pushLight(A),A.castShadow&&T.pushShadow(A);else if(A.isSprite){let Ut=X.isArrayCamera?vt:ot;if(!A.frustumCulled||A.intersectsFrustum(Ut)){Z&&kt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Dt);let It=dt.update(A),Ft=A.material;Ft.visible&&C.push(A,It,Ft,Q,kt.z,null,X)}}else if(A.isMesh||A.isLine||A.isPoints){let Ut=X.isArrayCamera?vt:ot;if(!A.frustumCulled||A.intersectsFrustum(Ut)){let It=dt.update(A),Ft=A.material;if(Z&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),kt.copy(A.boundingSphere.center)):(It.boundingSphere===null&&It.computeBoundingSphere(),kt.copy(It.boundingSphere.center)),kt.applyMatrix4(A.matrixWorld).applyMatrix4(Dt)),Array.isArray(Ft)){let Zt=It.groups;for(let ue=0,Me=Zt.length;ue<Me;ue++){let Yt=Zt[ue],be=Ft[Yt.materialIndex];be&&be.visible&&C.push(A,It,be,Q,kt.z,Yt,X)}}else Ft.visible&&C.push(A,It,Ft,Q,kt.z,null,X)}}}let Pt=A.children;for(let Ut=0,It=Pt.length;Ut<It;Ut++)ji(Pt[Ut],X,Q,Z)}function Uo(A,X,Q,Z){let{opaque:J,transmissive:Pt,transparent:Ut}=A;T.setupLightsView(Q),yt===!0&&st.setGlobalState(P.clippingPlanes,Q),Z&&Tt.viewport(et.copy(Z)),J.length>0&&nn(J,X,Q),Pt.length>0&&nn(Pt,X,Q),Ut.length>0&&nn(Ut,X,Q),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function Si(A,X,Q,Z){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Z.id]===void 0){let Yt=Xt.has("EXT_color_buffer_half_float")||Xt.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Z.id]=new hi(1,1,{generateMipmaps:!0,type:Yt?Di:Kn,minFilter:_s,samples:Math.max(4,he.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ce.workingColorSpace})}let Pt=T.state.transmissionRenderTarget[Z.id],Ut=Z.viewport||et;Pt.setSize(Ut.z*P.transmissionResolutionScale,Ut.w*P.transmissionResolutionScale);let It=P.getRenderTarget(),Ft=P.getActiveCubeFace(),Zt=P.getActiveMipmapLevel();P.setRenderTarget(Pt),P.getClearColor(tt),gt=P.getClearAlpha(),gt<1&&P.setClearColor(16777215,.5),P.clear(),de&&z.render(Q);let ue=P.toneMapping;P.toneMapping=$i;let Me=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),T.setupLightsView(Z),yt===!0&&st.setGlobalState(P.clippingPlanes,Z),nn(A,Q,Z),Qt.updateMultisampleRenderTarget(Pt),Qt.updateRenderTargetMipmap(Pt),Xt.has("WEBGL_multisampled_render_to_texture")===!1){let Yt=!1;for(let be=0,tn=X.length;be<tn;be++){let ke=X[be],{object:ze,geometry:_n,material:Ht,group:cn}=ke;if(Ht.side===fi&&ze.layers.test(Z.layers)){let Ee=Ht.side;Ht.side=Zn,Ht.needsUpdate=!0,an(ze,Q,Z,_n,Ht,cn),Ht.side=Ee,Ht.needsUpdate=!0,Yt=!0}}Yt===!0&&(Qt.updateMultisampleRenderTarget(Pt),Qt.updateRenderTargetMipmap(Pt))}P.setRenderTarget(It,Ft,Zt),P.setClearColor(tt,gt),Me!==void 0&&(Z.viewport=Me),P.toneMapping=ue}function nn(A,X,Q){let Z=X.isScene===!0?X.overrideMaterial:null;for(let J=0,Pt=A.length;J<Pt;J++){let Ut=A[J],{object:It,geometry:Ft,group:Zt}=Ut,ue=Ut.material;ue.allowOverride===!0&&Z!==null&&(ue=Z),It.layers.test(Q.layers)&&an(It,X,Q,Ft,ue,Zt)}}function an(A,X,Q,Z,J,Pt){G!==null&&J.isNodeMaterial&&G.setObject(A,J),A.onBeforeRender(P,X,Q,Z,J,Pt),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),J.onBeforeRender(P,X,Q,Z,A,Pt),J.transparent===!0&&J.side===fi&&J.forceSinglePass===!1?(J.side=Zn,J.needsUpdate=!0,P.renderBufferDirect(Q,X,Z,J,A,Pt),J.side=Ws,J.needsUpdate=!0,P.renderBufferDirect(Q,X,Z,J,A,Pt),J.side=fi):P.renderBufferDirect(Q,X,Z,J,A,Pt),A.onAfterRender(P,X,Q,Z,J,Pt)}function ln(A){let X=0;for(let Q of A)Q.texture!==null&&X++;return X}function Fi(A,X,Q){X.isScene!==!0&&(X=me);let Z=$t.get(A),J=T.state.lights,Pt=T.state.shadowsArray,Ut=J.state.version,It=at.getParameters(A,J.state,Pt,X,Q,T.state.lightProbeGridArray),Ft=at.getProgramCacheKey(It),Zt=Z.programs;Z.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?X.environment:null,Z.fog=X.fog;let ue=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Z.envMap=I.get(A.envMap||Z.environment,ue),Z.envMapRotation=Z.environment!==null&&A.envMap===null?X.environmentRotation:A.envMapRotation,Zt===void 0&&(A.addEventListener("dispose",ge),Zt=new Map,Z.programs=Zt,Z.programVariants=new Map);let Me=Zt.get(Ft);if(Me!==void 0){if(Z.currentProgram===Me&&Z.lightsStateVersion===Ut)return Fo(A,It),Me}else It.uniforms=at.getUniforms(A),G!==null&&A.isNodeMaterial&&G.build(A,Q,It),A.onBeforeCompile(It,P),Me=at.acquireProgram(It,Ft),Zt.set(Ft,Me),Z.uniforms=It.uniforms;let Yt=Z.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Yt.clippingPlanes=st.uniform),Fo(A,It),Z.needsLights=Ms(A),Z.lightsStateVersion=Ut,Z.needsLights&&(Yt.ambientLightColor.value=J.state.ambient,Yt.lightProbe.value=J.state.probe,Yt.sunLights.value=J.state.sun,Yt.sunLightShadows.value=J.state.sunShadow,Yt.directionalLights.value=J.state.directional,Yt.directionalLightShadows.value=J.state.directionalShadow,Yt.spotLights.value=J.state.spot,Yt.spotLightShadows.value=J.state.spotShadow,Yt.rectAreaLights.value=J.state.rectArea,Yt.ltc_1.value=J.state.rectAreaLTC1,Yt.ltc_2.value=J.state.rectAreaLTC2,Yt.pointLights.value=J.state.point,Yt.pointLightShadows.value=J.state.pointShadow,Yt.hemisphereLights.value=J.state.hemi,Yt.sunShadowMatrix.value=J.state.sunShadowMatrix,Yt.sunShadowCascade.value=J.state.sunShadowCascade,Yt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Yt.spotLightMatrix.value=J.state.spotLightMatrix,Yt.spotLightMap.value=J.state.spotLightMap,Yt.pointShadowMatrix.value=J.state.pointShadowMatrix),Z.numLightProbeGrids=ln(T.state.lightProbeGridArray),Z.currentProgram=Me,Z.uniformsList=null,Me}function Qn(A,X,Q,Z,J){let Pt=$t.get(A),Ut=Pt.currentProgram.id+","+Z+","+J,It=Pt.programVariants.get(Ut);return It===void 0?(It=Fi(A,X,Q),Pt.programVariants.set(Ut,It)):(Pt.currentProgram=It,Pt.uniformsList=null,Pt.outputColorSpace=Z,Pt.toneMapping=J),It}function Ss(A){if(A.uniformsList===null){let X=A.currentProgram.getUniforms();A.uniformsList=Ro.seqWithValue(X.seq,A.uniforms)}return A.uniformsList}function Fo(A,X){let Q=$t.get(A);Q.outputColorSpace=X.outputColorSpace,Q.batching=X.batching,Q.batchingColor=X.batchingColor,Q.instancing=X.instancing,Q.instancingColor=X.instancingColor,Q.instancingMorph=X.instancingMorph,Q.skinning=X.skinning,Q.morphTargets=X.morphTargets,Q.morphNormals=X.morphNormals,Q.morphColors=X.morphColors,Q.morphTargetsCount=X.morphTargetsCount,Q.numClippingPlanes=X.numClippingPlanes,Q.numIntersection=X.numClipIntersection,Q.vertexAlphas=X.vertexAlphas,Q.vertexTangents=X.vertexTangents,Q.toneMapping=X.toneMapping}function Oo(A,X,Q,Z,J){X.isScene!==!0&&(X=me),Qt.resetTextureUnits();let Pt=X.fog,Ut=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?X.environment:null,It=lt===null?P.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:Ce.workingColorSpace,Ft=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,Zt=I.get(Z.envMap||Ut,Ft),ue=Z.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,Me=!!Q.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Yt=!!Q.morphAttributes.position,be=!!Q.morphAttributes.normal,tn=!!Q.morphAttributes.color,ke=$i;Z.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(ke=P.toneMapping);let ze=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,_n=ze!==void 0?ze.length:0,Ht=$t.get(Z),cn=T.state.lights;if(yt===!0&&(Bt===!0||A!==j)){let Ge=A===j&&Z.id===$;st.setState(Z,A,Ge)}let Ee=!1,Qi=!1;Z.version===Ht.__version?Ht.needsLights&&Ht.lightsStateVersion!==cn.state.version||J.isBatchedMesh&&Ht.batching===!1||!J.isBatchedMesh&&Ht.batching===!0||J.isBatchedMesh&&Ht.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ht.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ht.instancing===!1||!J.isInstancedMesh&&Ht.instancing===!0||J.isSkinnedMesh&&Ht.skinning===!1||!J.isSkinnedMesh&&Ht.skinning===!0||J.isInstancedMesh&&Ht.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ht.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ht.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ht.instancingMorph===!1&&J.morphTexture!==null||Ht.envMap!==Zt||Z.fog===!0&&Ht.fog!==Pt||Ht.numClippingPlanes!==void 0&&(Ht.numClippingPlanes!==st.numPlanes||Ht.numIntersection!==st.numIntersection)||Ht.vertexAlphas!==ue||Ht.vertexTangents!==Me||Ht.morphTargets!==Yt||Ht.morphNormals!==be||Ht.morphColors!==tn||Ht.morphTargetsCount!==_n||Ht.numLightProbeGrids!==ln(T.state.lightProbeGridArray)?Ee=!0:(Ht.outputColorSpace!==It||Ht.toneMapping!==ke)&&(Qi=!0):(Ee=!0,Ht.__version=Z.version);let hn=Ht.currentProgram;(Ee===!0||Qi===!0)&&(hn=Qi===!0?Qn(Z,X,J,It,ke):Fi(Z,X,J),G&&Z.isNodeMaterial&&G.onUpdateProgram(Z,hn,Ht));let Er=!1,Oi=!1,ts=!1,ye=hn.getUniforms(),sn=Ht.uniforms;if(Tt.useProgram(hn.program)&&(Er=!0,Oi=!0,ts=!0),Z.id!==$&&($=Z.id,Oi=!0),Er||j!==A){Tt.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ye.setValue(O,"projectionMatrix",A.projectionMatrix),ye.setValue(O,"viewMatrix",A.matrixWorldInverse);let un=ye.map.cameraPosition;un!==void 0&&un.setValue(O,ee.setFromMatrixPosition(A.matrixWorld)),he.logarithmicDepthBuffer&&ye.setValue(O,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ye.setValue(O,"isOrthographic",A.isOrthographicCamera===!0),j!==A&&(j=A,Oi=!0,ts=!0)}if(Ht.needsLights&&(cn.state.sunShadowMap.length>0&&ye.setValue(O,"sunShadowMap",cn.state.sunShadowMap,Qt),cn.state.directionalShadowMap.length>0&&ye.setValue(O,"directionalShadowMap",cn.state.directionalShadowMap,Qt),cn.state.spotShadowMap.length>0&&ye.setValue(O,"spotShadowMap",cn.state.spotShadowMap,Qt),cn.state.pointShadowMap.length>0&&ye.setValue(O,"pointShadowMap",cn.state.pointShadowMap,Qt)),J.isSkinnedMesh){ye.setOptional(O,J,"bindMatrix"),ye.setOptional(O,J,"bindMatrixInverse");let Ge=J.skeleton;Ge&&(Ge.boneTexture===null&&Ge.computeBoneTexture(),ye.setValue(O,"boneTexture",Ge.boneTexture,Qt))}J.isBatchedMesh&&(ye.setOptional(O,J,"batchingTexture"),ye.setValue(O,"batchingTexture",J._matricesTexture,Qt),ye.setOptional(O,J,"batchingIdTexture"),ye.setValue(O,"batchingIdTexture",J._indirectTexture,Qt),ye.setOptional(O,J,"batchingColorTexture"),J._colorsTexture!==null&&ye.setValue(O,"batchingColorTexture",J._colorsTexture,Qt));let Gn=Q.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&rt.update(J,Q,hn),(Oi||Ht.receiveShadow!==J.receiveShadow)&&(Ht.receiveShadow=J.receiveShadow,ye.setValue(O,"receiveShadow",J.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&X.environment!==null&&(sn.envMapIntensity.value=X.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=ST()),Oi){if(ye.setValue(O,"toneMappingExposure",P.toneMappingExposure),Ht.needsLights&&wr(sn,ts),Pt&&Z.fog===!0&&bt.refreshFogUniforms(sn,Pt),bt.refreshMaterialUniforms(sn,Z,wt,Lt,T.state.transmissionRenderTarget[A.id]),Ht.needsLights&&Ht.numLightProbeGrids>0){let Ge=v,un=0;for(let Fn of T.state.lightProbeGridArray)Fn.texture!==null&&(Ge.textures[un]=Fn.texture,Ge.min[un]=Fn.boundingBox.min,Ge.max[un]=Fn.boundingBox.max,Ge.resolution[un]=Fn.resolution,un++);for(let Fn in Ge)Ge[Fn].length=un;sn.probesSH.value=Ge.textures,sn.probesMin.value=Ge.min,sn.probesMax.value=Ge.max,sn.probesResolution.value=Ge.resolution}Ro.upload(O,Ss(Ht),sn,Qt)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ro.upload(O,Ss(Ht),sn,Qt),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ye.setValue(O,"center",J.center),ye.setValue(O,"modelViewMatrix",J.modelViewMatrix),ye.setValue(O,"normalMatrix",J.normalMatrix),ye.setValue(O,"modelMatrix",J.matrixWorld),Z.uniformsGroups!==void 0){let Ge=Z.uniformsGroups;for(let un=0,Fn=Ge.length;un<Fn;un++){let ul=Ge[un];Kt.update(ul,hn),Kt.bind(ul,hn)}}return hn}function wr(A,X){A.ambientLightColor.needsUpdate=X,A.lightProbe.needsUpdate=X,A.sunLights.needsUpdate=X,A.sunLightShadows.needsUpdate=X,A.directionalLights.needsUpdate=X,A.directionalLightShadows.needsUpdate=X,A.pointLights.needsUpdate=X,A.pointLightShadows.needsUpdate=X,A.spotLights.needsUpdate=X,A.spotLightShadows.needsUpdate=X,A.rectAreaLights.needsUpdate=X,A.hemisphereLights.needsUpdate=X}function Ms(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return B},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(A,X,Q){let Z=$t.get(A);Z.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),$t.get(A.texture).__webglTexture=X,$t.get(A.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:Q,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,X){let Q=$t.get(A);Q.__webglFramebuffer=X,Q.__useDefaultFramebuffer=X===void 0},this.setRenderTarget=function(A,X=0,Q=0){lt=A,B=X,k=Q;let Z=null,J=!1,Pt=!1;if(A){let It=$t.get(A);if(It.__useDefaultFramebuffer!==void 0){Tt.bindFramebuffer(O.FRAMEBUFFER,It.__webglFramebuffer),et.copy(A.viewport),ft.copy(A.scissor),ht=A.scissorTest,Tt.viewport(et),Tt.scissor(ft),Tt.setScissorTest(ht),$=-1;return}else if(It.__webglFramebuffer===void 0)Qt.setupRenderTarget(A);else if(It.__hasExternalTextures)Qt.rebindTextures(A,$t.get(A.texture).__webglTexture,$t.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let ue=A.depthTexture;if(It.__boundDepthTexture!==ue){if(ue!==null&&$t.has(ue)&&(A.width!==ue.image.width||A.height!==ue.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Qt.setupDepthRenderbuffer(A)}}let Ft=A.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(Pt=!0);let Zt=$t.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Zt[X])?Z=Zt[X][Q]:Z=Zt[X],J=!0):A.samples>0&&Qt.useMultisampledRTT(A)===!1?Z=$t.get(A).__webglMultisampledFramebuffer:Array.isArray(Zt)?Z=Zt[Q]:Z=Zt,et.copy(A.viewport),ft.copy(A.scissor),ht=A.scissorTest}else et.copy(Jt).multiplyScalar(wt).floor(),ft.copy(se).multiplyScalar(wt).floor(),ht=ne;if(Q!==0&&(Z=H),Tt.bindFramebuffer(O.FRAMEBUFFER,Z)&&Tt.drawBuffers(A,Z),Tt.viewport(et),Tt.scissor(ft),Tt.setScissorTest(ht),J){let It=$t.get(A.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+X,It.__webglTexture,Q)}else if(Pt){let It=X;for(let Ft=0;Ft<A.textures.length;Ft++){let Zt=$t.get(A.textures[Ft]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Ft,Zt.__webglTexture,Q,It)}}else if(A!==null&&Q!==0){let It=$t.get(A.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,It.__webglTexture,Q)}$=-1};function Tr(A){let X=$t.get(A);return(X.__readFormat!==A.format||X.__readType!==A.type)&&(X.__readFormat=A.format,X.__readType=A.type,X.__formatReadable=he.textureFormatReadable(A.format),X.__typeReadable=he.textureTypeReadable(A.type)),X}this.readRenderTargetPixels=function(A,X,Q,Z,J,Pt,Ut,It=0){if(!(A&&A.isWebGLRenderTarget)){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=$t.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Tt.bindFramebuffer(O.FRAMEBUFFER,Ft);try{let Zt=A.textures[It],ue=Zt.format,Me=Zt.type;A.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+It);let Yt=Tr(Zt);if(Yt.__formatReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Yt.__typeReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}X>=0&&X<=A.width-Z&&Q>=0&&Q<=A.height-J&&O.readPixels(X,Q,Z,J,St.convert(ue),St.convert(Me),Pt)}finally{let Zt=lt!==null?$t.get(lt).__webglFramebuffer:null;Tt.bindFramebuffer(O.FRAMEBUFFER,Zt)}}},this.readRenderTargetPixelsAsync=async function(A,X,Q,Z,J,Pt,Ut,It=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=$t.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(X>=0&&X<=A.width-Z&&Q>=0&&Q<=A.height-J){Tt.bindFramebuffer(O.FRAMEBUFFER,Ft);let Zt=A.textures[It],ue=Zt.format,Me=Zt.type;A.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+It);let Yt=Tr(Zt);if(Yt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Yt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let be=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,be),O.bufferData(O.PIXEL_PACK_BUFFER,Pt.byteLength,O.STREAM_READ),O.readPixels(X,Q,Z,J,St.convert(ue),St.convert(Me),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let tn=lt!==null?$t.get(lt).__webglFramebuffer:null;Tt.bindFramebuffer(O.FRAMEBUFFER,tn);let ke=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await y0(O,ke,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,be),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Pt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(be),O.deleteSync(ke),Pt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,X=null,Q=0){let Z=Math.pow(2,-Q),J=Math.floor(A.image.width*Z),Pt=Math.floor(A.image.height*Z),Ut=X!==null?X.x:0,It=X!==null?X.y:0;Qt.setTexture2D(A,0),O.copyTexSubImage2D(O.TEXTURE_2D,Q,0,0,Ut,It,J,Pt),Tt.unbindTexture()},this.copyTextureToTexture=function(A,X,Q=null,Z=null,J=0,Pt=0){let Ut,It,Ft,Zt,ue,Me,Yt,be,tn,ke=A.isCompressedTexture?A.mipmaps[Pt]:A.image;if(Q!==null)Ut=Q.max.x-Q.min.x,It=Q.max.y-Q.min.y,Ft=Q.isBox3?Q.max.z-Q.min.z:1,Zt=Q.min.x,ue=Q.min.y,Me=Q.isBox3?Q.min.z:0;else{let ye=Math.pow(2,-J);Ut=Math.floor(ke.width*ye),It=Math.floor(ke.height*ye),A.isDataArrayTexture?Ft=ke.depth:A.isData3DTexture?Ft=Math.floor(ke.depth*ye):Ft=1,Zt=0,ue=0,Me=0}Z!==null?(Yt=Z.x,be=Z.y,tn=Z.z):(Yt=0,be=0,tn=0);let ze=St.convert(X.format),_n=St.convert(X.type),Ht;X.isData3DTexture?(Qt.setTexture3D(X,0),Ht=O.TEXTURE_3D):X.isDataArrayTexture||X.isCompressedArrayTexture?(Qt.setTexture2DArray(X,0),Ht=O.TEXTURE_2D_ARRAY):(Qt.setTexture2D(X,0),Ht=O.TEXTURE_2D),Tt.activeTexture(O.TEXTURE0),Tt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,X.flipY),Tt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,X.premultiplyAlpha),Tt.pixelStorei(O.UNPACK_ALIGNMENT,X.unpackAlignment);let cn=Tt.getParameter(O.UNPACK_ROW_LENGTH),Ee=Tt.getParameter(O.UNPACK_IMAGE_HEIGHT),Qi=Tt.getParameter(O.UNPACK_SKIP_PIXELS),hn=Tt.getParameter(O.UNPACK_SKIP_ROWS),Er=Tt.getParameter(O.UNPACK_SKIP_IMAGES);Tt.pixelStorei(O.UNPACK_ROW_LENGTH,ke.width),Tt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,ke.height),Tt.pixelStorei(O.UNPACK_SKIP_PIXELS,Zt),Tt.pixelStorei(O.UNPACK_SKIP_ROWS,ue),Tt.pixelStorei(O.UNPACK_SKIP_IMAGES,Me);let Oi=A.isDataArrayTexture||A.isData3DTexture,ts=X.isDataArrayTexture||X.isData3DTexture;if(A.isDepthTexture){let ye=$t.get(A),sn=$t.get(X),Gn=$t.get(ye.__renderTarget),Ge=$t.get(sn.__renderTarget);Tt.bindFramebuffer(O.READ_FRAMEBUFFER,Gn.__webglFramebuffer),Tt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ge.__webglFramebuffer);for(let un=0;un<Ft;un++)Oi&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,$t.get(A).__webglTexture,J,Me+un),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,$t.get(X).__webglTexture,Pt,tn+un)),O.blitFramebuffer(Zt,ue,Zt+Ut,ue+It,Yt,be,Yt+Ut,be+It,O.DEPTH_BUFFER_BIT,O.NEAREST);Tt.bindFramebuffer(O.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(J!==0||A.isRenderTargetTexture||$t.has(A)){let ye=$t.get(A),sn=$t.get(X);Tt.bindFramebuffer(O.READ_FRAMEBUFFER,N),Tt.bindFramebuffer(O.DRAW_FRAMEBUFFER,W);for(let Gn=0;Gn<Ft;Gn++)Oi?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ye.__webglTexture,J,Me+Gn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ye.__webglTexture,J),ts?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,sn.__webglTexture,Pt,tn+Gn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,sn.__webglTexture,Pt),J!==0?O.blitFramebuffer(Zt,ue,Zt+Ut,ue+It,Yt,be,Yt+Ut,be+It,O.COLOR_BUFFER_BIT,O.NEAREST):ts?O.copyTexSubImage3D(Ht,Pt,Yt,be,tn+Gn,Zt,ue,Ut,It):O.copyTexSubImage2D(Ht,Pt,Yt,be,Zt,ue,Ut,It);Tt.bindFramebuffer(O.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else ts?A.isDataTexture||A.isData3DTexture?O.texSubImage3D(Ht,Pt,Yt,be,tn,Ut,It,Ft,ze,_n,ke.data):X.isCompressedArrayTexture?O.compressedTexSubImage3D(Ht,Pt,Yt,be,tn,Ut,It,Ft,ze,ke.data):O.texSubImage3D(Ht,Pt,Yt,be,tn,Ut,It,Ft,ze,_n,ke):A.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Pt,Yt,be,Ut,It,ze,_n,ke.data):A.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Pt,Yt,be,ke.width,ke.height,ze,ke.data):O.texSubImage2D(O.TEXTURE_2D,Pt,Yt,be,Ut,It,ze,_n,ke);Tt.pixelStorei(O.UNPACK_ROW_LENGTH,cn),Tt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Ee),Tt.pixelStorei(O.UNPACK_SKIP_PIXELS,Qi),Tt.pixelStorei(O.UNPACK_SKIP_ROWS,hn),Tt.pixelStorei(O.UNPACK_SKIP_IMAGES,Er),Pt===0&&X.generateMipmaps===!0&&X.mipmapsAutoUpdate===!0&&O.generateMipmap(Ht),Tt.unbindTexture()},this.initRenderTarget=function(A){$t.get(A).__webglFramebuffer===void 0&&Qt.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Qt.setTextureCube(A,0):A.isData3DTexture?Qt.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Qt.setTexture2DArray(A,0):Qt.setTexture2D(A,0),Tt.unbindTexture()},this.resetState=function(){B=0,k=0,lt=null,Tt.reset(),Ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return xi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ce._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ce._getUnpackColorSpace()}};var l_={type:"change"},Df={type:"start"},h_={type:"end"},Kh=new hr,c_=new ci,MT=Math.cos(70*Wh.DEG2RAD),wn=new V,jn=2*Math.PI,Ue={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Lf=1e-6,jh=class extends Ya{constructor(t,e=null){super(t,e),this.state=Ue.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Vs.ROTATE,MIDDLE:Vs.DOLLY,RIGHT:Vs.PAN},this.touches={ONE:Hs.ROTATE,TWO:Hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new Ln,this._lastTargetPosition=new V,this._quat=new Ln().setFromUnitVectors(t.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new wo,this._sphericalDelta=new wo,this._scale=1,this._panOffset=new V,this._rotateStart=new _t,this._rotateEnd=new _t,this._rotateDelta=new _t,this._panStart=new _t,this._panEnd=new _t,this._panDelta=new _t,this._dollyStart=new _t,this._dollyEnd=new _t,this._dollyDelta=new _t,this._dollyDirection=new V,this._mouse=new _t,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=wT.bind(this),this._onPointerDown=bT.bind(this),this._onPointerUp=TT.bind(this),this._onContextMenu=LT.bind(this),this._onMouseWheel=CT.bind(this),this._onKeyDown=RT.bind(this),this._onTouchStart=PT.bind(this),this._onTouchMove=IT.bind(this),this._onMouseDown=ET.bind(this),this._onMouseMove=AT.bind(this),this._interceptControlDown=DT.bind(this),this._interceptControlUp=NT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ue.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(l_),this.update(),this.state=Ue.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;wn.copy(e).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===Ue.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=jn:n>Math.PI&&(n-=jn),s<-Math.PI?s+=jn:s>Math.PI&&(s-=jn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),e.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Kh.origin.copy(this.object.position),Kh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Kh.direction))<MT?this.object.lookAt(this.target):(c_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Kh.intersectPlane(c_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Lf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Lf||this._lastTargetPosition.distanceToSquared(this.target)>Lf?(this.dispatchEvent(l_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?jn/60*this.autoRotateSpeed*t:jn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){wn.setFromMatrixColumn(e,0),wn.multiplyScalar(-t),this._panOffset.add(wn)}_panUp(t,e){this.screenSpacePanning===!0?wn.setFromMatrixColumn(e,1):(wn.setFromMatrixColumn(e,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(t),this._panOffset.add(wn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new _t,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function bT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function wT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function TT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(h_),this.state=Ue.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function ET(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Vs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ue.DOLLY;break;case Vs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ue.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ue.ROTATE}break;case Vs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ue.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ue.PAN}break;default:this.state=Ue.NONE}this.state!==Ue.NONE&&this.dispatchEvent(Df)}function AT(i){switch(this.state){case Ue.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ue.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ue.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function CT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ue.NONE||(i.preventDefault(),this.dispatchEvent(Df),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(h_))}function RT(i){this.enabled!==!1&&this._handleKeyDown(i)}function PT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Hs.ROTATE:if(this.enableRotate===!1){this.state=Ue.NONE;break}this._handleTouchStartRotate(i),this.state=Ue.TOUCH_ROTATE;break;case Hs.PAN:if(this.enablePan===!1){this.state=Ue.NONE;break}this._handleTouchStartPan(i),this.state=Ue.TOUCH_PAN;break;default:this.state=Ue.NONE}break;case 2:switch(this.touches.TWO){case Hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ue.TOUCH_DOLLY_PAN;break;case Hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ue.TOUCH_DOLLY_ROTATE;break;default:this.state=Ue.NONE}break;default:this.state=Ue.NONE}this.state!==Ue.NONE&&this.dispatchEvent(Df)}function IT(i){switch(this._trackPointer(i),this.state){case Ue.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ue.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ue.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ue.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ue.NONE}}function LT(i){this.enabled!==!1&&i.preventDefault()}function DT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function NT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Nf(i,t=!1){let e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new gn;l.morphTargetsRelative=a;let c=0;for(let h=0;h<i.length;++h){let u=i[h],d=0,f=0;if(e!==(u.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in u.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(u.attributes[p]),d++}if(d!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==u.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in u.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(u.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(u.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=u.index.count;else if(u.attributes.position!==void 0)p=u.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,h),c+=p}}if(e){let h=0,u=[];for(let d=0;d<i.length;++d){let f=i[d].index;for(let p=0;p<f.count;++p)u.push(f.getX(p)+h);h+=i[d].attributes.position.count}l.setIndex(u)}for(let h in r){let u=u_(r[h]);if(!u)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,u)}for(let h in o){let u=o[h][0].length;if(u!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let d=0;d<u;++d){let f=[];for(let x=0;x<o[h].length;++x)f.push(o[h][x][d]);let p=u_(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(p)}}}return l}function u_(i){let t,e,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new Pn(o,e,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let u=l/e;for(let d=0,f=h.count;d<f;d++)for(let p=0;p<e;p++){let x=h.getComponent(d,p);a.setComponent(d+u,p,x)}}else o.set(h.array,l);l+=h.count*e}return s!==void 0&&(a.gpuType=s),a}var Io=40,d_=24e3,UT=100,f_=48,FT=401,p_=254,Un=(i,t=new V)=>t.set(i[1],-i[2],-i[0]);function m_(i,t){let[e,n,s]=[i.heading_rad/2,i.pitch_rad/2,i.roll_rad/2],r=Uf[0].set(0,-Math.sin(e),0,Math.cos(e)),o=Uf[1].set(Math.sin(n),0,0,Math.cos(n)),a=Uf[2].set(0,0,-Math.sin(s),Math.cos(s));return t.copy(r).multiply(o).multiply(a)}var Uf=[new Ln,new Ln,new Ln];function OT(i,t){let e=[],n=i==="tanker"?new qi(.34,.26,.6):new qi(.2,.12,.28),s=new So(.22).translate(0,.28,0);if(t){for(let a of[Math.PI/4,-Math.PI/4])e.push(new mr(.34,1.3).rotateX(Math.PI/2).rotateY(a));let o=new fr(.14,.5,3).rotateX(-Math.PI/2).translate(0,.02,-.35);return e.push(o,...i==="pursuer"?[]:[n],...i==="target"?[s]:[]),Nf(e.map(a=>a.index?a.toNonIndexed():a))}for(let[o,a]of[[1,1],[1,-1],[-1,1],[-1,-1]]){let l=new dr(.22,.22,.03,10);l.translate(.32*o,.05,.32*a);let c=new qi(.06,.05,.45);c.translate(0,0,.22),c.rotateY(Math.atan2(o,a)),e.push(l,c)}let r=new fr(.09,.3,6);return r.rotateX(-Math.PI/2),r.translate(0,.02,-.28),e.push(r,n),i==="target"&&e.push(s),Nf(e.map(o=>o.index?o.toNonIndexed():o))}var Qh=class{constructor(t,e,n){this.canvas=t,this.names=e,this.renderer=new $h({canvas:t,antialias:!1,powerPreference:"low-power"}),this.scene=new xa,this.camera=new Yn(50,1,.05,5e3),this.controls=new jh(this.camera,t),this.controls.maxPolarAngle=.97*Math.PI,this.controls.addEventListener("change",()=>this.dirty=!0),this.dirty=!0,this.mode="free";let s=new Ha(16777215,2.2);s.position.set(30,80,20),this.scene.add(new Wa(16777215,1.3),s),this.material=new Mo({side:fi}),this.bodies=new Map,this.lines=this.#e(0),this.paths=this.#e(0),this.scene.add(this.lines,this.paths),this.fixed=new hs,this.scene.add(this.fixed),this.madeOf=null,this.world=null,this.pathsOf={version:-1,until_s:NaN,chosen:null,dark:!1,at:0},this.size=1,this.places=[],this.target=new V,this.framed=!1,this.framedFar=0,this.touched=!1,this.controls.addEventListener("start",()=>this.touched=!0),this.width=0,this.height=0;let r=[0,0];t.addEventListener("pointerdown",o=>r=[o.clientX,o.clientY]),t.addEventListener("pointerup",o=>{Math.hypot(o.clientX-r[0],o.clientY-r[1])>4||n(Vo(this.places,o.offsetX,o.offsetY),o)}),t.addEventListener("keydown",o=>this.#t(o))}#t(t){let e={ArrowLeft:[.1,0],ArrowRight:[-.1,0],ArrowUp:[0,.08],ArrowDown:[0,-.08]}[t.key],n=this.camera.position.clone().sub(this.controls.target);if(e){let s=Math.hypot(n.x,n.z),r=Math.atan2(n.x,n.z)-e[0],o=Math.min(Math.max(Math.atan2(n.y,s)+e[1],-.2),1.5),a=n.length();n.set(a*Math.cos(o)*Math.sin(r),a*Math.sin(o),a*Math.cos(o)*Math.cos(r))}else if(t.key==="+"||t.key==="-")n.multiplyScalar(t.key==="+"?.85:1.18);else return t.key==="0"?void this.whole():void 0;this.camera.position.copy(this.controls.target).add(n),this.touched=!0,this.controls.update(),this.dirty=!0,t.preventDefault(),t.stopPropagation()}whole(){this.framed=this.touched=!1,this.mode="free",this.dirty=!0}#e(t){let e=new gn;e.setAttribute("position",new Pn(new Float32Array(3*t),3)),e.setAttribute("color",new Pn(new Float32Array(3*t),3));let n=new ur(e,new Bs({vertexColors:!0,transparent:!0,opacity:.9}));return n.frustumCulled=!1,n}#i(t,e,n){let s=t.geometry;if(s.attributes.position.array.length<e.length){s.dispose();let a=new gn,l=Math.ceil(e.length*1.5);a.setAttribute("position",new Pn(new Float32Array(l-l%3),3)),a.setAttribute("color",new Pn(new Float32Array(l-l%3),3)),t.geometry=a}let{position:r,color:o}=t.geometry.attributes;r.array.set(e),o.array.set(n),r.needsUpdate=o.needsUpdate=!0,t.geometry.setDrawRange(0,e.length/3)}#s(t,e){let n=t.sessionAt(e),s=n?.wind,r=`${JSON.stringify(s??0)} ${JSON.stringify(t.session?.plans??0)} ${t.session?.vehicles.length} ${we().dark}`;if(this.madeOf===r&&this.world===n&&this.fixed.children.length)return;[this.madeOf,this.world]=[r,n];for(let _ of this.fixed.children)(_ instanceof Sn||_ instanceof ur)&&_.geometry.dispose();this.fixed.clear();let o=we(),a=Qo(t)??[[-10,10],[-10,10]],l=Math.max(a[0][1]-a[0][0],a[1][1]-a[1][0],10),c=Gl(l/6),h=2*Math.ceil(.75*l/c),u=new Xa(h*c,h,o.grid,o.grid),d=_=>Math.round((_[0]+_[1])/2/c)*c;u.position.set(d(a[1]),0,-d(a[0])),this.fixed.add(u);let f=new Mo({color:o.solid,transparent:!0,opacity:.6,side:fi});for(let _ of n?.obstacles??[]){let[M,v,C]=_.centre_ned,T=Math.max(_.bottom_d-_.top_d,.05),y;if(_.kind==="sphere")y=new Sn(new Ba(_.radius_m??.5,20,14),f),Un([M,v,C],y.position);else if(!_.outline_ne.length)y=new Sn(new So(.3),f),Un([M,v,C],y.position);else{let b=new xo;_.outline_ne.forEach(([U,P],R)=>b[R?"lineTo":"moveTo"](P,U)),y=new Sn(new Oa(b,{depth:T,bevelEnabled:!1}),f),y.rotation.x=-Math.PI/2,y.position.y=-_.bottom_d}this.fixed.add(y)}let p=[],x=[],g=(_,M,v)=>_.slice(1).forEach((C,T)=>{let y=Un(_[T]),b=Un(C),U=Math.min(Math.max(Math.round(y.distanceTo(b)/v),1),FT);for(let P=0;P<U;P+=2)p.push(...y.clone().lerp(b,P/U).toArray(),...y.clone().lerp(b,Math.min(P+1,U)/U).toArray()),x.push(...M.toArray(),...M.toArray())});for(let _ of n?.vehicles??[])g(_.path_ned,new oe(o.soft),.8);for(let{points:_,colour:M}of qm(t.session))g(_,new oe(M),Math.max(l/150,.8));if(s){let _=(s.from_deg+180)*Math.PI/180,M=new V(Math.sin(_),0,-Math.cos(_)),v=new V((a[1][0]+a[1][1])/2,.12*l,-(a[0][0]+a[0][1])/2),C=.14*l,T=v.clone().addScaledVector(M,-.62*l);this.fixed.add(new qa(M,T,C,o.ink,.3*C,.14*C))}let m=this.#e(0);this.#i(m,p,x),this.fixed.add(m);for(let _ of t.session?.bases??[]){let M=new Sn(new dr(1,1,.1,24),f);Un(_.p_ned,M.position),this.fixed.add(M)}this.span=l,this.size=Math.min(Math.max(l/45,.6),4),this.scene.background=new oe(o.paper)}#n(t){let e=Qo(t);if(!e)return 8;let[[n,s],[r,o]]=e;return 1.3*Math.max(1,1.3/this.camera.aspect)*Math.max(s-n,.9*(o-r),8)}#r(t){let e=Qo(t);if(!e||!t.count)return;let[[n,s],[r,o]]=e,a=this.#n(t);this.target.set((r+o)/2,2,-(n+s)/2),this.controls.target.copy(this.target),this.camera.position.set(this.target.x-.35*a,2+.5*a,this.target.z+.72*a),this.controls.update(),this.framed=!0,this.framedFar=a}draw(t,e,{chosen:n,selected:s,paths:r,until_s:o,trail_s:a,ghosts:l}){let c=this.canvas.getBoundingClientRect();if(!c.width||!c.height)return;(this.width!==c.width||this.height!==c.height)&&([this.width,this.height]=[c.width,c.height],this.renderer.setPixelRatio(Math.min(window.devicePixelRatio||1,2)),this.renderer.setSize(c.width,c.height,!1),this.camera.aspect=c.width/c.height,this.camera.updateProjectionMatrix()),this.#s(t,e.t_s);let h=this.#n(t)>1.15*this.framedFar;(!this.framed||h&&!this.touched)&&this.#r(t),this.#o(e,n),this.#c(t,e,l,o,r),this.paths.visible=r,r&&this.#h(t,o,a,n),this.#u(e,n),this.renderer.render(this.scene,this.camera),this.#d(e,n,s),l.length&&this.#l(l,o)}#a(t,e,n,s){let r=.35*this.size;for(let o of t){for(let c of o.at(e)?.vehicles??[]){if(!c.p_ned)continue;let h=Un(c.p_ned),u=[[r,0,0],[0,0,r],[-r,0,0],[0,0,-r]].map(([d,f,p])=>h.clone().add(new V(d,f,p)));u.forEach((d,f)=>s(d,u[(f+1)%4]));for(let d of[r,-r])for(let f of u)s(f,h.clone().add(new V(0,d,0)))}let a=n?qn(o.t_s,e+1e-6,o.count)+1:0,l=Math.max(Math.ceil(a*o.columns.size/d_),1);for(let{n:c,e:h,d:u}of o.columns.values())for(let d=0;d+l<a;d+=2*l)Number.isNaN(c[d]+c[d+l])||s(Un([c[d],h[d],u[d]]),Un([c[d+l],h[d+l],u[d+l]]))}}#l(t,e){let n=sr(this.names),s=new V;n.font="11px system-ui, sans-serif",n.fillStyle=we().soft;for(let r of t.flatMap(o=>o.at(e)?.vehicles??[]))r.p_ned&&(Un(r.p_ned,s).project(this.camera),s.z<=1&&n.fillText(`(${r.sysid})`,(s.x+1)/2*this.width+9,(1-s.y)/2*this.height+14))}#o(t,e){let n=new Map([["pursuer",0],["target",0],["tanker",0]]),s=new Ne,r=new Ln,o=new V,a=new V,l=new oe,c=t.vehicles.length>Io;for(let h of t.vehicles){if(!h.p_ned||this.mode==="first"&&h.sysid===e)continue;let u=n.has(h.role)?h.role:"pursuer",d=`${u} ${c}`,f=this.bodies.get(d);f||(f=new wa(OT(u,c),this.material,p_+1),f.frustumCulled=!1,this.bodies.set(d,f),this.scene.add(f));let p=n.get(u)??0;if(p>p_)continue;let x=this.size*(h.sysid===e?1.35:1);f.setMatrixAt(p,s.compose(Un(h.p_ned,o),m_(h,r),a.setScalar(x))),f.setColorAt(p,l.set(h.alive?pn(h.sysid):we().solid)),n.set(u,p+1)}for(let[h,u]of this.bodies)u.count=h.endsWith(String(c))?n.get(h.split(" ")[0])??0:0,u.instanceMatrix.needsUpdate=!0,u.instanceColor&&(u.instanceColor.needsUpdate=!0)}#c(t,e,n,s,r){let o=[],a=[],l=we(),[c,h,u]=[new oe(l.soft),new oe(l.warn),new oe(l.crowd.replace(/,[^,]*\)$/,")").replace("rgba","rgb"))],d=(g,m,_)=>{o.push(g.x,g.y,g.z,m.x,m.y,m.z),a.push(_.r,_.g,_.b,_.r,_.g,_.b)},f=new Map,p=e.vehicles.length<=Io,x=t.session?.ring_m??null;for(let g of e.vehicles){if(!g.p_ned)continue;let m=Un(g.p_ned);if(f.set(g.sysid,m),p&&d(m,m.clone().setY(0),u),p&&g.aim_ned&&d(m,Un(g.aim_ned),c),g.role==="target"&&x!==null)for(let _=0;_<f_;_+=1){let[M,v]=[_,_+1].map(C=>2*Math.PI*C/f_);d(new V(m.x+x*Math.cos(M),m.y,m.z+x*Math.sin(M)),new V(m.x+x*Math.cos(v),m.y,m.z+x*Math.sin(v)),c)}}for(let g of t.session?.bases??[])f.set(`base ${g.name}`,Un(g.p_ned));for(let g of e.services){let m=f.get(g.tanker??`base ${g.base}`),_=f.get(g.receiver);if(!m||!_)continue;let M=g.phase==="transfer"?1:9;for(let v=0;v<M;v+=2)d(m.clone().lerp(_,v/M),m.clone().lerp(_,(v+1)/M),h);if(g.phase==="transfer")for(let v of[-.06,.06])d(m.clone().add(new V(0,v,0)),_.clone().add(new V(0,v,0)),h)}for(let g of e.traffic){let m=Un(g.p_ned),_=.6*this.size,[M,v]=[m.clone().setY(m.y+_),m.clone().setY(m.y-_)],C=[[_,0],[0,_],[-_,0],[0,-_]].map(([T,y])=>new V(m.x+T,m.y,m.z+y));C.forEach((T,y)=>{d(M,T,h),d(v,T,h),d(T,C[(y+1)%4],h)})}this.#a(n,s,r,(g,m)=>d(g,m,c)),this.#i(this.lines,o,a)}#h(t,e,n,s){let r=we().dark,o=this.pathsOf,a=performance.now();if(o.version===t.version&&o.until_s===e&&o.chosen===s&&o.dark===r||t.columns.size>Io&&a-o.at<900&&o.chosen===s&&o.dark===r&&e>=o.until_s)return;this.pathsOf={version:t.version,until_s:e,chosen:s,dark:r,at:a};let l=qn(t.t_s,e+1e-6,t.count)+1,c=qn(t.t_s,e-n,t.count)+1,h=[],u=[],d=new oe(we().paper);for(let[f,{n:p,e:x,d:g}]of t.columns){let m=t.columns.size>Io,_=new oe(pn(f));(s===null?m:f!==s)&&_.lerp(d,m?.6:.45);let M=m&&f!==s?c:0,v=Math.max(Math.ceil((l-M)/(m?UT:d_/t.columns.size)),1);for(let C=M;C<l-1;C+=v){let T=Math.min(C+v,l-1);Number.isNaN(p[C])||Number.isNaN(p[T])||(h.push(x[C],-g[C],-p[C],x[T],-g[T],-p[T]),u.push(_.r,_.g,_.b,_.r,_.g,_.b))}}this.#i(this.paths,h,u)}#u(t,e){let n=t.vehicles.find(r=>r.sysid===e);if(this.controls.enabled=this.mode!=="first"||!n?.p_ned,!n?.p_ned||this.mode==="free"){this.controls.update();return}let s=Un(n.p_ned);if(this.mode==="follow"){let r=this.camera.position.clone().sub(this.controls.target),o=Math.min(r.length(),14*this.size);this.controls.target.copy(s),this.camera.position.copy(s).add(r.setLength(Math.max(o,2*this.size))),this.camera.lookAt(s);return}m_(n,this.camera.quaternion),this.camera.position.copy(s).add(new V(0,.12,0).applyQuaternion(this.camera.quaternion))}#d(t,e,n){let s=Math.min(window.devicePixelRatio||1,2),{width:r,height:o}=this,a=t.vehicles.length>Io;this.names.width!==Math.round(r*s)&&(this.names.width=Math.round(r*s)),this.names.height!==Math.round(o*s)&&(this.names.height=Math.round(o*s));let l=sr(this.names);l.setTransform(s,0,0,s,0,0),l.clearRect(0,0,r,o),l.font=`600 ${qr(12)}px system-ui, sans-serif`;let c=qr(a?5:8),{ink:h,paper:u,warn:d}=we(),f=new V;this.places=[];let p=[],x=(m,_,M,v)=>{p.some(([C,T])=>Math.abs(C-_)<24&&Math.abs(T-M)<13)||(p.push([_,M]),l.lineWidth=3,l.strokeStyle=u,l.strokeText(m,_+9,M-7),l.fillStyle=v,l.fillText(m,_+9,M-7))},g=[...t.vehicles].sort((m,_)=>+(_.sysid===e)-+(m.sysid===e)||_.severity-m.severity);for(let m of g){if(!m.p_ned||(Un(m.p_ned,f).project(this.camera),f.z>1))continue;let[_,M]=[(f.x+1)/2*r,(1-f.y)/2*o];this.places.push({sysid:m.sysid,x:_,y:M}),zl(l,m,_,M,c),n.has(m.sysid)&&(m.sysid!==e||this.mode!=="first")&&(l.strokeStyle=h,l.lineWidth=m.sysid===e?2.5:1.5,l.beginPath(),l.arc(_,M,15,0,2*Math.PI),l.stroke()),p.length<Io&&(!a||m.sysid===e||m.severity>1||m.role!=="pursuer")&&x(String(m.sysid),_,M,h)}for(let m of t.traffic)Un(m.p_ned,f).project(this.camera),f.z<=1&&x(m.callsign,(f.x+1)/2*r,(1-f.y)/2*o,d)}};var Ff=14,ol=[];function g_(i){ol=i}function Mr(i){let t=ol.findIndex(e=>e.name===i.condition);return t<0?ol.length:t}function BT(i,t){return i.slice(0,Ff).map((n,s)=>`${n.sysid}${n.figure?` (${n.figure}${s||!t?"":` ${t}`})`:""}`).join(", ")+(i.length>Ff?` and ${i.length-Ff} more`:"")}var tu=class{constructor(t){this.well=D("p",{class:"well"}),this.parts=new Map;let e=D("ul");for(let{name:n,title:s}of ol){let[r,o]=[D("b"),D("span",{class:"figures-of"})],a=D("button",{type:"button",onclick:()=>t(this.parts.get(n)?.sysids??[])},D("span",{class:"sign","aria-hidden":"true"},Qu[n]??""),r,o),l=D("li",{class:n,"data-condition":n,"data-title":s},a);l.hidden=!0,e.append(l),this.parts.set(n,{item:l,button:a,count:r,text:o,sysids:[]})}this.counts=D("p",{class:"unseen","aria-live":"polite"}),this.all=D("div",{class:"all"}),this.element=D("section",{class:"strip","aria-label":"trouble"},this.well,e,this.all,this.counts)}show(t){let e=[];for(let{name:r,title:o,unit:a}of ol){let l=this.parts.get(r);if(!l)continue;let c=t.vehicles.filter(u=>u.condition===r).sort((u,d)=>d.urgency-u.urgency||u.sysid-d.sysid);if(l.sysids=c.map(u=>u.sysid),l.item.hidden!==!c.length&&(l.item.hidden=!c.length),!c.length)continue;let h=`${o}: ${BT(c,a)}`;Re(l.count,String(c.length)),Re(l.text,h),l.button.title=`${h}. Click to select.`,e.push(`${c.length} ${o.toLowerCase()}`)}let n=t.vehicles.filter(r=>r.armed).length,s=e.length?"":`All well · ${t.vehicles.length} ${t.vehicles.length===1?"vehicle":"vehicles"}, ${n} armed`;this.well.hidden!==!s&&(this.well.hidden=!s),Re(this.well,s),Re(this.counts,e.join(", "))}};var eu=10,kT=40,qs=[{key:"id",name:"id",text:i=>String(i.sysid),sort:i=>i.sysid},{key:"trouble",name:"trouble",word:!0,text:i=>i.trouble.join(", ")||i.note||(i.landed?"landed":""),sort:i=>Mr(i)+(i.condition||i.landed?0:.5)},{key:"state",name:"state",word:!0,folds:!0,text:i=>i.state||(i.alive?"–":"lost"),sort:i=>i.state},{key:"mode",name:"mode",word:!0,folds:!0,text:i=>i.mode||"–",sort:i=>i.mode},{key:"role",name:"role",word:!0,folds:!0,text:i=>i.role,sort:i=>i.role},{key:"battery",name:"battery %",text:i=>xe(i.battery===null?null:100*i.battery,0),sort:i=>i.battery??-1},{key:"height",name:"height m",text:i=>xe(i.height_m,1),sort:i=>i.height_m??-1e9},{key:"speed",name:"speed m/s",text:i=>xe(i.speed_m_s,1),sort:i=>i.speed_m_s},{key:"target",name:"target m",text:i=>xe(i.target_m,1),sort:i=>i.target_m??-1}],zT=qs.filter(i=>i.folds),__=i=>[i.word&&"word",i.folds&&"folds",i.key==="trouble"&&"trouble"].filter(Boolean).join(" "),nu=class{constructor(t,e){this.choose=e,this.by="trouble",this.down=!1,this.rows=new Map,this.shown_at=0,this.filter=D("input",{type:"search",placeholder:"filter, e.g. tanker, served, 12","aria-label":"filter vehicles",oninput:()=>this.again()}),this.goto=D("input",{type:"text",inputmode:"numeric",size:4,placeholder:"id","aria-label":"go to vehicle"});let n=D("form",{class:"goto",onsubmit:r=>{r.preventDefault();let o=Number(this.goto.value);this.rows.has(o)&&e(o,!0),this.goto.setCustomValidity(this.rows.has(o)?"":"There is no such vehicle."),this.goto.reportValidity()}},this.goto,D("button",{type:"submit"},"go to"));this.goto.addEventListener("input",()=>this.goto.setCustomValidity("")),this.totals=D("p",{class:"totals small","aria-live":"off"}),this.histogram=D("div",{class:"histogram",role:"img","aria-label":"batteries: not known yet"}),this.heads=qs.map(r=>{let o=D("button",{type:"button",onclick:()=>this.sortBy(r.key)},r.name);return D("th",{scope:"col",class:__(r)},o)}),this.body=D("tbody");let s=D("table",{class:"fleet"},D("thead",{},D("tr",{},...this.heads)),this.body);t.append(D("div",{class:"tools"},this.filter,n),this.totals,this.histogram,D("div",{class:"scroll fleet-scroll",tabindex:0,role:"region","aria-label":"vehicles"},s)),this.sortBy("trouble",!1)}sortBy(t,e=!0){this.down=e&&this.by===t&&!this.down,this.by=t,this.heads.forEach((n,s)=>{qs[s].key===t?n.setAttribute("aria-sort",this.down?"descending":"ascending"):n.removeAttribute("aria-sort")}),this.again()}again(){this.last&&this.show(this.last.snapshot,this.last.chosen,this.last.picked,!0)}show(t,e,n,s=!1){let r=this.last?.picked!==n;this.last={snapshot:t,chosen:e,picked:n};let o=t.vehicles.length>kT?500:180;if(!s&&!r&&performance.now()-this.shown_at<o)return;this.shown_at=performance.now();let a=this.filter.value.trim().toLowerCase(),l=qs.find(u=>u.key===this.by)??qs[0],c=[...t.vehicles].sort((u,d)=>{let[f,p]=[l.sort(u),l.sort(d)],x=f<p?-1:f>p?1:u.sysid-d.sysid;return this.down?-x:x}),h=[];for(let u of c){let d=this.rows.get(u.sysid)??this.#t(u);qs.forEach((m,_)=>Re(d.texts[_],m.text(u))),Re(d.sign,Hm(u)),Re(d.folded,zT.map(m=>m.text(u)).filter(m=>m!=="–").join(" · "));let f=pn(u.sysid);d.colour!==f&&(d.swatch.style.background=d.colour=f);let p=`${u.sysid} ${u.role} ${u.label} ${u.state} ${u.mode} ${u.note} ${u.trouble.join(" ")}`.toLowerCase(),x=a!==""&&!a.split(/\s+/).every(m=>/^\d+$/.test(m)?String(u.sysid).startsWith(m):p.includes(m));d.row.hidden!==x&&(d.row.hidden=x);let g=String(n.has(u.sysid));d.row.getAttribute("aria-selected")!==g&&d.row.setAttribute("aria-selected",g),d.row.className!==u.condition&&(d.row.className=u.condition),h.push(d.row)}(h.some((u,d)=>this.body.children[d]!==u)||this.body.children.length!==h.length)&&this.body.replaceChildren(...h),this.#e(t),r&&e!==null&&this.rows.get(e)?.row.scrollIntoView({block:"nearest"})}get shown(){return[...this.rows].filter(([,t])=>!t.row.hidden).sort(([,t],[,e])=>t.row.rowIndex-e.row.rowIndex).map(([t])=>t)}between(t,e,n){if(!(n.target instanceof Node&&this.body.contains(n.target)))return null;let{shown:s}=this,[r,o]=[s.indexOf(t),s.indexOf(e)].sort((a,l)=>a-l);return r<0?null:s.slice(r,o+1)}#t(t){let e=D("i",{class:"swatch"}),n=D("span",{class:"sign","aria-hidden":"true"}),s=D("small",{class:"folded"}),r=qs.map((l,c)=>c?D("span"):D("button",{type:"button",class:"link"})),o=qs.map((l,c)=>{let h={id:[e],trouble:[n]}[l.key]??[];return D("td",{class:__(l)},...h,r[c],l.key==="trouble"?s:null)}),a={row:D("tr",{onclick:l=>this.choose(t.sysid,!1,l)},...o),texts:r,sign:n,folded:s,swatch:e,colour:""};return this.rows.set(t.sysid,a),a}#e(t){let e=new Map,n=new Array(eu).fill(0);for(let a of t.vehicles){let l=a.mode||a.state||"unknown";e.set(l,(e.get(l)??0)+1),a.battery!==null&&Number.isFinite(a.battery)&&(n[Math.min(Math.max(Math.floor(eu*a.battery),0),eu-1)]+=1)}let s=[...e].sort((a,l)=>l[1]-a[1]).map(([a,l])=>`${l} ${a}`);Re(this.totals,`${t.vehicles.length} vehicles: ${s.join(", ")}`);let r=Math.max(...n,1);for(;this.histogram.children.length<eu;)this.histogram.append(D("span"));n.forEach((a,l)=>{let c=this.histogram.children[l];c.style.height=`${100*a/r}%`,c.title=`${a} with ${10*l} to ${10*l+10} %`,c.className=l<2?"low":""});let o=n[0]+n[1];this.histogram.setAttribute("aria-label",`batteries, by tenths from empty to full: ${n.join(", ")}; ${o} below 20 %`)}};var GT=100;function al(){let i=Number.parseFloat(new URLSearchParams(location.hash.slice(1)).get("t")??"");return Number.isFinite(i)?i:null}var iu=class{constructor(t,e){this.player=e,this.marks=D("canvas",{class:"marks","aria-hidden":"true"}),this.slider=D("input",{type:"range",min:0,max:1,step:.1,value:0,"aria-label":"time",oninput:()=>{this.dragged_at=performance.now(),e.seek(Number(this.slider.value))}}),this.dragged_at=-1/0,this.play=D("button",{type:"button",onclick:()=>e.toggle()},"pause"),this.slower=D("button",{type:"button","aria-label":"slower",onclick:()=>e.faster(-1)},"−"),this.quicker=D("button",{type:"button","aria-label":"faster",onclick:()=>e.faster(1)},"+"),this.speed=D("span",{class:"value"}),this.time=D("span",{class:"value time"}),this.live=D("button",{type:"button",class:"live",onclick:()=>e.newest?.()},"live"),this.live.hidden=!e.newest,this.marked="",t.append(D("div",{class:"tools"},this.play,this.slower,this.speed,this.quicker,this.time,this.live),D("div",{class:"line"},this.marks,this.slider))}show({now_s:t,begin_s:e,end_s:n,playing:s,speed:r,following:o,events:a}){Re(this.play,s?"pause":"play"),Re(this.speed,r),Re(this.time,`${wi(t)} of ${wi(n)}`),this.live.setAttribute("aria-pressed",String(o));let[l,c]=[e.toFixed(1),Math.max(n,e+.1).toFixed(1)];this.slider.min!==l&&(this.slider.min=l),this.slider.max!==c&&(this.slider.max=c),performance.now()-this.dragged_at>4*GT&&(this.slider.value=t.toFixed(1)),this.slider.setAttribute("aria-valuetext",wi(t));let u=`${this.marks.clientWidth} ${a.length} ${l} ${c} ${we().dark}`;if(u===this.marked)return;this.marked=u;let{width:d,height:f,scale:p}=pl(this.marks),x=sr(this.marks),{bad:g,warn:m,soft:_}=we();x.setTransform(p,0,0,p,0,0),x.clearRect(0,0,d,f);let M=Math.max(n-e,.1);for(let v of["info","warning","critical"]){x.fillStyle=v==="info"?_:v==="warning"?m:g;let C=v==="info"?.4:v==="warning"?.7:1;for(let T of a)T.level!==v||T.t_s<e||T.t_s>n||x.fillRect((T.t_s-e)/M*d-.75,f*(1-C),1.5,f*C)}}};var vs=[.1,.25,.5,1,2,5,10,20,50,100],Ys=16,VT=20,HT=500,WT=300,XT=200,qT=[{title:"Distance to target",unit:"m",digits:2,channel:"target",zero:!0},{title:"Battery",unit:"%",digits:1,channel:"battery",zero:!0},{title:"Height",unit:"m",digits:2,channel:"height"},{title:"Speed",unit:"m/s",digits:2,channel:"speed",zero:!0},{title:"State v of each competitor",unit:"",digits:3,channel:"v",range:[-.03,1.06]},{title:"Frames lost so far",unit:"",digits:0,channel:"lost",zero:!0}],Lo=class{constructor(t,{charts:e,player:n}){this.flight=new Xr,this.time=new Ol,this.at_s=null,this.chosen=null,this.selected=new Set,this.shown=new Set,this.given=!1,this.paths=!0,this.whole_paths=!1,this.view="space",this.player=n,this.playing=!0,this.speed="",this.begin_s=void 0,this.end_s=void 0,this.dirty=!0,this.drawn_ms=0,this.frames=0,this.after=[],this.current=null,this.paneled=null,this.paneledFor=null,this.charted=-1,this.charted_at=0,this.shown_at=0,this.time.seek=_=>n.seek(_),this.drawnFirst=()=>{},this.first=new Promise(_=>this.drawnFirst=()=>_(null));let s=(_,M)=>this.pick(_,M);this.strip=new tu(_=>this.select(_));let r=D("canvas",{class:"space",tabindex:0,role:"img","aria-label":"the fleet in space; arrow keys turn, + and − zoom, 0 shows everything, b selects all in the picture"}),o=D("canvas",{class:"names","aria-hidden":"true"}),a=D("canvas",{class:"map",tabindex:0,role:"img","aria-label":"the fleet from above, north up; arrow keys move, + and − zoom, 0 shows everything, b selects all in the picture"});this.views={space:D("button",{type:"button",onclick:()=>this.show("space")},"3-D",As("3")),map:D("button",{type:"button",onclick:()=>this.show("map")},"map",As("M"))},this.camera=D("select",{"aria-label":"camera",onchange:()=>this.setCamera(this.camera.value)},D("option",{value:"free"},"free view"),D("option",{value:"follow"},"follow chosen"),D("option",{value:"first"},"from its eyes"));let l=D("button",{type:"button",onclick:()=>this.whole()},"show all",As("0"));this.pathsButton=D("button",{type:"button","aria-pressed":"true",onclick:()=>this.togglePaths()},"paths",As("V")),this.wind=D("span",{class:"soft wind"});let c=D("div",{class:"picture"},r,o,a);this.box=new ml(c,{places:()=>this.places,take:(_,M)=>this.select(M?[...new Set([...this.selected,..._])]:_),pick:s});let h=D("div",{class:"tools"},this.views.space,this.views.map,this.camera,l,this.pathsButton,this.box.button,this.wind),u=D("section",{class:"card scene","aria-label":"picture"},h,c),d=D("section",{class:"card time-line","aria-label":"time"}),f=D("section",{class:"card","aria-label":"fleet"},D("h2",{},"Fleet")),p=D("section",{class:"card vehicle","aria-label":"vehicle"},D("h2",{},"Vehicle")),x=D("section",{class:"card contest","aria-label":"competition and refuelling"},D("h2",{},"Competition and refuelling")),g=D("section",{class:"card","aria-label":"events"},D("h2",{},"Events"));this.vehicleAt=D("div",{class:"vehicle-page"}),this.orders=D("div",{class:"tools orders"}),this.selection=D("p",{class:"small selection","aria-live":"polite"}),p.append(this.selection,this.orders,this.vehicleAt),this.contestAt=D("div"),x.append(this.contestAt),this.plansAt=D("div",{class:"plans"}),this.plansCard=D("section",{class:"card","aria-label":"missions and fences"},D("h2",{},"Missions and fences"),this.plansAt),this.plansCard.hidden=!0,t.append(D("div",{class:"flight"},D("div",{class:"wide"},u,d),D("div",{class:"narrow"},f,p),D("div",{class:"narrow"},this.plansCard,x,g))),this.map=new $r(a,s);try{this.space=new Qh(r,o,s)}catch{this.space=null,this.views.space.disabled=!0}this.timeline=new iu(d,n),this.table=new nu(f,(_,M,v)=>{this.pick(_,v),M&&this.setCamera("follow")}),this.events=new Hl(g,_=>{_.sysid>0&&_.sysid<255&&this.choose(_.sysid),n.seek(_.t_s)}),this.charts=[],this.picker=null,e&&this.#t(t),this.show(this.space?"space":"map"),Dl(()=>{this.dirty=!0,this.charted_at=0,this.space&&(this.space.pathsOf.version=-1),this.table.again(),this.fillPicker()}),new ResizeObserver(()=>this.dirty=!0).observe(c);let m=()=>{requestAnimationFrame(m),this.#s()};requestAnimationFrame(m)}#t(t){this.picker=D("fieldset",{class:"picker"},D("legend",{},"Vehicles:"));let e=D("div",{class:"figures"});t.append(D("section",{class:"charts","aria-label":"charts"},D("h2",{},"Over time"),this.picker,e));let n=new IntersectionObserver(s=>{for(let r of s){let o=this.charts.find(a=>a.div===r.target);o&&(o.seen=r.isIntersecting),this.charted_at=0}});for(let s of qT){let r=D("div",{class:"plot",role:"img","aria-label":`${s.title} over time`});e.append(D("figure",{},r)),this.charts.push({chart:new Wr(r,this.time,o=>this.label(o)),div:r,make:()=>this.#e(s),seen:!1}),n.observe(r)}}#e(t){let{flight:e}=this,n=e.t_s.subarray(0,e.count),s=[];for(let[u,d]of e.columns){let f=d[t.channel].subarray(0,e.count);this.shown.has(u)&&f.some(p=>!Number.isNaN(p))&&s.push({id:u,x:n,y:f})}let r=e.newest?.goal,o=t.channel==="target"&&r?.pursue_within_m?[{y:r.pursue_within_m,label:`goal: within ${r.pursue_within_m} m`}]:[],a=e.columns.size>Ys?this.#i(t.channel):void 0,l=t.channel==="battery"||t.channel==="v"?[...e.newest?.history??[],...e.newest?.services??[]]:[],c=t.channel==="v"?l.map(u=>({t_s:u.decided_at_s,id:u.receiver,label:`→ ${u.receiver}`})):[],h=t.channel!=="battery"?[]:(e.newest?.history??[]).filter(u=>u.start_s!==null&&this.shown.has(u.receiver)).map(u=>({from:u.start_s??0,to:u.end_s??e.last_s,id:u.receiver}));return{panels:[{...t,limits:o,lines:s,own:[],band:a}],marks:c,spans:h}}#i(t){let{flight:e}=this,n=Math.max(Math.floor(e.count/WT),1),s=[...e.columns.values()].map(c=>c[t]),[r,o,a,l]=[[],[],[],[]];for(let c=0;c<e.count;c+=n){let h=Float32Array.from(s,u=>u[c]).filter(u=>!Number.isNaN(u)).sort();r.push(e.t_s[c]),o.push(h[0]??NaN),a.push(h[h.length>>1]??NaN),l.push(h[h.length-1]??NaN)}return{least:{x:r,y:o},median:{x:r,y:a},greatest:{x:r,y:l},count:s.length}}label(t){return this.flight.session?.vehicles.find(e=>e.sysid===t)?.label??`vehicle ${t}`}members(){let t=this.flight.session?.vehicles??[];Ll(t),this.given||(this.shown=new Set(t.length>Ys?[]:t.map(n=>n.sysid))),this.space&&(this.space.madeOf=null),this.plansCard.hidden=!Yr(this.flight.session).length;let e=this.flight.session?.wind;Re(this.wind,e?`wind ${xe(e.speed_m_s,1)} m/s from ${xe(e.from_deg,0)}°`:""),this.fillPicker(),this.dirty=!0}fillPicker(){if(!this.picker)return;let t=this.flight.session?.vehicles??[],n=(t.length>Ys?t.filter(s=>this.shown.has(s.sysid)):t).map(s=>{let r=D("i",{class:"swatch"});return r.style.background=pn(s.sysid),D("button",{type:"button","aria-pressed":String(this.shown.has(s.sysid)),onclick:()=>this.toggle(s.sysid)},r,s.label)});if(this.picker.replaceChildren(D("legend",{},t.length>Ys?"Drawn singly:":"Vehicles:"),...n),t.length>Ys){let s=D("select",{"aria-label":"draw one more vehicle singly",onchange:()=>s.value&&this.toggle(Number(s.value))},D("option",{value:""},"one more …"),...t.filter(o=>!this.shown.has(o.sysid)).map(o=>D("option",{value:o.sysid},o.label)));this.picker.append(s,D("span",{class:"small soft"},"The ground is from the least to the greatest of all vehicles, dotted their median."))}}toggle(t){this.shown.delete(t)||this.shown.add(t),this.given=!0,this.fillPicker(),this.charted_at=0,this.after.forEach(e=>e())}choose(t){this.select(t===null?[]:[t])}pick(t,e){if(t===null||!(e?.shiftKey||e?.ctrlKey||e?.metaKey))return this.choose(t);let n=e.shiftKey&&this.chosen!==null?this.table.between(this.chosen,t,e):null;if(n)return this.select([...new Set([t,...n,...this.selected])]);let s=[...this.selected].filter(r=>r!==t);this.select(this.selected.has(t)?s:[t,...s])}get ghosts(){return this.flight.ghosts}set ghosts(t){this.flight.ghosts=t,this.flight.version+=1,this.space&&(this.space.madeOf=null),this.dirty=!0}get places(){return(this.view==="space"?this.space?.places:this.map.places)??[]}selectInPicture(){let{width:t,height:e}=(this.view==="space"&&this.space?this.space.canvas:this.map.canvas).getBoundingClientRect();this.select(xu(this.places,[0,0],[t,e]))}selectAll(){this.select(this.table.shown)}select(t){let e=t[0]??null;this.chosen=e,this.selected=new Set(t),Re(this.selection,t.length>1?`${t.length} vehicles selected: hold, return and land go to all of them.`:""),(this.flight.session?.vehicles.length??0)>Ys&&e!==null&&!this.shown.has(e)&&this.toggle(e),e===null&&this.setCamera("free"),this.dirty=!0}chooseNext(t){let e=(this.flight.session?.vehicles??[]).map(s=>s.sysid).sort((s,r)=>s-r);if(!e.length)return;let n=this.chosen===null?t>0?-1:0:e.indexOf(this.chosen);this.choose(e[(n+t+e.length)%e.length])}show(t){this.view=t==="space"&&this.space?"space":"map";for(let[e,n]of Object.entries(this.views))n.setAttribute("aria-pressed",String(e===this.view));this.map.canvas.hidden=this.view!=="map",this.space&&(this.space.canvas.hidden=this.space.names.hidden=this.view!=="space"),this.setCamera(this.camera.value)}setCamera(t){this.camera.value=t,this.space&&(this.space.mode=t),this.map.follow=t!=="free",this.dirty=!0}nextCamera(){let t=["free","follow","first"];this.setCamera(t[(t.indexOf(this.camera.value)+1)%t.length])}whole(){this.setCamera("free"),this.map.whole(),this.space?.whole(),this.dirty=!0}togglePaths(){this.paths=!this.paths,this.pathsButton.setAttribute("aria-pressed",String(this.paths)),this.dirty=!0}nextTheme(){ir()}present(){let{flight:t,at_s:e}=this;return e===null?t.newest:t.at(e)}#s(){let t=performance.now(),e=(this.view==="space"?this.space?.dirty:this.map.dirty)??!1;if(!this.dirty&&!e)return void this.#n(t);let n=this.present();if(!n)return;this.dirty=!1,this.map.dirty=!1,this.space&&(this.space.dirty=!1);let s=this.at_s??n.t_s,r={chosen:this.chosen,selected:this.selected,paths:this.paths,until_s:s,trail_s:this.whole_paths&&!this.playing?1/0:VT,ghosts:this.ghosts};this.view==="space"?this.space?.draw(this.flight,n,r):this.map.draw(this.flight,n,r),this.frames+=1,this.drawnFirst(),this.current=n,this.time.begin_s=this.flight.first_s,this.time.end_s=Math.max(this.flight.last_s,this.end_s??0),this.time.setNow(s),this.timeline.show({now_s:s,begin_s:this.begin_s??this.flight.first_s,end_s:this.end_s??Math.max(this.flight.last_s,n.t_s),playing:this.playing,speed:this.speed,following:this.at_s===null,events:this.flight.events}),this.#n(t)}#n(t){let e=this.current;if(e&&t-this.shown_at>(this.flight.columns.size>Ys?2.5:1)*XT&&this.paneled!==e){this.shown_at=t,this.paneled=e,this.table.show(e,this.chosen,this.selected),this.strip.show(e),Zm(this.plansAt,this.flight.session,e),Qm(this.contestAt,e,n=>this.label(n)),rd(this.vehicleAt,e,this.chosen,this.flight.session),this.events.show(this.flight.events,this.at_s??1/0,n=>this.label(n));return}if(e&&this.paneledFor!==this.selected&&(this.paneledFor=this.selected,this.table.show(e,this.chosen,this.selected,!0),rd(this.vehicleAt,e,this.chosen,this.flight.session)),this.charts.length&&t-this.charted_at>(this.flight.columns.size>Ys?2:1)*HT&&this.charted!==this.flight.version){this.charted_at=t,this.charted=this.flight.version;for(let n of this.charts)n.seen&&n.chart.draw(n.make(),this.shown)}this.charted_at===0&&(this.charted=-1)}};var y_=[.25,.5,1,2,4],YT=4401,$T="skytender",su=class{constructor(t,e,n){this.restart=n,this.take=t,this.changed=e,this.state="connecting",this.heard=0,this.sent=0,this.tries=0,this.socket=null,this.waiting=new Map,this.token=new URLSearchParams(location.hash.slice(1)).get("token")??""}open(){let t=location.protocol==="https:"?"wss":"ws",e=new WebSocket(`${t}://${location.host}/stream`,[$T,`token.${this.token||"none"}`]);this.socket=e,e.onopen=()=>{this.tries=0,this.#e("open")},e.onmessage=n=>{let s=JSON.parse(n.data);for(let r of Array.isArray(s)?s:[s])this.#t(r)},e.onclose=n=>{if(this.state!=="ended"){if(this.#i(),n.code===YT)return void this.#e("refused");this.#e("lost"),setTimeout(()=>this.open(),1e3*y_[Math.min(this.tries,y_.length-1)]),this.tries+=1}}}#t(t){if(t.type==="reply"){let e=this.waiting.get(String(t.id));this.waiting.delete(String(t.id)),e?.(t.ok,t.text);return}if(t.type==="session"&&t.events!==void 0){let e=t.told??0,n=e<this.heard,s=Math.min(e-(n?0:this.heard),t.events.length);this.heard=e,n&&this.restart(),t={...t,events:t.events.slice(t.events.length-s)}}else t.type==="snapshot"?this.heard+=t.events.length:t.type==="end"&&this.#e("ended");this.take(t)}send(t,e){if(this.state!=="open"||!this.socket)return void e?.(!1,"There is no connection: it was not sent.");this.sent+=1;let n=`page-${this.sent}`;e&&this.waiting.set(n,e),this.socket.send(JSON.stringify({...t,id:n}))}#e(t){this.state=t,this.changed(t)}#i(){for(let t of this.waiting.values())t(!1,"The connection was lost before an answer came.");this.waiting.clear()}};var x_={whole:680,half:332},ZT=30;async function S_(i,t){let e=atob((i.getElementById(t)?.textContent??"").trim()),n=Uint8Array.from(e,r=>r.charCodeAt(0)),s=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(s).arrayBuffer()}function ru(i){document.documentElement.dataset[i]=String(Math.round(performance.now()))}function Of(i,t,e,n,s){let r=new Uint16Array(i,t,e),o=new Float64Array(e),a=(s-n)/65534;for(let l=0;l<e;l+=1)o[l]=r[l]===65535?NaN:n+a*r[l];return o}function M_(i,t){let e=n=>({...n,x:Of(t,n.at,n.n,0,i.end_s),y:Of(t,n.at+2*n.n,n.n,n.low,n.high)});for(let n of Object.values(i.figures))for(let s of n.panels??[])if(s.lines=s.lines.map(e),s.own=s.own.map(e),s.band)for(let r of["least","median","greatest"])s.band[r]=e(s.band[r]);return n=>Float32Array.from(Of(t,n.at,n.n,n.low,n.high))}async function JT(i){let t=new DOMParser().parseFromString(await i.text(),"text/html"),e=t.getElementById("model")?.textContent,n=e?JSON.parse(e):null;if(!n?.flight)throw new Error("it carries no flight");let s=new Xr;return w_(s,n,n.flight,M_(n,await S_(t,"series"))),s}function KT(i){let t=D("span",{class:"small soft",role:"status"}),e=D("input",{type:"file",accept:".html",multiple:!0,"aria-label":"reports to compare with",onchange:async()=>{let n=[...e.files??[]],s=[],r=[];for(let o of n)try{let a=await JT(o);s.push(a),r.push(`${a.session?.name??o.name}, ${a.last_s.toFixed(1)} s`)}catch(a){r.push(`${o.name} is no report that can be compared (${a.message})`)}t.textContent=r.length?`In grey, ids in brackets: ${r.join("; ")}`:"",i.ghosts=s}});return D("label",{class:"small compare"},"compare with other reports ",e," ",t)}function v_({x:i,y:t},e){return Float32Array.from(e,n=>{let s=qn(i,n);if(s<0)return NaN;let r=Math.min(s+1,i.length-1),o=i[r]-i[s],a=t[s]+(o>0?(n-i[s])/o:0)*(t[r]-t[s]);return Number.isNaN(a)?t[s]:a})}async function b_(i,t){let e=JSON.parse(document.getElementById("model")?.textContent??"{}"),n=await S_(document,"series");ru("unpacked");let s=M_(e,n);Ll(e.vehicles.map(b=>({sysid:b.id,role:b.role,colour:b.colour})));let r=new Set(e.chosen),o=b=>e.vehicles.find(U=>U.id===b)?.label??String(b),a=document.getElementById("app"),l=a&&e.flight?jT(a,e,e.flight,s):null,c=l?.time??new Bf(e.end_s);if(c.begin_s=0,c.end_s=e.end_s,l){l.shown=r,l.given=!0,l.after.push(()=>M());let b=t(l,[],()=>{}),U=D("div",{class:"tools only-screen"},D("button",{type:"button",onclick:()=>ir()},"dark / light"),D("button",{type:"button",onclick:()=>b.showModal()},"keys ?"),KT(l));a?.before(U)}let h=[];for(let b of document.querySelectorAll(".plot[data-figure]")){let U=e.figures[b.dataset.figure??""];!U&&b.dataset.figure!=="flight"||h.push({div:b,draw:u(b,U),drawn:!1})}function u(b,U){if(b.dataset.figure==="flight")return()=>d(b);if(U.kind==="timeline")return()=>km(b,U,c);if(U.kind==="ledger")return()=>zm(b,U,r,o);let P=new Wr(b,c,o);return R=>P.draw(U,r,R)}function d(b){if(!l)return;let U=D("canvas",{class:"still"});b.replaceChildren(U);let P=l.flight.at(e.end_s);P&&new $r(U,()=>{}).draw(l.flight,P,{chosen:null,selected:new Set,paths:!0,until_s:e.end_s,trail_s:1/0,shown:r}),b.dataset.lines=String(r.size)}let f=b=>b.classList.contains("only-print");function p(b,U){b.drawn||b.div.replaceChildren(),b.draw(U),b.drawn=!0}let x=()=>h.filter(b=>b.drawn&&!f(b.div)).forEach(b=>p(b)),g=document.querySelector("fieldset.picker");function m(){g.querySelectorAll("button, select").forEach(R=>R.remove());let b=e.many?[...r].sort((R,G)=>R-G):e.vehicles.map(R=>R.id);for(let R of b){let G=D("i",{class:"swatch"});G.style.background=pn(R),g.append(D("button",{type:"button","aria-pressed":String(r.has(R)),onclick:()=>_(R)},G,o(R)))}if(!e.many)return;let U=e.vehicles.filter(R=>!r.has(R.id)).map(R=>D("option",{value:R.id},R.label)),P=D("select",{"aria-label":"show one more vehicle",onchange:()=>P.value&&_(Number(P.value))},D("option",{value:""},"show one more …"),...U);g.append(P)}function _(b){r.delete(b)||r.add(b),M()}function M(){m(),x(),l&&(l.dirty=!0)}m(),tE(),l&&await l.first,ru("first");let v=h.filter(b=>!f(b.div)),C=new Set(v);for(let b of v)p(b),C.delete(b),await new Promise(U=>{setTimeout(U)});ru("flat"),requestAnimationFrame(()=>requestAnimationFrame(()=>ru("all"))),Dl(()=>{m(),x()});let T=document.body.clientWidth,y=!1;return window.addEventListener("resize",()=>{y||document.body.clientWidth===T||(T=document.body.clientWidth,x())}),window.addEventListener("beforeprint",()=>{y=!0,ju(!0);for(let b of h)p(b,b.div.closest(".pair")?x_.half:x_.whole)}),window.addEventListener("afterprint",()=>{y=!1,ju(!1),x()}),l}var Bf=class{constructor(t){this.begin_s=0,this.end_s=t,this.now_s=NaN,this.zoom=null,this.charts=new Set}get range(){return this.zoom??[0,this.end_s]}setZoom(t){this.zoom=t;let[e,n]=this.range;for(let s of this.charts)for(let r of s.plots)r.setScale("x",{min:e,max:n})}setNow(){}seek(){}point(){}};function jT(i,t,e,n){let s={playing:!1,speed:5,at:performance.now()},r={seek:c=>{o.at_s=Math.min(Math.max(c,0),e.end_s),o.dirty=!0},toggle:()=>{s.playing=!s.playing,s.playing&&(o.at_s??e.end_s)>=e.end_s&&(o.at_s=0),s.at=performance.now(),a()},faster:c=>{s.speed=vs[Math.min(Math.max(vs.indexOf(s.speed)+c,0),vs.length-1)],a()},newest:null},o=new Lo(i,{charts:!1,player:r});o.whole_paths=!0;let a=()=>{o.playing=s.playing,o.speed=`×${s.speed}`,o.dirty=!0};w_(o.flight,t,e,n),o.begin_s=0,o.end_s=e.end_s,o.members(),a();let l=()=>r.seek(al()??e.end_s);return l(),addEventListener("hashchange",()=>al()!==null&&l()),setInterval(()=>{let c=performance.now();s.playing&&(o.at_s=Math.min((o.at_s??0)+.001*(c-s.at)*s.speed,e.end_s),o.at_s>=e.end_s&&(s.playing=!1),a()),s.at=c},ZT),o}function w_(i,t,e,n){i.session=e.session;let s=e.solids??[];i.worlds=(e.worlds??[]).map(([l,c,h])=>({t_s:l,session:{...e.session,obstacles:c.map(u=>s[u]),vehicles:e.session.vehicles.map(u=>({...u,path_ned:h[String(u.sysid)]??u.path_ned}))}})),i.events=e.events,i.count=i.capacity=e.count,i.t_s=Float64Array.from({length:e.count},(l,c)=>c*e.end_s/(e.count-1)),i.share=new Float32Array(e.count).fill(NaN);let r=(l,c)=>new Map((t.figures[l]?.panels[c]?.lines??[]).map(h=>[h.id,h])),o={battery:r("battery",0),speed:r("motion",0),target:r("target",0),v:r("contest",0)},a=t.figures.contest?.panels[1]?.own[0];a&&(i.share=v_(a,i.t_s));for(let l of e.vehicles){let c={};for(let d of ss)c[d]=null;[c.n,c.e,c.d]=l.p.map(n),c.height=c.d.map(d=>-d);for(let d of["heading","roll","pitch"])c[d]=l[d]?n(l[d]):new Float32Array(e.count);for(let[d,f]of Object.entries(o)){let p=f.get(l.sysid);c[d]=p?d==="v"?QT(p,i.t_s):v_(p,i.t_s):null}let h=new Float32Array(e.count).fill(NaN);for(let d of ss)c[d]??=h;i.columns.set(l.sysid,c);let u=new Ko;for(let[d,f,p,x]of e.words[String(l.sysid)]??[])u.t_s.push(d),u.rows.push({mode:f,armed:p,landed:!x});i.words.set(l.sysid,u)}for(let l of e.traffic)i.traffic.set(l.callsign,l.p.map(n));i.newest={type:"snapshot",t_s:e.end_s,duration_s:e.session.duration_s,speed:null,phase:"ended",vehicles:[],traffic:[],competition:{v:{},tau:{},leader:null,share:null,runner_up:null,threshold:e.threshold},services:[],history:e.history,refuelled:e.history.length,goal:e.goal,inspected:{},events:[]},i.version+=1}function QT({x:i,y:t},e){return Float32Array.from(e,n=>t[qn(i,n)]??NaN)}function tE(){for(let i of document.querySelectorAll("table.sorts")){let t=[...i.tHead?.rows[0].cells??[]];t.forEach((e,n)=>{let s=()=>{let r=e.getAttribute("aria-sort")!=="ascending";t.forEach(l=>l.removeAttribute("aria-sort")),e.setAttribute("aria-sort",r?"ascending":"descending");let o=l=>l.cells[n].textContent??"",a=[...i.tBodies[0].rows].sort((l,c)=>o(l).localeCompare(o(c),void 0,{numeric:!0}));i.tBodies[0].append(...r?a:a.reverse())};e.replaceChildren(D("button",{type:"button",onclick:s},e.textContent??""))})}}var eE=800,kf=.14,zf={dead:[880,660,880],silent:[880,660],failing:[880,660],low:[520]},ou=class{constructor(){this.button=D("button",{type:"button","aria-pressed":"false",title:"a sound where a vehicle dies, falls silent, fails or runs low",onclick:()=>this.toggle()},"sound"),this.audio=null,this.rung=0,this.at=-1/0,this.known=new Map}toggle(){this.audio?(this.audio.close(),this.audio=null):(this.audio=new AudioContext,this.#t(zf.low)),this.button.setAttribute("aria-pressed",String(this.audio!==null))}watch(t){let e=t.vehicles.filter(n=>Mr(n)<(this.known.get(n.sysid)??1/0)&&zf[n.condition]).sort((n,s)=>Mr(n)-Mr(s))[0];this.known=new Map(t.vehicles.map(n=>[n.sysid,Mr(n)])),!(!e||!this.audio||performance.now()-this.at<eE)&&(this.at=performance.now(),this.rung+=1,this.#t(zf[e.condition]))}#t(t){let e=this.audio;t.forEach((n,s)=>{let[r,o]=[e.createOscillator(),e.createGain()],a=e.currentTime+s*kf;r.frequency.value=n,o.gain.setValueAtTime(.25,a),o.gain.exponentialRampToValueAtTime(.001,a+kf),r.connect(o).connect(e.destination),r.start(a),r.stop(a+kf)})}};var Do=Math.PI/180,T_=6378137,E_=.00669438;function nE(i){let t=1-E_*Math.sin(i*Do)**2;return[Do*T_*(1-E_)/t**1.5,Do*T_*Math.cos(i*Do)/Math.sqrt(t)]}var iE=(i,t)=>(i+180)/360*t,sE=(i,t)=>(1-Math.asinh(Math.tan(i*Do))/Math.PI)/2*t,rE=(i,t)=>Math.atan(Math.sinh(Math.PI*(1-2*i/t)))/Do,au=class{constructor(t,e){this.template=t,this.arrived=e,this.kept=new Map;let n=new URL(t.replace(/[{}]/g,"")).hostname;this.credit=/(^|\.)openstreetmap\.org$/.test(n)?"© OpenStreetMap contributors":`map: ${n}`}draw(t,e,n,s,r,o){let[a,l]=e;if(Math.abs(a)>85)return;let[c,h]=nE(a),u=Math.min(Math.max(Math.round(Math.log2(360*h*n.perMetre/256)),0),19),d=2**u,[f,p]=[n.height/2/n.perMetre,n.width/2/n.perMetre],[x,g]=[-p,p].map(M=>Math.floor(iE(l+(n.e+M)/h,d))),[m,_]=[f,-f].map(M=>Math.min(Math.max(Math.floor(sE(a+(n.n+M)/c,d)),0),d-1));if(!((g-x+1)*(_-m+1)>80)){for(let M=m;M<=_;M+=1){let[v,C]=[M,M+1].map(T=>r((rE(T,d)-a)*c));for(let T=x;T<=g;T+=1){let y=this.#t(u,(T%d+d)%d,M);if(!y.complete||!y.naturalWidth)continue;let[b,U]=[T,T+1].map(P=>s((360*P/d-180-l)*h));t.drawImage(y,b,v,U-b,C-v)}}t.font="11px system-ui, sans-serif",t.lineWidth=3,t.strokeStyle=o.paper,t.strokeText(this.credit,5,14),t.fillStyle=o.ink,t.fillText(this.credit,5,14)}}#t(t,e,n){let s=this.template.replace("{z}",String(t)).replace("{x}",String(e)).replace("{y}",String(n)),r=this.kept.get(s);return r||(r=new Image,r.referrerPolicy="origin",r.onload=this.arrived,r.src=s,this.kept.size>=400&&this.kept.delete(this.kept.keys().next().value??""),this.kept.set(s,r),r)}};var A_="skytender-tour",ll=[[".strip","Trouble stands here: how many vehicles are dead, silent, failing, low or warned, and how badly. A click selects them."],[".picture","The fleet, in space (key 3) or on a map (key M). Drag to move, click a vehicle to select it, drag with Shift held to select all in a box."],[".fleet-scroll","Every vehicle, those in trouble first. Shift or Ctrl adds to the selection; orders then go to all selected vehicles."],[".top","Orders ask first, and list which vehicles cannot obey. Keys stand on their buttons; the key ? lists them all."],[".time-line","The line of time: go back while the flight goes on, and return with “live”. Marks are events."]],lu=class{constructor(){this.step=-1,this.text=D("p",{"aria-live":"polite"}),this.count=D("b",{class:"small soft"}),this.next=D("button",{type:"button",class:"primary",onclick:()=>this.go(this.step+1)},"Next"),this.element=D("section",{class:"tour","aria-label":"tour"},this.count,this.text,D("div",{class:"tools"},this.next,D("button",{type:"button",onclick:()=>this.end()},"Close tour"))),this.element.hidden=!0,document.body.append(this.element)}first(){try{if(localStorage.getItem(A_))return}catch{return}this.go(0)}go(t){if(t>=ll.length)return this.end();this.#t(t),this.element.hidden=!1,Re(this.count,`${t+1} of ${ll.length}`),Re(this.text,ll[t][1]),Re(this.next,t+1<ll.length?"Next":"Done")}end(){this.#t(-1),this.element.hidden=!0;try{localStorage.setItem(A_,"seen")}catch{}}#t(t){document.querySelector(".pointed")?.classList.remove("pointed"),this.step=t,t>=0&&document.querySelector(ll[t][0])?.classList.add("pointed")}};var oE=[["space","pause, or go on"],["← →","10 s back or on (replay, report, or back in a live flight)"],["< >","slower, faster"],["End","back to the newest"],["[ ]","the vehicle before, after"],["g","go to a vehicle by its id"],["/","filter vehicles"],["3 m","in space, map"],["c","camera: free, follow, from its eyes"],["0","show everything"],["v","paths on or off"],["b","select all that are in the picture"],["a","select all that the table shows"],["Esc","select none"],["d","dark or light"],["?","this page"]],C_=10;function R_(i,t,e){let n=D("dialog",{class:"ask","aria-label":"keys"}),s=[...oE,...t.map(o=>[o.key.toUpperCase(),o.what])].map(([o,a])=>D("tr",{},D("th",{scope:"row"},o),D("td",{class:"word"},a)));n.append(D("h2",{},"Keys"),D("table",{},D("tbody",{},...s)),D("form",{method:"dialog"},D("button",{},"Close"))),document.body.append(n);let r={" ":()=>i.player.toggle(),ArrowLeft:()=>i.player.seek((i.time.now_s??0)-C_),ArrowRight:()=>i.player.seek(i.time.now_s+C_),"<":()=>i.player.faster(-1),">":()=>i.player.faster(1),End:()=>i.player.newest?.(),"[":()=>i.chooseNext(-1),"]":()=>i.chooseNext(1),g:()=>i.table.goto.focus(),"/":()=>i.table.filter.focus(),3:()=>i.show("space"),m:()=>i.show("map"),c:()=>i.nextCamera(),0:()=>i.whole(),v:()=>i.togglePaths(),d:()=>ir(),b:()=>i.selectInPicture(),a:()=>i.selectAll(),Escape:()=>i.choose(null),"?":()=>n.showModal()};return document.addEventListener("keydown",o=>{let a=o.target;if(o.ctrlKey||o.metaKey||o.altKey||a.closest("dialog"))return;if(a.matches("input:not([type=range]), select, textarea")){o.key==="Escape"&&a.blur();return}if(a.matches("input[type=range]")&&o.key.startsWith("Arrow")||a.matches("button, summary")&&(o.key===" "||o.key==="Enter"))return;let l=t.find(c=>c.key.toUpperCase()===o.key&&o.shiftKey);if(l)e(l);else if(r[o.key])r[o.key]();else return;o.preventDefault()}),n}function aE(i){let t=new Map;for(let{role:e}of i)t.set(e,(t.get(e)??0)+1);return[...t].map(([e,n])=>`${n} ${e||"vehicle"}${n===1?"":"s"}`).join(", ")||"Vehicles"}function lE(i){let t=document.getElementById("app"),e=D("h1",{},"Starting …"),n=D("span",{class:"badge"}),s=D("span",{class:"badge phase"}),[r,o]=[D("b",{class:"bad"}),D("span")],a=D("p",{class:"soft small goal-line"},r,o),l=D("button",{type:"button"},"keys ?"),c=D("button",{type:"button",onclick:()=>ir()},"dark / light",As("D")),h=new ou,u=D("a",{target:"_blank"},"Open the report");u.hidden=!0;let d=D("span"),f=D("p",{class:"connection",role:"alert"},d," ",u);f.hidden=!0;let p=D("div",{class:"tools orders"}),x=D("header",{class:"top"},D("div",{class:"tools"},e,n,s,D("span",{class:"gap"}),p,h.button,c,l),a,f);t.before(x);let g=!1,m=!1,_,M=!1,v="",C={seek:B=>{g?H.send({command:"seek",t_s:B},T):(y.at_s=B>=y.flight.last_s-.05?null:Math.max(B,y.flight.first_s),y.dirty=!0)},toggle:()=>{g?H.send({command:_?.paused||y.flight.newest?.phase==="ended"?"resume":"pause"},T):P(i.orders.find(B=>B.command==="pause"))},faster:B=>{if(!g)return void b.notice("Speed can be changed only in a replay.");let k=_?.speed??1,lt=vs.reduce(($,j,et)=>Math.abs(j-k)<Math.abs(vs[$]-k)?et:$,0);H.send({command:"speed",speed:vs[Math.min(Math.max(lt+B,0),vs.length-1)]},T)},newest:()=>{y.at_s=null,y.dirty=!0}},T=(B,k)=>{B||b.notice(k,"bad")},y=new Lo(t,{charts:!0,player:C});x.append(y.strip.element),i.tiles&&(y.map.tiles=new au(i.tiles,()=>y.map.dirty=!0));let b=new Vl(i.orders,(B,k)=>H.send(B,k)),U=()=>new Map((y.flight.session?.vehicles??[]).map(B=>[B.sysid,B.plan_b])),P=B=>{if(!M)return void b.notice(g?"A recording takes no commands.":"View-only link: commands are disabled.","bad");B.of_many&&y.selected.size>1?b.askMany(B,[...y.selected],!1,R,()=>y.flight.newest,U()):b.ask(B,y.chosen,R,()=>y.flight.newest)},R=B=>y.label(B),G=D("p",{class:"starting",role:"status"},"The session is starting.");t.querySelector(".picture")?.append(G);for(let B of[p,y.orders,y.strip.all,n,s])B.hidden=!0;for(let B of i.orders.filter(k=>k.of_many&&k.command!=="land")){let k=()=>(y.flight.newest?.vehicles??[]).map(lt=>lt.sysid);y.strip.all.append(D("button",{type:"button",title:`${B.name} all vehicles`,onclick:()=>b.askMany(B,k(),!0,R,()=>y.flight.newest,U())},`all: ${B.name}`))}l.addEventListener("click",R_(y,i.orders,P).showModal.bind(document.querySelector("dialog[aria-label=keys]")));for(let B of i.orders){let k=D("button",{type:"button",title:`${B.what} (Shift+${B.key.toUpperCase()})`,onclick:()=>P(B)},B.name,As(`⇧${B.key.toUpperCase()}`));(B.of_vehicle?y.orders:p).append(k)}let H=new su(B=>{if(B.type==="session"){y.flight.begin(B),y.flight.tell(B.events??[]),g=B.source==="replay";let k=al();g&&!m&&k!==null&&C.seek(k),m=!0,M=!!B.control&&!g,document.title=`${B.name} – Skytender`,Re(e,B.name),Re(n,{session:"live",monitor:"monitor",replay:"replay"}[B.source]);for(let lt of[p,y.orders,y.strip.all])lt.hidden=!M;n.hidden=!1,Re(G,`${aE(B.vehicles)} ${B.vehicles.length===1?"starts":"start"}; they are shown here as soon as they report.`),y.timeline.live.hidden=g,y.members()}else if(B.type==="snapshot"){_=B.replay,y.flight.take(B),y.flight.tell(B.events),h.watch(B),g?(y.begin_s=_?.from_s,y.end_s=_?.to_s,y.playing=!_?.paused&&B.phase!=="ended",y.speed=`×${_?.speed??1}`):(y.playing=B.phase!=="paused",y.speed=B.speed?`×${B.speed.toFixed(B.speed<10?1:0)}`:""),s.hidden=!1,G.hidden=!0,Re(s,`${B.phase} ${wi(B.t_s)}${B.duration_s?` of ${wi(B.duration_s)}`:""}`);let{goal:k}=B,lt=k.pursue_for_s&&k.pursue_held_s!==null?`pursuit held ${k.pursue_held_s.toFixed(0)} of ${k.pursue_for_s.toFixed(0)} s`:"",$=k.refuelled_at_least?`${B.refuelled} refuelled, at least ${k.refuelled_at_least} wanted`:B.refuelled?`${B.refuelled} refuelled`:"",j=k.broken.map(et=>et.text+(et.t_s===null?"":` (${et.t_s.toFixed(1)} s)`));Re(r,j.length?`${j.length} ${j.length===1?"goal":"goals"} failed: ${j.join("; ")}. `:""),Re(o,[lt,$].filter(Boolean).join("; ")),a.title=a.textContent??"",y.dirty=!0}else if(B.type==="end"){v=`The session has ended: ${B.text||B.outcome||"unknown"}. The page keeps what it has seen.`;for(let k of[p,y.orders,y.strip.all])k.hidden=!0;N()}else B.type==="report"&&(u.href=B.path,u.hidden=!1,N())},()=>N(),()=>y.flight.clear()),N=()=>{let k={connecting:"",open:"",ended:v,lost:"The connection is lost; the page tries again by itself. What is shown is the last that came.",refused:"This link lacks its token, or the token is of another session: open the whole link that `gcs` printed."}[H.state];f.hidden=!k,f.className=`connection ${H.state==="ended"?"soft":"bad"}`,Re(d,k),H.state==="refused"&&Re(e,"no entry"),(H.state==="refused"||H.state==="ended")&&(G.hidden=!0),document.documentElement.dataset.connection=H.state};H.open();let W=new lu;return W.first(),document.querySelector("dialog[aria-label=keys] form")?.append(D("button",{onclick:()=>W.go(0)},"Show the tour")),Object.assign(y,{operator:b,sound:h})}Fm();var cl=JSON.parse(document.getElementById("config")?.textContent??"{}");Um(cl.palette);g_(cl.conditions);var cE=cl.source==="report"?b_(cl,R_):lE(cl);Object.assign(window,{skytender:cE});})();
