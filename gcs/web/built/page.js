/* of sources 45e0dc0c646560a4 */
"use strict";(()=>{function N(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===!1||r===null||r===void 0||(s.startsWith("on")?n.addEventListener(s.slice(2),r):s==="class"?n.className=r:n.setAttribute(s,r===!0?"":String(r)));for(let s of e)s!==null&&s!==!1&&n.append(s);return n}var Cs=i=>N("kbd",{"aria-hidden":"true"},i);function me(i,t){i.textContent!==t&&(i.textContent=t)}function oe(i,t,e=""){if(i==null||!Number.isFinite(i))return"–";let n=i.toFixed(t);return`${Number(n)===0?n.replace("-",""):n.replace("-","−")}${e}`}var Qs=i=>`${i} ${i===1?"vehicle":"vehicles"}`;function bi(i){let t=i<0?"−":"",e=Math.abs(i),n=Math.floor(e/60);return`${t}${n}:${(e-60*n).toFixed(1).padStart(4,"0")}`}function ll(i){let t=i.getBoundingClientRect(),e=Math.min(window.devicePixelRatio||1,2),n=Math.max(Math.round(t.width*e),1),s=Math.max(Math.round(t.height*e),1),r=i.width!==n||i.height!==s;return r&&(i.width=n,i.height=s),{width:t.width,height:t.height,scale:e,changed:r}}var R_=4,P_=24;function tr(i,t,e){let[n]=i.map(s=>({sysid:s.sysid,off:Math.hypot(s.x-t,s.y-e)})).sort((s,r)=>s.off-r.off);return n&&n.off<P_?n.sysid:null}function cu(i,t,e){let[[n,s],[r,o]]=[0,1].map(a=>[t[a],e[a]].sort((l,c)=>l-c));return i.filter(a=>a.x>=n&&a.x<=s&&a.y>=r&&a.y<=o).map(a=>a.sysid)}var cl=class{constructor(t,{places:e,take:n,pick:s}){this.button=N("button",{type:"button","aria-pressed":"false",title:"select the vehicles in a box: drag it over the picture (or drag with Shift held); b selects all that are in the picture",onclick:()=>this.arm(!this.armed)},"box"),this.armed=!1;let r=N("div",{class:"box"});r.hidden=!0,t.append(r);let o=null,a=h=>{let{left:u,top:d,width:f,height:p}=t.getBoundingClientRect();return[Math.min(Math.max(h.clientX-u,0),f),Math.min(Math.max(h.clientY-d,0),p)]},l=(h,u)=>Math.hypot(h[0]-u[0],h[1]-u[1])>R_;t.addEventListener("pointerdown",h=>{o||h.button!==0||!(h.shiftKey||this.armed)||(h.stopPropagation(),o={id:h.pointerId,from:a(h)},t.setPointerCapture(h.pointerId))},{capture:!0}),t.addEventListener("pointermove",h=>{if(h.pointerId!==o?.id)return;h.stopPropagation();let u=a(h);r.hidden=!l(o.from,u);let[d,f]=[0,1].map(p=>Math.min(o.from[p],u[p]));Object.assign(r.style,{left:`${d}px`,top:`${f}px`,width:`${Math.abs(u[0]-o.from[0])}px`,height:`${Math.abs(u[1]-o.from[1])}px`})},{capture:!0});let c=h=>{if(h.pointerId!==o?.id)return;h.stopPropagation();let[u,d]=[o.from,a(h)];o=null,r.hidden=!0,h.type==="pointerup"&&(l(u,d)?n(cu(e(),u,d),h.shiftKey):s(tr(e(),d[0],d[1]),h),this.arm(!1))};t.addEventListener("pointerup",c,{capture:!0}),t.addEventListener("pointercancel",c,{capture:!0})}arm(t){this.armed=t,this.button.setAttribute("aria-pressed",String(t))}};var I_="uplot",L_="u-hz",D_="u-vt",N_="u-title",U_="u-wrap",F_="u-under",O_="u-over",B_="u-axis",ir="u-off",k_="u-select",z_="u-cursor-x",G_="u-cursor-y",V_="u-cursor-pt",H_="u-legend",W_="u-live",X_="u-inline",q_="u-series",$_="u-marker",Xf="u-label",Y_="u-value",Xo="width",qo="height";var qf="bottom",Fr="left",hu="right",Au="#000",$f=Au+"0",uu="mousemove",Yf="mousedown",du="mouseup",Zf="mouseenter",Jf="mouseleave",Kf="dblclick",Z_="resize",J_="scroll",jf="change",pl="dppxchange",Cu="--",Hr=typeof window<"u",_u=Hr?document:null,Br=Hr?window:null,K_=Hr?navigator:null,Te,hl;function yu(){let i=devicePixelRatio;Te!=i&&(Te=i,hl&&vu(jf,hl,yu),hl=matchMedia(`(min-resolution: ${Te-.001}dppx) and (max-resolution: ${Te+.001}dppx)`),sr(jf,hl,yu),Br.dispatchEvent(new CustomEvent(pl)))}function ii(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function xu(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function We(i,t,e){i.style[t]=e+"px"}function wi(i,t,e,n){let s=_u.createElement(i);return t!=null&&ii(s,t),e?.insertBefore(s,n),s}function pi(i,t){return wi("div",i,t)}var Qf=new WeakMap;function Gi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Qf.get(i);r!=o&&(i.style.transform=r,Qf.set(i,r),t<0||e<0||t>n||e>s?ii(i,ir):xu(i,ir))}var tp=new WeakMap;function ep(i,t,e){let n=t+e,s=tp.get(i);n!=s&&(tp.set(i,n),i.style.background=t,i.style.borderColor=e)}var np=new WeakMap;function ip(i,t,e,n){let s=t+""+e,r=np.get(i);s!=r&&(np.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Ru={passive:!0},j_={...Ru,capture:!0};function sr(i,t,e,n){t.addEventListener(i,e,n?j_:Ru)}function vu(i,t,e,n){t.removeEventListener(i,e,Ru)}Hr&&yu();function Ti(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:si((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Ip(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Lp=i=>i!=null,Dp=i=>i!=null&&i>0,_l=Ip(Lp),Q_=Ip(Dp);function ty(i,t,e,n=0,s=!1){let r=s?Q_:_l,o=s?Dp:Lp;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Oe,l??-Oe]}function yl(i,t,e,n){let s=op(i),r=op(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?is:Np,a=s==1?si:mi,l=r==1?mi:si,c=a(o(xn(i))),h=l(o(xn(t))),u=kr(e,c),d=kr(e,h);return e==10&&(c<0&&(u=Be(u,-c)),h<0&&(d=Be(d,-h))),n||e==2?(i=u*s,t=d*r):(i=Bp(i,u),t=xl(t,d)),[i,t]}function Pu(i,t,e,n){let s=yl(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Iu=.1,sp={mode:3,pad:Iu},Yo={pad:0,soft:null,mode:0},ey={min:Yo,max:Yo};function ml(i,t,e,n){return vl(e)?rp(i,t,e):(Yo.pad=e,Yo.soft=n?0:null,Yo.mode=n?3:0,rp(i,t,ey))}function be(i,t){return i??t}function ny(i,t,e){for(t=be(t,0),e=be(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function rp(i,t,e){let n=e.min,s=e.max,r=be(n.pad,0),o=be(s.pad,0),a=be(n.hard,-Oe),l=be(s.hard,Oe),c=be(n.soft,Oe),h=be(s.soft,-Oe),u=be(n.mode,0),d=be(s.mode,0),f=t-i,p=is(f),y=Xn(xn(i),xn(t)),m=is(y),g=xn(m-p);(f<1e-24||g>10)&&(f=0,(i==0||t==0)&&(f=1e-24,u==2&&c!=Oe&&(r=0),d==2&&h!=-Oe&&(o=0)));let _=f||y||1e3,M=is(_),x=kr(10,si(M)),C=_*(f==0?i==0?.1:1:r),T=Be(Bp(i-C,x/10),24),v=i>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:Oe,b=Xn(a,T<v&&i>=v?v:Ei(v,T)),R=_*(f==0?t==0?.1:1:o),P=Be(xl(t+R,x/10),24),L=t<=h&&(d==1||d==3&&P>=h||d==2&&P<=h)?h:-Oe,O=Ei(l,P>L&&t<=L?L:Xn(L,P));return b==O&&b==0&&(O=100),[b,O]}var iy=new Intl.NumberFormat(Hr?K_.language:"en-US"),Lu=i=>iy.format(i),ri=Math,fl=ri.PI,xn=ri.abs,si=ri.floor,yn=ri.round,mi=ri.ceil,Ei=ri.min,Xn=ri.max,kr=ri.pow,op=ri.sign,is=ri.log10,Np=ri.log2,sy=(i,t=1)=>ri.sinh(i)*t,fu=(i,t=1)=>ri.asinh(i/t),Oe=1/0;function ap(i){return(is((i^i>>31)-(i>>31))|0)+1}function Su(i,t,e){return Ei(Xn(i,t),e)}function Up(i){return typeof i=="function"}function xe(i){return Up(i)?i:()=>i}var ry=()=>{},Fp=i=>i,Op=(i,t)=>t,oy=i=>null,lp=i=>!0,cp=(i,t)=>i==t,ay=/\.\d*?(?=9{6,}|0{6,})/gm,rr=i=>{if(zp(i)||Ps.has(i))return i;let t=`${i}`,e=t.match(ay);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${rr(s)}e${r}`}return Be(i,n)};function er(i,t){return rr(Be(rr(i/t))*t)}function xl(i,t){return rr(mi(rr(i/t))*t)}function Bp(i,t){return rr(si(rr(i/t))*t)}function Be(i,t=0){if(zp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return yn(n)/e}var Ps=new Map;function kp(i){return((""+i).split(".")[1]||"").length}function Jo(i,t,e,n){let s=[],r=n.map(kp);for(let o=t;o<e;o++){let a=xn(o),l=Be(kr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Be(h,u);s.push(d),Ps.set(d,u)}}return s}var Zo={},Du=[],zr=[null,null],Rs=Array.isArray,zp=Number.isInteger,ly=i=>i===void 0;function hp(i){return typeof i=="string"}function vl(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function cy(i){return i!=null&&typeof i=="object"}var hy=Object.getPrototypeOf(Uint8Array),Gp="__proto__";function Gr(i,t=vl){let e;if(Rs(i)){let n=i.find(s=>s!=null);if(Rs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Gr(i[s],t)}else e=i.slice()}else if(i instanceof hy)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Gp&&(e[n]=Gr(i[n],t))}else e=i;return e}function fn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Gp&&(vl(i[s])?fn(i[s],Gr(n[s])):i[s]=Gr(n[s]))}return i}var uy=0,dy=1,fy=2;function py(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function my(i,t){if(yy(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return xy(o[0])||(o=_y(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[o][c]:dy,f=[];for(let p=0;p<h.length;p++){let y=h[p],m=r.get(l[p]);y===null?d!=uy&&(u[m]=y,d==fy&&f.push(m)):u[m]=y}py(u,f,s),n.push(u)}}return n}var gy=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function _y(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function yy(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function xy(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Xn(1,si((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Vp=["January","February","March","April","May","June","July","August","September","October","November","December"],Hp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Wp(i){return i.slice(0,3)}var vy=Hp.map(Wp),Sy=Vp.map(Wp),My={MMMM:Vp,MMM:Sy,WWWW:Hp,WWW:vy};function Wo(i){return(i<10?"0":"")+i}function by(i){return(i<10?"00":i<100?"0":"")+i}var wy={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Wo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Wo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Wo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Wo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Wo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>by(i.getMilliseconds())};function Nu(i,t){t=t||My;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?wy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Ty=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Ey(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Ty?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var Xp=i=>i%1==0,gl=[1,2,2.5,5],Ay=Jo(10,-32,0,gl),qp=Jo(10,0,32,gl),Cy=qp.filter(Xp),nr=Ay.concat(qp),Uu=`
`,$p="{YYYY}",up=Uu+$p,Yp="{M}/{D}",$o=Uu+Yp,ul=$o+"/{YY}",Zp="{aa}",Ry="{h}:{mm}",Or=Ry+Zp,dp=Uu+Or,fp=":{ss}",Ae=null;function Jp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Jo(10,0,3,gl).filter(Xp):Jo(10,-3,0,gl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,$p,Ae,Ae,Ae,Ae,Ae,Ae,1],[s*28,"{MMM}",up,Ae,Ae,Ae,Ae,Ae,1],[s,Yp,up,Ae,Ae,Ae,Ae,Ae,1],[n,"{h}"+Zp,ul,Ae,$o,Ae,Ae,Ae,1],[e,Or,ul,Ae,$o,Ae,Ae,Ae,1],[t,fp,ul+" "+Or,Ae,$o+" "+Or,Ae,dp,Ae,1],[i,fp+".{fff}",ul+" "+Or,Ae,$o+" "+Or,Ae,dp,Ae,1]];function h(u){return(d,f,p,y,m,g)=>{let _=[],M=m>=o,x=m>=r&&m<o,C=u(p),T=Be(C*i,3),v=pu(C.getFullYear(),M?0:C.getMonth(),x||M?1:C.getDate()),b=Be(v*i,3);if(x||M){let R=x?m/r:0,P=M?m/o:0,L=T==b?T:Be(pu(v.getFullYear()+P,v.getMonth()+R,1)*i,3),O=new Date(yn(L/i)),V=O.getFullYear(),U=O.getMonth();for(let G=0;L<=y;G++){let Z=pu(V+P*G,U+R*G,1),X=Z-u(Be(Z*i,3));L=Be((+Z+X)*i,3),L<=y&&_.push(L)}}else{let R=m>=s?s:m,P=si(p)-si(T),L=b+P+xl(T-b,R);_.push(L);let O=u(L),V=O.getHours()+O.getMinutes()/e+O.getSeconds()/n,U=m/n,G=d.axes[f]._space,Z=g/G;for(;L=Be(L+m,i==1?0:3),!(L>y);)if(U>1){let X=si(Be(V+U,6))%24,$=u(L).getHours()-X;$>1&&($=-1),L-=$*n,V=(V+U)%24;let et=_[_.length-1];Be((L-et)/m,3)*Z>=.7&&_.push(L)}else _.push(L)}return _}}return[l,c,h]}var[Py,Iy,Ly]=Jp(1),[Dy,Ny,Uy]=Jp(.001);Jo(2,-53,53,[1]);function pp(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function mp(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,h,u,d,f;return n.map(p=>{let y=i(p),m=y.getFullYear(),g=y.getMonth(),_=y.getDate(),M=y.getHours(),x=y.getMinutes(),C=y.getSeconds(),T=m!=l&&a[2]||g!=c&&a[3]||_!=h&&a[4]||M!=u&&a[5]||x!=d&&a[6]||C!=f&&a[7]||a[1];return l=m,c=g,h=_,u=M,d=x,f=C,T(y)})}}function Fy(i,t){let e=Nu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function pu(i,t,e){return new Date(i,t,e)}function gp(i,t){return t(i)}var Oy="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function _p(i,t){return(e,n,s,r)=>r==null?Cu:t(i(n))}function By(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function ky(i,t){return i.series[t].fill(i,t)}var zy={show:!0,live:!0,isolate:!1,mount:ry,markers:{show:!0,width:2,stroke:By,fill:ky,dash:"solid"},idx:null,idxs:null,values:[]};function Gy(i,t){let e=i.cursor.points,n=pi(),s=e.size(i,t);We(n,Xo,s),We(n,qo,s);let r=s/-2;We(n,"marginLeft",r),We(n,"marginTop",r);let o=e.width(i,t,s);return o&&We(n,"borderWidth",o),n}function Vy(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Hy(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Wy(i,t){return i.series[t].points.size}var mu=[0,0];function Xy(i,t,e){return mu[0]=t,mu[1]=e,mu}function dl(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function gu(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var qy={show:!0,x:!0,y:!0,lock:!1,move:Xy,points:{one:!1,show:Gy,size:Wy,width:0,stroke:Hy,fill:Vy},bind:{mousedown:dl,mouseup:dl,click:dl,dblclick:dl,mousemove:gu,mouseleave:gu,mouseenter:gu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Kp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Fu=fn({},Kp,{filter:Op}),jp=fn({},Fu,{size:10}),Qp=fn({},Kp,{show:!1}),Ou='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',tm="bold "+Ou,em=1.5,yp={show:!0,scale:"x",stroke:Au,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:tm,side:2,grid:Fu,ticks:jp,border:Qp,font:Ou,lineGap:em,rotate:0},$y="Value",Yy="Time",xp={show:!0,scale:"x",auto:!1,sorted:1,min:Oe,max:-Oe,idxs:[]};function Zy(i,t,e,n,s){return t.map(r=>r==null?"":Lu(r))}function Jy(i,t,e,n,s,r,o){let a=[],l=Ps.get(s)||0;e=o?e:Be(xl(e,s),l);for(let c=e;c<=n;c=Be(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Mu(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?is:Np,h=si(c(e));s=kr(l,h),l==10&&(s=nr[Ti(s,nr)]);let u=e,d=s*l;l==10&&(d=nr[Ti(d,nr)]);do a.push(u),u=u+s,l==10&&!Ps.has(u)&&(u=Be(u,Ps.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=nr[Ti(d,nr)]));while(u<=n);return a}function Ky(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Mu(i,t,Xn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Mu(i,t,Xn(l,-n),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}var nm=/./,jy=/[12357]/,Qy=/[125]/,vp=/1/,bu=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function tx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?nm:l(7,o)-h>=c?jy:l(5,o)-h>=c?Qy:vp;if(u==vp){let d=xn(l(1,o)-h);if(d<c)return bu(t.slice().reverse(),a.distr,u,mi(c/d)).reverse()}return bu(t,a.distr,u,1)}function ex(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=xn(l(1,o)-l(2,o));return c<a?bu(t.slice().reverse(),3,nm,mi(a/c)).reverse():t}function nx(i,t,e,n){return n==null?Cu:t==null?"":Lu(t)}var Sp={show:!0,scale:"y",stroke:Au,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:tm,side:3,grid:Fu,ticks:jp,border:Qp,font:Ou,lineGap:em,rotate:0};function ix(i,t){let e=3+(i||1)*2;return Be(e*t,3)}function sx(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=xn(o-r),l=i.series[t],c=a/(l.points.space*Te);return n[1]-n[0]<=c}var Mp={scale:null,auto:!0,sorted:0,min:Oe,max:-Oe},im=(i,t,e,n,s)=>s,bp={show:!0,auto:!0,sorted:0,gaps:im,alpha:1,facets:[fn({},Mp,{scale:"x"}),fn({},Mp,{scale:"y"})]},wp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:im,alpha:1,points:{show:sx,filter:null},values:null,min:Oe,max:-Oe,idxs:[],path:null,clip:null};function rx(i,t,e,n,s){return e/10}var sm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},ox=fn({},sm,{time:!1,ori:1}),Tp={};function rm(i,t){let e=Tp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Tp[i]=e)),e}var Vr=1,wu=2;function or(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,y=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,g,d,f,p,y,Ml,Wr,wl,am,cm):e(s,l,c,h,u,g,m,f,d,y,p,bl,Xr,zu,lm,hm)}function Bu(i,t){let e=0,n=0,s=be(i.bands,Du);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function ax(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ss(i,t,e,n,s,r){return or(i,t,(o,a,l,c,h,u,d,f,p,y,m)=>{let g=o.pxRound,_=c.dir*(c.ori==0?1:-1),M=c.ori==0?Wr:Xr,x,C;_==1?(x=e,C=n):(x=n,C=e);let T=g(u(a[x],c,y,f)),v=g(d(l[x],h,m,p)),b=g(u(a[C],c,y,f)),R=g(d(r==1?h.max:h.min,h,m,p)),P=new Path2D(s);return M(P,b,R),M(P,T,R),M(P,T,v),P})}function Sl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?wl:zu,l=e;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function lx(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function ku(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),y=u-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(i[g]):p,p>=f&&a.push([f,p])}return a}function Ep(i){return i==0?Fp:i==1?yn:t=>er(t,i)}function om(i){let t=i==0?Ml:bl,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ei(c,a/2,l/2),h=Ei(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var Ml=(i,t,e)=>{i.moveTo(t,e)},bl=(i,t,e)=>{i.moveTo(e,t)},Wr=(i,t,e)=>{i.lineTo(t,e)},Xr=(i,t,e)=>{i.lineTo(e,t)},wl=om(0),zu=om(1),am=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},lm=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},cm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},hm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function um(i){return(t,e,n,s,r)=>or(t,e,(o,a,l,c,h,u,d,f,p,y,m)=>{let{pxRound:g,points:_}=o,M,x;c.ori==0?(M=Ml,x=am):(M=bl,x=lm);let C=Be(_.width*Te,3),T=(_.size-_.width)/2*Te,v=Be(T*2,3),b=new Path2D,R=new Path2D,{left:P,top:L,width:O,height:V}=t.bbox;wl(R,P-v,L-v,O+v*2,V+v*2);let U=G=>{if(l[G]!=null){let Z=g(u(a[G],c,y,f)),X=g(d(l[G],h,m,p));M(b,Z+T,X),x(b,Z,X,T,0,fl*2)}};if(r)r.forEach(U);else for(let G=n;G<=s;G++)U(G);return{stroke:C>0?b:null,fill:b,clip:R,flags:Vr|wu}})}function dm(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var cx=dm(Wr),hx=dm(Xr);function fm(i){let t=be(i?.alignGaps,0);return(e,n,s,r)=>or(e,n,(o,a,l,c,h,u,d,f,p,y,m)=>{[s,r]=_l(l,s,r);let g=o.pxRound,_=V=>g(u(V,c,y,f)),M=V=>g(d(V,h,m,p)),x,C;c.ori==0?(x=Wr,C=cx):(x=Xr,C=hx);let T=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vr},b=v.stroke,R=!1;if(r-s>=y*4){let V=at=>e.posToVal(at,c.key,!0),U=null,G=null,Z,X,ct,B=_(a[T==1?s:r]),$=_(a[s]),et=_(a[r]),ht=V(T==1?$+1:et-1);for(let at=T==1?s:r;at>=s&&at<=r;at+=T){let Q=a[at],yt=(T==1?Q<ht:Q>ht)?B:_(Q),At=l[at];yt==B?At!=null?(X=At,U==null?(x(b,yt,M(X)),Z=U=G=X):X<U?U=X:X>G&&(G=X)):At===null&&(R=!0):(U!=null&&C(b,B,M(U),M(G),M(Z),M(X)),At!=null?(X=At,x(b,yt,M(X)),U=G=Z=X):(U=G=null,At===null&&(R=!0)),B=yt,ht=V(B+T))}U!=null&&U!=G&&ct!=B&&C(b,B,M(U),M(G),M(Z),M(X))}else for(let V=T==1?s:r;V>=s&&V<=r;V+=T){let U=l[V];U===null?R=!0:U!=null&&x(b,_(a[V]),M(U))}let[L,O]=Bu(e,n);if(o.fill!=null||L!=0){let V=v.fill=new Path2D(b),U=o.fillTo(e,n,o.min,o.max,L),G=M(U),Z=_(a[s]),X=_(a[r]);T==-1&&([X,Z]=[Z,X]),x(V,X,G),x(V,Z,G)}if(!o.spanGaps){let V=[];R&&V.push(...ku(a,l,s,r,T,_,t)),v.gaps=V=o.gaps(e,n,s,r,V),v.clip=Sl(V,c.ori,f,p,y,m)}return O!=0&&(v.band=O==2?[ss(e,n,s,r,b,-1),ss(e,n,s,r,b,1)]:ss(e,n,s,r,b,O)),v})}function ux(i){let t=be(i.align,1),e=be(i.ascDesc,!1),n=be(i.alignGaps,0),s=be(i.extend,!1);return(r,o,a,l)=>or(r,o,(c,h,u,d,f,p,y,m,g,_,M)=>{[a,l]=_l(u,a,l);let x=c.pxRound,{left:C,width:T}=r.bbox,v=$=>x(p($,d,_,m)),b=$=>x(y($,f,M,g)),R=d.ori==0?Wr:Xr,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vr},L=P.stroke,O=d.dir*(d.ori==0?1:-1),V=b(u[O==1?a:l]),U=v(h[O==1?a:l]),G=U,Z=U;s&&t==-1&&(Z=C,R(L,Z,V)),R(L,U,V);for(let $=O==1?a:l;$>=a&&$<=l;$+=O){let et=u[$];if(et==null)continue;let ht=v(h[$]),at=b(et);t==1?R(L,ht,V):R(L,G,at),R(L,ht,at),V=at,G=ht}let X=G;s&&t==1&&(X=C+T,R(L,X,V));let[ct,B]=Bu(r,o);if(c.fill!=null||ct!=0){let $=P.fill=new Path2D(L),et=c.fillTo(r,o,c.min,c.max,ct),ht=b(et);R($,X,ht),R($,Z,ht)}if(!c.spanGaps){let $=[];$.push(...ku(h,u,a,l,O,v,n));let et=c.width*Te/2,ht=e||t==1?et:-et,at=e||t==-1?-et:et;$.forEach(Q=>{Q[0]+=ht,Q[1]+=at}),P.gaps=$=c.gaps(r,o,a,l,$),P.clip=Sl($,d.ori,m,g,_,M)}return B!=0&&(P.band=B==2?[ss(r,o,a,l,L,-1),ss(r,o,a,l,L,1)]:ss(r,o,a,l,L,B)),P})}function Ap(i,t,e,n,s,r,o=Oe){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=xn(i[l]-i[a]);h<c&&(c=h,o=xn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function dx(i){i=i||Zo;let t=be(i.size,[.6,Oe,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xe(s),o=1-t[0],a=be(t[1],Oe),l=be(t[2],1),c=be(i.disp,Zo),h=be(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,y,m)=>or(f,p,(g,_,M,x,C,T,v,b,R,P,L)=>{let O=g.pxRound,V=e,U=n*Te,G=a*Te,Z=l*Te,X,ct;x.ori==0?[X,ct]=r(f,p):[ct,X]=r(f,p);let B=x.dir*(x.ori==0?1:-1),$=x.ori==0?wl:zu,et=x.ori==0?h:(Rt,Yt,re,bt,Fe,zt,qt)=>{h(Rt,Yt,re,Fe,bt,qt,zt)},ht=be(f.bands,Du).find(Rt=>Rt.series[0]==p),at=ht!=null?ht.dir:0,Q=g.fillTo(f,p,g.min,g.max,at),mt=O(v(Q,C,L,R)),yt,At,Mt,Ht=P,se=O(g.width*Te),Gt=!1,de=null,le=null,ne=null,qe=null;u!=null&&(se==0||d!=null)&&(Gt=!0,de=u.values(f,p,y,m),le=new Map,new Set(de).forEach(Rt=>{Rt!=null&&le.set(Rt,new Path2D)}),se>0&&(ne=d.values(f,p,y,m),qe=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&qe.set(Rt,new Path2D)})));let{x0:ke,size:an}=c;if(ke!=null&&an!=null){V=1,_=ke.values(f,p,y,m),ke.unit==2&&(_=_.map(re=>f.posToVal(b+re*P,x.key,!0)));let Rt=an.values(f,p,y,m);an.unit==2?At=Rt[0]*P:At=T(Rt[0],x,P,b)-T(0,x,P,b),Ht=Ap(_,M,T,x,P,b,Ht),Mt=Ht-At+U}else Ht=Ap(_,M,T,x,P,b,Ht),Mt=Ht*o+U,At=Ht-Mt;Mt<1&&(Mt=0),se>=At/2&&(se=0),Mt<5&&(O=Fp);let Ne=Mt>0,wn=Ht-Mt-(Ne?se:0);At=O(Su(wn,Z,G)),yt=(V==0?At/2:V==B?0:At)-V*B*((V==0?U/2:0)+(Ne?se/2:0));let Se={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gn=Gt?null:new Path2D,Ke=null;if(ht!=null)Ke=f.data[ht.series[1]];else{let{y0:Rt,y1:Yt}=c;Rt!=null&&Yt!=null&&(M=Yt.values(f,p,y,m),Ke=Rt.values(f,p,y,m))}let ln=X*At,z=ct*At;for(let Rt=B==1?y:m;Rt>=y&&Rt<=m;Rt+=B){let Yt=M[Rt];if(Yt==null)continue;if(Ke!=null){let Y=Ke[Rt]??0;if(Yt-Y==0)continue;mt=v(Y,C,L,R)}let re=x.distr!=2||c!=null?_[Rt]:Rt,bt=T(re,x,P,b),Fe=v(be(Yt,Q),C,L,R),zt=O(bt-yt),qt=O(Xn(Fe,mt)),I=O(Ei(Fe,mt)),w=qt-I;if(Yt!=null){let Y=Yt<0?z:ln,dt=Yt<0?ln:z;Gt?(se>0&&ne[Rt]!=null&&$(qe.get(ne[Rt]),zt,I+si(se/2),At,Xn(0,w-se),Y,dt),de[Rt]!=null&&$(le.get(de[Rt]),zt,I+si(se/2),At,Xn(0,w-se),Y,dt)):$(gn,zt,I+si(se/2),At,Xn(0,w-se),Y,dt),et(f,p,Rt,zt-se/2,I,At+se,w)}}return se>0?Se.stroke=Gt?qe:gn:Gt||(Se._fill=g.width==0?g._fill:g._stroke??g._fill,Se.width=0),Se.fill=Gt?le:gn,Se})}function fx(i,t){let e=be(t?.alignGaps,0);return(n,s,r,o)=>or(n,s,(a,l,c,h,u,d,f,p,y,m,g)=>{[r,o]=_l(c,r,o);let _=a.pxRound,M=X=>_(d(X,h,m,p)),x=X=>_(f(X,u,g,y)),C,T,v;h.ori==0?(C=Ml,v=Wr,T=cm):(C=bl,v=Xr,T=hm);let b=h.dir*(h.ori==0?1:-1),R=M(l[b==1?r:o]),P=R,L=[],O=[];for(let X=b==1?r:o;X>=r&&X<=o;X+=b)if(c[X]!=null){let B=l[X],$=M(B);L.push(P=$),O.push(x(c[X]))}let V={stroke:i(L,O,C,v,T,_),fill:null,clip:null,band:null,gaps:null,flags:Vr},U=V.stroke,[G,Z]=Bu(n,s);if(a.fill!=null||G!=0){let X=V.fill=new Path2D(U),ct=a.fillTo(n,s,a.min,a.max,G),B=x(ct);v(X,P,B),v(X,R,B)}if(!a.spanGaps){let X=[];X.push(...ku(l,c,r,o,b,M,e)),V.gaps=X=a.gaps(n,s,r,o,X),V.clip=Sl(X,h.ori,p,y,m,g)}return Z!=0&&(V.band=Z==2?[ss(n,s,r,o,U,-1),ss(n,s,r,o,U,1)]:ss(n,s,r,o,U,Z)),V})}function px(i){return fx(mx,i)}function mx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,t[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,i[d+1],t[d+1])}return a}var Tu=new Set;function Cp(){for(let i of Tu)i.syncRect(!0)}Hr&&(sr(Z_,Br,Cp),sr(J_,Br,Cp,!0),sr(pl,Br,()=>{vn.pxRatio=Te}));var gx=fm(),_x=um();function Rp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Eu(r,o,t,e))}function yx(i,t){return i.map((e,n)=>n==0?{}:fn({},t,e))}function Eu(i,t,e,n){return fn({},t==0?e:n,i)}function pm(i,t,e){return t==null?zr:[t,e]}var xx=pm;function vx(i,t,e){return t==null?zr:ml(t,e,Iu,!0)}function mm(i,t,e,n){return t==null?zr:yl(t,e,i.scales[n].log,!1)}var Sx=mm;function gm(i,t,e,n){return t==null?zr:Pu(t,e,i.scales[n].log,!1)}var Mx=gm;function bx(i,t,e,n,s){let r=Xn(ap(i),ap(t)),o=t-i,a=Ti(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Ps.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Pp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=yn((e=+s)*Te))+"px"),[i,t,e]}function wx(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Be(t[2]*Te,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function vn(i,t,e){let n={mode:be(i.mode,1)},s=n.mode;function r(S,E,D,F){let q=E.valToPct(S);return F+D*(E.dir==-1?1-q:q)}function o(S,E,D,F){let q=E.valToPct(S);return F+D*(E.dir==-1?q:1-q)}function a(S,E,D,F){return E.ori==0?r(S,E,D,F):o(S,E,D,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=pi(I_);if(i.id!=null&&(c.id=i.id),ii(c,i.class),i.title){let S=pi(N_,c);S.textContent=i.title}let h=wi("canvas"),u=n.ctx=h.getContext("2d"),d=pi(U_,c);sr("click",d,S=>{S.target===p&&(Ge!=Ir||$e!=Lr)&&Ln.click(n,S)},!0);let f=n.under=pi(F_,d);d.appendChild(h);let p=n.over=pi(O_,d);i=Gr(i);let y=+be(i.pxAlign,1),m=Ep(y);(i.plugins||[]).forEach(S=>{S.opts&&(i=S.opts(n,i)||i)});let g=i.ms||.001,_=n.series=s==1?Rp(i.series||[],xp,wp,!1):yx(i.series||[null],bp),M=n.axes=Rp(i.axes||[],yp,Sp,!0),x=n.scales={},C=n.bands=i.bands||[];C.forEach(S=>{S.fill=xe(S.fill||null),S.dir=be(S.dir,-1)});let T=s==2?_[1].facets[0].scale:_[0].scale,v={axes:es,series:pe},b=(i.drawOrder||["axes","series"]).map(S=>v[S]);function R(S){let E=S.distr==3?D=>is(D>0?D:S.clamp(n,D,S.min,S.max,S.key)):S.distr==4?D=>fu(D,S.asinh):S.distr==100?D=>S.fwd(D):D=>D;return D=>{let F=E(D),{_min:q,_max:j}=S,lt=j-q;return(F-q)/lt}}function P(S){let E=x[S];if(E==null){let D=(i.scales||Zo)[S]||Zo;if(D.from!=null){P(D.from);let F=fn({},x[D.from],D,{key:S});F.valToPct=R(F),x[S]=F}else{E=x[S]=fn({},S==T?sm:ox,D),E.key=S;let F=E.time,q=E.range,j=Rs(q);if((S!=T||s==2&&!F)&&(j&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?sp:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?sp:{mode:1,hard:q[1],soft:q[1]}},j=!1),!j&&vl(q))){let lt=q;q=(ft,vt,Dt)=>vt==null?zr:ml(vt,Dt,lt)}E.range=xe(q||(F?xx:S==T?E.distr==3?Sx:E.distr==4?Mx:pm:E.distr==3?mm:E.distr==4?gm:vx)),E.auto=xe(j?!1:E.auto),E.clamp=xe(E.clamp||rx),E._min=E._max=null,E.valToPct=R(E)}}}P("x"),P("y"),s==1&&_.forEach(S=>{P(S.scale)}),M.forEach(S=>{P(S.scale)});for(let S in i.scales)P(S);let L=x[T],O=L.distr,V,U;L.ori==0?(ii(c,L_),V=r,U=o):(ii(c,D_),V=o,U=r);let G={};for(let S in x){let E=x[S];(E.min!=null||E.max!=null)&&(G[S]={min:E.min,max:E.max},E.min=E.max=null)}let Z=i.tzDate||(S=>new Date(yn(S/g))),X=i.fmtDate||Nu,ct=g==1?Ly(Z):Uy(Z),B=mp(Z,pp(g==1?Iy:Ny,X)),$=_p(Z,gp(Oy,X)),et=[],ht=n.legend=fn({},zy,i.legend),at=n.cursor=fn({},qy,{drag:{y:s==2}},i.cursor),Q=ht.show,mt=at.show,yt=ht.markers;ht.idxs=et,yt.width=xe(yt.width),yt.dash=xe(yt.dash),yt.stroke=xe(yt.stroke),yt.fill=xe(yt.fill);let At,Mt,Ht,se=[],Gt=[],de,le=!1,ne={};if(ht.live){let S=_[1]?_[1].values:null;le=S!=null,de=le?S(n,1,0):{_:0};for(let E in de)ne[E]=Cu}if(Q)if(At=wi("table",H_,c),Ht=wi("tbody",null,At),ht.mount(n,At),le){Mt=wi("thead",null,At,Ht);let S=wi("tr",null,Mt);wi("th",null,S);for(var qe in de)wi("th",Xf,S).textContent=qe}else ii(At,X_),ht.live&&ii(At,W_);let ke={show:!0},an={show:!1};function Ne(S,E){if(E==0&&(le||!ht.live||s==2))return zr;let D=[],F=wi("tr",q_,Ht,Ht.childNodes[E]);ii(F,S.class),S.show||ii(F,ir);let q=wi("th",null,F);if(yt.show){let ft=pi($_,q);if(E>0){let vt=yt.width(n,E);vt&&(ft.style.border=vt+"px "+yt.dash(n,E)+" "+yt.stroke(n,E)),ft.style.background=yt.fill(n,E)}}let j=pi(Xf,q);S.label instanceof HTMLElement?j.appendChild(S.label):j.textContent=S.label,E>0&&(yt.show||(j.style.color=S.width>0?yt.stroke(n,E):yt.fill(n,E)),Se("click",q,ft=>{if(at._lock)return;Kt(ft);let vt=_.indexOf(S);if((ft.ctrlKey||ft.metaKey)!=ht.isolate){let Dt=_.some((Nt,Ft)=>Ft>0&&Ft!=vt&&Nt.show);_.forEach((Nt,Ft)=>{Ft>0&&Oi(Ft,Dt?Ft==vt?ke:an:ke,!0,dn.setSeries)})}else Oi(vt,{show:!S.show},!0,dn.setSeries)},!1),jt&&Se(Zf,q,ft=>{at._lock||(Kt(ft),Oi(_.indexOf(S),Nr,!0,dn.setSeries))},!1));for(var lt in de){let ft=wi("td",Y_,F);ft.textContent="--",D.push(ft)}return[F,D]}let wn=new Map;function Se(S,E,D,F=!0){let q=wn.get(E)||{},j=at.bind[S](n,E,D,F);j&&(sr(S,E,q[S]=j),wn.set(E,q))}function gn(S,E,D){let F=wn.get(E)||{};for(let q in F)(S==null||q==S)&&(vu(q,E,F[q]),delete F[q]);S==null&&wn.delete(E)}let Ke=0,ln=0,z=0,Rt=0,Yt=0,re=0,bt=Yt,Fe=re,zt=z,qt=Rt,I=0,w=0,Y=0,dt=0;n.bbox={};let ot=!1,_t=!1,xt=!1,nt=!1,st=!1,pt=!1;function k(S,E,D){(D||S!=n.width||E!=n.height)&&rt(S,E),ce(!1),xt=!0,_t=!0,Un()}function rt(S,E){n.width=Ke=z=S,n.height=ln=Rt=E,Yt=re=0,St(),Vt();let D=n.bbox;I=D.left=er(Yt*Te,.5),w=D.top=er(re*Te,.5),Y=D.width=er(z*Te,.5),dt=D.height=er(Rt*Te,.5)}let it=3;function wt(){let S=!1,E=0;for(;!S;){E++;let D=Cr(E),F=Fi(E);S=E==it||D&&F,S||(rt(n.width,n.height),_t=!0)}}function gt({width:S,height:E}){k(S,E)}n.setSize=gt;function St(){let S=!1,E=!1,D=!1,F=!1;M.forEach((q,j)=>{if(q.show&&q._show){let{side:lt,_size:ft}=q,vt=lt%2,Dt=q.label!=null?q.labelSize:0,Nt=ft+Dt;Nt>0&&(vt?(z-=Nt,lt==3?(Yt+=Nt,F=!0):D=!0):(Rt-=Nt,lt==0?(re+=Nt,S=!0):E=!0))}}),Ni[0]=S,Ni[1]=D,Ni[2]=E,Ni[3]=F,z-=vi[1]+vi[3],Yt+=vi[3],Rt-=vi[2]+vi[0],re+=vi[0]}function Vt(){let S=Yt+z,E=re+Rt,D=Yt,F=re;function q(j,lt){switch(j){case 1:return S+=lt,S-lt;case 2:return E+=lt,E-lt;case 3:return D-=lt,D+lt;case 0:return F-=lt,F+lt}}M.forEach((j,lt)=>{if(j.show&&j._show){let ft=j.side;j._pos=q(ft,j._size),j.label!=null&&(j._lpos=q(ft,j.labelSize))}})}if(at.dataIdx==null){let S=at.hover,E=S.skip=new Set(S.skip??[]);E.add(void 0);let D=S.prox=xe(S.prox),F=S.bias??=0;at.dataIdx=(q,j,lt,ft)=>{if(j==0)return lt;let vt=lt,Dt=D(q,j,lt,ft)??Oe,Nt=Dt>=0&&Dt<Oe,Ft=L.ori==0?z:Rt,ie=at.left,we=t[0],Me=t[j];if(E.has(Me[lt])){vt=null;let _e=null,Jt=null,Wt;if(F==0||F==-1)for(Wt=lt;_e==null&&Wt-- >0;)E.has(Me[Wt])||(_e=Wt);if(F==0||F==1)for(Wt=lt;Jt==null&&Wt++<Me.length;)E.has(Me[Wt])||(Jt=Wt);if(_e!=null||Jt!=null)if(Nt){let He=_e==null?-1/0:V(we[_e],L,Ft,0),tn=Jt==null?1/0:V(we[Jt],L,Ft,0),Cn=ie-He,Ue=tn-ie;Cn<=Ue?Cn<=Dt&&(vt=_e):Ue<=Dt&&(vt=Jt)}else vt=Jt==null?_e:_e==null?Jt:lt-_e<=Jt-lt?_e:Jt}else Nt&&xn(ie-V(we[lt],L,Ft,0))>Dt&&(vt=null);return vt}}let Kt=S=>{at.event=S};at.idxs=et,at._lock=!1;let ut=at.points;ut.show=xe(ut.show),ut.size=xe(ut.size),ut.stroke=xe(ut.stroke),ut.width=xe(ut.width),ut.fill=xe(ut.fill);let Ot=n.focus=fn({},i.focus||{alpha:.3},at.focus),jt=Ot.prox>=0,Ct=jt&&ut.one,ae=[],ze=[],zn=[];function Fo(S,E){let D=ut.show(n,E);if(D instanceof HTMLElement)return ii(D,V_),ii(D,S.class),Gi(D,-10,-10,z,Rt),p.insertBefore(D,ae[E]),D}function Tr(S,E){if(s==1||E>0){let D=s==1&&x[S.scale].time,F=S.value;S.value=D?hp(F)?_p(Z,gp(F,X)):F||$:F||nx,S.label=S.label||(D?Yy:$y)}if(Ct||E>0){S.width=S.width==null?1:S.width,S.paths=S.paths||gx||oy,S.fillTo=xe(S.fillTo||ax),S.pxAlign=+be(S.pxAlign,y),S.pxRound=Ep(S.pxAlign),S.stroke=xe(S.stroke||null),S.fill=xe(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let D=ix(Xn(1,S.width),1),F=S.points=fn({},{size:D,width:Xn(1,D*.2),stroke:S.stroke,space:D*2,paths:_x,_stroke:null,_fill:null},S.points);F.show=xe(F.show),F.filter=xe(F.filter),F.fill=xe(F.fill),F.stroke=xe(F.stroke),F.paths=xe(F.paths),F.pxAlign=S.pxAlign}if(Q){let D=Ne(S,E);se.splice(E,0,D[0]),Gt.splice(E,0,D[1]),ht.values.push(null)}if(mt){et.splice(E,0,null);let D=null;Ct?E==0&&(D=Fo(S,E)):E>0&&(D=Fo(S,E)),ae.splice(E,0,D),ze.splice(E,0,0),zn.splice(E,0,0)}An("addSeries",E)}function Qh(S,E){E=E??_.length,S=s==1?Eu(S,E,xp,wp):Eu(S,E,{},bp),_.splice(E,0,S),Tr(_[E],E)}n.addSeries=Qh;function sl(S){if(_.splice(S,1),Q){ht.values.splice(S,1),Gt.splice(S,1);let E=se.splice(S,1)[0];gn(null,E.firstChild),E.remove()}mt&&(et.splice(S,1),ae.splice(S,1)[0].remove(),ze.splice(S,1),zn.splice(S,1)),An("delSeries",S)}n.delSeries=sl;let Ni=[!1,!1,!1,!1];function ji(S,E){if(S._show=S.show,S.show){let D=S.side%2,F=x[S.scale];F==null&&(S.scale=D?_[1].scale:T,F=x[S.scale]);let q=F.time;S.size=xe(S.size),S.space=xe(S.space),S.rotate=xe(S.rotate),Rs(S.incrs)&&S.incrs.forEach(lt=>{!Ps.has(lt)&&Ps.set(lt,kp(lt))}),S.incrs=xe(S.incrs||(F.distr==2?Cy:q?g==1?Py:Dy:nr)),S.splits=xe(S.splits||(q&&F.distr==1?ct:F.distr==3?Mu:F.distr==4?Ky:Jy)),S.stroke=xe(S.stroke),S.grid.stroke=xe(S.grid.stroke),S.ticks.stroke=xe(S.ticks.stroke),S.border.stroke=xe(S.border.stroke);let j=S.values;S.values=Rs(j)&&!Rs(j[0])?xe(j):q?Rs(j)?mp(Z,pp(j,X)):hp(j)?Fy(Z,j):j||B:j||Zy,S.filter=xe(S.filter||(F.distr>=3&&F.log==10?tx:F.distr==3&&F.log==2?ex:Op)),S.font=Pp(S.font),S.labelFont=Pp(S.labelFont),S._size=S.size(n,null,E,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(Ni[E]=!0,S._el=pi(B_,d))}}function Qi(S,E,D,F){let[q,j,lt,ft]=D,vt=E%2,Dt=0;return vt==0&&(ft||j)&&(Dt=E==0&&!q||E==2&&!lt?yn(yp.size/3):0),vt==1&&(q||lt)&&(Dt=E==1&&!j||E==3&&!ft?yn(Sp.size/2):0),Dt}let Oo=n.padding=(i.padding||[Qi,Qi,Qi,Qi]).map(S=>xe(be(S,Qi))),vi=n._padding=Oo.map((S,E)=>S(n,E,Ni,0)),je,sn=null,rn=null,Ui=s==1?_[0].idxs:null,Qn=null,Ms=!1;function Bo(S,E){if(t=S??[],n.data=n._data=t,s==2){je=0;for(let D=1;D<_.length;D++)je+=t[D][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),Qn=t[0],je=Qn.length;let D=t;if(O==2){D=t.slice();let F=D[0]=Array(je);for(let q=0;q<je;q++)F[q]=q}n._data=t=D}if(ce(!0),An("setData"),O==2&&(xt=!0),E!==!1){let D=L;D.auto(n,Ms)?ko():Ts(T,D.min,D.max),nt=nt||at.left>=0,pt=!0,Un()}}n.setData=Bo;function ko(){Ms=!0;let S,E;s==1&&(je>0?(sn=Ui[0]=0,rn=Ui[1]=je-1,S=t[0][sn],E=t[0][rn],O==2?(S=sn,E=rn):S==E&&(O==3?[S,E]=yl(S,S,L.log,!1):O==4?[S,E]=Pu(S,S,L.log,!1):L.time?E=S+yn(86400/g):[S,E]=ml(S,E,Iu,!0))):(sn=Ui[0]=S=null,rn=Ui[1]=E=null)),Ts(T,S,E)}let Er,bs,Ar,A,H,tt,J,K,Tt,Pt;function Et(S,E,D,F,q,j){S??=$f,D??=Du,F??="butt",q??=$f,j??="round",S!=Er&&(u.strokeStyle=Er=S),q!=bs&&(u.fillStyle=bs=q),E!=Ar&&(u.lineWidth=Ar=E),j!=H&&(u.lineJoin=H=j),F!=tt&&(u.lineCap=tt=F),D!=A&&u.setLineDash(A=D)}function It(S,E,D,F){E!=bs&&(u.fillStyle=bs=E),S!=J&&(u.font=J=S),D!=K&&(u.textAlign=K=D),F!=Tt&&(u.textBaseline=Tt=F)}function kt(S,E,D,F,q=0){if(F.length>0&&S.auto(n,Ms)&&(E==null||E.min==null)){let j=be(sn,0),lt=be(rn,F.length-1),ft=D.min==null?ty(F,j,lt,q,S.distr==3):[D.min,D.max];S.min=Ei(S.min,D.min=ft[0]),S.max=Xn(S.max,D.max=ft[1])}}let Qt={min:null,max:null};function fe(){for(let F in x){let q=x[F];G[F]==null&&(q.min==null||G[T]!=null&&q.auto(n,Ms))&&(G[F]=Qt)}for(let F in x){let q=x[F];G[F]==null&&q.from!=null&&G[q.from]!=null&&(G[F]=Qt)}G[T]!=null&&ce(!0);let S={};for(let F in G){let q=G[F];if(q!=null){let j=S[F]=Gr(x[F],cy);if(q.min!=null)fn(j,q);else if(F!=T||s==2)if(je==0&&j.from==null){let lt=j.range(n,null,null,F);j.min=lt[0],j.max=lt[1]}else j.min=Oe,j.max=-Oe}}if(je>0){_.forEach((F,q)=>{if(s==1){let j=F.scale,lt=G[j];if(lt==null)return;let ft=S[j];if(q==0){let vt=ft.range(n,ft.min,ft.max,j);ft.min=vt[0],ft.max=vt[1],sn=Ti(ft.min,t[0]),rn=Ti(ft.max,t[0]),rn-sn>1&&(t[0][sn]<ft.min&&sn++,t[0][rn]>ft.max&&rn--),F.min=Qn[sn],F.max=Qn[rn]}else F.show&&F.auto&&kt(ft,lt,F,t[q],F.sorted);F.idxs[0]=sn,F.idxs[1]=rn}else if(q>0&&F.show&&F.auto){let[j,lt]=F.facets,ft=j.scale,vt=lt.scale,[Dt,Nt]=t[q],Ft=S[ft],ie=S[vt];Ft!=null&&kt(Ft,G[ft],j,Dt,j.sorted),ie!=null&&kt(ie,G[vt],lt,Nt,lt.sorted),F.min=lt.min,F.max=lt.max}});for(let F in S){let q=S[F],j=G[F];if(q.from==null&&(j==null||j.min==null)){let lt=q.range(n,q.min==Oe?null:q.min,q.max==-Oe?null:q.max,F);q.min=lt[0],q.max=lt[1]}}}for(let F in S){let q=S[F];if(q.from!=null){let j=S[q.from];if(j.min==null)q.min=q.max=null;else{let lt=q.range(n,j.min,j.max,F);q.min=lt[0],q.max=lt[1]}}}let E={},D=!1;for(let F in S){let q=S[F],j=x[F];if(j.min!=q.min||j.max!=q.max){j.min=q.min,j.max=q.max;let lt=j.distr;j._min=lt==3?is(j.min):lt==4?fu(j.min,j.asinh):lt==100?j.fwd(j.min):j.min,j._max=lt==3?is(j.max):lt==4?fu(j.max,j.asinh):lt==100?j.fwd(j.max):j.max,E[F]=D=!0}}if(D){_.forEach((F,q)=>{s==2?q>0&&E.y&&(F._paths=null):E[F.scale]&&(F._paths=null)});for(let F in E)xt=!0,An("setScale",F);mt&&at.left>=0&&(nt=pt=!0)}for(let F in G)G[F]=null}function Bt(S){let E=Su(sn-1,0,je-1),D=Su(rn+1,0,je-1);for(;S[E]==null&&E>0;)E--;for(;S[D]==null&&D<je-1;)D++;return[E,D]}function pe(){if(je>0){let S=_.some(E=>E._focus)&&Pt!=Ot.alpha;S&&(u.globalAlpha=Pt=Ot.alpha),_.forEach((E,D)=>{if(D>0&&E.show&&(Ze(D,!1),Ze(D,!0),E._paths==null)){let F=Pt;Pt!=E.alpha&&(u.globalAlpha=Pt=E.alpha);let q=s==2?[0,t[D][0].length-1]:Bt(t[D]);E._paths=E.paths(n,D,q[0],q[1]),Pt!=F&&(u.globalAlpha=Pt=F)}}),_.forEach((E,D)=>{if(D>0&&E.show){let F=Pt;Pt!=E.alpha&&(u.globalAlpha=Pt=E.alpha),E._paths!=null&&Ie(D,!1);{let q=E._paths!=null?E._paths.gaps:null,j=E.points.show(n,D,sn,rn,q),lt=E.points.filter(n,D,j,q);(j||lt)&&(E.points._paths=E.points.paths(n,D,sn,rn,lt),Ie(D,!0))}Pt!=F&&(u.globalAlpha=Pt=F),An("drawSeries",D)}}),S&&(u.globalAlpha=Pt=1)}}function Ze(S,E){let D=E?_[S].points:_[S];D._stroke=D.stroke(n,S),D._fill=D.fill(n,S)}function Ie(S,E){let D=E?_[S].points:_[S],{stroke:F,fill:q,clip:j,flags:lt,_stroke:ft=D._stroke,_fill:vt=D._fill,_width:Dt=D.width}=D._paths;Dt=Be(Dt*Te,3);let Nt=null,Ft=Dt%2/2;E&&vt==null&&(vt=Dt>0?"#fff":ft);let ie=D.pxAlign==1&&Ft>0;if(ie&&u.translate(Ft,Ft),!E){let we=I-Dt/2,Me=w-Dt/2,_e=Y+Dt,Jt=dt+Dt;Nt=new Path2D,Nt.rect(we,Me,_e,Jt)}E?Ut(ft,Dt,D.dash,D.cap,vt,F,q,lt,j):Le(S,ft,Dt,D.dash,D.cap,vt,F,q,lt,Nt,j),ie&&u.translate(-Ft,-Ft)}function Le(S,E,D,F,q,j,lt,ft,vt,Dt,Nt){let Ft=!1;vt!=0&&C.forEach((ie,we)=>{if(ie.series[0]==S){let Me=_[ie.series[1]],_e=t[ie.series[1]],Jt=(Me._paths||Zo).band;Rs(Jt)&&(Jt=ie.dir==1?Jt[0]:Jt[1]);let Wt,He=null;Me.show&&Jt&&ny(_e,sn,rn)?(He=ie.fill(n,we)||j,Wt=Me._paths.clip):Jt=null,Ut(E,D,F,q,He,lt,ft,vt,Dt,Nt,Wt,Jt),Ft=!0}}),Ft||Ut(E,D,F,q,j,lt,ft,vt,Dt,Nt)}let _n=Vr|wu;function Ut(S,E,D,F,q,j,lt,ft,vt,Dt,Nt,Ft){Et(S,E,D,F,q),(vt||Dt||Ft)&&(u.save(),vt&&u.clip(vt),Dt&&u.clip(Dt)),Ft?(ft&_n)==_n?(u.clip(Ft),Nt&&u.clip(Nt),ye(q,lt),cn(S,j,E)):ft&wu?(ye(q,lt),u.clip(Ft),cn(S,j,E)):ft&Vr&&(u.save(),u.clip(Ft),Nt&&u.clip(Nt),ye(q,lt),u.restore(),cn(S,j,E)):(ye(q,lt),cn(S,j,E)),(vt||Dt||Ft)&&u.restore()}function cn(S,E,D){D>0&&(E instanceof Map?E.forEach((F,q)=>{u.strokeStyle=Er=q,u.stroke(F)}):E!=null&&S&&u.stroke(E))}function ye(S,E){E instanceof Map?E.forEach((D,F)=>{u.fillStyle=bs=F,u.fill(D)}):E!=null&&S&&u.fill(E)}function ts(S,E,D,F){let q=M[S],j;if(F<=0)j=[0,0];else{let lt=q._space=q.space(n,S,E,D,F),ft=q._incrs=q.incrs(n,S,E,D,F,lt);j=bx(E,D,ft,F,lt)}return q._found=j}function hn(S,E,D,F,q,j,lt,ft,vt,Dt){let Nt=lt%2/2;y==1&&u.translate(Nt,Nt),Et(ft,lt,vt,Dt,ft),u.beginPath();let Ft,ie,we,Me,_e=q+(F==0||F==3?-j:j);D==0?(ie=q,Me=_e):(Ft=q,we=_e);for(let Jt=0;Jt<S.length;Jt++)E[Jt]!=null&&(D==0?Ft=we=S[Jt]:ie=Me=S[Jt],u.moveTo(Ft,ie),u.lineTo(we,Me));u.stroke(),y==1&&u.translate(-Nt,-Nt)}function Cr(S){let E=!0;return M.forEach((D,F)=>{if(!D.show)return;let q=x[D.scale];if(q.min==null){D._show&&(E=!1,D._show=!1,ce(!1));return}else D._show||(E=!1,D._show=!0,ce(!1));let j=D.side,lt=j%2,{min:ft,max:vt}=q,[Dt,Nt]=ts(F,ft,vt,lt==0?z:Rt);if(Nt==0)return;let Ft=q.distr==2,ie=D._splits=D.splits(n,F,ft,vt,Dt,Nt,Ft),we=q.distr==2?ie.map(Wt=>Qn[Wt]):ie,Me=q.distr==2?Qn[ie[1]]-Qn[ie[0]]:Dt,_e=D._values=D.values(n,D.filter(n,we,F,Nt,Me),F,Nt,Me);D._rotate=j==2?D.rotate(n,_e,F,Nt):0;let Jt=D._size;D._size=mi(D.size(n,_e,F,S)),Jt!=null&&D._size!=Jt&&(E=!1)}),E}function Fi(S){let E=!0;return Oo.forEach((D,F)=>{let q=D(n,F,Ni,S);q!=vi[F]&&(E=!1),vi[F]=q}),E}function es(){for(let S=0;S<M.length;S++){let E=M[S];if(!E.show||!E._show)continue;let D=E.side,F=D%2,q,j,lt=E.stroke(n,S),ft=D==0||D==3?-1:1,[vt,Dt]=E._found;if(E.label!=null){let Hn=E.labelGap*ft,ni=yn((E._lpos+Hn)*Te);It(E.labelFont[0],lt,"center",D==2?"top":qf),u.save(),F==1?(q=j=0,u.translate(ni,yn(w+dt/2)),u.rotate((D==3?-fl:fl)/2)):(q=yn(I+Y/2),j=ni);let js=Up(E.label)?E.label(n,S,vt,Dt):E.label;u.fillText(js,q,j),u.restore()}if(Dt==0)continue;let Nt=x[E.scale],Ft=F==0?Y:dt,ie=F==0?I:w,we=E._splits,Me=Nt.distr==2?we.map(Hn=>Qn[Hn]):we,_e=Nt.distr==2?Qn[we[1]]-Qn[we[0]]:vt,Jt=E.ticks,Wt=E.border,He=Jt.show?Jt.size:0,tn=yn(He*Te),Cn=yn((E.alignTo==2?E._size-He-E.gap:E.gap)*Te),Ue=E._rotate*-fl/180,en=m(E._pos*Te),ti=(tn+Cn)*ft,Vn=en+ti;j=F==0?Vn:0,q=F==1?Vn:0;let di=E.font[0],Si=E.align==1?Fr:E.align==2?hu:Ue>0?Fr:Ue<0?hu:F==0?"center":D==3?hu:Fr,ki=Ue||F==1?"middle":D==2?"top":qf;It(di,lt,Si,ki);let ei=E.font[1]*E.lineGap,fi=we.map(Hn=>m(a(Hn,Nt,Ft,ie))),Mi=E._values;for(let Hn=0;Hn<Mi.length;Hn++){let ni=Mi[Hn];if(ni!=null){F==0?q=fi[Hn]:j=fi[Hn],ni=""+ni;let js=ni.indexOf(`
`)==-1?[ni]:ni.split(/\n/gm);for(let Wn=0;Wn<js.length;Wn++){let Wf=js[Wn];Ue?(u.save(),u.translate(q,j+Wn*ei),u.rotate(Ue),u.fillText(Wf,0,0),u.restore()):u.fillText(Wf,q,j+Wn*ei)}}}Jt.show&&hn(fi,Jt.filter(n,Me,S,Dt,_e),F,D,en,tn,Be(Jt.width*Te,3),Jt.stroke(n,S),Jt.dash,Jt.cap);let zi=E.grid;zi.show&&hn(fi,zi.filter(n,Me,S,Dt,_e),F,F==0?2:1,F==0?w:I,F==0?dt:Y,Be(zi.width*Te,3),zi.stroke(n,S),zi.dash,zi.cap),Wt.show&&hn([en],[1],F==0?1:0,F==0?1:2,F==1?w:I,F==1?dt:Y,Be(Wt.width*Te,3),Wt.stroke(n,S),Wt.dash,Wt.cap)}An("drawAxes")}function ce(S){_.forEach((E,D)=>{D>0&&(E._paths=null,S&&(s==1?(E.min=null,E.max=null):E.facets.forEach(F=>{F.min=null,F.max=null})))})}let Qe=!1,Gn=!1,De=[];function un(){Gn=!1;for(let S=0;S<De.length;S++)An(...De[S]);De.length=0}function Un(){Qe||(gy(Ef),Qe=!0)}function rl(S,E=!1){Qe=!0,Gn=E,S(n),Ef(),E&&De.length>0&&queueMicrotask(un)}n.batch=rl;function Ef(){if(ot&&(fe(),ot=!1),xt&&(wt(),xt=!1),_t){if(We(f,Fr,Yt),We(f,"top",re),We(f,Xo,z),We(f,qo,Rt),We(p,Fr,Yt),We(p,"top",re),We(p,Xo,z),We(p,qo,Rt),We(d,Xo,Ke),We(d,qo,ln),h.width=yn(Ke*Te),h.height=yn(ln*Te),M.forEach(({_el:S,_show:E,_size:D,_pos:F,side:q})=>{if(S!=null)if(E){let j=q===3||q===0?D:0,lt=q%2==1;We(S,lt?"left":"top",F-j),We(S,lt?"width":"height",D),We(S,lt?"top":"left",lt?re:Yt),We(S,lt?"height":"width",lt?Rt:z),xu(S,ir)}else ii(S,ir)}),Er=bs=Ar=H=tt=J=K=Tt=A=null,Pt=1,Vo(!0),Yt!=bt||re!=Fe||z!=zt||Rt!=qt){ce(!1);let S=z/zt,E=Rt/qt;if(mt&&!nt&&at.left>=0){at.left*=S,at.top*=E,Rr&&Gi(Rr,yn(at.left),0,z,Rt),Pr&&Gi(Pr,0,yn(at.top),z,Rt);for(let D=0;D<ae.length;D++){let F=ae[D];F!=null&&(ze[D]*=S,zn[D]*=E,Gi(F,mi(ze[D]),mi(zn[D]),z,Rt))}}if(Ve.show&&!st&&Ve.left>=0&&Ve.width>0){Ve.left*=S,Ve.width*=S,Ve.top*=E,Ve.height*=E;for(let D in ru)We(Dr,D,Ve[D])}bt=Yt,Fe=re,zt=z,qt=Rt}An("setSize"),_t=!1}Ke>0&&ln>0&&(u.clearRect(0,0,h.width,h.height),An("drawClear"),b.forEach(S=>S()),An("draw")),Ve.show&&st&&(ol(Ve),st=!1),mt&&nt&&(Ks(null,!0,!1),nt=!1),ht.show&&ht.live&&pt&&(iu(),pt=!1),l||(l=!0,n.status=1,An("ready")),Ms=!1,Qe=!1}n.redraw=(S,E)=>{xt=E||!1,S!==!1?Ts(T,L.min,L.max):Un()};function tu(S,E){let D=x[S];if(D.from==null){if(je==0){let F=D.range(n,E.min,E.max,S);E.min=F[0],E.max=F[1]}if(E.min>E.max){let F=E.min;E.min=E.max,E.max=F}if(je>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;S==T&&D.distr==2&&je>0&&(E.min=Ti(E.min,t[0]),E.max=Ti(E.max,t[0]),E.min==E.max&&E.max++),G[S]=E,ot=!0,Un()}}n.setScale=tu;let eu,nu,Rr,Pr,Af,Cf,Ir,Lr,Rf,Pf,Ge,$e,ws=!1,Ln=at.drag,Tn=Ln.x,En=Ln.y;mt&&(at.x&&(eu=pi(z_,p)),at.y&&(nu=pi(G_,p)),L.ori==0?(Rr=eu,Pr=nu):(Rr=nu,Pr=eu),Ge=at.left,$e=at.top);let Ve=n.select=fn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Dr=Ve.show?pi(k_,Ve.over?p:f):null;function ol(S,E){if(Ve.show){for(let D in S)Ve[D]=S[D],D in ru&&We(Dr,D,S[D]);E!==!1&&An("setSelect")}}n.setSelect=ol;function __(S){if(_[S].show)Q&&xu(se[S],ir);else if(Q&&ii(se[S],ir),mt){let D=Ct?ae[0]:ae[S];D!=null&&Gi(D,-10,-10,z,Rt)}}function Ts(S,E,D){tu(S,{min:E,max:D})}function Oi(S,E,D,F){E.focus!=null&&M_(S),E.show!=null&&_.forEach((q,j)=>{j>0&&(S==j||S==null)&&(q.show=E.show,__(j),s==2?(Ts(q.facets[0].scale,null,null),Ts(q.facets[1].scale,null,null)):Ts(q.scale,null,null),Un())}),D!==!1&&An("setSeries",S,E),F&&Ho("setSeries",n,S,E)}n.setSeries=Oi;function y_(S,E){fn(C[S],E)}function x_(S,E){S.fill=xe(S.fill||null),S.dir=be(S.dir,-1),E=E??C.length,C.splice(E,0,S)}function v_(S){S==null?C.length=0:C.splice(S,1)}n.addBand=x_,n.setBand=y_,n.delBand=v_;function S_(S,E){_[S].alpha=E,mt&&ae[S]!=null&&(ae[S].style.opacity=E),Q&&se[S]&&(se[S].style.opacity=E)}let ns,Es,Js,Nr={focus:!0};function M_(S){if(S!=Js){let E=S==null,D=Ot.alpha!=1;_.forEach((F,q)=>{if(s==1||q>0){let j=E||q==0||q==S;F._focus=E?null:j,D&&S_(q,j?1:Ot.alpha)}}),Js=S,D&&Un()}}Q&&jt&&Se(Jf,At,S=>{at._lock||(Kt(S),Js!=null&&Oi(null,Nr,!0,dn.setSeries))});function Bi(S,E,D){let F=x[E];D&&(S=S/Te-(F.ori==1?re:Yt));let q=z;F.ori==1&&(q=Rt,S=q-S),F.dir==-1&&(S=q-S);let j=F._min,lt=F._max,ft=S/q,vt=j+(lt-j)*ft,Dt=F.distr;return Dt==3?kr(10,vt):Dt==4?sy(vt,F.asinh):Dt==100?F.bwd(vt):vt}function b_(S,E){let D=Bi(S,T,E);return Ti(D,t[0],sn,rn)}n.valToIdx=S=>Ti(S,t[0]),n.posToIdx=b_,n.posToVal=Bi,n.valToPos=(S,E,D)=>x[E].ori==0?r(S,x[E],D?Y:z,D?I:0):o(S,x[E],D?dt:Rt,D?w:0),n.setCursor=(S,E,D)=>{Ge=S.left,$e=S.top,Ks(null,E,D)};function If(S,E){We(Dr,Fr,Ve.left=S),We(Dr,Xo,Ve.width=E)}function Lf(S,E){We(Dr,"top",Ve.top=S),We(Dr,qo,Ve.height=E)}let zo=L.ori==0?If:Lf,Go=L.ori==1?If:Lf;function w_(){if(Q&&ht.live)for(let S=s==2?1:0;S<_.length;S++){if(S==0&&le)continue;let E=ht.values[S],D=0;for(let F in E)Gt[S][D++].firstChild.nodeValue=E[F]}}function iu(S,E){if(S!=null&&(S.idxs?S.idxs.forEach((D,F)=>{et[F]=D}):ly(S.idx)||et.fill(S.idx),ht.idx=et[0]),Q&&ht.live){for(let D=0;D<_.length;D++)(D>0||s==1&&!le)&&T_(D,et[D]);w_()}pt=!1,E!==!1&&An("setLegend")}n.setLegend=iu;function T_(S,E){let D=_[S],F=S==0&&O==2?Qn:t[S],q;le?q=D.values(n,S,E)??ne:(q=D.value(n,E==null?null:F[E],S,E),q=q==null?ne:{_:q}),ht.values[S]=q}function Ks(S,E,D){Rf=Ge,Pf=$e,[Ge,$e]=at.move(n,Ge,$e),at.left=Ge,at.top=$e,mt&&(Rr&&Gi(Rr,yn(Ge),0,z,Rt),Pr&&Gi(Pr,0,yn($e),z,Rt));let F,q=sn>rn;ns=Oe,Es=null;let j=L.ori==0?z:Rt,lt=L.ori==1?z:Rt;if(Ge<0||je==0||q){F=at.idx=null;for(let ft=0;ft<_.length;ft++){let vt=ae[ft];vt!=null&&Gi(vt,-10,-10,z,Rt)}jt&&Oi(null,Nr,!0,S==null&&dn.setSeries),ht.live&&(et.fill(F),pt=!0)}else{let ft,vt,Dt;s==1&&(ft=L.ori==0?Ge:$e,vt=Bi(ft,T),F=at.idx=Ti(vt,t[0],sn,rn),Dt=V(t[0][F],L,j,0));let Nt=-10,Ft=-10,ie=0,we=0,Me=!0,_e="",Jt="";for(let Wt=s==2?1:0;Wt<_.length;Wt++){let He=_[Wt],tn=et[Wt],Cn=tn==null?null:s==1?t[Wt][tn]:t[Wt][1][tn],Ue=at.dataIdx(n,Wt,F,vt),en=Ue==null?null:s==1?t[Wt][Ue]:t[Wt][1][Ue];if(pt=pt||en!=Cn||Ue!=tn,et[Wt]=Ue,Wt>0&&He.show){let ti=Ue==null?-10:Ue==F?Dt:V(s==1?t[0][Ue]:t[Wt][0][Ue],L,j,0),Vn=en==null?-10:U(en,s==1?x[He.scale]:x[He.facets[1].scale],lt,0);if(jt&&en!=null){let di=L.ori==1?Ge:$e,Si=xn(Ot.dist(n,Wt,Ue,Vn,di));if(Si<ns){let ki=Ot.bias;if(ki!=0){let ei=Bi(di,He.scale),fi=en>=0?1:-1,Mi=ei>=0?1:-1;Mi==fi&&(Mi==1?ki==1?en>=ei:en<=ei:ki==1?en<=ei:en>=ei)&&(ns=Si,Es=Wt)}else ns=Si,Es=Wt}}if(pt||Ct){let di,Si;L.ori==0?(di=ti,Si=Vn):(di=Vn,Si=ti);let ki,ei,fi,Mi,zi,Hn,ni=!0,js=ut.bbox;if(js!=null){ni=!1;let Wn=js(n,Wt);fi=Wn.left,Mi=Wn.top,ki=Wn.width,ei=Wn.height}else fi=di,Mi=Si,ki=ei=ut.size(n,Wt);if(Hn=ut.fill(n,Wt),zi=ut.stroke(n,Wt),Ct)Wt==Es&&ns<=Ot.prox&&(Nt=fi,Ft=Mi,ie=ki,we=ei,Me=ni,_e=Hn,Jt=zi);else{let Wn=ae[Wt];Wn!=null&&(ze[Wt]=fi,zn[Wt]=Mi,ip(Wn,ki,ei,ni),ep(Wn,Hn,zi),Gi(Wn,mi(fi),mi(Mi),z,Rt))}}}}if(Ct){let Wt=Ot.prox,He=Js==null?ns<=Wt:ns>Wt||Es!=Js;if(pt||He){let tn=ae[0];tn!=null&&(ze[0]=Nt,zn[0]=Ft,ip(tn,ie,we,Me),ep(tn,_e,Jt),Gi(tn,mi(Nt),mi(Ft),z,Rt))}}}if(Ve.show&&ws)if(S!=null){let[ft,vt]=dn.scales,[Dt,Nt]=dn.match,[Ft,ie]=S.cursor.sync.scales,we=S.cursor.drag;if(Tn=we._x,En=we._y,Tn||En){let{left:Me,top:_e,width:Jt,height:Wt}=S.select,He=S.scales[Ft].ori,tn=S.posToVal,Cn,Ue,en,ti,Vn,di=ft!=null&&Dt(ft,Ft),Si=vt!=null&&Nt(vt,ie);di&&Tn?(He==0?(Cn=Me,Ue=Jt):(Cn=_e,Ue=Wt),en=x[ft],ti=V(tn(Cn,Ft),en,j,0),Vn=V(tn(Cn+Ue,Ft),en,j,0),zo(Ei(ti,Vn),xn(Vn-ti))):zo(0,j),Si&&En?(He==1?(Cn=Me,Ue=Jt):(Cn=_e,Ue=Wt),en=x[vt],ti=U(tn(Cn,ie),en,lt,0),Vn=U(tn(Cn+Ue,ie),en,lt,0),Go(Ei(ti,Vn),xn(Vn-ti))):Go(0,lt)}else ou()}else{let ft=xn(Rf-Af),vt=xn(Pf-Cf);if(L.ori==1){let ie=ft;ft=vt,vt=ie}Tn=Ln.x&&ft>=Ln.dist,En=Ln.y&&vt>=Ln.dist;let Dt=Ln.uni;Dt!=null?Tn&&En&&(Tn=ft>=Dt,En=vt>=Dt,!Tn&&!En&&(vt>ft?En=!0:Tn=!0)):Ln.x&&Ln.y&&(Tn||En)&&(Tn=En=!0);let Nt,Ft;Tn&&(L.ori==0?(Nt=Ir,Ft=Ge):(Nt=Lr,Ft=$e),zo(Ei(Nt,Ft),xn(Ft-Nt)),En||Go(0,lt)),En&&(L.ori==1?(Nt=Ir,Ft=Ge):(Nt=Lr,Ft=$e),Go(Ei(Nt,Ft),xn(Ft-Nt)),Tn||zo(0,j)),!Tn&&!En&&(zo(0,0),Go(0,0))}if(Ln._x=Tn,Ln._y=En,S==null){if(D){if(Hf!=null){let[ft,vt]=dn.scales;dn.values[0]=ft!=null?Bi(L.ori==0?Ge:$e,ft):null,dn.values[1]=vt!=null?Bi(L.ori==1?Ge:$e,vt):null}Ho(uu,n,Ge,$e,z,Rt,F)}if(jt){let ft=D&&dn.setSeries,vt=Ot.prox;Js==null?ns<=vt&&Oi(Es,Nr,!0,ft):ns>vt?Oi(null,Nr,!0,ft):Es!=Js&&Oi(Es,Nr,!0,ft)}}pt&&(ht.idx=F,iu()),E!==!1&&An("setCursor")}let As=null;Object.defineProperty(n,"rect",{get(){return As==null&&Vo(!1),As}});function Vo(S=!1){S?As=null:(As=p.getBoundingClientRect(),An("syncRect",As))}function Df(S,E,D,F,q,j,lt){at._lock||ws&&S!=null&&S.movementX==0&&S.movementY==0||(su(S,E,D,F,q,j,lt,!1,S!=null),S!=null?Ks(null,!0,!0):Ks(E,!0,!1))}function su(S,E,D,F,q,j,lt,ft,vt){if(As==null&&Vo(!1),Kt(S),S!=null)D=S.clientX-As.left,F=S.clientY-As.top;else{if(D<0||F<0){Ge=-10,$e=-10;return}let[Dt,Nt]=dn.scales,Ft=E.cursor.sync,[ie,we]=Ft.values,[Me,_e]=Ft.scales,[Jt,Wt]=dn.match,He=E.axes[0].side%2==1,tn=L.ori==0?z:Rt,Cn=L.ori==1?z:Rt,Ue=He?j:q,en=He?q:j,ti=He?F:D,Vn=He?D:F;if(Me!=null?D=Jt(Dt,Me)?a(ie,x[Dt],tn,0):-10:D=tn*(ti/Ue),_e!=null?F=Wt(Nt,_e)?a(we,x[Nt],Cn,0):-10:F=Cn*(Vn/en),L.ori==1){let di=D;D=F,F=di}}vt&&(E==null||E.cursor.event.type==uu)&&((D<=1||D>=z-1)&&(D=er(D,z)),(F<=1||F>=Rt-1)&&(F=er(F,Rt))),ft?(Af=D,Cf=F,[Ir,Lr]=at.move(n,D,F)):(Ge=D,$e=F)}let ru={width:0,height:0,left:0,top:0};function ou(){ol(ru,!1)}let Nf,Uf,Ff,Of;function Bf(S,E,D,F,q,j,lt){ws=!0,Tn=En=Ln._x=Ln._y=!1,su(S,E,D,F,q,j,lt,!0,!1),S!=null&&(Se(du,_u,kf,!1),Ho(Yf,n,Ir,Lr,z,Rt,null));let{left:ft,top:vt,width:Dt,height:Nt}=Ve;Nf=ft,Uf=vt,Ff=Dt,Of=Nt}function kf(S,E,D,F,q,j,lt){ws=Ln._x=Ln._y=!1,su(S,E,D,F,q,j,lt,!1,!0);let{left:ft,top:vt,width:Dt,height:Nt}=Ve,Ft=Dt>0||Nt>0,ie=Nf!=ft||Uf!=vt||Ff!=Dt||Of!=Nt;if(Ft&&ie&&ol(Ve),Ln.setScale&&Ft&&ie){let we=ft,Me=Dt,_e=vt,Jt=Nt;if(L.ori==1&&(we=vt,Me=Nt,_e=ft,Jt=Dt),Tn&&Ts(T,Bi(we,T),Bi(we+Me,T)),En)for(let Wt in x){let He=x[Wt];Wt!=T&&He.from==null&&He.min!=Oe&&Ts(Wt,Bi(_e+Jt,Wt),Bi(_e,Wt))}ou()}else at.lock&&(at._lock=!at._lock,Ks(E,!0,S!=null));S!=null&&(gn(du,_u),Ho(du,n,Ge,$e,z,Rt,null))}function E_(S,E,D,F,q,j,lt){if(at._lock)return;Kt(S);let ft=ws;if(ws){let vt=!0,Dt=!0,Nt=10,Ft,ie;L.ori==0?(Ft=Tn,ie=En):(Ft=En,ie=Tn),Ft&&ie&&(vt=Ge<=Nt||Ge>=z-Nt,Dt=$e<=Nt||$e>=Rt-Nt),Ft&&vt&&(Ge=Ge<Ir?0:z),ie&&Dt&&($e=$e<Lr?0:Rt),Ks(null,!0,!0),ws=!1}Ge=-10,$e=-10,et.fill(null),Ks(null,!0,!0),ft&&(ws=ft)}function zf(S,E,D,F,q,j,lt){at._lock||(Kt(S),ko(),ou(),S!=null&&Ho(Kf,n,Ge,$e,z,Rt,null))}function Gf(){M.forEach(wx),k(n.width,n.height,!0)}sr(pl,Br,Gf);let Ur={};Ur.mousedown=Bf,Ur.mousemove=Df,Ur.mouseup=kf,Ur.dblclick=zf,Ur.setSeries=(S,E,D,F)=>{let q=dn.match[2];D=q(n,E,D),D!=-1&&Oi(D,F,!0,!1)},mt&&(Se(Yf,p,Bf),Se(uu,p,Df),Se(Zf,p,S=>{Kt(S),Vo(!1)}),Se(Jf,p,E_),Se(Kf,p,zf),Tu.add(n),n.syncRect=Vo);let al=n.hooks=i.hooks||{};function An(S,E,D){Gn?De.push([S,E,D]):S in al&&al[S].forEach(F=>{F.call(null,n,E,D)})}(i.plugins||[]).forEach(S=>{for(let E in S.hooks)al[E]=(al[E]||[]).concat(S.hooks[E])});let Vf=(S,E,D)=>D,dn=fn({key:null,setSeries:!1,filters:{pub:lp,sub:lp},scales:[T,_[1]?_[1].scale:null],match:[cp,cp,Vf],values:[null,null]},at.sync);dn.match.length==2&&dn.match.push(Vf),at.sync=dn;let Hf=dn.key,au=rm(Hf);function Ho(S,E,D,F,q,j,lt){dn.filters.pub(S,E,D,F,q,j,lt)&&au.pub(S,E,D,F,q,j,lt)}au.sub(n);function A_(S,E,D,F,q,j,lt){dn.filters.sub(S,E,D,F,q,j,lt)&&Ur[S](null,E,D,F,q,j,lt)}n.pub=A_;function C_(){au.unsub(n),Tu.delete(n),wn.clear(),vu(pl,Br,Gf),c.remove(),At?.remove(),An("destroy")}n.destroy=C_;function lu(){An("init",i,t),Bo(t||i.data,!1),G[T]?tu(T,G[T]):ko(),st=Ve.show&&(Ve.width>0||Ve.height>0),nt=pt=!0,k(i.width,i.height)}return _.forEach(Tr),M.forEach(ji),e?e instanceof HTMLElement?(e.appendChild(c),lu()):e(n,lu):lu(),n}vn.assign=fn;vn.fmtNum=Lu;vn.rangeNum=ml;vn.rangeLog=yl;vn.rangeAsinh=Pu;vn.orient=or;vn.pxRatio=Te;vn.join=my;vn.fmtDate=Nu,vn.tzDate=Ey;vn.sync=rm;{vn.addGap=lx,vn.clipGaps=Sl;let i=vn.paths={points:um};i.linear=fm,i.stepped=ux,i.bars=dx,i.spline=px}var _m=matchMedia("(prefers-color-scheme: dark)"),Is={light:["#000"],dark:["#fff"],sources:{light:[],dark:[]},alarm:{light:"#000",dark:"#fff"}},Tl=new Map,ym=!1,xm=new Set;function vm(i){Is=i}function El(i){Tl.clear();for(let t of i)Tl.set(t.sysid,{index:t.colour,role:t.role})}function Al(i){xm.add(i)}var Gu=()=>xm.forEach(i=>i());_m.addEventListener("change",Gu);function Vu(i){ym=i,Gu()}function Tx(){let i=document.documentElement.dataset.theme;return i==="light"||i==="dark"?i:"auto"}function ar(){let i=Ko()?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem("skytender-theme",i)}catch{}Gu()}function Sm(){try{let i=localStorage.getItem("skytender-theme");(i==="light"||i==="dark")&&(document.documentElement.dataset.theme=i)}catch{}}function Ko(){if(ym)return!1;let i=Tx();return i==="auto"?_m.matches:i==="dark"}function he(){return Ko()?{dark:!0,ink:"#e6e9ed",soft:"#a3adb8",grid:"#2b323a",paper:"#12161b",faint:"#1d232a",solid:"#7d8894",band:"rgba(86,180,233,.25)",crowd:"rgba(163,173,184,.35)",bad:"#ff9d7a",warn:"#f0c860",good:"#5fd3ac"}:{dark:!1,ink:"#1b1f24",soft:"#57606a",grid:"#dfe4e9",paper:"#ffffff",faint:"#f3f5f7",solid:"#6b7682",band:"rgba(0,114,178,.18)",crowd:"rgba(87,96,106,.3)",bad:"#a52a00",warn:"#7a5200",good:"#00664b"}}function pn(i){let t=Tl.get(i);if(t?.role==="target")return he().ink;let e=Ko()?Is.dark:Is.light;return e[(t?.index??i-1)%e.length]}var Cl=()=>Ko()?Is.alarm.dark:Is.alarm.light;function Rl(i){let t=Tl.get(i);if(t?.role==="target")return[2,3];if(t?.role==="tanker")return[8,3];let e=Is.light.length;return[[],[6,4],[2,3],[6,3,2,3]][Math.floor((t?.index??i-1)/e)%4]}function Pl(i){let t=Ko()?Is.sources.dark:Is.sources.light;return t[i%t.length]}var Ex=165,Ax=52,Mm=9,Tm=[.1,.2,.5,1,2,5,10,20,50,100,200,500,1e3,2e3,5e3,1e4,2e4,5e4],Il=class{constructor(){this.zoom=null,this.now_s=0,this.end_s=1,this.begin_s=0,this.charts=new Set,this.seek=()=>{},this.point=()=>{}}get range(){return this.zoom??[this.begin_s,Math.max(this.end_s,this.begin_s+.001)]}setZoom(t){this.zoom=t;let[e,n]=this.range;for(let s of this.charts)for(let r of s.plots)r.setScale("x",{min:e,max:n})}setNow(t){if(this.now_s!==t){this.now_s=t;for(let e of this.charts)e.showNow()}}};function bm(i,t){let[e,n]=i.range,[s,r]=[i.begin_s,Math.max(i.end_s,i.begin_s+.001)],o=Math.max(t*(n-e),Tm[0]);if(o>=r-s)return i.setZoom(null);let a=i.now_s>=e&&i.now_s<=n?i.now_s:(e+n)/2,l=Math.min(Math.max(a-o/2,s),r-o);i.setZoom([l,l+o])}function Cx(i){return Array.from(i,t=>Number.isNaN(t)?null:t)}var qr=class{constructor(t,e,n){this.div=t,this.time=e,this.label=n,this.plots=[],this.key="",this.ranges=[],this.figure=null,this.nows=[],e.charts.add(this),t.tabIndex=0,t.setAttribute("aria-keyshortcuts","+ - 0"),t.addEventListener("keydown",s=>{if(s.key==="+")bm(e,.5);else if(s.key==="-")bm(e,2);else if(s.key==="0")e.setZoom(null);else return;s.preventDefault(),s.stopPropagation()})}draw(t,e,n=this.div.clientWidth){if(n<=0)return;this.figure=t;let s=t.panels.map(o=>this.#t(o,e)),r=JSON.stringify([n,he().dark,he().paper,s.map(o=>o.series.map(a=>[a.label,a.stroke,a.dash]))]);this.ranges=s.map(o=>o.range),r!==this.key&&this.#e(s,r,n),this.plots.forEach((o,a)=>{o.setData(s[a].data,!1);let[l,c]=this.time.range;o.setScale("x",{min:l,max:c})}),this.div.dataset.lines=String(s.reduce((o,a)=>o+a.series.length-1,0)),this.showNow()}#t(t,e){let{soft:n}=he(),s=[{}],r=[],o=(d,f)=>{s.push({spanGaps:!1,points:{show:!1},width:1.6,...f}),r.push([Array.from(d.x),Cx(d.y)])};t.band&&(o(t.band.least,{label:"least",stroke:"transparent"}),o(t.band.greatest,{label:"greatest",stroke:"transparent"}),o(t.band.median,{label:`median of ${t.band.count}`,stroke:n,dash:[2,3]}));for(let d of t.ghosts??[])e.has(d.id??-1)&&o(d,{label:`(${this.label(d.id??-1)})`,stroke:n,width:1,dash:[5,3]});for(let d of t.lines){let f=d.id;e.has(f)&&o(d,{label:this.label(f),stroke:pn(f),dash:Rl(f)})}t.own.forEach((d,f)=>o(d,{label:d.label,stroke:Pl(f)}));let a=r.length?vn.join(r):[[this.time.begin_s,this.time.end_s]],[l,c]=[1/0,-1/0];for(let[,d]of r)for(let f of d)f!==null&&(f<l&&(l=f),f>c&&(c=f));for(let d of t.limits)l=Math.min(l,d.y),c=Math.max(c,d.y);t.zero&&(l=Math.min(l,0)),l>c&&([l,c]=[0,1]);let h=Math.max((c-l)*.06,10**-t.digits),u=t.range?{min:t.range[0],max:t.range[1]}:{min:t.zero&&l>=0?0:l-h,max:c+h};return{panel:t,series:s,data:a,range:u}}#e(t,e,n){this.key=e,this.close(),this.div.replaceChildren();let{soft:s,grid:r,band:o}=he();t.forEach(({panel:a,series:l},c)=>{let h=N("div",{class:"now"}),u=N("div",{class:"tip",hidden:!0}),d=N("p",{class:"panel-title"},a.title,a.unit?` (${a.unit})`:""),f=N("div",{class:"panel"});this.div.append(d,f);let p=c===t.length-1,y="11px system-ui, sans-serif",m=new vn({width:n,height:Ex+(p?18:0),series:l,legend:{show:!1},padding:[6,10,0,0],scales:{x:{time:!1,range:(g,_,M)=>[_,M]},y:{range:()=>[this.ranges[c].min,this.ranges[c].max]}},axes:[{stroke:s,font:y,grid:{stroke:r,width:1},ticks:{show:!1},incrs:Tm,size:22,label:p?"session time (s)":void 0,labelFont:y,labelSize:18,labelGap:0},{stroke:s,font:y,grid:{stroke:r,width:1},ticks:{show:!1},size:Ax,space:28}],bands:a.band?[{series:[2,1],fill:o}]:[],cursor:{sync:{key:"skytender",setSeries:!1},y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!1},bind:{dblclick:()=>()=>(this.time.setZoom(null),null)}},hooks:{drawClear:[g=>this.#i(g)],draw:[g=>this.#s(g,a)],setSelect:[g=>{g.select.width<8||(this.time.setZoom([g.posToVal(g.select.left,"x"),g.posToVal(g.select.left+g.select.width,"x")]),g.setSelect({left:0,top:0,width:0,height:0},!1))}],setCursor:[g=>this.#n(g,a,u)]}},l.map(()=>[]),f);m.over.append(h,u),m.over.addEventListener("click",()=>{m.select.width<8&&m.cursor.left!==void 0&&m.cursor.left>=0&&this.time.seek(m.posToVal(m.cursor.left,"x"))}),this.plots.push(m),this.nows.push(h)})}#i(t){let{ctx:e}=t,{left:n,top:s,width:r,height:o}=t.bbox;e.save(),e.beginPath(),e.rect(n,s,r,o),e.clip(),e.globalAlpha=.13;for(let a of this.figure?.spans??[]){let[l,c]=[t.valToPos(a.from,"x",!0),t.valToPos(a.to,"x",!0)];e.fillStyle=pn(a.id),e.fillRect(l,s,c-l,o)}e.restore()}#s(t,e){let{ctx:n}=t,{left:s,top:r,width:o,height:a}=t.bbox,{ink:l,soft:c,bad:h,paper:u}=he(),d=vn.pxRatio;n.save(),n.beginPath(),n.rect(s,r,o,a),n.clip(),n.font=`${11*d}px system-ui, sans-serif`,n.lineWidth=d;let f=(y,m,g,_)=>{n.lineWidth=3*d,n.strokeStyle=u,n.strokeText(y,m,g),n.fillStyle=_,n.fillText(y,m,g),n.lineWidth=d};for(let y of e.limits){let m=t.valToPos(y.y,"y",!0);n.setLineDash([6*d,4*d]),n.strokeStyle=l,n.beginPath(),n.moveTo(s,m),n.lineTo(s+o,m),n.stroke(),n.setLineDash([]),n.textAlign="right",f(y.label,s+o-4*d,m<r+14*d?m+13*d:m-4*d,c)}n.textAlign="left";let p=-1/0;for(let y of this.figure?.marks??[]){let m=t.valToPos(y.t_s,"x",!0);n.setLineDash([2*d,3*d]),n.strokeStyle=y.bad?h:c,n.beginPath(),n.moveTo(m,r),n.lineTo(m,r+a),n.stroke(),n.setLineDash([]),!(m-p<34*d)&&(p=m,f(y.label,m+3*d,r+12*d,y.bad?h:y.id!==void 0?pn(y.id):c))}n.restore()}#n(t,e,n){let{left:s,idx:r}=t.cursor,o=t.over.matches(":hover");if(o&&this.time.point(s===void 0||s<0?null:t.posToVal(s,"x")),s===void 0||s<0||r===null||r===void 0||!o)return void(n.hidden=!0);let a=t.posToVal(s,"x"),l=[];for(let u=1;u<t.series.length;u+=1){if(t.series[u].stroke==="transparent")continue;let d=t.data[u],f=r;for(;f>0&&d[f]===void 0;)f-=1;let p=d[f];if(p==null)continue;let y=N("i",{class:"swatch"}),m=t.series[u].stroke;y.style.background=String(typeof m=="function"?m(t,u):m),l.push({value:p,row:N("div",{},y,`${t.series[u].label}: ${oe(p,e.digits)} ${e.unit}`)})}let c=l.length-Mm;n.replaceChildren(N("b",{},`${a.toFixed(1)} s`),...l.slice(0,Mm).map(u=>u.row),c>0?`and ${c} more`:"");for(let u of this.figure?.marks??[])Math.abs(t.valToPos(u.t_s,"x")-s)<5&&n.append(N("div",{},u.text??`${u.id===void 0?u.label:`${this.label(u.id)} is next`}, ${u.t_s.toFixed(1)} s`));n.hidden=!1;let h=s>t.over.clientWidth/2;n.style.left=h?"":`${s+12}px`,n.style.right=h?`${t.over.clientWidth-s+12}px`:""}showNow(){this.plots.forEach((t,e)=>{let n=t.valToPos(this.time.now_s,"x"),s=Number.isFinite(n)&&n>=0&&n<=t.over.clientWidth;this.nows[e].hidden=!s,s&&(this.nows[e].style.transform=`translateX(${n}px)`)})}close(){for(let t of this.plots)t.destroy();this.plots=[],this.nows=[]}},wm=["on the way","in formation","transfer"];function Em(i,t,e){let[n,s]=[e.begin_s,Math.max(e.end_s,e.begin_s+.001)],r=c=>`${(100*(c-n)/(s-n)).toFixed(2)}%`,o=t.rows.map(c=>{let h=N("div",{class:"track"});for(let u of t.bars.filter(d=>d.row===c)){let d=`${wm[u.stage]} ${u.from.toFixed(1)} to ${u.to.toFixed(1)} s, ${u.text}`,f=N("button",{type:"button",class:`bar stage${u.stage}`,title:d,"aria-label":`${c}: ${d}`,onclick:()=>e.seek(u.from)});f.style.left=r(u.from),f.style.width=`max(3px, ${r(n+u.to-u.from)})`,h.append(f)}return N("div",{class:"row"},N("span",{class:"row-name"},c),h)}),a=N("p",{class:"small soft key"},...wm.map((c,h)=>N("span",{},N("i",{class:`swatch stage${h}`}),c))),l=N("div",{class:"row"},N("span",{class:"row-name"},"session time (s)"),N("div",{class:"ends"},N("span",{},n.toFixed(0)),N("span",{},s.toFixed(0))));i.replaceChildren(a,...o,l),i.classList.add("bars"),i.dataset.lines=String(t.bars.length)}function Am(i,t,e,n){let s=[["initial","initial_j",0],["received","received_j",0],["drawn","drawn_j",1],["given","given_j",1],["remaining","remaining_j",1]],r=t.rows.filter(h=>e.has(h.id)),o=Math.max(...r.map(h=>h.initial_j+h.received_j),1),a=r.flatMap(h=>[0,1].map(u=>{let d=N("div",{class:"track stack"});return s.forEach(([f,p,y],m)=>{let g=h[String(p)];if(y!==u||!(g>0))return;let _=`${f} ${(g/1e3).toFixed(1)} kJ`,M=N("span",{class:"bar",title:_,role:"img","aria-label":_});M.style.width=`${(100*g/o).toFixed(2)}%`,M.style.background=Pl(m),d.append(M)}),N("div",{class:"row"},N("span",{class:"row-name"},u?"went":`${n(h.id)}: came`),d)})),l=s.map(([h],u)=>{let d=N("i",{class:"swatch"});return d.style.background=Pl(u),N("span",{},d,String(h))}),c=N("div",{class:"row"},N("span",{class:"row-name"},"energy (kJ)"),N("div",{class:"ends"},N("span",{},"0"),N("span",{},(o/1e3).toFixed(0))));i.replaceChildren(N("p",{class:"small soft key"},...l),...a,c),i.classList.add("bars"),i.dataset.lines=String(i.querySelectorAll(".bar").length)}var rs=["n","e","d","heading","roll","pitch","speed","height","battery","power","target","v","lost","age"],Rx=new Set(["heading","roll","pitch"]),Px=2,Ix=4e3,Lx=6e6,Dx=.09,Cm=6e3,Nx=600;function Ux(i){let[t,e,n]=i.p_ned??[NaN,NaN,NaN],s=i.battery===null?NaN:100*i.battery;return[t,e,n,i.heading_rad??NaN,i.roll_rad??NaN,i.pitch_rad??NaN,i.speed_m_s??NaN,i.height_m??NaN,s,i.power_w??NaN,i.target_m??NaN,i.v??NaN,i.lost,i.age_s??NaN]}var jo=class{constructor(){this.t_s=[],this.rows=[],this.last=""}take(t,e){let{mode:n,mode_name:s,stage:r,state:o,alive:a,armed:l,landed:c,note:h,trouble:u,severity:d,condition:f,figure:p,urgency:y,autopilot:m}=e,g={mode:n,mode_name:s,stage:r,state:o,alive:a,armed:l,landed:c,note:h,trouble:u,severity:d,condition:f,figure:p,urgency:y,autopilot:m},_=JSON.stringify(g);_!==this.last&&(this.t_s.length&&t<=this.t_s[this.t_s.length-1]||(this.last=_,this.t_s.push(t),this.rows.push(g)))}at(t){let e=Fn(this.t_s,t);return this.rows[Math.max(e,0)]??{}}};function Fn(i,t,e=i.length){let n=0,s=e;for(;n<s;){let r=n+s>>1;i[r]<=t?n=r+1:s=r}return n-1}var Ls=(i,t)=>Number.isNaN(i.n[t])||i.age[t]>Px,$r=class i{session=null;worlds=[];newest=null;events=[];count=0;capacity=256;spacing_s=Dx;t_s=new Float64Array(this.capacity);share=new Float32Array(this.capacity);columns=new Map;words=new Map;traffic=new Map;ghosts=[];version=0;clear(){Object.assign(this,new i,{version:this.version+1})}get first_s(){return this.count?this.t_s[0]:0}get last_s(){return this.count?this.t_s[this.count-1]:0}begin(t){if(this.session=t,t.source==="replay")return;let e=this.worlds.length?this.newest?.t_s??0:-1/0;for(;this.worlds.length&&this.worlds[this.worlds.length-1].t_s>=e;)this.worlds.pop();this.worlds.push({t_s:e,session:t}),this.worlds.length>Nx&&(this.worlds=this.worlds.filter((n,s)=>s%2===0))}sessionAt(t){let e=Fn(this.worlds.map(n=>n.t_s),t);return this.worlds[Math.max(e,0)]?.session??this.session}tell(t){t.length&&(this.events.push(...t),this.events.length>Cm&&this.events.splice(0,this.events.length-Cm))}take(t){this.newest=t;let e=t.t_s;for(let r of t.vehicles){let o=this.words.get(r.sysid);o||this.words.set(r.sysid,o=new jo),o.take(e,r)}let n=Fn(this.t_s,e,this.count),s=r=>r>=0&&r<this.count&&Math.abs(this.t_s[r]-e)<this.spacing_s;s(n)||s(n+1)||(this.#s(),this.#t(n+1,t),this.version+=1)}#t(t,e){let n=t<this.count,s=(a,l)=>{n&&a.copyWithin(t+1,t,this.count),a[t]=l};s(this.t_s,e.t_s),s(this.share,e.competition.share??NaN);let r=new Set;for(let a of e.vehicles){r.add(a.sysid);let l=this.#e(a.sysid);Ux(a).forEach((c,h)=>s(l[rs[h]],c))}for(let[a,l]of this.columns)if(!r.has(a))for(let c of rs)s(l[c],NaN);let o=new Set;for(let a of e.traffic){o.add(a.callsign);let l=this.#i(a.callsign);a.p_ned.forEach((c,h)=>s(l[h],c))}for(let[a,l]of this.traffic)if(!o.has(a))for(let c of l)s(c,NaN);this.count+=1}#e(t){let e=this.columns.get(t);if(!e){e={};for(let n of rs)e[n]=new Float32Array(this.capacity).fill(NaN);this.columns.set(t,e)}return e}#i(t){let e=this.traffic.get(t);return e||(e=[0,1,2].map(()=>new Float32Array(this.capacity).fill(NaN)),this.traffic.set(t,e)),e}#s(){if(this.count<this.capacity)return;let t=Math.min(Ix,Math.max(256,Lx/(rs.length*Math.max(this.columns.size,1))));if(2*this.capacity<=t){this.capacity*=2,this.#n(n=>{let s=new n.constructor(this.capacity).fill(NaN);return s.set(n),s});return}let e=this.count>>1;this.#n(n=>{for(let s=0;s<e;s+=1)n[s]=n[2*s];return n}),this.count=e,this.spacing_s=Math.max(2*this.spacing_s,.9*(this.last_s-this.first_s)/Math.max(e,1))}#n(t){this.t_s=t(this.t_s),this.share=t(this.share);for(let e of this.columns.values())for(let n of rs)e[n]=t(e[n]);for(let e of this.traffic.values())e.forEach((n,s)=>e[s]=t(n))}at(t){let e=this.newest;if(!e||!this.count)return e;let n=Math.max(Fn(this.t_s,t,this.count),0),s=Math.min(n+1,this.count-1),r=this.t_s[s]-this.t_s[n],o=r>0?Math.min(Math.max((t-this.t_s[n])/r,0),1):0,a=(_,M=!1)=>{let x=_[n],C=_[s];return Number.isNaN(C)||Number.isNaN(x)?o<.5?x:C:(M&&(C=x+Math.atan2(Math.sin(C-x),Math.cos(C-x))),x+o*(C-x))},l=_=>Number.isNaN(_)?null:_,c=new Map((this.session?.vehicles??[]).map(_=>[_.sysid,_])),h=[];for(let[_,M]of this.columns){let x=c.get(_),C={};for(let b of rs)C[b]=l(a(M[b],Rx.has(b)));let T=x?.capacity_j??null,v=C.battery===null?null:C.battery/100;h.push({sysid:_,role:x?.role??"",label:x?.label??String(_),autopilot:null,alive:!0,stage:"",mode:"",mode_name:"",armed:!0,landed:!1,state:"",note:"",trouble:[],severity:0,condition:"",figure:"",urgency:0,...this.words.get(_)?.at(t),p_ned:C.n===null?null:[C.n,C.e,C.d],v_ned:null,speed_m_s:C.speed,height_m:C.height,heading_rad:C.heading,roll_rad:C.roll,pitch_rad:C.pitch,aim_ned:null,margin_m:null,age_s:C.age,heard_s:null,lost:C.lost??0,lost_share:null,target_m:C.target,battery:v,remaining_j:v!==null&&T!==null?v*T:null,power_w:C.power,endurance_s:null,energy_source:"",v:C.v,tau:null})}h.sort((_,M)=>_.sysid-M.sysid);let{services:u,history:d,refuelled:f}=this.#r(t);for(let _ of h){if(_.state)continue;let M=u.find(x=>x.receiver===_.sysid||x.tanker===_.sysid);_.state=M?M.tanker===_.sysid?"serves":M.phase==="transfer"?"served":"waits":""}let p=[];for(let[_,M]of this.traffic){let x=M.map(C=>a(C));x.some(Number.isNaN)||p.push({callsign:_,p_ned:x,v_ned:[0,0,0],age_s:0})}let y=Object.fromEntries(h.filter(_=>_.v!==null).map(_=>[_.sysid,_.v])),m=l(this.share[n]),g=Object.keys(y).sort((_,M)=>Number(y[M])-Number(y[_]));return{...e,t_s:t,vehicles:h,traffic:p,events:[],inspected:{},competition:{...e.competition,v:y,tau:{},share:m,leader:m===null||!g.length?null:Number(g[0]),runner_up:g.length>1?Number(g[1]):null},services:u,history:d,refuelled:f,goal:{...e.goal,pursue_held_s:null,broken:e.goal.broken.filter(_=>_.t_s===null||_.t_s<=t)}}}#r(t){let e=this.newest,n=e.history.filter(a=>a.end_s!==null&&a.end_s<=t),s=e.history.filter(a=>a.decided_at_s<=t&&(a.end_s===null||a.end_s>t)),r=e.services.filter(a=>a.decided_at_s<=t);return{services:[...s.map(a=>({receiver:a.receiver,tanker:a.tanker,base:a.base,by:a.by,energy_j:0,decided_at_s:a.decided_at_s,phase:a.start_s!==null&&a.start_s<=t?"transfer":"join",joined_at_s:a.joined_at_s!==null&&a.joined_at_s<=t?a.joined_at_s:null,rendezvous_ned:null,bids:{},why:""})),...r],history:n,refuelled:n.filter(a=>a.energy_j>0).length}}};var Hu={dead:"✕",silent:"⌀",failing:"▲",low:"◔",warned:"△",landed:"▼"},Pm=i=>Hu[i.condition||(i.landed?"landed":"")]??"",Vi=i=>i.alive?i.mode_name:"DEAD",Fx=3,Ll=2*Math.PI;function Rm(i,t,e,n,s){i.beginPath(),i.moveTo(t,e-.8*s*n),i.lineTo(t+n,e+.8*s*n),i.lineTo(t-n,e+.8*s*n),i.closePath()}function Dl(i,t,e,n,s){let{ink:r,paper:o,soft:a}=he(),[l,c]=[1.5*s,Math.max(.35*s,2)];i.setLineDash([]);let h=(d,f)=>{for(let[p,y]of[[o,f+Fx],[d,f]])i.strokeStyle=p,i.lineWidth=y,i.stroke()},u=(d,f)=>{h(f,.75*c),i.fillStyle=d,i.fill()};if(t.condition==="dead"||t.condition==="silent"){let d=.75*l;i.beginPath(),t.condition==="silent"?i.arc(e,n,l,0,Ll):(i.moveTo(e-d,n-d),i.lineTo(e+d,n+d)),i.moveTo(e-d,n+d),i.lineTo(e+d,n-d),h(Cl(),c)}else if(t.condition==="failing"||t.condition==="warned"){let d=t.condition==="failing";Rm(i,e,n-2.3*s,(d?1.3:.9)*s,1),u(d?Cl():o,d?Cl():r)}else t.condition==="low"&&(i.beginPath(),i.arc(e,n,1.1*l,0,Ll),h(a,1),i.beginPath(),i.arc(e,n,1.1*l,-Ll/4,Ll*(Math.min(Math.max(t.battery??0,.02),1)-.25)),h(r,1.3*c));t.landed&&t.condition!=="dead"&&(Rm(i,e,n+2.2*s,.9*s,-1),u(r,r))}function Ox(i){return[i.label,i.trouble.join(", "),Vi(i),i.battery===null?"":`battery ${oe(100*i.battery,0)} %`,i.height_m===null?"":`${oe(i.height_m,1)} m high`,i.speed_m_s===null?"":`${oe(i.speed_m_s,1)} m/s`].filter(Boolean).join(" · ")}var Nl=class{constructor(t,e){this.shown=e,this.element=N("div",{class:"hover small","aria-hidden":"true"}),this.element.hidden=!0,this.at=null,t.append(this.element),t.addEventListener("pointermove",n=>{let{left:s,top:r}=t.getBoundingClientRect();this.at=n.buttons||n.pointerType==="touch"?null:[n.clientX-s,n.clientY-r],this.show()}),t.addEventListener("pointerleave",()=>{this.at=null,this.show()})}show(){let{at:t}=this,{places:e,rows:n}=t?this.shown():{places:[],rows:[]},s=t&&tr(e,t[0],t[1]),r=n.find(l=>l.sysid===s);this.element.hidden!==!r&&(this.element.hidden=!r);let o=e.find(l=>l.sysid===s);if(!r||!o)return;me(this.element,Ox(r));let a=o.x>(this.element.parentElement?.clientWidth??0)/2;this.element.style.transform=`translate(${o.x+(a?-14:14)}px, ${o.y+10}px) translateX(${a?"-100%":"0"})`}};function Ul(i,t,e,n){i.save(),i.fillStyle=he().ink,i.translate(t,e),i.rotate(n),i.beginPath(),[[0,-14],[5,0],[0,-4],[-5,0]].forEach(([s,r],o)=>i[o?"lineTo":"moveTo"](s,r)),i.fill(),i.textAlign="center",i.textBaseline="middle",i.font="700 13px system-ui, sans-serif",i.translate(0,10),i.rotate(-n),i.fillText("N",0,0),i.restore()}var Fl=null;function Bx(){if(Fl!==null)return Fl;let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info"),e=i&&t?String(i.getParameter(t.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),Fl=!i||/swiftshader|llvmpipe|softpipe|software/i.test(e),Fl}function lr(i){return i.getContext("2d",{willReadFrequently:Bx()})}var Yr=i=>i/16*Number.parseFloat(getComputedStyle(document.documentElement).fontSize);var kx=1e5,zx=300,Zr=i=>i?.plans??[];function Im(i){return Zr(i).flatMap(e=>[...e.items.flatMap(n=>n.p_ned?[n.p_ned]:[]),...e.rally_ned,...e.home_ned?[e.home_ned]:[],...e.fence.flatMap(n=>n.outline_ne)]).filter(([e,n])=>Math.hypot(e,n)<kx).map(([e,n])=>[e,n])}var Qo=i=>i.sysid===null?he().ink:pn(i.sysid),Lm=i=>i.items.filter(t=>t.flown&&t.p_ned);function Dm(i){return Zr(i).flatMap(t=>{let e=Lm(t).map(n=>n.p_ned);return[{points:t.home_ned&&e.length?[t.home_ned,...e]:e,colour:Qo(t)},...t.fence.map(n=>({points:n.outline_ne.map(([s,r])=>[s,r,0]),colour:n.inside?he().good:he().bad})),...t.rally_ned.map(([n,s,r])=>({points:[[n,s,0],[n,s,r]],colour:he().good}))]})}function Nm(i,t,e,n,s){let{good:r,bad:o,paper:a,ink:l}=he();i.save(),i.font="600 10px system-ui, sans-serif",i.textAlign="center",i.textBaseline="middle";for(let c of Zr(t)){for(let p of c.fence)i.strokeStyle=i.fillStyle=p.inside?r:o,i.lineWidth=1.8,i.setLineDash([10,4]),i.beginPath(),p.outline_ne.forEach(([y,m],g)=>i[g?"lineTo":"moveTo"](n(m),s(y))),i.globalAlpha=p.inside?.04:.1,i.fill(),i.globalAlpha=.9,i.stroke();i.globalAlpha=1,i.strokeStyle=Qo(c),i.lineWidth=1.6,i.setLineDash([8,5]),i.beginPath();let h=Lm(c),[u]=h;c.home_ned&&u&&i.moveTo(n(c.home_ned[1]),s(c.home_ned[0])),h.forEach(({p_ned:[p,y]},m)=>i[m||c.home_ned?"lineTo":"moveTo"](n(y),s(p))),i.stroke(),i.setLineDash([]);let d=Um(c,e);for(let p of c.items.slice(0,zx)){if(!p.p_ned)continue;let[y,m]=[n(p.p_ned[1]),s(p.p_ned[0])];i.beginPath(),p.flown?i.arc(y,m,8,0,2*Math.PI):i.rect(y-7,m-7,14,14),i.fillStyle=p.number===d?Qo(c):a,i.fill(),i.stroke(),i.fillStyle=p.number===d?a:l,i.fillText(String(p.number),y,m)}let f=c.rally_ned.map(p=>["R",p,r]);c.home_ned&&f.push(["H",c.home_ned,Qo(c)]);for(let[p,[y,m],g]of f)i.beginPath(),[[0,-10],[10,0],[0,10],[-10,0]].forEach(([_,M],x)=>i[x?"lineTo":"moveTo"](n(m)+_,s(y)+M)),i.closePath(),i.fillStyle=a,i.fill(),i.strokeStyle=i.fillStyle=g,i.stroke(),i.fillText(p,n(m),s(y)),i.strokeStyle=Qo(c)}i.restore()}var Um=(i,t)=>i.sysid===null?void 0:t.vehicles.find(e=>e.sysid===i.sysid)?.mission_item,Wu=(i,t,e)=>i?[`${i} ${i===1?t:e}`]:[];function Fm(i,t,e){let n=Zr(t),s=n.map(a=>Um(a,e)),r=JSON.stringify([n,s]);if(i.dataset.key===r)return;i.dataset.key=r;let o=new Set([...i.querySelectorAll("details[open]")].map(a=>a.getAttribute("data-source")));i.replaceChildren(...n.map((a,l)=>{let c=[...Wu(a.items.length,"item","items"),...Wu(a.fence.length,"fence area","fence areas"),...Wu(a.rally_ned.length,"rally point","rally points")],h=a.items.map(p=>N("tr",{class:p.number===s[l]?"chosen":"","aria-current":p.number===s[l]?"step":null},...[String(p.number),p.command,p.height_m===null?"":`${oe(p.height_m,1)} m`,p.above===null?"":`above ${p.above}`,p.p_ned?`${oe(p.p_ned[0],1)}, ${oe(p.p_ned[1],1)}`:"",p.about].map((y,m)=>N("td",{class:[1,3,5].includes(m)?"word":""},y)))),u=["","command","height","","north, east m","parameters"].map((p,y)=>N(p?"th":"td",{scope:p?"col":null,class:[1,3,5].includes(y)?"word":""},p)),d=h.length?[N("div",{class:"scroll",tabindex:0,role:"region","aria-label":`mission of ${a.source}`},N("table",{},N("thead",{},N("tr",{},...u)),N("tbody",{},...h)))]:[],f=N("details",{"data-source":a.source},N("summary",{},N("b",{},a.source),`: ${c.join(", ")||"nothing"}`),...d,...a.left_out.map(p=>N("p",{class:"warn small"},p)));return f.open=i.childElementCount?o.has(a.source):n.length===1,f}))}var Gx=.08,Xu=40,Vx=50,Hx=[1,2,5];function Ol(i){let t=10**Math.floor(Math.log10(i));return t*Math.max(...Hx.filter(e=>e*t<=i*1.0001),1)}var Om=new WeakMap;function Kr(i){let t=Om.get(i);if(t&&t.version===i.version&&t.session===i.session)return t.found;let e=Wx(i);return Om.set(i,{version:i.version,session:i.session,found:e}),e}function Wx(i){let[t,e,n,s,r]=[1/0,-1/0,1/0,-1/0,0],o=(l,c,h=0)=>{Number.isNaN(l)||(r=Math.max(r,-h),t=Math.min(t,l),e=Math.max(e,l),n=Math.min(n,c),s=Math.max(s,c))};for(let l of[i,...i.ghosts]){let c=Math.max(Math.floor(l.count/100),1);for(let h of l.columns.values()){for(let u=0;u<l.count;u+=c)o(h.n[u],h.e[u],h.d[u]);l.count&&o(h.n[l.count-1],h.e[l.count-1],h.d[l.count-1])}}let a=i.worlds.length?i.worlds.map(l=>l.session):[i.session];for(let l of a.flatMap(c=>c?.obstacles??[])){o(l.centre_ned[0],l.centre_ned[1]);for(let[c,h]of l.outline_ne)o(c,h)}for(let l of i.session?.bases??[])o(l.p_ned[0],l.p_ned[1]);for(let l of a.flatMap(c=>c?.vehicles??[]))for(let[c,h]of l.path_ned)o(c,h);for(let[l,c]of Im(i.session))o(l,c);return t>e?null:[[t,e],[n,s],[0,r]]}var Jr=class{constructor(t,e,n=!1){this.canvas=t,this.still=n,this.view=null,this.follow=!1,this.places=[],this.dirty=!0,this.tiles=null;let s=new Map,r=0;t.addEventListener("pointerdown",a=>{t.setPointerCapture(a.pointerId),s.set(a.pointerId,{x:a.offsetX,y:a.offsetY}),r=0}),t.addEventListener("pointermove",a=>{let l=s.get(a.pointerId);if(!l)return;let c={x:a.offsetX,y:a.offsetY},h=[...s].find(([u])=>u!==a.pointerId)?.[1];if(h){let u=d=>Math.hypot(d.x-h.x,d.y-h.y);this.zoom(u(l)/Math.max(u(c),1),(c.x+h.x)/2,(c.y+h.y)/2)}else this.pan(c.x-l.x,c.y-l.y);r+=Math.hypot(c.x-l.x,c.y-l.y),s.set(a.pointerId,c)});let o=a=>{s.delete(a.pointerId),!(a.type!=="pointerup"||r>4)&&e(tr(this.places,a.offsetX,a.offsetY),a)};t.addEventListener("pointerup",o),t.addEventListener("pointercancel",o),t.addEventListener("wheel",a=>{a.preventDefault(),this.zoom(Math.exp(a.deltaY*.0015),a.offsetX,a.offsetY)},{passive:!1}),t.addEventListener("keydown",a=>{let l={ArrowLeft:[40,0],ArrowRight:[-40,0],ArrowUp:[0,40],ArrowDown:[0,-40]}[a.key];if(l)this.pan(l[0],l[1]);else if(a.key==="+"||a.key==="-")this.zoom(a.key==="+"?.8:1.25);else if(a.key==="0")this.whole();else return;a.preventDefault(),a.stopPropagation()})}whole(){this.view=null,this.follow=!1,this.dirty=!0}pan(t,e){this.frame&&(this.view??={n:this.frame.n,e:this.frame.e,m:this.frame.m},this.follow=!1,this.view.e-=t/this.frame.perMetre,this.view.n+=e/this.frame.perMetre,this.dirty=!0)}zoom(t,e,n){let s=this.frame;if(!s)return;this.view??={n:s.n,e:s.e,m:s.m};let r=Math.min(Math.max(this.view.m*t,1),1e6),o=1-r/this.view.m;e!==void 0&&n!==void 0&&(this.view.e+=o*(e-s.width/2)/s.perMetre,this.view.n-=o*(n-s.height/2)/s.perMetre),this.view.m=r,this.dirty=!0}draw(t,e,{chosen:n,selected:s,paths:r,until_s:o,trail_s:a,shown:l=null,ghosts:c=[]}){let{width:h,height:u,scale:d}=ll(this.canvas),f=lr(this.canvas),p=he();f.setTransform(d,0,0,d,0,0),f.fillStyle=p.paper,f.fillRect(0,0,h,u);let y=Kr(t);if(!y)return;let m=this.follow&&n!==null?e.vehicles.find(G=>G.sysid===n)?.p_ned:null,[[g,_],[M,x]]=y,C=Math.max((_-g)/u,(x-M)/h,2/Math.min(h,u))*(1+2*Gx),T={n:(g+_)/2,e:(M+x)/2,m:C*Math.min(h,u)},v=this.view??T;m&&(this.view={n:m[0],e:m[1],m:Math.min(v.m,Math.max(T.m/3,12))},this.view.m<v.m&&v!==T&&(this.view.m=v.m));let{n:b,e:R,m:P}=this.view??T,L=Math.min(h,u)/P;this.frame={n:b,e:R,m:P,perMetre:L,width:h,height:u};let O=G=>h/2+(G-R)*L,V=G=>u/2-(G-b)*L,U=t.session?.origin;this.tiles&&U&&this.tiles.draw(f,U,this.frame,O,V,p),this.#e(f,O,V,L,h,u),this.#i(f,t.sessionAt(e.t_s),O,V,L),Nm(f,t.session,e,O,V),r&&this.#s(f,t,O,V,o,a,n,l),this.#r(f,t,e,O,V);for(let G of c)this.#l(f,G,O,V,o,r);this.#a(f,t,e,O,V,L,n,s),this.#c(f,L,h,u),this.#t(f,t,h)}#t(t,e,n){let s=e.session?.wind;if(!s)return;let{ink:r}=he(),[o,a]=[n-20,64];t.save(),t.translate(o,a),t.rotate((s.from_deg+180)*Math.PI/180),t.strokeStyle=r,t.lineWidth=2,t.beginPath(),[[0,14],[0,-14]].forEach(([l,c],h)=>t[h?"lineTo":"moveTo"](l,c)),[[-5,-7],[0,-14],[5,-7]].forEach(([l,c],h)=>t[h?"lineTo":"moveTo"](l,c)),t.stroke(),t.restore()}#e(t,e,n,s,r,o){let a=this.frame,l=Ol(110/s)||1,{grid:c,soft:h}=he();t.lineWidth=1,t.strokeStyle=c,t.fillStyle=h,t.font="11px system-ui, sans-serif";let u=l<1?1:0,d=Math.ceil((a.e-r/2/s)/l)*l;t.beginPath();for(let p=d;e(p)<r;p+=l)t.moveTo(e(p),0),t.lineTo(e(p),o);let f=Math.ceil((a.n-o/2/s)/l)*l;for(let p=f;n(p)>0;p+=l)t.moveTo(0,n(p)),t.lineTo(r,n(p));t.stroke(),t.textAlign="center";for(let p=d;e(p)<r-30;p+=l)e(p)>40&&t.fillText(`E ${oe(p,u)}`,e(p),o-5);t.textAlign="left";for(let p=f;n(p)>24;p+=l)n(p)<o-24&&t.fillText(`N ${oe(p,u)}`,5,n(p)-3)}#i(t,e,n,s,r){let{solid:o,soft:a,crowd:l}=he();t.strokeStyle=o,t.fillStyle=l,t.lineWidth=1.2;for(let c of e?.obstacles??[])if(t.beginPath(),c.outline_ne.length)c.outline_ne.forEach(([h,u],d)=>t[d?"lineTo":"moveTo"](n(u),s(h))),t.fill(),t.stroke();else{let[h,u]=[n(c.centre_ned[1]),s(c.centre_ned[0])];t.moveTo(h-5,u-5),t.lineTo(h+5,u+5),t.moveTo(h+5,u-5),t.lineTo(h-5,u+5),t.stroke()}t.setLineDash([6,5]),t.strokeStyle=a;for(let c of e?.vehicles??[])t.beginPath(),c.path_ned.forEach(([h,u],d)=>t[d?"lineTo":"moveTo"](n(u),s(h))),t.stroke();t.setLineDash([]),t.font="12px system-ui, sans-serif",t.fillStyle=a;for(let c of e?.bases??[]){let[h,u]=[n(c.p_ned[1]),s(c.p_ned[0])];t.strokeStyle=a,t.lineWidth=2,t.strokeRect(h-6,u-6,12,12),t.fillText(`base ${c.name}`,h+9,u+4)}}#s(t,e,n,s,r,o,a,l){let c=e.columns.size>Xu,h=Fn(e.t_s,r+1e-6,e.count)+1,u=Fn(e.t_s,r-o,e.count)+1,{soft:d}=he();t.lineJoin="round";let f=c?0:3;for(let[p,y]of e.columns){if(l&&!l.has(p)&&!c)continue;let m=p===a||(l?.has(p)??!1);t.globalAlpha=m||!c?a===null||m?.95:.45:.35,t.strokeStyle=pn(p),t.lineWidth=m?2.4:1.4,t.setLineDash(c?[]:Rl(p));let g=m||!c?0:u;this.#n(t,y.e,y.n,M=>Ls(y,M),g,h,Math.max(Math.floor((h-g)/(m||!c?2e3:Vx)),1),n,s);let _=y.n.findIndex(M=>!Number.isNaN(M));!f||_<0||_>=h||(t.setLineDash([]),t.beginPath(),t.arc(n(y.e[_]),s(y.n[_]),f,0,2*Math.PI),t.stroke())}t.globalAlpha=.9,t.strokeStyle=d,t.setLineDash([2,4]);for(let[p,y]of e.traffic.values())this.#n(t,y,p,m=>Number.isNaN(p[m]),0,h,Math.max(Math.floor(h/500),1),n,s);t.setLineDash([]),t.globalAlpha=1}#n(t,e,n,s,r,o,a,l,c){t.beginPath();let h=!1;for(let u=r;u<o;u=u+a<o||u===o-1?u+a:o-1){if(s(u)){h=!1;continue}t[h?"lineTo":"moveTo"](l(e[u]),c(n[u])),h=!0}t.stroke()}#r(t,e,n,s,r){let o=new Map(n.vehicles.map(c=>[c.sysid,c.p_ned])),a=new Map((e.session?.bases??[]).map(c=>[c.name,c.p_ned])),{warn:l}=he();for(let c of n.services){let h=c.tanker!==null?o.get(c.tanker):a.get(c.base??""),u=o.get(c.receiver);!h||!u||(t.strokeStyle=l,t.lineWidth=c.phase==="transfer"?4:1.5,t.setLineDash(c.phase==="transfer"?[]:[4,4]),t.beginPath(),t.moveTo(s(h[1]),r(h[0])),t.lineTo(s(u[1]),r(u[0])),t.stroke())}t.setLineDash([])}#a(t,e,n,s,r,o,a,l){let c=he(),h=e.session?.ring_m??null,u=n.vehicles.length>Xu,d=Yr(u?5:8);this.places=[];for(let y of n.vehicles){if(!y.p_ned)continue;let[m,g]=[s(y.p_ned[1]),r(y.p_ned[0])];this.places.push({sysid:y.sysid,x:m,y:g}),y.role==="target"&&h!==null&&(t.strokeStyle=c.soft,t.lineWidth=1,t.setLineDash([3,4]),t.beginPath(),t.arc(m,g,h*o,0,2*Math.PI),t.stroke(),t.setLineDash([])),t.fillStyle=pn(y.sysid),t.strokeStyle=c.paper,t.lineWidth=1.5,t.save(),t.translate(m,g),t.rotate(y.heading_rad??0),t.beginPath(),y.role==="tanker"?t.rect(-d,-d,2*d,2*d):y.role==="target"?[[0,-1.3],[1.1,0],[0,1.3],[-1.1,0]].forEach(([_,M],x)=>t[x?"lineTo":"moveTo"](_*d,M*d)):[[0,-1.5],[1,1.1],[0,.6],[-1,1.1]].forEach(([_,M],x)=>t[x?"lineTo":"moveTo"](_*d,M*d)),t.closePath(),t.fill(),t.stroke(),t.restore(),Dl(t,y,m,g,d),l.has(y.sysid)&&(t.strokeStyle=c.ink,t.lineWidth=y.sysid===a?2.5:1.5,t.beginPath(),t.arc(m,g,d+8,0,2*Math.PI),t.stroke())}for(let y of n.traffic){let[m,g]=[s(y.p_ned[1]),r(y.p_ned[0])];t.strokeStyle=c.warn,t.lineWidth=2,t.beginPath(),[[0,-8],[8,6],[-8,6],[0,-8]].forEach(([_,M],x)=>t[x?"lineTo":"moveTo"](m+_,g+M)),t.stroke(),this.#o(t,y.callsign,m,g,c.warn,[])}let f=this.places.map(y=>[y.x-d,y.y-d,y.x+d,y.y+d]),p=n.vehicles.filter(y=>!u||y.sysid===a||y.severity>1||y.role!=="pursuer");p.sort((y,m)=>+(m.sysid===a)-+(y.sysid===a)||m.severity-y.severity),t.font=`600 ${Yr(12)}px system-ui, sans-serif`,t.lineJoin="round";for(let y of p.slice(0,Xu))y.p_ned&&this.#o(t,String(y.sysid),s(y.p_ned[1]),r(y.p_ned[0]),c.ink,f)}#l(t,e,n,s,r,o){let{soft:a,paper:l}=he(),c=Fn(e.t_s,r+1e-6,e.count)+1;if(t.strokeStyle=a,t.lineWidth=1.2,t.setLineDash([5,3]),o)for(let h of e.columns.values())this.#n(t,h.e,h.n,u=>Ls(h,u),0,c,Math.max(Math.floor(c/500),1),n,s);t.setLineDash([]),t.font="11px system-ui, sans-serif";for(let h of e.at(r)?.vehicles??[]){if(!h.p_ned)continue;let[u,d]=[n(h.p_ned[1]),s(h.p_ned[0])];t.beginPath(),t.arc(u,d,6,0,2*Math.PI),t.fillStyle=l,t.fill(),t.stroke(),this.#o(t,`(${h.sysid})`,u,d,a,[])}}#o(t,e,n,s,r,o){let a=t.measureText(e).width;for(let[l,c]of[[11,-6],[-11-a,-6],[-a/2,-14],[-a/2,22],[11,14],[-11-a,14]]){let h=[n+l,s+c-10,n+l+a,s+c+3];if(!o.some(u=>h[0]<u[2]&&h[2]>u[0]&&h[1]<u[3]&&h[3]>u[1])){o.push(h),t.lineWidth=3,t.strokeStyle=he().paper,t.strokeText(e,n+l,s+c),t.fillStyle=r,t.fillText(e,n+l,s+c);return}}}#c(t,e,n,s){let{ink:r,paper:o}=he(),a=Ol(Math.min(160,.4*n)/e),[l,c]=[n-14,s-24],h=l-a*e;for(let[u,d]of[[o,6],[r,2]])t.strokeStyle=u,t.lineWidth=d,t.beginPath(),t.moveTo(h,c-5),t.lineTo(h,c),t.lineTo(l,c),t.lineTo(l,c-5),t.stroke();t.fillStyle=r,t.textAlign="right",t.font="12px system-ui, sans-serif",t.fillText(`${a} m`,l,c-9),Ul(t,n-20,20,0),t.textAlign="left"}};var Bl=class{constructor(t,e){this.orders=t,this.send=e,this.monitors=!1,this.notices=N("div",{class:"notices",role:"status","aria-live":"polite"}),this.dialog=N("dialog",{class:"ask","aria-labelledby":"ask-question"}),document.body.append(this.notices,this.dialog)}takes(t){return t.in_monitor||!this.monitors}#t(t){return this.monitors?"":t.means}notice(t,e=""){let n=N("p",{class:e},t);for(this.notices.append(n);this.notices.children.length>4;)this.notices.firstChild?.remove();setTimeout(()=>n.remove(),e==="bad"?12e3:6e3)}askMany(t,e,n,s,r,o){if(this.dialog.open)return;let a=(r()?.vehicles??[]).filter(d=>e.includes(d.sysid)),l=a.filter(d=>!qu(d)).map(d=>d.sysid),c=`${t.name[0].toUpperCase()}${t.name.slice(1)} ${n?"all ":""}${Qs(a.length)}?`,h=n?"":e.join(", "),u=N("button",{type:"submit",value:"yes",class:"primary"},"Yes");u.disabled=!l.length,this.dialog.replaceChildren(N("form",{method:"dialog"},N("h2",{id:"ask-question"},c),h?N("p",{},h):null,this.#t(t)?N("p",{class:"soft"},this.#t(t)):null,...Bm(a,qu,d=>`${d} of them cannot:`,"bad",s),...Bm(a,Xx,d=>`${d} ${d===1?"takes":"take"} the order, but:`,"warn",s),...qx(a,o),N("p",{class:"buttons"},u,N("button",{type:"submit",value:"no"},"No")))),this.dialog.returnValue="no",this.dialog.onclose=()=>{if(this.dialog.returnValue!=="yes")return;let d=[],f=l.length,p=l.filter(y=>this.send({command:t.command,sysid:y},(m,g)=>{if(m||d.push(g||`${s(y)}: not taken`),f-=1,f)return;let _=`${t.name}: ${l.length-d.length} of ${l.length} obey.`;this.notice([_,...d].join(" "),d.length?"bad":"good")}));p.length&&this.notice(`${t.name} ${Qs(p.length)}: sent`)},this.dialog.showModal(),(l.length?u:this.dialog.querySelector("button[value=no]"))?.focus()}ask(t,e,n,s){if(this.dialog.open)return;if(t.of_vehicle&&e===null)return void this.notice("No vehicle is chosen: choose one in the table, on the map or by its id.","bad");let r=t.command==="pause"&&s()?.phase==="paused",o=r?"Go on with the session?":t.question.replace("{}",e===null?"":n(e)),a=()=>s()?.vehicles.find(y=>y.sysid===e),l=N("p",{class:"soft"}),c=()=>{let y=t.of_vehicle?a():void 0;me(l,[y?$x(y):"",this.#t(t)].filter(Boolean).join(". "))},h=t.command==="retarget"?(s()?.vehicles??[]).filter(y=>y.role==="target"):[];if(t.command==="retarget"&&!h.length)return void this.notice("There is no target.","bad");let u=N("select",{"aria-label":"target"},...h.map(y=>N("option",{value:y.sysid},y.label))),d=N("button",{type:"submit",value:"yes",class:"primary"},"Yes"),f=N("form",{method:"dialog"},N("h2",{id:"ask-question"},o),l,h.length?N("p",{},u):null,N("p",{class:"buttons"},d,N("button",{type:"submit",value:"no"},"No")));this.dialog.replaceChildren(f),this.dialog.returnValue="no",this.dialog.onclose=()=>{if(clearInterval(p),this.dialog.returnValue!=="yes")return;let y={command:r?"resume":t.command};t.of_vehicle&&(y.sysid=e),h.length&&(y.target=Number(u.value));let m=t.of_vehicle&&e!==null?`${t.name} ${n(e)}`:r?"resume":t.name;this.send(y,(_,M)=>this.notice(`${m}: ${M||(_?"taken":"not taken")}`,_?"good":"bad"))&&this.notice(`${m}: sent`)},c();let p=setInterval(c,500);this.dialog.showModal(),d.focus()}};function qu(i){return i.alive?i.heard_s===null?"has not sent any telemetry yet.":"":"is dead."}function Xx(i){return qu(i)?"":i.condition==="silent"?`is silent (${i.figure}) and may not hear it.`:i.armed?i.landed?"has landed and stays there.":i.note.startsWith("taken by")?`is ${i.note} already (${i.mode_name}).`:i.trouble.includes(`failsafe: ${i.mode_name}`)?`is in ${i.mode_name} by its own failsafe, which the order would end.`:i.condition==="failing"&&i.trouble.includes(i.mode_name)?`is in ${i.mode_name} without an order from here, which this order would end.`:"":"is on the ground and stays there."}function Bm(i,t,e,n,s){let r=i.flatMap(o=>t(o)?[`${s(o.sysid)} ${t(o)}`]:[]);return r.length?[N("p",{class:n},e(r.length)),N("ul",{class:`${n} refusing`,tabindex:0},...r.map(o=>N("li",{},o)))]:[]}function $u(i){if(!i)return"by its own parameters";let t=i.down_after_s?`, level from ${i.level_after_s.toFixed(0)} s, down from ${i.down_after_s.toFixed(0)} s after the last HEARTBEAT`:"";return`straight home at ${i.return_m.toFixed(1)} m above it${t}`}function qx(i,t){let e=new Map;for(let{sysid:s}of i){let r=$u(t.get(s));e.set(r,[...e.get(r)??[],s])}let n=[...e].map(([s,r])=>N("tr",{},N("th",{scope:"row"},r.join(", ")),N("td",{class:"word"},s)));return n.length?[N("div",{class:"scroll plan-b",tabindex:0,role:"region","aria-label":"plan B"},N("table",{},N("caption",{},"Plan B, how each comes home by itself"),N("tbody",{},...n)))]:[]}function $x(i){let t=i.battery===null?"":`, battery ${(100*i.battery).toFixed(0)} %`,e=i.height_m===null?"":`, ${i.height_m.toFixed(1)} m high`;return`${Vi(i)||i.state||"mode not known"}${e}${t}`}var Yx=300,Zx=.35;function Yu(i,t,e){i.dataset.key!==t&&(i.dataset.key=t,i.replaceChildren(...e()))}function zm(i,t,e){let{competition:n,services:s,history:r}=t,o=Object.keys(n.v).map(Number).sort((l,c)=>n.v[c]-n.v[l]||l-c).slice(0,12),a=JSON.stringify([o.map(l=>n.v[l].toFixed(2)),n.leader,n.share?.toFixed(2),s,r.length]);Yu(i,a,()=>{let l=[];if(o.length){let c=n.share===null?"":`, ${oe(100*n.share,0)} % (${oe(100*n.threshold,0)} % needed to win)`;l.push(N("p",{},n.leader===null?"No vehicle leads yet.":N("b",{},`${e(n.leader)} leads`),c));for(let h of o){let u=N("span",{class:"bar"});u.style.width=`${Math.min(Math.max(100*n.v[h],0),100)}%`,u.style.background=pn(h),l.push(N("div",{class:"row"},N("span",{class:"row-name"},e(h)),N("div",{class:"track stack"},u),N("span",{class:"value"},oe(n.v[h],2))))}}else l.push(N("p",{class:"soft"},"No vehicle competes at this time."));for(let c of s){let h=c.tanker===null?`base ${c.base}`:e(c.tanker),u=c.phase==="transfer"?`${oe(c.energy_j/1e3,1)} kJ so far`:c.joined_at_s===null?"on the way":"in formation";l.push(N("div",{class:"service"},N("b",{},`${h} → ${e(c.receiver)}: ${c.phase}`),` ${u}`,N("p",{class:"small soft"},c.why||`decided at ${c.decided_at_s.toFixed(1)} s by ${c.by}`)))}if(r.length){let c=[...r].reverse().slice(0,12).map(u=>N("tr",{},...[e(u.receiver),u.tanker===null?`base ${u.base}`:e(u.tanker),u.by,oe(u.decided_at_s,1),oe(u.end_s,1),oe(u.energy_j/1e3,1),u.reason].map((d,f)=>N("td",{class:[0,1,2,6].includes(f)?"word":""},d)))),h=["receiver","by","decided by","decided s","done s","kJ","ended"];l.push(N("div",{class:"scroll",tabindex:0,role:"region","aria-label":"refuellings"},N("table",{},N("caption",{},`${r.length} refuellings have ended`),N("thead",{},N("tr",{},...h.map((u,d)=>N("th",{scope:"col",class:[0,1,2,6].includes(d)?"word":""},u)))),N("tbody",{},...c))))}return l})}function Jx(i){let t=[],e={critical:0,warning:1,info:2};for(let n of i){let s=t[t.length-1];s&&s.head.sysid===n.sysid&&n.t_s-s.head.t_s<=Zx&&e[n.level]>=2&&s.head.level==="info"?s.more.push(n):t.push({head:n,more:[]})}return t}var kl=class{constructor(t,e){this.go=e,this.search=N("input",{type:"search",placeholder:"search events","aria-label":"search events",oninput:()=>this.again()}),this.level=N("select",{"aria-label":"level of events",onchange:()=>this.again()},N("option",{value:"info"},"all"),N("option",{value:"warning"},"warnings and errors")),this.list=N("ol",{class:"events"}),t.append(N("div",{class:"tools"},this.search,this.level),N("div",{class:"scroll",tabindex:0,role:"region","aria-label":"list of events"},this.list)),this.key=""}again(){this.key="",this.last&&this.show(this.last.events,this.last.until_s,this.last.label)}show(t,e,n){this.last={events:t,until_s:e,label:n};let s=t.length;for(;s>0&&t[s-1].t_s>e+.05;)s-=1;let r=`${s} ${t.length?t[Math.max(s-1,0)]?.text:""}`;if(r===this.key)return;this.key=r;let o=this.search.value.trim().toLowerCase(),a=this.level.value==="warning",l=[];for(let h=s-1;h>=0&&l.length<Yx;h-=1){let u=t[h];a&&u.level==="info"||o&&!`${km(u,n)} ${u.text}`.toLowerCase().includes(o)||l.push(u)}let c=Jx(l.reverse()).reverse().map(({head:h,more:u})=>{let d=y=>[N("time",{},bi(y.t_s)),N("span",{class:"who"},km(y,n)),N("span",{},y.text)],f=N("li",{class:h.level}),p=N("button",{type:"button",class:"link","aria-label":`go to ${bi(h.t_s)}`,onclick:()=>this.go(h)},...d(h));return f.append(p),u.length&&f.append(N("details",{},N("summary",{},`and ${u.length} more`),...u.map(y=>N("p",{},...d(y))))),f});this.list.replaceChildren(...c.length?c:[N("li",{class:"soft"},"No events.")])}};function km(i,t){return i.sysid===0?"session":i.sysid===255?"traffic":t(i.sysid)}function Zu(i,t,e,n){let s=t.vehicles.find(l=>l.sysid===e);if(!s){Yu(i,"none",()=>[N("p",{class:"soft"},"Choose a vehicle in the table or in the picture.")]);return}let r=l=>oe(l===null?null:l*180/Math.PI,0,"°"),o=[["state",[s.state,s.stage].filter(Boolean).join(", ")||"–"],["mode",Vi(s)||"–"],["autopilot",s.autopilot??"–"],["armed",s.alive?s.armed?s.landed?"armed, landed":"armed, in the air":"disarmed":"–"],["battery",s.battery===null?"–":`${oe(100*s.battery,1)} %${s.remaining_j===null?"":`, ${oe(s.remaining_j/1e3,1)} kJ`}`],...(s.batteries??[]).map(l=>[`battery ${l.id}${l.function?`, ${l.function}`:""}`,`${l.share===null?"–":`${oe(100*l.share,0)} %`}${l.voltage_v===null?"":`, ${oe(l.voltage_v,1)} V`}`]),["power",oe(s.alive?s.power_w:null,0," W")],["lasts",!s.alive||s.endurance_s===null?"–":bi(s.endurance_s)],["north, east",s.p_ned?`${oe(s.p_ned[0],1)}, ${oe(s.p_ned[1],1)} m`:"–"],["height",oe(s.height_m,1," m")],["speed",oe(s.speed_m_s,2," m/s")],["heading",r(s.heading_rad===null?null:(s.heading_rad+2*Math.PI)%(2*Math.PI))],["roll, pitch",`${r(s.roll_rad)}, ${r(s.pitch_rad)}`],["to its target",oe(s.target_m,2," m")],["competition",s.v===null?"does not compete":`v ${oe(s.v,2)}${s.tau===null?"":`, τ ${oe(s.tau,2)}`}`],["link",`${s.lost} frames lost${s.lost_share===null?"":`, ${oe(100*s.lost_share,1)} % lately`}`],["position's age",oe(s.age_s,1," s")],...s.remote_id?[["Remote ID",s.remote_id]]:[],...(n?.vehicles??[]).flatMap(l=>l.sysid===e&&l.plan_b?[["plan B",$u(l.plan_b)]]:[])],a=`${s.sysid} ${s.trouble.join("|")} ${s.note} ${o.map(([l])=>l).join("|")}`;Yu(i,a,()=>[N("h3",{},s.label),...s.trouble.map(l=>N("p",{class:s.severity>1?"bad":"warn"},l)),s.note?N("p",{class:"soft"},s.note):"",N("dl",{class:"facts"},...o.map(([l])=>N("div",{},N("dt",{},l),N("dd"))))]),i.querySelectorAll("dd").forEach((l,c)=>me(l,o[c][1]))}var Xs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},qs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Sg=0,Cd=1,Mg=2;var Ga=1,bg=2,Eo=3,Yi=0,Yn=1,yi=2,xr=0,Ao=1,Rd=2,Pd=3,Id=4,wg=5;var vr=100,Tg=101,Eg=102,Ag=103,Cg=104,Rg=200,Pg=201,Ig=202,Lg=203,Ld=204,Dd=205,Dg=206,Ng=207,Ug=208,Fg=209,Og=210,Bg=211,kg=212,zg=213,Gg=214,pc=0,mc=1,gc=2,po=3,_c=4,yc=5,xc=6,vc=7,qc=0,Vg=1,Hg=2,Zi=0,Nd=1,Ud=2,Fd=3,Od=4,Bd=5,kd=6,zd=7;var Gd=300,Sr=301,Co=302,$c=303,Yc=304,Sc=1e3,Wi=1001,Mc=1002,Pn=1003,Wg=1004;var Va=1005;var $n=1006,Zc=1007;var ys=1008;var Kn=1009,Vd=1010,Hd=1011,Ro=1012,Jc=1013,Ii=1014,xi=1015,Li=1016,Kc=1017,jc=1018,Mr=1020,Wd=35902,Xd=35899,qd=1021,$d=1022,Di=1023,fs=1026,xs=1027,Qc=1028,th=1029,$s=1030,eh=1031;var nh=1033,Ha=33776,Wa=33777,Xa=33778,qa=33779,ih=35840,sh=35841,rh=35842,oh=35843,ah=36196,lh=37492,ch=37496,hh=37488,uh=37489,$a=37490,dh=37491,fh=37808,ph=37809,mh=37810,gh=37811,_h=37812,yh=37813,xh=37814,vh=37815,Sh=37816,Mh=37817,bh=37818,wh=37819,Th=37820,Eh=37821,Ah=36492,Ch=36494,Rh=36495,Ph=36283,Ih=36284,Ya=36285,Lh=36286;var ua=2300,bc=2301,dc=2302,yd=2303,xd=2400,vd=2401,Sd=2402;var Xg=3200;var Dh=0,qg=1,vs="",li="srgb",da="srgb-linear",fa="linear",Ce="srgb";var fc=7680;var $g=519,Yg=512,Zg=513,Jg=514,Yd=515,Kg=516,jg=517,Zd=518,Jd=519,Qg=35044;var Kd="300 es",_i=2e3,mo=2001;function Kx(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function jx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function pa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function t0(){let i=pa("canvas");return i.style.display="block",i}var Gm={},go=null;function jd(...i){let t="THREE."+i.shift();go?go("log",t,...i):console.log(t,...i)}function e0(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function $t(...i){i=e0(i);let t="THREE."+i.shift();if(go)go("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function te(...i){i=e0(i);let t="THREE."+i.shift();if(go)go("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function la(...i){let t=i.join(" ");t in Gm||(Gm[t]=!0,$t(...i))}function n0(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var i0={[pc]:pc,[gc]:xc,[_c]:_c,[po]:yc,[mc]:mc,[xc]:gc,[vc]:vc,[yc]:po},Pi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Vm=1234567,ca=Math.PI/180,_o=180/Math.PI;function Po(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]+"-"+On[t&255]+On[t>>8&255]+"-"+On[t>>16&15|64]+On[t>>24&255]+"-"+On[e&63|128]+On[e>>8&255]+"-"+On[e>>16&255]+On[e>>24&255]+On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]).toLowerCase()}function ge(i,t,e){return Math.max(t,Math.min(e,i))}function Qd(i,t){return(i%t+t)%t}function Qx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function tv(i,t,e){return i!==t?(e-i)/(t-i):0}function ha(i,t,e){return(1-e)*i+e*t}function ev(i,t,e,n){return ha(i,t,1-Math.exp(-e*n))}function nv(i,t=1){return t-Math.abs(Qd(i,t*2)-t)}function iv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function sv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function rv(i,t){return i+Math.floor(Math.random()*(t-i+1))}function ov(i,t){return i+Math.random()*(t-i)}function av(i){return i*(.5-Math.random())}function lv(i){i!==void 0&&(Vm=i);let t=Vm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function cv(i){return i*ca}function hv(i){return i*_o}function uv(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function dv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function tf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function fv(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:$t("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ef(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function s0(i,t){if(t.constructor===Float32Array)return i;let e=ef(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function r0(i,t){if(t.constructor===Float32Array)return i;let e=ef(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Nh={DEG2RAD:ca,RAD2DEG:_o,generateUUID:Po,clamp:ge,euclideanModulo:Qd,mapLinear:Qx,inverseLerp:tv,lerp:ha,damp:ev,pingpong:nv,smoothstep:iv,smootherstep:sv,randInt:rv,randFloat:ov,randFloatSpread:av,seededRandom:lv,degToRad:cv,radToDeg:hv,isPowerOfTwo:uv,ceilPowerOfTwo:dv,floorPowerOfTwo:tf,setQuaternionFromProperEuler:fv,normalize:r0,denormalize:s0},Xt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ge(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ge(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},In=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],y=r[o+3];if(u!==y||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*y;m<0&&(d=-d,f=-f,p=-p,y=-y,m=-m);let g=1-a;if(m<.9995){let _=Math.acos(m),M=Math.sin(_);g=Math.sin(g*_)/M,a=Math.sin(a*_)/M,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+y*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+y*a;let _=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=_,c*=_,h*=_,u*=_}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-a*f,t[e+2]=c*p+h*f+a*d-l*u,t[e+3]=h*p-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:$t("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ge(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Hm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Hm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this.z=ge(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this.z=ge(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ge(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Ju.copy(this).projectOnVector(t),this.sub(Ju)}reflect(t){return this.sub(Ju.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ge(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ju=new W,Hm=new In,ee=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],y=s[0],m=s[3],g=s[6],_=s[1],M=s[4],x=s[7],C=s[2],T=s[5],v=s[8];return r[0]=o*y+a*_+l*C,r[3]=o*m+a*M+l*T,r[6]=o*g+a*x+l*v,r[1]=c*y+h*_+u*C,r[4]=c*m+h*M+u*T,r[7]=c*g+h*x+u*v,r[2]=d*y+f*_+p*C,r[5]=d*m+f*M+p*T,r[8]=d*g+f*x+p*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=u*y,t[1]=(s*c-h*n)*y,t[2]=(a*n-s*o)*y,t[3]=d*y,t[4]=(h*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return la("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ku.makeScale(t,e)),this}rotate(t){return la("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ku.makeRotation(-t)),this}translate(t,e){return la("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ku.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Ku=new ee,Wm=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Xm=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function pv(){let i={enabled:!0,workingColorSpace:da,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ce&&(s.r=ds(s.r),s.g=ds(s.g),s.b=ds(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ce&&(s.r=fo(s.r),s.g=fo(s.g),s.b=fo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===vs?fa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[da]:{primaries:t,whitePoint:n,transfer:fa,toXYZ:Wm,fromXYZ:Xm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:li},outputColorSpaceConfig:{drawingBufferColorSpace:li}},[li]:{primaries:t,whitePoint:n,transfer:Ce,toXYZ:Wm,fromXYZ:Xm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:li}}}),i}var ve=pv();function ds(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function fo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var jr,wc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{jr===void 0&&(jr=pa("canvas")),jr.width=t.width,jr.height=t.height;let s=jr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=jr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=pa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ds(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(ds(e[n]/255)*255):e[n]=ds(e[n]);return{data:e,width:t.width,height:t.height}}else return $t("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},mv=0,yo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:mv++}),this.uuid=Po(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ju(s[o].image)):r.push(ju(s[o]))}else r=ju(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function ju(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?wc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:($t("Texture: Unable to serialize Texture."),{})}var gv=0,Qu=new W,Jn=class i extends Pi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Wi,s=Wi,r=$n,o=ys,a=Di,l=Kn,c=i.DEFAULT_ANISOTROPY,h=vs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:gv++}),this.uuid=Po(),this.name="",this.source=new yo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Xt(0,0),this.repeat=new Xt(1,1),this.center=new Xt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Qu).x}get height(){return this.source.getSize(Qu).y}get depth(){return this.source.getSize(Qu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){$t(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Gd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Sc:t.x=t.x-Math.floor(t.x);break;case Wi:t.x=t.x<0?0:1;break;case Mc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Sc:t.y=t.y-Math.floor(t.y);break;case Wi:t.y=t.y<0?0:1;break;case Mc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=Gd;Jn.DEFAULT_ANISOTROPY=1;var Ye=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],y=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(c+1)/2,x=(f+1)/2,C=(g+1)/2,T=(h+d)/4,v=(u+y)/4,b=(p+m)/4;return M>x&&M>C?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=T/n,r=v/n):x>C?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=T/s,r=b/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=v/r,s=b/r),this.set(n,s,r,e),this}let _=Math.sqrt((m-p)*(m-p)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(u-y)/_,this.z=(d-h)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this.z=ge(this.z,t.z,e.z),this.w=ge(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this.z=ge(this.z,t,e),this.w=ge(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ge(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Tc=class extends Pi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:$n,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ye(0,0,t,e),this.scissorTest=!1,this.viewport=new Ye(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:$n,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new yo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},hi=class extends Tc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ma=class extends Jn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ec=class extends Jn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Re=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,d,f,p,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,y,m)}set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,y,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=y,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Qr.setFromMatrixColumn(t,0).length(),r=1/Qr.setFromMatrixColumn(t,1).length(),o=1/Qr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,y=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-y*c,e[9]=-a*l,e[2]=y-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,y=c*u;e[0]=d+y*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=y+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,y=c*u;e[0]=d-y*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=y-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,y=a*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+y,e[1]=l*u,e[5]=y*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,y=a*c;e[0]=l*h,e[4]=y-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-y*u}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,y=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+y,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=y*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(_v,t,yv)}lookAt(t,e,n){let s=this.elements;return oi.subVectors(t,e),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Ds.crossVectors(n,oi),Ds.lengthSq()===0&&(Math.abs(n.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Ds.crossVectors(n,oi)),Ds.normalize(),zl.crossVectors(oi,Ds),s[0]=Ds.x,s[4]=zl.x,s[8]=oi.x,s[1]=Ds.y,s[5]=zl.y,s[9]=oi.y,s[2]=Ds.z,s[6]=zl.z,s[10]=oi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],y=n[6],m=n[10],g=n[14],_=n[3],M=n[7],x=n[11],C=n[15],T=s[0],v=s[4],b=s[8],R=s[12],P=s[1],L=s[5],O=s[9],V=s[13],U=s[2],G=s[6],Z=s[10],X=s[14],ct=s[3],B=s[7],$=s[11],et=s[15];return r[0]=o*T+a*P+l*U+c*ct,r[4]=o*v+a*L+l*G+c*B,r[8]=o*b+a*O+l*Z+c*$,r[12]=o*R+a*V+l*X+c*et,r[1]=h*T+u*P+d*U+f*ct,r[5]=h*v+u*L+d*G+f*B,r[9]=h*b+u*O+d*Z+f*$,r[13]=h*R+u*V+d*X+f*et,r[2]=p*T+y*P+m*U+g*ct,r[6]=p*v+y*L+m*G+g*B,r[10]=p*b+y*O+m*Z+g*$,r[14]=p*R+y*V+m*X+g*et,r[3]=_*T+M*P+x*U+C*ct,r[7]=_*v+M*L+x*G+C*B,r[11]=_*b+M*O+x*Z+C*$,r[15]=_*R+M*V+x*X+C*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],y=t[7],m=t[11],g=t[15],_=l*f-c*d,M=a*f-c*u,x=a*d-l*u,C=o*f-c*h,T=o*d-l*h,v=o*u-a*h;return e*(y*_-m*M+g*x)-n*(p*_-m*C+g*T)+s*(p*M-y*C+g*v)-r*(p*x-y*T+m*v)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],y=t[13],m=t[14],g=t[15],_=e*a-n*o,M=e*l-s*o,x=e*c-r*o,C=n*l-s*a,T=n*c-r*a,v=s*c-r*l,b=h*y-u*p,R=h*m-d*p,P=h*g-f*p,L=u*m-d*y,O=u*g-f*y,V=d*g-f*m,U=_*V-M*O+x*L+C*P-T*R+v*b;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/U;return t[0]=(a*V-l*O+c*L)*G,t[1]=(s*O-n*V-r*L)*G,t[2]=(y*v-m*T+g*C)*G,t[3]=(d*T-u*v-f*C)*G,t[4]=(l*P-o*V-c*R)*G,t[5]=(e*V-s*P+r*R)*G,t[6]=(m*x-p*v-g*M)*G,t[7]=(h*v-d*x+f*M)*G,t[8]=(o*O-a*P+c*b)*G,t[9]=(n*P-e*O-r*b)*G,t[10]=(p*T-y*x+g*_)*G,t[11]=(u*x-h*T-f*_)*G,t[12]=(a*R-o*L-l*b)*G,t[13]=(e*L-n*R+s*b)*G,t[14]=(y*M-p*C-m*_)*G,t[15]=(h*C-u*M+d*_)*G,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,y=o*h,m=o*u,g=a*u,_=l*c,M=l*h,x=l*u,C=n.x,T=n.y,v=n.z;return s[0]=(1-(y+g))*C,s[1]=(f+x)*C,s[2]=(p-M)*C,s[3]=0,s[4]=(f-x)*T,s[5]=(1-(d+g))*T,s[6]=(m+_)*T,s[7]=0,s[8]=(p+M)*v,s[9]=(m-_)*v,s[10]=(1-(d+y))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Qr.set(s[0],s[1],s[2]).length(),a=Qr.set(s[4],s[5],s[6]).length(),l=Qr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ai.copy(this);let c=1/o,h=1/a,u=1/l;return Ai.elements[0]*=c,Ai.elements[1]*=c,Ai.elements[2]*=c,Ai.elements[4]*=h,Ai.elements[5]*=h,Ai.elements[6]*=h,Ai.elements[8]*=u,Ai.elements[9]*=u,Ai.elements[10]*=u,e.setFromRotationMatrix(Ai),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=_i,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,y;if(l)p=r/(o-r),y=o*r/(o-r);else if(a===_i)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===mo)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=_i,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,y;if(l)p=1/(o-r),y=o/(o-r);else if(a===_i)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===mo)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Qr=new W,Ai=new Re,_v=new W(0,0,0),yv=new W(1,1,1),Ds=new W,zl=new W,oi=new W,qm=new Re,$m=new In,ps=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ge(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ge(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ge(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ge(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ge(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ge(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:$t("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return qm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(qm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return $m.setFromEuler(this),this.setFromQuaternion($m,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ps.DEFAULT_ORDER="XYZ";var ga=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},xv=0,Ym=new W,to=new In,os=new Re,Gl=new W,ta=new W,vv=new W,Sv=new In,Zm=new W(1,0,0),Jm=new W(0,1,0),Km=new W(0,0,1),jm={type:"added"},Mv={type:"removed"},eo={type:"childadded",child:null},td={type:"childremoved",child:null},Dn=class i extends Pi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:xv++}),this.uuid=Po(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new W,e=new ps,n=new In,s=new W(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Re},normalMatrix:{value:new ee}}),this.matrix=new Re,this.matrixWorld=new Re,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ga,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return to.setFromAxisAngle(t,e),this.quaternion.multiply(to),this}rotateOnWorldAxis(t,e){return to.setFromAxisAngle(t,e),this.quaternion.premultiply(to),this}rotateX(t){return this.rotateOnAxis(Zm,t)}rotateY(t){return this.rotateOnAxis(Jm,t)}rotateZ(t){return this.rotateOnAxis(Km,t)}translateOnAxis(t,e){return Ym.copy(t).applyQuaternion(this.quaternion),this.position.add(Ym.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Zm,t)}translateY(t){return this.translateOnAxis(Jm,t)}translateZ(t){return this.translateOnAxis(Km,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(os.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Gl.copy(t):Gl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ta.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?os.lookAt(ta,Gl,this.up):os.lookAt(Gl,ta,this.up),this.quaternion.setFromRotationMatrix(os),s&&(os.extractRotation(s.matrixWorld),to.setFromRotationMatrix(os),this.quaternion.premultiply(to.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(te("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(jm),eo.child=t,this.dispatchEvent(eo),eo.child=null):te("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Mv),td.child=t,this.dispatchEvent(td),td.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),os.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),os.multiply(t.parent.matrixWorld)),t.applyMatrix4(os),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(jm),eo.child=t,this.dispatchEvent(eo),eo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ta,t,vv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ta,Sv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Dn.DEFAULT_UP=new W(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var us=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},bv={type:"move"},xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new us,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new us,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new us,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,n),g=this._getHandJoint(c,y);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(bv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new us;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},o0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ns={h:0,s:0,l:0},Vl={h:0,s:0,l:0};function ed(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Zt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=li){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=n,ve.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ve.workingColorSpace){if(t=Qd(t,1),e=ge(e,0,1),n=ge(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=ed(o,r,t+1/3),this.g=ed(o,r,t),this.b=ed(o,r,t-1/3)}return ve.colorSpaceToWorking(this,s),this}setStyle(t,e=li){function n(r){r!==void 0&&parseFloat(r)<1&&$t("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:$t("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);$t("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=li){let n=o0[t.toLowerCase()];return n!==void 0?this.setHex(n,e):$t("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ds(t.r),this.g=ds(t.g),this.b=ds(t.b),this}copyLinearToSRGB(t){return this.r=fo(t.r),this.g=fo(t.g),this.b=fo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=li){return ve.workingToColorSpace(Bn.copy(this),t),Math.round(ge(Bn.r*255,0,255))*65536+Math.round(ge(Bn.g*255,0,255))*256+Math.round(ge(Bn.b*255,0,255))}getHexString(t=li){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.workingToColorSpace(Bn.copy(this),e);let n=Bn.r,s=Bn.g,r=Bn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ve.workingColorSpace){return ve.workingToColorSpace(Bn.copy(this),e),t.r=Bn.r,t.g=Bn.g,t.b=Bn.b,t}getStyle(t=li){ve.workingToColorSpace(Bn.copy(this),t);let e=Bn.r,n=Bn.g,s=Bn.b;return t!==li?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ns),this.setHSL(Ns.h+t,Ns.s+e,Ns.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ns),t.getHSL(Vl);let n=ha(Ns.h,Vl.h,e),s=ha(Ns.s,Vl.s,e),r=ha(Ns.l,Vl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Bn=new Zt;Zt.NAMES=o0;var _a=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ps,this.environmentIntensity=1,this.environmentRotation=new ps,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ci=new W,as=new W,nd=new W,ls=new W,no=new W,io=new W,Qm=new W,id=new W,sd=new W,rd=new W,od=new Ye,ad=new Ye,ld=new Ye,Bs=class i{constructor(t=new W,e=new W,n=new W){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ci.subVectors(t,e),s.cross(Ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ci.subVectors(s,e),as.subVectors(n,e),nd.subVectors(t,e);let o=Ci.dot(Ci),a=Ci.dot(as),l=Ci.dot(nd),c=as.dot(as),h=as.dot(nd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,ls)===null?!1:ls.x>=0&&ls.y>=0&&ls.x+ls.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,ls)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ls.x),l.addScaledVector(o,ls.y),l.addScaledVector(a,ls.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return od.setScalar(0),ad.setScalar(0),ld.setScalar(0),od.fromBufferAttribute(t,e),ad.fromBufferAttribute(t,n),ld.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(od,r.x),o.addScaledVector(ad,r.y),o.addScaledVector(ld,r.z),o}static isFrontFacing(t,e,n,s){return Ci.subVectors(n,e),as.subVectors(t,e),Ci.cross(as).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ci.subVectors(this.c,this.b),as.subVectors(this.a,this.b),Ci.cross(as).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;no.subVectors(s,n),io.subVectors(r,n),id.subVectors(t,n);let l=no.dot(id),c=io.dot(id);if(l<=0&&c<=0)return e.copy(n);sd.subVectors(t,s);let h=no.dot(sd),u=io.dot(sd);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(no,o);rd.subVectors(t,r);let f=no.dot(rd),p=io.dot(rd);if(p>=0&&f<=p)return e.copy(r);let y=f*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(io,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return Qm.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(Qm,a);let g=1/(m+y+d);return o=y*g,a=d*g,e.copy(n).addScaledVector(no,o).addScaledVector(io,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Xi=class{constructor(t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ri.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ri.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ri.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ri):Ri.fromBufferAttribute(r,o),Ri.applyMatrix4(t.matrixWorld),this.expandByPoint(Ri);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Hl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Hl.copy(n.boundingBox)),Hl.applyMatrix4(t.matrixWorld),this.union(Hl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ri),Ri.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ea),Wl.subVectors(this.max,ea),so.subVectors(t.a,ea),ro.subVectors(t.b,ea),oo.subVectors(t.c,ea),Us.subVectors(ro,so),Fs.subVectors(oo,ro),cr.subVectors(so,oo);let e=[0,-Us.z,Us.y,0,-Fs.z,Fs.y,0,-cr.z,cr.y,Us.z,0,-Us.x,Fs.z,0,-Fs.x,cr.z,0,-cr.x,-Us.y,Us.x,0,-Fs.y,Fs.x,0,-cr.y,cr.x,0];return!cd(e,so,ro,oo,Wl)||(e=[1,0,0,0,1,0,0,0,1],!cd(e,so,ro,oo,Wl))?!1:(Xl.crossVectors(Us,Fs),e=[Xl.x,Xl.y,Xl.z],cd(e,so,ro,oo,Wl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ri).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ri).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(cs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},cs=[new W,new W,new W,new W,new W,new W,new W,new W],Ri=new W,Hl=new Xi,so=new W,ro=new W,oo=new W,Us=new W,Fs=new W,cr=new W,ea=new W,Wl=new W,Xl=new W,hr=new W;function cd(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){hr.fromArray(i,r);let a=s.x*Math.abs(hr.x)+s.y*Math.abs(hr.y)+s.z*Math.abs(hr.z),l=t.dot(hr),c=e.dot(hr),h=n.dot(hr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var mn=new W,ql=new Xt,wv=0,on=class extends Pi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:wv++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Qg,this.updateRanges=[],this.gpuType=xi,this.version=0,this._normalizationScale=t!==void 0?ef(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)ql.fromBufferAttribute(this,e),ql.applyMatrix3(t),this.setXY(e,ql.x,ql.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):s0(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):r0(t,this.array)}};var ya=class extends on{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var xa=class extends on{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Pe=class extends on{constructor(t,e,n){super(new Float32Array(t),e,n)}},Tv=new Xi,na=new W,hd=new W,ms=class{constructor(t=new W,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Tv.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;na.subVectors(t,this.center);let e=na.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(na,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(hd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(na.copy(t.center).add(hd)),this.expandByPoint(na.copy(t.center).sub(hd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Ev=0,gi=new Re,ud=new Dn,ao=new W,ai=new Xi,ia=new Xi,Rn=new W,nn=class i extends Pi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ev++}),this.uuid=Po(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Kx(t)?xa:ya)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ee().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return gi.makeRotationFromQuaternion(t),this.applyMatrix4(gi),this}rotateX(t){return gi.makeRotationX(t),this.applyMatrix4(gi),this}rotateY(t){return gi.makeRotationY(t),this.applyMatrix4(gi),this}rotateZ(t){return gi.makeRotationZ(t),this.applyMatrix4(gi),this}translate(t,e,n){return gi.makeTranslation(t,e,n),this.applyMatrix4(gi),this}scale(t,e,n){return gi.makeScale(t,e,n),this.applyMatrix4(gi),this}lookAt(t){return ud.lookAt(t),ud.updateMatrix(),this.applyMatrix4(ud.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ao).negate(),this.translate(ao.x,ao.y,ao.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Pe(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&$t("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Xi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&te('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ms);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(t){let n=this.boundingSphere.center;if(ai.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(ai.min,ia.min),ai.expandByPoint(Rn),Rn.addVectors(ai.max,ia.max),ai.expandByPoint(Rn)):(ai.expandByPoint(ia.min),ai.expandByPoint(ia.max))}ai.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Rn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Rn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Rn.fromBufferAttribute(a,c),l&&(ao.fromBufferAttribute(t,c),Rn.add(ao)),s=Math.max(s,n.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&te('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){te("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new on(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let R=0;R<n.count;R++)a[R]=new W,l[R]=new W;let h=new W,u=new W,d=new W,f=new Xt,p=new Xt,y=new Xt,m=new W,g=new W;function _(R,P,L){c[R]=c[P]=c[L]=1,h.fromBufferAttribute(n,R),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,R),p.fromBufferAttribute(r,P),y.fromBufferAttribute(r,L),u.sub(h),d.sub(h),p.sub(f),y.sub(f);let O=1/(p.x*y.y-y.x*p.y);isFinite(O)&&(m.copy(u).multiplyScalar(y.y).addScaledVector(d,-p.y).multiplyScalar(O),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-y.x).multiplyScalar(O),a[R].add(m),a[P].add(m),a[L].add(m),l[R].add(g),l[P].add(g),l[L].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let R=0,P=M.length;R<P;++R){let L=M[R],O=L.start,V=L.count;for(let U=O,G=O+V;U<G;U+=3)_(t.getX(U+0),t.getX(U+1),t.getX(U+2))}let x=new W,C=new W,T=new W,v=new W;function b(R){T.fromBufferAttribute(s,R),v.copy(T);let P=a[R];x.copy(P),x.sub(T.multiplyScalar(T.dot(P))).normalize(),C.crossVectors(v,P);let O=C.dot(l[R])<0?-1:1;o.setXYZW(R,x.x,x.y,x.z,O)}for(let R=0,P=n.count;R<P;++R)c[R]&&b(R);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new on(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,h=new W,u=new W;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),y=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Rn.fromBufferAttribute(t,e),Rn.normalize(),t.setXYZ(e,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new on(d,h,u)}if(this.index===null)return $t("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var dd=new W,Av=new W,Cv=new ee,ci=class{constructor(t=new W(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=dd.subVectors(n,e).cross(Av.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(dd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Cv.getNormalMatrix(t),s=this.coplanarPoint(dd).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Rv=0,gs=class extends Pi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Rv++}),this.uuid=Po(),this.name="",this.type="Material",this.blending=Ao,this.side=Yi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ld,this.blendDst=Dd,this.blendEquation=vr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Zt(0,0,0),this.blendAlpha=0,this.depthFunc=po,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=$g,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=fc,this.stencilZFail=fc,this.stencilZPass=fc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){$t(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Zt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new ci().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Xt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var hs=new W,fd=new W,$l=new W,Yl=new W,fr=class{constructor(t=new W,e=new W(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,hs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=hs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(hs.copy(this.origin).addScaledVector(this.direction,e),hs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){fd.copy(t).add(e).multiplyScalar(.5),$l.copy(e).sub(t).normalize(),Yl.copy(this.origin).sub(fd);let r=t.distanceTo(e)*.5,o=-this.direction.dot($l),a=Yl.dot(this.direction),l=-Yl.dot($l),c=Yl.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let y=1/h;u*=y,d*=y,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(fd).addScaledVector($l,d),f}intersectSphere(t,e){if(t.radius<0)return null;hs.subVectors(t.center,this.origin);let n=hs.dot(this.direction),s=hs.dot(hs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,hs)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,y=e.y-o.y,m=e.z-o.z,g=n.x-o.x,_=n.y-o.y,M=n.z-o.z,x=Math.abs(l),C=Math.abs(c),T=Math.abs(h),v,b,R,P,L,O,V,U,G,Z,X,ct;if(x>=C&&x>=T?(R=l,O=u,G=p,ct=g,l>=0?(v=c,b=h,P=d,L=f,V=y,U=m,Z=_,X=M):(v=h,b=c,P=f,L=d,V=m,U=y,Z=M,X=_)):C>=T?(R=c,O=d,G=y,ct=_,c>=0?(v=h,b=l,P=f,L=u,V=m,U=p,Z=M,X=g):(v=l,b=h,P=u,L=f,V=p,U=m,Z=g,X=M)):(R=h,O=f,G=m,ct=M,h>=0?(v=l,b=c,P=u,L=d,V=p,U=y,Z=g,X=_):(v=c,b=l,P=d,L=u,V=y,U=p,Z=_,X=g)),R===0)return null;let B=v/R,$=b/R,et=1/R,ht=P-B*O,at=L-$*O,Q=V-B*G,mt=U-$*G,yt=Z-B*ct,At=X-$*ct,Mt=yt*mt-At*Q,Ht=ht*At-at*yt,se=Q*at-mt*ht;if(s){if(Mt<0||Ht<0||se<0)return null}else if((Mt<0||Ht<0||se<0)&&(Mt>0||Ht>0||se>0))return null;let Gt=Mt+Ht+se;if(Gt===0)return null;let de=et*(Mt*O+Ht*G+se*ct);return(Gt>0?de<0:de>0)?null:this.at(de/Gt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},va=class extends gs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ps,this.combine=qc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},tg=new Re,ur=new fr,Zl=new ms,eg=new W,Jl=new W,Kl=new W,jl=new W,pd=new W,Ql=new W,ng=new W,tc=new W,Nn=class extends Dn{constructor(t=new nn,e=new va){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ql.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(pd.fromBufferAttribute(u,t),o?Ql.addScaledVector(pd,h):Ql.addScaledVector(pd.sub(e),h))}e.add(Ql)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Zl.copy(n.boundingSphere),Zl.applyMatrix4(r),ur.copy(t.ray).recast(t.near),!(Zl.containsPoint(ur.origin)===!1&&(ur.intersectSphere(Zl,eg)===null||ur.origin.distanceToSquared(eg)>(t.far-t.near)**2))&&(tg.copy(r).invert(),ur.copy(t.ray).applyMatrix4(tg),!(n.boundingBox!==null&&ur.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,ur)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=d.length;p<y;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let x=_,C=M;x<C;x+=3){let T=a.getX(x),v=a.getX(x+1),b=a.getX(x+2);s=ec(this,g,t,n,c,h,u,T,v,b),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let _=a.getX(m),M=a.getX(m+1),x=a.getX(m+2);s=ec(this,o,t,n,c,h,u,_,M,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=d.length;p<y;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),M=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let x=_,C=M;x<C;x+=3){let T=x,v=x+1,b=x+2;s=ec(this,g,t,n,c,h,u,T,v,b),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let _=m,M=m+1,x=m+2;s=ec(this,o,t,n,c,h,u,_,M,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Pv(i,t,e,n,s,r,o,a){let l;if(t.side===Yn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Yi,a),l===null)return null;tc.copy(a),tc.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(tc);return c<e.near||c>e.far?null:{distance:c,point:tc.clone(),object:i}}function ec(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Jl),i.getVertexPosition(l,Kl),i.getVertexPosition(c,jl);let h=Pv(i,t,e,n,Jl,Kl,jl,ng);if(h){let u=new W;Bs.getBarycoord(ng,Jl,Kl,jl,u),s&&(h.uv=Bs.getInterpolatedAttribute(s,a,l,c,u,new Xt)),r&&(h.uv1=Bs.getInterpolatedAttribute(r,a,l,c,u,new Xt)),o&&(h.normal=Bs.getInterpolatedAttribute(o,a,l,c,u,new W),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new W,materialIndex:0};Bs.getNormal(Jl,Kl,jl,d.normal),h.face=d,h.barycoord=u}return h}var Sa=class extends Jn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Pn,h=Pn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var vo=class extends on{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},lo=new Re,ig=new Re,nc=[],sg=new Xi,Iv=new Re,sa=new Nn,ra=new ms,Ma=class extends Nn{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new vo(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Iv)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Xi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,lo),sg.copy(t.boundingBox).applyMatrix4(lo),this.boundingBox.union(sg)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ms),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,lo),ra.copy(t.boundingSphere).applyMatrix4(lo),this.boundingSphere.union(ra)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(sa.geometry=this.geometry,sa.material=this.material,sa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ra.copy(this.boundingSphere),ra.applyMatrix4(n),t.ray.intersectsSphere(ra)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,lo),ig.multiplyMatrices(n,lo),sa.matrixWorld=ig,sa.raycast(t,nc);for(let o=0,a=nc.length;o<a;o++){let l=nc[o];l.instanceId=r,l.object=this,e.push(l)}nc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new vo(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Sa(new Float32Array(s*this.count),s,this.count,Qc,xi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},dr=new ms,Lv=new Xt(.5,.5),ic=new W,ks=class{constructor(t=new ci,e=new ci,n=new ci,s=new ci,r=new ci,o=new ci){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=_i,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],y=r[9],m=r[10],g=r[11],_=r[12],M=r[13],x=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,g-p,C-_).normalize(),s[1].setComponents(c+o,f+h,g+p,C+_).normalize(),s[2].setComponents(c+a,f+u,g+y,C+M).normalize(),s[3].setComponents(c-a,f-u,g-y,C-M).normalize(),n)s[4].setComponents(l,d,m,x).normalize(),s[5].setComponents(c-l,f-d,g-m,C-x).normalize();else if(s[4].setComponents(c-l,f-d,g-m,C-x).normalize(),e===_i)s[5].setComponents(c+l,f+d,g+m,C+x).normalize();else if(e===mo)s[5].setComponents(l,d,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),dr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),dr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(dr)}intersectsSprite(t){dr.center.set(0,0,0);let e=Lv.distanceTo(t.center);return dr.radius=.7071067811865476+e,dr.applyMatrix4(t.matrixWorld),this.intersectsSphere(dr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(ic.x=s.normal.x>0?t.max.x:t.min.x,ic.y=s.normal.y>0?t.max.y:t.min.y,ic.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ic)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},rg=new Re,Ac=class i{constructor(){this.coordinateSystem=_i,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];rg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ks),n[s].setFromProjectionMatrix(rg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new ks),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var zs=class extends gs{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Zt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Cc=new W,Rc=new W,og=new Re,oa=new fr,sc=new ms,md=new W,ag=new W,ba=class extends Dn{constructor(t=new nn,e=new zs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Cc.fromBufferAttribute(e,s-1),Rc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Cc.distanceTo(Rc);t.setAttribute("lineDistance",new Pe(n,1))}else $t("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),sc.copy(n.boundingSphere),sc.applyMatrix4(s),sc.radius+=r,t.ray.intersectsSphere(sc)===!1)return;og.copy(s).invert(),oa.copy(t.ray).applyMatrix4(og);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let y=f,m=p-1;y<m;y+=c){let g=h.getX(y),_=h.getX(y+1),M=rc(this,t,oa,l,g,_,y);M&&e.push(M)}if(this.isLineLoop){let y=h.getX(p-1),m=h.getX(f),g=rc(this,t,oa,l,y,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let y=f,m=p-1;y<m;y+=c){let g=rc(this,t,oa,l,y,y+1,y);g&&e.push(g)}if(this.isLineLoop){let y=rc(this,t,oa,l,p-1,f,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function rc(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(Cc.fromBufferAttribute(a,s),Rc.fromBufferAttribute(a,r),e.distanceSqToSegment(Cc,Rc,md,ag)>n)return;md.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(md);if(!(c<t.near||c>t.far))return{distance:c,point:ag.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var lg=new W,cg=new W,pr=class extends ba{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)lg.fromBufferAttribute(e,s),cg.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+lg.distanceTo(cg);t.setAttribute("lineDistance",new Pe(n,1))}else $t("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var wa=class extends Jn{constructor(t=[],e=Sr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var _s=class extends Jn{constructor(t,e,n=Ii,s,r,o,a=Pn,l=Pn,c,h=fs,u=1){if(h!==fs&&h!==xs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new yo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ta=class extends _s{constructor(t,e=Ii,n=Sr,s,r,o=Pn,a=Pn,l,c=fs){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ea=class extends Jn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},qi=class i extends nn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Pe(c,3)),this.setAttribute("normal",new Pe(h,3)),this.setAttribute("uv",new Pe(u,2));function p(y,m,g,_,M,x,C,T,v,b,R){let P=x/v,L=C/b,O=x/2,V=C/2,U=T/2,G=v+1,Z=b+1,X=0,ct=0,B=new W;for(let $=0;$<Z;$++){let et=$*L-V;for(let ht=0;ht<G;ht++){let at=ht*P-O;B[y]=at*_,B[m]=et*M,B[g]=U,c.push(B.x,B.y,B.z),B[y]=0,B[m]=0,B[g]=T>0?1:-1,h.push(B.x,B.y,B.z),u.push(ht/v),u.push(1-$/b),X+=1}}for(let $=0;$<b;$++)for(let et=0;et<v;et++){let ht=d+et+G*$,at=d+et+G*($+1),Q=d+(et+1)+G*($+1),mt=d+(et+1)+G*$;l.push(ht,at,mt),l.push(at,Q,mt),ct+=6}a.addGroup(f,ct,R),f+=ct,d+=X}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Aa=class i extends nn{constructor(t=1,e=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:n,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new W,h=new Xt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=e;u++,d+=3){let f=n+u/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/t+1)/2,h.y=(o[d+1]/t+1)/2,l.push(h.x,h.y)}for(let u=1;u<=e;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new Pe(o,3)),this.setAttribute("normal",new Pe(a,3)),this.setAttribute("uv",new Pe(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Gs=class i extends nn{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,y=[],m=n/2,g=0;_(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new Pe(u,3)),this.setAttribute("normal",new Pe(d,3)),this.setAttribute("uv",new Pe(f,2));function _(){let x=new W,C=new W,T=0,v=(e-t)/n;for(let b=0;b<=r;b++){let R=[],P=b/r,L=P*(e-t)+t;for(let O=0;O<=s;O++){let V=O/s,U=V*l+a,G=Math.sin(U),Z=Math.cos(U);C.x=L*G,C.y=-P*n+m,C.z=L*Z,u.push(C.x,C.y,C.z),x.set(G,v,Z).normalize(),d.push(x.x,x.y,x.z),f.push(V,1-P),R.push(p++)}y.push(R)}for(let b=0;b<s;b++)for(let R=0;R<r;R++){let P=y[R][b],L=y[R+1][b],O=y[R+1][b+1],V=y[R][b+1];(t>0||R!==0)&&(h.push(P,L,V),T+=3),(e>0||R!==r-1)&&(h.push(L,O,V),T+=3)}c.addGroup(g,T,0),g+=T}function M(x){let C=p,T=new Xt,v=new W,b=0,R=x===!0?t:e,P=x===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*P,0),d.push(0,P,0),f.push(.5,.5),p++;let L=p;for(let O=0;O<=s;O++){let U=O/s*l+a,G=Math.cos(U),Z=Math.sin(U);v.x=R*Z,v.y=m*P,v.z=R*G,u.push(v.x,v.y,v.z),d.push(0,P,0),T.x=G*.5+.5,T.y=Z*.5*P+.5,f.push(T.x,T.y),p++}for(let O=0;O<s;O++){let V=C+O,U=L+O;x===!0?h.push(U,U+1,V):h.push(U+1,U,V),b+=3}c.addGroup(g,b,x===!0?1:2),g+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},So=class i extends Gs{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Pc=class i extends nn{constructor(t=[],e=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:n,detail:s};let r=[],o=[];a(s),c(n),h(),this.setAttribute("position",new Pe(r,3)),this.setAttribute("normal",new Pe(r.slice(),3)),this.setAttribute("uv",new Pe(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(_){let M=new W,x=new W,C=new W;for(let T=0;T<e.length;T+=3)f(e[T+0],M),f(e[T+1],x),f(e[T+2],C),l(M,x,C,_)}function l(_,M,x,C){let T=C+1,v=[];for(let b=0;b<=T;b++){v[b]=[];let R=_.clone().lerp(x,b/T),P=M.clone().lerp(x,b/T),L=T-b;for(let O=0;O<=L;O++)O===0&&b===T?v[b][O]=R:v[b][O]=R.clone().lerp(P,O/L)}for(let b=0;b<T;b++)for(let R=0;R<2*(T-b)-1;R++){let P=Math.floor(R/2);R%2===0?(d(v[b][P+1]),d(v[b+1][P]),d(v[b][P])):(d(v[b][P+1]),d(v[b+1][P+1]),d(v[b+1][P]))}}function c(_){let M=new W;for(let x=0;x<r.length;x+=3)M.x=r[x+0],M.y=r[x+1],M.z=r[x+2],M.normalize().multiplyScalar(_),r[x+0]=M.x,r[x+1]=M.y,r[x+2]=M.z}function h(){let _=new W;for(let M=0;M<r.length;M+=3){_.x=r[M+0],_.y=r[M+1],_.z=r[M+2];let x=m(_)/2/Math.PI+.5,C=g(_)/Math.PI+.5;o.push(x,1-C)}p(),u()}function u(){for(let _=0;_<o.length;_+=6){let M=o[_+0],x=o[_+2],C=o[_+4],T=Math.max(M,x,C),v=Math.min(M,x,C);T>.9&&v<.1&&(M<.2&&(o[_+0]+=1),x<.2&&(o[_+2]+=1),C<.2&&(o[_+4]+=1))}}function d(_){r.push(_.x,_.y,_.z)}function f(_,M){let x=_*3;M.x=t[x+0],M.y=t[x+1],M.z=t[x+2]}function p(){let _=new W,M=new W,x=new W,C=new W,T=new Xt,v=new Xt,b=new Xt;for(let R=0,P=0;R<r.length;R+=9,P+=6){_.set(r[R+0],r[R+1],r[R+2]),M.set(r[R+3],r[R+4],r[R+5]),x.set(r[R+6],r[R+7],r[R+8]),T.set(o[P+0],o[P+1]),v.set(o[P+2],o[P+3]),b.set(o[P+4],o[P+5]),C.copy(_).add(M).add(x).divideScalar(3);let L=m(C);y(T,P+0,_,L),y(v,P+2,M,L),y(b,P+4,x,L)}}function y(_,M,x,C){C<0&&_.x===1&&(o[M]=_.x-1),x.x===0&&x.z===0&&(o[M]=C/2/Math.PI+.5)}function m(_){return Math.atan2(_.z,-_.x)}function g(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.vertices,t.indices,t.radius,t.detail)}};function Dv(i,t,e=2){let n=t&&t.length,s=n?t[0]*e:i.length,r=a0(i,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=Bv(i,t,r,e)),i.length>80*e){a=i[0],l=i[1];let h=a,u=l;for(let d=e;d<s;d+=e){let f=i[d],p=i[d+1];f<a&&(a=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return Ca(r,o,e,a,l,c,0),o}function a0(i,t,e,n,s){let r;if(s===Zv(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=hg(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=hg(o/n|0,i[o],i[o+1],r);return r&&Mo(r,r.next)&&(Pa(r),r=r.next),r}function mr(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(Mo(e,e.next)||Je(e.prev,e,e.next)===0)){if(Pa(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function Ca(i,t,e,n,s,r,o){if(!i)return;!o&&r&&Hv(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?Uv(i,n,s,r):Nv(i)){t.push(l.i,i.i,c.i),Pa(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=Fv(mr(i),t),Ca(i,t,e,n,s,r,2)):o===2&&Ov(i,t,e,n,s,r):Ca(mr(i),t,e,n,s,r,1);break}}}function Nv(i){let t=i.prev,e=i,n=i.next;if(Je(t,e,n)>=0)return!1;let s=t.x,r=e.x,o=n.x,a=t.y,l=e.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),p=n.next;for(;p!==t;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&aa(s,a,r,l,o,c,p.x,p.y)&&Je(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function Uv(i,t,e,n){let s=i.prev,r=i,o=i.next;if(Je(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),p=Math.min(h,u,d),y=Math.max(a,l,c),m=Math.max(h,u,d),g=Md(f,p,t,e,n),_=Md(y,m,t,e,n),M=i.prevZ,x=i.nextZ;for(;M&&M.z>=g&&x&&x.z<=_;){if(M.x>=f&&M.x<=y&&M.y>=p&&M.y<=m&&M!==s&&M!==o&&aa(a,h,l,u,c,d,M.x,M.y)&&Je(M.prev,M,M.next)>=0||(M=M.prevZ,x.x>=f&&x.x<=y&&x.y>=p&&x.y<=m&&x!==s&&x!==o&&aa(a,h,l,u,c,d,x.x,x.y)&&Je(x.prev,x,x.next)>=0))return!1;x=x.nextZ}for(;M&&M.z>=g;){if(M.x>=f&&M.x<=y&&M.y>=p&&M.y<=m&&M!==s&&M!==o&&aa(a,h,l,u,c,d,M.x,M.y)&&Je(M.prev,M,M.next)>=0)return!1;M=M.prevZ}for(;x&&x.z<=_;){if(x.x>=f&&x.x<=y&&x.y>=p&&x.y<=m&&x!==s&&x!==o&&aa(a,h,l,u,c,d,x.x,x.y)&&Je(x.prev,x,x.next)>=0)return!1;x=x.nextZ}return!0}function Fv(i,t){let e=i;do{let n=e.prev,s=e.next.next;!Mo(n,s)&&c0(n,e,e.next,s)&&Ra(n,s)&&Ra(s,n)&&(t.push(n.i,e.i,s.i),Pa(e),Pa(e.next),e=i=s),e=e.next}while(e!==i);return mr(e)}function Ov(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&qv(o,a)){let l=h0(o,a);o=mr(o,o.next),l=mr(l,l.next),Ca(o,t,e,n,s,r,0),Ca(l,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function Bv(i,t,e,n){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*n,l=r<o-1?t[r+1]*n:i.length,c=a0(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(Xv(c))}s.sort(kv);for(let r=0;r<s.length;r++)e=zv(s[r],e);return e}function kv(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function zv(i,t){let e=Gv(i,t);if(!e)return t;let n=h0(e,i);return mr(n,n.next),mr(e,e.next)}function Gv(i,t){let e=t,n=i.x,s=i.y,r=-1/0,o;if(Mo(i,e))return e;do{if(Mo(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let u=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(u<=n&&u>r&&(r=u,o=e.x<e.next.x?e:e.next,u===n))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;e=o;do{if(n>=e.x&&e.x>=l&&n!==e.x&&l0(s<c?n:r,s,l,c,s<c?r:n,s,e.x,e.y)){let u=Math.abs(s-e.y)/(n-e.x);Ra(e,i)&&(u<h||u===h&&(e.x>o.x||e.x===o.x&&Vv(o,e)))&&(o=e,h=u)}e=e.next}while(e!==a);return o}function Vv(i,t){return Je(i.prev,i,t.prev)<0&&Je(t.next,i,i.next)<0}function Hv(i,t,e,n){let s=i;do s.z===0&&(s.z=Md(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,Wv(s)}function Wv(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function Md(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function Xv(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function l0(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function aa(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&l0(i,t,e,n,s,r,o,a)}function qv(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!$v(i,t)&&(Ra(i,t)&&Ra(t,i)&&Yv(i,t)&&(Je(i.prev,i,t.prev)||Je(i,t.prev,t))||Mo(i,t)&&Je(i.prev,i,i.next)>0&&Je(t.prev,t,t.next)>0)}function Je(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function Mo(i,t){return i.x===t.x&&i.y===t.y}function c0(i,t,e,n){let s=ac(Je(i,t,e)),r=ac(Je(i,t,n)),o=ac(Je(e,n,i)),a=ac(Je(e,n,t));return!!(s!==r&&o!==a||s===0&&oc(i,e,t)||r===0&&oc(i,n,t)||o===0&&oc(e,i,n)||a===0&&oc(e,t,n))}function oc(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function ac(i){return i>0?1:i<0?-1:0}function $v(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&c0(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function Ra(i,t){return Je(i.prev,i,i.next)<0?Je(i,t,i.next)>=0&&Je(i,i.prev,t)>=0:Je(i,t,i.prev)<0||Je(i,i.next,t)<0}function Yv(i,t){let e=i,n=!1,s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function h0(i,t){let e=bd(i.i,i.x,i.y),n=bd(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function hg(i,t,e,n){let s=bd(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function Pa(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function bd(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Zv(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var wd=class{static triangulate(t,e,n=2){return Dv(t,e,n)}},bo=class i{static area(t){let e=t.length,n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return i.area(t)<0}static triangulateShape(t,e){let n=[],s=[],r=[];ug(t),dg(n,t);let o=t.length;e.forEach(ug);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,dg(n,e[l]);let a=wd.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function ug(i){let t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function dg(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}var gr=class i extends Pc{constructor(t=1,e=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new i(t.radius,t.detail)}},_r=class i extends nn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],p=[],y=[],m=[];for(let g=0;g<h;g++){let _=g*d-o;for(let M=0;M<c;M++){let x=M*u-r;p.push(x,-_,0),y.push(0,0,1),m.push(M/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let _=0;_<a;_++){let M=_+c*g,x=_+c*(g+1),C=_+1+c*(g+1),T=_+1+c*g;f.push(M,x,T),f.push(x,C,T)}this.setIndex(f),this.setAttribute("position",new Pe(p,3)),this.setAttribute("normal",new Pe(y,3)),this.setAttribute("uv",new Pe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ia=class i extends nn{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new W,d=new W,f=[],p=[],y=[],m=[];for(let g=0;g<=n;g++){let _=[],M=g/n,x=o+M*a,C=t*Math.cos(x),T=Math.sqrt(t*t-C*C),v=0;g===0&&o===0?v=.5/e:g===n&&l===Math.PI&&(v=-.5/e);for(let b=0;b<=e;b++){let R=b/e,P=s+R*r;u.x=-T*Math.cos(P),u.y=C,u.z=T*Math.sin(P),p.push(u.x,u.y,u.z),d.copy(u).normalize(),y.push(d.x,d.y,d.z),m.push(R+v,1-M),_.push(c++)}h.push(_)}for(let g=0;g<n;g++)for(let _=0;_<e;_++){let M=h[g][_+1],x=h[g][_],C=h[g+1][_],T=h[g+1][_+1];(g!==0||o>0)&&f.push(M,x,T),(g!==n-1||l<Math.PI)&&f.push(x,C,T)}this.setIndex(f),this.setAttribute("position",new Pe(p,3)),this.setAttribute("normal",new Pe(y,3)),this.setAttribute("uv",new Pe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function br(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(fg(s))s.isRenderTargetTexture?($t("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(fg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function kn(i){let t={};for(let e=0;e<i.length;e++){let n=br(i[e]);for(let s in n)t[s]=n[s]}return t}function fg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Jv(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function nf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var u0={clone:br,merge:kn},Kv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,jv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,$i=class extends gs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Kv,this.fragmentShader=jv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=br(t.uniforms),this.uniformsGroups=Jv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Zt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Xt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new W().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ye().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ee().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Re().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Ic=class extends $i{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var yr=class extends gs{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Zt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Dh,this.normalScale=new Xt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ps,this.combine=qc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Lc=class extends gs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Xg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Dc=class extends gs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function co(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function lc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Vs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Nc=class extends Vs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:xd,endingEnd:xd}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case vd:r=t,a=2*e-n;break;case Sd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case vd:o=t,l=2*n-e;break;case Sd:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),y=p*p,m=y*p,g=-d*m+2*d*y-d*p,_=(1+d)*m+(-1.5-2*d)*y+(-.5+d)*p+1,M=(-1-f)*m+(1.5+f)*y+.5*p,x=f*m-f*y;for(let C=0;C!==a;++C)r[C]=g*o[h+C]+_*o[c+C]+M*o[l+C]+x*o[u+C];return r}},Uc=class extends Vs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Fc=class extends Vs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Oc=class extends Vs{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),y=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*y+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let y=o[c+p],m=o[l+p],g=f*d+p*2,_=u[g],M=u[g+1],x=t*d+p*2,C=h[x],T=h[x+1],v=tS(n,e,_,C,s);r[p]=d0(v,y,M,T,m)}return r}};function d0(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function Qv(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function tS(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=d0(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Qv(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ui=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=co(e,this.TimeBufferType),this.values=co(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:co(t.times,Array),values:co(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),lc(t.settings)&&(n.settings={inTangents:co(t.settings.inTangents,Array),outTangents:co(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Fc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Uc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Nc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Oc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ua:e=this.InterpolantFactoryMethodDiscrete;break;case bc:e=this.InterpolantFactoryMethodLinear;break;case dc:e=this.InterpolantFactoryMethodSmooth;break;case yd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return $t("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ua;case this.InterpolantFactoryMethodLinear:return bc;case this.InterpolantFactoryMethodSmooth:return dc;case this.InterpolantFactoryMethodBezier:return yd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;lc(this.settings)&&(pg(this.settings.inTangents,t),pg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;lc(this.settings)&&(mg(this.settings.inTangents,t),mg(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(te("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(te("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){te("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){te("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&jx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){te("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===dc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let y=e[u+p];if(y!==e[d+p]||y!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,lc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function pg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function mg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}ui.prototype.ValueTypeName="";ui.prototype.TimeBufferType=Float32Array;ui.prototype.ValueBufferType=Float32Array;ui.prototype.DefaultInterpolation=bc;var Hs=class extends ui{constructor(t,e,n){super(t,e,n)}};Hs.prototype.ValueTypeName="bool";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=ua;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var Bc=class extends ui{constructor(t,e,n,s){super(t,e,n,s)}};Bc.prototype.ValueTypeName="color";var kc=class extends ui{constructor(t,e,n,s){super(t,e,n,s)}};kc.prototype.ValueTypeName="number";var zc=class extends Vs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)In.slerpFlat(r,0,o,c-a,o,c,l);return r}},La=class extends ui{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new zc(this.times,this.values,this.getValueSize(),t)}};La.prototype.ValueTypeName="quaternion";La.prototype.InterpolantFactoryMethodSmooth=void 0;var Ws=class extends ui{constructor(t,e,n){super(t,e,n)}};Ws.prototype.ValueTypeName="string";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=ua;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var Gc=class extends ui{constructor(t,e,n,s){super(t,e,n,s)}};Gc.prototype.ValueTypeName="vector";var Vc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},f0=new Vc,Hc=class{constructor(t){this.manager=t!==void 0?t:f0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Hc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Da=class extends Dn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Zt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var gd=new Re,gg=new W,_g=new W,Wc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Xt(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new Re,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ks,this._frameExtents=new Xt(1,1),this._viewportCount=1,this._viewports=[new Ye(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;gg.setFromMatrixPosition(t.matrixWorld),e.position.copy(gg),_g.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(_g),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){gd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(gd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===mo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(gd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},cc=new W,hc=new In,Hi=new W,Na=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Re,this.projectionMatrix=new Re,this.projectionMatrixInverse=new Re,this.coordinateSystem=_i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(cc,hc,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(cc,hc,Hi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(cc,hc,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(cc,hc,Hi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Os=new W,yg=new Xt,xg=new Xt,qn=class extends Na{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=_o*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ca*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return _o*2*Math.atan(Math.tan(ca*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Os.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Os.x,Os.y).multiplyScalar(-t/Os.z),Os.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Os.x,Os.y).multiplyScalar(-t/Os.z)}getViewSize(t,e){return this.getViewBounds(t,yg,xg),e.subVectors(xg,yg)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ca*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ua=class extends Na{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Td=class extends Wc{constructor(){super(new Ua(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fa=class extends Da{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.target=new Dn,this.shadow=new Td}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Oa=class extends Da{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var ho=-90,uo=1,wo=class extends Dn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new qn(ho,uo,t,e);s.layers=this.layers,this.add(s);let r=new qn(ho,uo,t,e);r.layers=this.layers,this.add(r);let o=new qn(ho,uo,t,e);o.layers=this.layers,this.add(o);let a=new qn(ho,uo,t,e);a.layers=this.layers,this.add(a);let l=new qn(ho,uo,t,e);l.layers=this.layers,this.add(l);let c=new qn(ho,uo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===_i)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===mo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Xc=class extends qn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var sf="\\[\\]\\.:\\/",eS=new RegExp("["+sf+"]","g"),rf="[^"+sf+"]",nS="[^"+sf.replace("\\.","")+"]",iS=/((?:WC+[\/:])*)/.source.replace("WC",rf),sS=/(WCOD+)?/.source.replace("WCOD",nS),rS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",rf),oS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",rf),aS=new RegExp("^"+iS+sS+rS+oS+"$"),lS=["material","materials","bones","map"],Ed=class{constructor(t,e,n){let s=n||Xe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Xe=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(eS,"")}static parseTrackName(t){let e=aS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);lS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){$t("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){te("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){te("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){te("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){te("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){te("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;te("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xe.Composite=Ed;Xe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xe.prototype.GetterByBindingType=[Xe.prototype._getValue_direct,Xe.prototype._getValue_array,Xe.prototype._getValue_arrayElement,Xe.prototype._getValue_toArray];Xe.prototype.SetterByBindingTypeAndVersioning=[[Xe.prototype._setValue_direct,Xe.prototype._setValue_direct_setNeedsUpdate,Xe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_array,Xe.prototype._setValue_array_setNeedsUpdate,Xe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_arrayElement,Xe.prototype._setValue_arrayElement_setNeedsUpdate,Xe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_fromArray,Xe.prototype._setValue_fromArray_setNeedsUpdate,Xe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var BE=new Float32Array(1);var To=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ge(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ge(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ad=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Ba=class extends pr{constructor(t=10,e=10,n=4473924,s=8947848){n=new Zt(n),s=new Zt(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let d=0,f=0,p=-a;d<=e;d++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let y=d===r?n:s;y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3}let h=new nn;h.setAttribute("position",new Pe(l,3)),h.setAttribute("color",new Pe(c,3));let u=new zs({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var vg=new W,uc,_d,ka=class extends Dn{constructor(t=new W(0,0,1),e=new W(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",uc===void 0&&(uc=new nn,uc.setAttribute("position",new Pe([0,0,0,0,1,0],3)),_d=new So(.5,1,5,1),_d.translate(0,-.5,0)),this.position.copy(e),this.line=new ba(uc,new zs({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Nn(_d,new va({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(t),this.setLength(n,r,o)}setDirection(t){if(t.y>.99999)this.quaternion.set(0,0,0,1);else if(t.y<-.99999)this.quaternion.set(1,0,0,0);else{vg.set(t.z,0,-t.x).normalize();let e=Math.acos(t.y);this.quaternion.setFromAxisAngle(vg,e)}}setLength(t,e=t*.2,n=e*.2){this.line.scale.set(1,Math.max(1e-4,t-e),1),this.line.updateMatrix(),this.cone.scale.set(n,e,n),this.cone.position.y=t,this.cone.updateMatrix()}setColor(t){this.line.material.color.set(t),this.cone.material.color.set(t)}copy(t){return super.copy(t,!1),this.line.copy(t.line),this.cone.copy(t.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var za=class extends Pi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function of(i,t,e,n){let s=cS(n);switch(e){case qd:return i*t;case Qc:return i*t/s.components*s.byteLength;case th:return i*t/s.components*s.byteLength;case $s:return i*t*2/s.components*s.byteLength;case eh:return i*t*2/s.components*s.byteLength;case $d:return i*t*3/s.components*s.byteLength;case Di:return i*t*4/s.components*s.byteLength;case nh:return i*t*4/s.components*s.byteLength;case Ha:case Wa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Xa:case qa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case sh:case oh:return Math.max(i,16)*Math.max(t,8)/4;case ih:case rh:return Math.max(i,8)*Math.max(t,8)/2;case ah:case lh:case hh:case uh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case ch:case $a:case dh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case fh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ph:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case mh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case gh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case _h:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case yh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case xh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case vh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Sh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Mh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case bh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case wh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Th:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Eh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Ah:case Ch:case Rh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ph:case Ih:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ya:case Lh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function cS(i){switch(i){case Kn:case Vd:return{byteLength:1,components:1};case Ro:case Hd:case Li:return{byteLength:2,components:1};case Kc:case jc:return{byteLength:2,components:4};case Ii:case Jc:case xi:return{byteLength:4,components:1};case Wd:case Xd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$t("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function U0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function gS(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],y=u[f];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let y=u[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var _S=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,yS=`#ifdef USE_ALPHAHASH
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
#endif`,xS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,vS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,SS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,MS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,bS=`#ifdef USE_AOMAP
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
#endif`,wS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,TS=`#ifdef USE_BATCHING
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
#endif`,ES=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,AS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,CS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,RS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,PS=`#ifdef USE_IRIDESCENCE
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
#endif`,IS=`#ifdef USE_BUMPMAP
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
#endif`,LS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,DS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,NS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,US=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,FS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,OS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,BS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,kS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,zS=`#define PI 3.141592653589793
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
} // validated`,GS=`vec3 transformedNormal = objectNormal;
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
#endif`,VS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,HS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,WS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,XS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qS="gl_FragColor = linearToOutputTexel( gl_FragColor );",$S=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,YS=`#ifdef USE_ENVMAP
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
#endif`,ZS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,JS=`#ifdef USE_ENVMAP
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
#endif`,KS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,jS=`#ifdef USE_ENVMAP
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
#endif`,QS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,tM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,eM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,nM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,iM=`#ifdef USE_GRADIENTMAP
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
}`,sM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,rM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,oM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,aM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,lM=`#ifdef USE_ENVMAP
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
#endif`,cM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,hM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,uM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,dM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,fM=`PhysicalMaterial material;
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
#endif`,pM=`uniform sampler2D dfgLUT;
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
}`,mM=`
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
#endif`,gM=`#if defined( RE_IndirectDiffuse )
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
#endif`,_M=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,yM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,xM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,vM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,SM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,MM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,bM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,wM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,TM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,EM=`#if defined( USE_POINTS_UV )
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
#endif`,AM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,CM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,RM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,PM=`#if defined( USE_MORPHCOLORS )
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
#endif`,IM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,LM=`#ifdef USE_MORPHTARGETS
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
#endif`,DM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,NM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,UM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,FM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,OM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,BM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,kM=`#ifdef USE_NORMALMAP
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
#endif`,zM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,GM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,VM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,HM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,WM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,XM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,qM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$M=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,YM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,ZM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,JM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,KM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,jM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,QM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,tb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,eb=`float getShadowMask() {
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
}`,nb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ib=`#ifdef USE_SKINNING
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
#endif`,sb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,rb=`#ifdef USE_SKINNING
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
#endif`,ob=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ab=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,lb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,cb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,hb=`#ifdef USE_TRANSMISSION
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
#endif`,ub=`#ifdef USE_TRANSMISSION
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
#endif`,db=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,fb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,gb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,_b=`uniform sampler2D t2D;
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
}`,yb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xb=`uniform float backgroundBlurriness;
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
}`,vb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Sb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Mb=`#include <common>
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
}`,bb=`#if DEPTH_PACKING == 3200
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
}`,wb=`#define DISTANCE
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
}`,Tb=`#define DISTANCE
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
}`,Eb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ab=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Cb=`uniform float scale;
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
}`,Rb=`uniform vec3 diffuse;
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
}`,Pb=`#include <common>
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
}`,Ib=`uniform vec3 diffuse;
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
}`,Lb=`#define LAMBERT
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
}`,Db=`#define LAMBERT
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
}`,Nb=`#define MATCAP
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
}`,Ub=`#define MATCAP
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
}`,Fb=`#define NORMAL
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
}`,Ob=`#define NORMAL
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
}`,Bb=`#define PHONG
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
}`,kb=`#define PHONG
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
}`,zb=`#define STANDARD
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
}`,Gb=`#define STANDARD
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
}`,Vb=`#define TOON
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
}`,Hb=`#define TOON
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
}`,Wb=`uniform float size;
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
}`,Xb=`uniform vec3 diffuse;
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
}`,qb=`#include <common>
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
}`,$b=`uniform vec3 color;
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
}`,Yb=`uniform float rotation;
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
}`,Zb=`uniform vec3 diffuse;
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
}`,ue={alphahash_fragment:_S,alphahash_pars_fragment:yS,alphamap_fragment:xS,alphamap_pars_fragment:vS,alphatest_fragment:SS,alphatest_pars_fragment:MS,aomap_fragment:bS,aomap_pars_fragment:wS,batching_pars_vertex:TS,batching_vertex:ES,begin_vertex:AS,beginnormal_vertex:CS,bsdfs:RS,iridescence_fragment:PS,bumpmap_pars_fragment:IS,clipping_planes_fragment:LS,clipping_planes_pars_fragment:DS,clipping_planes_pars_vertex:NS,clipping_planes_vertex:US,color_fragment:FS,color_pars_fragment:OS,color_pars_vertex:BS,color_vertex:kS,common:zS,defaultnormal_vertex:GS,displacementmap_pars_vertex:VS,displacementmap_vertex:HS,emissivemap_fragment:WS,emissivemap_pars_fragment:XS,colorspace_fragment:qS,colorspace_pars_fragment:$S,envmap_fragment:YS,envmap_common_pars_fragment:ZS,envmap_pars_fragment:JS,envmap_pars_vertex:KS,envmap_physical_pars_fragment:lM,envmap_vertex:jS,fog_vertex:QS,fog_pars_vertex:tM,fog_fragment:eM,fog_pars_fragment:nM,gradientmap_pars_fragment:iM,lightmap_pars_fragment:sM,lights_lambert_fragment:rM,lights_lambert_pars_fragment:oM,lights_pars_begin:aM,lights_toon_fragment:cM,lights_toon_pars_fragment:hM,lights_phong_fragment:uM,lights_phong_pars_fragment:dM,lights_physical_fragment:fM,lights_physical_pars_fragment:pM,lights_fragment_begin:mM,lights_fragment_maps:gM,lights_fragment_end:_M,lightprobes_pars_fragment:yM,logdepthbuf_fragment:xM,logdepthbuf_pars_fragment:vM,logdepthbuf_pars_vertex:SM,logdepthbuf_vertex:MM,map_fragment:bM,map_pars_fragment:wM,map_particle_fragment:TM,map_particle_pars_fragment:EM,metalnessmap_fragment:AM,metalnessmap_pars_fragment:CM,morphinstance_vertex:RM,morphcolor_vertex:PM,morphnormal_vertex:IM,morphtarget_pars_vertex:LM,morphtarget_vertex:DM,normal_fragment_begin:NM,normal_fragment_maps:UM,normal_pars_fragment:FM,normal_pars_vertex:OM,normal_vertex:BM,normalmap_pars_fragment:kM,clearcoat_normal_fragment_begin:zM,clearcoat_normal_fragment_maps:GM,clearcoat_pars_fragment:VM,iridescence_pars_fragment:HM,opaque_fragment:WM,packing:XM,premultiplied_alpha_fragment:qM,project_vertex:$M,dithering_fragment:YM,dithering_pars_fragment:ZM,roughnessmap_fragment:JM,roughnessmap_pars_fragment:KM,shadowmap_pars_fragment:jM,shadowmap_pars_vertex:QM,shadowmap_vertex:tb,shadowmask_pars_fragment:eb,skinbase_vertex:nb,skinning_pars_vertex:ib,skinning_vertex:sb,skinnormal_vertex:rb,specularmap_fragment:ob,specularmap_pars_fragment:ab,tonemapping_fragment:lb,tonemapping_pars_fragment:cb,transmission_fragment:hb,transmission_pars_fragment:ub,uv_pars_fragment:db,uv_pars_vertex:fb,uv_vertex:pb,worldpos_vertex:mb,background_vert:gb,background_frag:_b,backgroundCube_vert:yb,backgroundCube_frag:xb,cube_vert:vb,cube_frag:Sb,depth_vert:Mb,depth_frag:bb,distance_vert:wb,distance_frag:Tb,equirect_vert:Eb,equirect_frag:Ab,linedashed_vert:Cb,linedashed_frag:Rb,meshbasic_vert:Pb,meshbasic_frag:Ib,meshlambert_vert:Lb,meshlambert_frag:Db,meshmatcap_vert:Nb,meshmatcap_frag:Ub,meshnormal_vert:Fb,meshnormal_frag:Ob,meshphong_vert:Bb,meshphong_frag:kb,meshphysical_vert:zb,meshphysical_frag:Gb,meshtoon_vert:Vb,meshtoon_frag:Hb,points_vert:Wb,points_frag:Xb,shadow_vert:qb,shadow_frag:$b,sprite_vert:Yb,sprite_frag:Zb},Lt={common:{diffuse:{value:new Zt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new Xt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Zt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Zt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new Zt(16777215)},opacity:{value:1},center:{value:new Xt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},Ki={basic:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ue.meshbasic_vert,fragmentShader:ue.meshbasic_frag},lambert:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Zt(0)},envMapIntensity:{value:1}}]),vertexShader:ue.meshlambert_vert,fragmentShader:ue.meshlambert_frag},phong:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Zt(0)},specular:{value:new Zt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ue.meshphong_vert,fragmentShader:ue.meshphong_frag},standard:{uniforms:kn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new Zt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag},toon:{uniforms:kn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new Zt(0)}}]),vertexShader:ue.meshtoon_vert,fragmentShader:ue.meshtoon_frag},matcap:{uniforms:kn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ue.meshmatcap_vert,fragmentShader:ue.meshmatcap_frag},points:{uniforms:kn([Lt.points,Lt.fog]),vertexShader:ue.points_vert,fragmentShader:ue.points_frag},dashed:{uniforms:kn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ue.linedashed_vert,fragmentShader:ue.linedashed_frag},depth:{uniforms:kn([Lt.common,Lt.displacementmap]),vertexShader:ue.depth_vert,fragmentShader:ue.depth_frag},normal:{uniforms:kn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ue.meshnormal_vert,fragmentShader:ue.meshnormal_frag},sprite:{uniforms:kn([Lt.sprite,Lt.fog]),vertexShader:ue.sprite_vert,fragmentShader:ue.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ue.background_vert,fragmentShader:ue.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:ue.backgroundCube_vert,fragmentShader:ue.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ue.cube_vert,fragmentShader:ue.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ue.equirect_vert,fragmentShader:ue.equirect_frag},distance:{uniforms:kn([Lt.common,Lt.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ue.distance_vert,fragmentShader:ue.distance_frag},shadow:{uniforms:kn([Lt.lights,Lt.fog,{color:{value:new Zt(0)},opacity:{value:1}}]),vertexShader:ue.shadow_vert,fragmentShader:ue.shadow_frag}};Ki.physical={uniforms:kn([Ki.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new Xt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ee},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new Zt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new Xt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new Zt(0)},specularColor:{value:new Zt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new Xt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag};var Uh={r:0,b:0,g:0},Jb=new Re,F0=new ee;F0.set(-1,0,0,0,1,0,0,0,1);function Kb(i,t,e,n,s,r){let o=new Zt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(_){let M=_.isScene===!0?_.background:null;if(M&&M.isTexture){let x=_.backgroundBlurriness>0;M=t.get(M,x)}return M}function p(_){let M=!1,x=f(_);x===null?m(o,a):x&&x.isColor&&(m(x,1),M=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(_,M){let x=f(M);x&&x.isCubeTexture?(c===void 0&&(c=new Nn(new qi(1,1,1),new $i({name:"BackgroundCubeMaterial",uniforms:br(Ki.backgroundCube.uniforms),vertexShader:Ki.backgroundCube.vertexShader,fragmentShader:Ki.backgroundCube.fragmentShader,side:Yn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,T,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=x,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Jb.makeRotationFromEuler(M.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(F0),c.material.toneMapped=ve.getTransfer(x.colorSpace)!==Ce,(h!==x||u!==x.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=x,u=x.version,d=i.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new Nn(new _r(2,2),new $i({name:"BackgroundMaterial",uniforms:br(Ki.background.uniforms),vertexShader:Ki.background.vertexShader,fragmentShader:Ki.background.fragmentShader,side:Yi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=ve.getTransfer(x.colorSpace)!==Ce,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||u!==x.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=x,u=x.version,d=i.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,M){_.getRGB(Uh,nf(i)),e.buffers.color.setClear(Uh.r,Uh.g,Uh.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,M=1){o.set(_),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:p,addToRenderList:y,dispose:g}}function jb(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,O,V,U,G){let Z=!1,X=u(L,U,V,O);r!==X&&(r=X,c(r.object)),Z=f(L,U,V,G),Z&&p(L,U,V,G),G!==null&&t.update(G,i.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,x(L,O,V,U),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,O,V,U){let G=U.wireframe===!0,Z=n[O.id];Z===void 0&&(Z={},n[O.id]=Z);let X=L.isInstancedMesh===!0?L.id:0,ct=Z[X];ct===void 0&&(ct={},Z[X]=ct);let B=ct[V.id];B===void 0&&(B={},ct[V.id]=B);let $=B[G];return $===void 0&&($=d(l()),B[G]=$),$}function d(L){let O=[],V=[],U=[];for(let G=0;G<e;G++)O[G]=0,V[G]=0,U[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:V,attributeDivisors:U,object:L,attributes:{},index:null}}function f(L,O,V,U){let G=r.attributes,Z=O.attributes,X=0,ct=V.getAttributes();for(let B in ct)if(ct[B].location>=0){let et=G[B],ht=Z[B];if(ht===void 0&&(B==="instanceMatrix"&&L.instanceMatrix&&(ht=L.instanceMatrix),B==="instanceColor"&&L.instanceColor&&(ht=L.instanceColor)),et===void 0||et.attribute!==ht||ht&&et.data!==ht.data)return!0;X++}return r.attributesNum!==X||r.index!==U}function p(L,O,V,U){let G={},Z=O.attributes,X=0,ct=V.getAttributes();for(let B in ct)if(ct[B].location>=0){let et=Z[B];et===void 0&&(B==="instanceMatrix"&&L.instanceMatrix&&(et=L.instanceMatrix),B==="instanceColor"&&L.instanceColor&&(et=L.instanceColor));let ht={};ht.attribute=et,et&&et.data&&(ht.data=et.data),G[B]=ht,X++}r.attributes=G,r.attributesNum=X,r.index=U}function y(){let L=r.newAttributes;for(let O=0,V=L.length;O<V;O++)L[O]=0}function m(L){g(L,0)}function g(L,O){let V=r.newAttributes,U=r.enabledAttributes,G=r.attributeDivisors;V[L]=1,U[L]===0&&(i.enableVertexAttribArray(L),U[L]=1),G[L]!==O&&(i.vertexAttribDivisor(L,O),G[L]=O)}function _(){let L=r.newAttributes,O=r.enabledAttributes;for(let V=0,U=O.length;V<U;V++)O[V]!==L[V]&&(i.disableVertexAttribArray(V),O[V]=0)}function M(L,O,V,U,G,Z,X){X===!0?i.vertexAttribIPointer(L,O,V,G,Z):i.vertexAttribPointer(L,O,V,U,G,Z)}function x(L,O,V,U){y();let G=U.attributes,Z=V.getAttributes(),X=O.defaultAttributeValues;for(let ct in Z){let B=Z[ct];if(B.location>=0){let $=G[ct];if($===void 0&&(ct==="instanceMatrix"&&L.instanceMatrix&&($=L.instanceMatrix),ct==="instanceColor"&&L.instanceColor&&($=L.instanceColor)),$!==void 0){let et=$.normalized,ht=$.itemSize,at=t.get($);if(at===void 0)continue;let Q=at.buffer,mt=at.type,yt=at.bytesPerElement,At=mt===i.INT||mt===i.UNSIGNED_INT||$.gpuType===Jc;if($.isInterleavedBufferAttribute){let Mt=$.data,Ht=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,se=$.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Gt=0;Gt<B.locationSize;Gt++)g(B.location+Gt,Mt.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Gt=0;Gt<B.locationSize;Gt++)m(B.location+Gt);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Gt=0;Gt<B.locationSize;Gt++)M(B.location+Gt,ht/B.locationSize,mt,et,Ht*yt,(se+ht/B.locationSize*Gt)*yt,At)}else{if($.isInstancedBufferAttribute){for(let Mt=0;Mt<B.locationSize;Mt++)g(B.location+Mt,$.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=$.meshPerAttribute*$.count)}else for(let Mt=0;Mt<B.locationSize;Mt++)m(B.location+Mt);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Mt=0;Mt<B.locationSize;Mt++)M(B.location+Mt,ht/B.locationSize,mt,et,ht*yt,ht/B.locationSize*Mt*yt,At)}}else if(X!==void 0){let et=X[ct];if(et!==void 0)switch(et.length){case 2:i.vertexAttrib2fv(B.location,et);break;case 3:i.vertexAttrib3fv(B.location,et);break;case 4:i.vertexAttrib4fv(B.location,et);break;default:i.vertexAttrib1fv(B.location,et)}}}}_()}function C(){R();for(let L in n){let O=n[L];for(let V in O){let U=O[V];for(let G in U){let Z=U[G];for(let X in Z)h(Z[X].object),delete Z[X];delete U[G]}}delete n[L]}}function T(L){if(n[L.id]===void 0)return;let O=n[L.id];for(let V in O){let U=O[V];for(let G in U){let Z=U[G];for(let X in Z)h(Z[X].object),delete Z[X];delete U[G]}}delete n[L.id]}function v(L){for(let O in n){let V=n[O];for(let U in V){let G=V[U];if(G[L.id]===void 0)continue;let Z=G[L.id];for(let X in Z)h(Z[X].object),delete Z[X];delete G[L.id]}}}function b(L){for(let O in n){let V=n[O],U=L.isInstancedMesh===!0?L.id:0,G=V[U];if(G!==void 0){for(let Z in G){let X=G[Z];for(let ct in X)h(X[ct].object),delete X[ct];delete G[Z]}delete V[U],Object.keys(V).length===0&&delete n[O]}}}function R(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:R,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:T,releaseStatesOfObject:b,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:m,disableUnusedAttributes:_}}function Qb(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function tw(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Di&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let b=v===Li&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==Kn&&v!==xi&&!b&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&($t("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&$t("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&$t("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),_=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:_,maxVaryings:M,maxFragmentUniforms:x,maxSamples:C,samples:T}}function ew(i){let t=this,e=null,n=0,s=!1,r=!1,o=new ci,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,y=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let _=r?0:n,M=_*4,x=g.clippingState||null;l.value=x,x=h(p,d,M,f);for(let C=0;C!==M;++C)x[C]=e[C];g.clippingState=x,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let y=u!==null?u.length:0,m=null;if(y!==0){if(m=l.value,p!==!0||m===null){let g=f+y*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,x=f;M!==y;++M,x+=4)o.copy(u[M]).applyMatrix4(_,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var Ka=class extends hi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new wa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new qi(5,5,5),r=new $i({name:"CubemapFromEquirect",uniforms:br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Yn,blending:xr});r.uniforms.tEquirect.value=e;let o=new Nn(s,r),a=e.minFilter;return e.minFilter===ys&&(e.minFilter=$n),new wo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},p0=256,nw=3,iw=20,O0=256,B0=16,sw=3,rw=new W,ow=new Zt,Oh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new wo(1,10,null),this._boxMesh=new Nn(new qi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=rw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(ow));let m=new wo(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=_0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=g0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(p0,tf(t))}_fromTexture(t,e){t.mapping===Sr||t.mapping===Co?this._setSize(t.image.length===0?p0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=m0(t,!1,!1),n=Math.log2(t)-nw;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=m0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Sr||t.mapping===Co?(this._cubemapMaterial===null&&(this._cubemapMaterial=_0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=g0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=aw(),this._integrationMaterial=lw());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/B0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-sw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(O0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=cw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function m0(i,t,e){return new Ka(i,{minFilter:ys,generateMipmaps:t,type:Li,colorSpace:da,depthBuffer:e})}function ja(i,t,e){return new $i({name:i,uniforms:t,vertexShader:ue.cube_vert,fragmentShader:e,side:Yn,blending:xr,depthTest:!1,depthWrite:!1})}function aw(){return ja("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${O0}u

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
	`)}function lw(){return ja("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:B0}},`

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
	`)}function cw(){return ja("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${iw}
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
	`)}function g0(){return ja("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function _0(){return ja("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function hw(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===$c||f===Yc)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let y=new Ka(p.height);return y.fromEquirectangularTexture(i,d),t.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===$c||f===Yc,y=f===Sr||f===Co;if(p||y){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new Oh(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let _=d.image;return p&&_&&_.height>0||y&&_&&l(_)?(n===null&&(n=new Oh(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===$c?d.mapping=Sr:f===Yc&&(d.mapping=Co),d}function l(d){let f=0,p=6;for(let y=0;y<p;y++)d[y]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function uw(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&la("WebGLRenderer: "+n+" extension not supported."),s}}}function dw(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(t.remove(y),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function h(p){let y=p.attributes;for(let m in y)t.update(y[m],i.ARRAY_BUFFER)}function u(p){let y=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let _=y!==null?y.array.length:m.array.length/3-1,M=m.count>=65535?xa:ya,x=new M(Math.ceil(_/3)*6,1),C=x.array;if(y!==null){let v=y.array;g=y.version;for(let b=0,R=0;b<_;b+=3){let P=v[b+0],L=v[b+1],O=v[b+2];C[R++]=P,C[R++]=L,C[R++]=L,C[R++]=O,C[R++]=O,C[R++]=P}}else{g=m.version;for(let v=0,b=0;v<_;v+=3){let R=v+0,P=v+1,L=v+2;C[b++]=R,C[b++]=P,C[b++]=P,C[b++]=L,C[b++]=L,C[b++]=R}}x.version=g;let T=r.get(p);T&&t.remove(T),r.set(p,x)}function d(p){let y=r.get(p);if(y){let m=p.index;m!==null&&y.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function fw(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let y=0;for(let m=0;m<f;m++)y+=d[m];e.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function pw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:te("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function mw(i,t,e){let n=new WeakMap,s=new Ye;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let R=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",R)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),y===!0&&(M=3);let x=a.attributes.position.count*M,C=1;x>t.maxTextureSize&&(C=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);let T=new Float32Array(x*C*4*u),v=new ma(T,x,C,u);v.type=xi,v.needsUpdate=!0;let b=M*4;for(let P=0;P<u;P++){let L=m[P],O=g[P],V=_[P],U=x*C*4*P;for(let G=0;G<L.count;G++){let Z=G*b;f===!0&&(s.fromBufferAttribute(L,G),T[U+Z+0]=s.x,T[U+Z+1]=s.y,T[U+Z+2]=s.z,T[U+Z+3]=0),p===!0&&(s.fromBufferAttribute(O,G),T[U+Z+4]=s.x,T[U+Z+5]=s.y,T[U+Z+6]=s.z,T[U+Z+7]=0),y===!0&&(s.fromBufferAttribute(V,G),T[U+Z+8]=s.x,T[U+Z+9]=s.y,T[U+Z+10]=s.z,T[U+Z+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:v,size:new Xt(x,C)},n.set(a,d),a.addEventListener("dispose",R)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function gw(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var _w={[Nd]:"LINEAR_TONE_MAPPING",[Ud]:"REINHARD_TONE_MAPPING",[Fd]:"CINEON_TONE_MAPPING",[Od]:"ACES_FILMIC_TONE_MAPPING",[kd]:"AGX_TONE_MAPPING",[zd]:"NEUTRAL_TONE_MAPPING",[Bd]:"CUSTOM_TONE_MAPPING"};function yw(i,t,e,n,s,r){let o=new hi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new nn;h.setAttribute("position",new Pe([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Pe([0,2,0,0,2,0],2));let u=new Ic({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Nn(h,u),f=new Ua(-1,1,1,-1,0,1),p=null,y=null,m=!1,g,_=null,M=[],x=!1;this.setSize=function(C,T){o.setSize(C,T),a!==null&&a.setSize(C,T),l!==null&&l.setSize(C,T);for(let v=0;v<M.length;v++){let b=M[v];b.setSize&&b.setSize(C,T)}},this.setEffects=function(C){M=C,x=M.length>0&&M[0].isRenderPass===!0;let T=o.width,v=o.height;M.length>0&&a===null&&(a=new hi(T,v,{type:Li,depthBuffer:!1,stencilBuffer:!1}),l=new hi(T,v,{type:Li,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&M.some(R=>R.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new _s(T,v),r===!0&&(c.format=xs,c.type=Mr)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let R=0;R<M.length;R++){let P=M[R];P.setSize&&P.setSize(T,v),b&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,T){if(m||C.toneMapping===Zi&&M.length===0)return!1;if(_=T,T!==null){let v=T.width,b=T.height;(o.width!==v||o.height!==b)&&this.setSize(v,b)}return x===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=Zi,!0},this.hasRenderPass=function(){return x},this.end=function(C,T){C.toneMapping=g,m=!0;let v=o,b=a;for(let R=0;R<M.length;R++){let P=M[R];P.enabled!==!1&&(P.render(C,b,v,T),P.needsSwap!==!1&&(v=b,b=b===a?l:a))}if(p!==C.outputColorSpace||y!==C.toneMapping){p=C.outputColorSpace,y=C.toneMapping,u.defines={},ve.getTransfer(p)===Ce&&(u.defines.SRGB_TRANSFER="");let R=_w[y];R&&(u.defines[R]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,C.setRenderTarget(_),C.render(d,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var k0=new Jn,z0=new _s(1,1),G0=new Ta(1),V0=new ma,H0=new Ec,W0=new wa,y0=[],x0=[],v0=new Float32Array(16),S0=new Float32Array(9),M0=new Float32Array(4);function Lo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=y0[s];if(r===void 0&&(r=new Float32Array(s),y0[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Sn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Mn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function kh(i,t){let e=x0[t];e===void 0&&(e=new Int32Array(t),x0[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function xw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function vw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Sn(e,t))return;i.uniform2fv(this.addr,t),Mn(e,t)}}function Sw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Sn(e,t))return;i.uniform3fv(this.addr,t),Mn(e,t)}}function Mw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Sn(e,t))return;i.uniform4fv(this.addr,t),Mn(e,t)}}function bw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Sn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Mn(e,t)}else{if(Sn(e,n))return;M0.set(n),i.uniformMatrix2fv(this.addr,!1,M0),Mn(e,n)}}function ww(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Sn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Mn(e,t)}else{if(Sn(e,n))return;S0.set(n),i.uniformMatrix3fv(this.addr,!1,S0),Mn(e,n)}}function Tw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Sn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Mn(e,t)}else{if(Sn(e,n))return;v0.set(n),i.uniformMatrix4fv(this.addr,!1,v0),Mn(e,n)}}function Ew(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Aw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Sn(e,t))return;i.uniform2iv(this.addr,t),Mn(e,t)}}function Cw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Sn(e,t))return;i.uniform3iv(this.addr,t),Mn(e,t)}}function Rw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Sn(e,t))return;i.uniform4iv(this.addr,t),Mn(e,t)}}function Pw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Iw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Sn(e,t))return;i.uniform2uiv(this.addr,t),Mn(e,t)}}function Lw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Sn(e,t))return;i.uniform3uiv(this.addr,t),Mn(e,t)}}function Dw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Sn(e,t))return;i.uniform4uiv(this.addr,t),Mn(e,t)}}function zh(i){return i.version===0&&(i.compareFunction=Jd,i.needsUpdate=!0),i}function Nw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=zh(z0):r=k0,e.setTexture2D(t||r,s)}function Uw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||H0,s)}function Fw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=zh(G0):r=W0,e.setTextureCube(t||r,s)}function Ow(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||V0,s)}function Bw(i){switch(i){case 5126:return xw;case 35664:return vw;case 35665:return Sw;case 35666:return Mw;case 35674:return bw;case 35675:return ww;case 35676:return Tw;case 5124:case 35670:return Ew;case 35667:case 35671:return Aw;case 35668:case 35672:return Cw;case 35669:case 35673:return Rw;case 5125:return Pw;case 36294:return Iw;case 36295:return Lw;case 36296:return Dw;case 35678:case 36198:case 36298:case 36306:case 35682:return Nw;case 35679:case 36299:case 36307:return Uw;case 35680:case 36300:case 36308:case 36293:return Fw;case 36289:case 36303:case 36311:case 36292:return Ow}}function kw(i,t){i.uniform1fv(this.addr,t)}function zw(i,t){let e=Lo(t,this.size,2);i.uniform2fv(this.addr,e)}function Gw(i,t){let e=Lo(t,this.size,3);i.uniform3fv(this.addr,e)}function Vw(i,t){let e=Lo(t,this.size,4);i.uniform4fv(this.addr,e)}function Hw(i,t){let e=Lo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Ww(i,t){let e=Lo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Xw(i,t){let e=Lo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function qw(i,t){i.uniform1iv(this.addr,t)}function $w(i,t){i.uniform2iv(this.addr,t)}function Yw(i,t){i.uniform3iv(this.addr,t)}function Zw(i,t){i.uniform4iv(this.addr,t)}function Jw(i,t){i.uniform1uiv(this.addr,t)}function Kw(i,t){i.uniform2uiv(this.addr,t)}function jw(i,t){i.uniform3uiv(this.addr,t)}function Qw(i,t){i.uniform4uiv(this.addr,t)}function t1(i,t,e){let n=this.cache,s=t.length,r=kh(e,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=zh(z0):o=k0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function e1(i,t,e){let n=this.cache,s=t.length,r=kh(e,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||H0,r[o])}function n1(i,t,e){let n=this.cache,s=t.length,r=kh(e,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=zh(G0):o=W0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function i1(i,t,e){let n=this.cache,s=t.length,r=kh(e,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||V0,r[o])}function s1(i){switch(i){case 5126:return kw;case 35664:return zw;case 35665:return Gw;case 35666:return Vw;case 35674:return Hw;case 35675:return Ww;case 35676:return Xw;case 5124:case 35670:return qw;case 35667:case 35671:return $w;case 35668:case 35672:return Yw;case 35669:case 35673:return Zw;case 5125:return Jw;case 36294:return Kw;case 36295:return jw;case 36296:return Qw;case 35678:case 36198:case 36298:case 36306:case 35682:return t1;case 35679:case 36299:case 36307:return e1;case 35680:case 36300:case 36308:case 36293:return n1;case 36289:case 36303:case 36311:case 36292:return i1}}var cf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Bw(e.type)}},hf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=s1(e.type)}},uf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},af=/(\w+)(\])?(\[|\.)?/g;function b0(i,t){i.seq.push(t),i.map[t.id]=t}function r1(i,t,e){let n=i.name,s=n.length;for(af.lastIndex=0;;){let r=af.exec(n),o=af.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){b0(e,c===void 0?new cf(a,i,t):new hf(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new uf(a),b0(e,u)),e=u}}}var Io=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);r1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function w0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var o1=37297,a1=0;function l1(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var T0=new ee;function c1(i){ve._getMatrix(T0,ve.workingColorSpace,i);let t=`mat3( ${T0.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(i)){case fa:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return $t("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function E0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+l1(i.getShaderSource(t),a)}else return r}function h1(i,t){let e=c1(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var u1={[Nd]:"Linear",[Ud]:"Reinhard",[Fd]:"Cineon",[Od]:"ACESFilmic",[kd]:"AgX",[zd]:"Neutral",[Bd]:"Custom"};function d1(i,t){let e=u1[t];return e===void 0?($t("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Fh=new W;function f1(){ve.getLuminanceCoefficients(Fh);let i=Fh.x.toFixed(4),t=Fh.y.toFixed(4),e=Fh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function p1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ja).join(`
`)}function m1(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function g1(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ja(i){return i!==""}function A0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function C0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var _1=/^[ \t]*#include +<([\w\d./]+)>/gm;function df(i){return i.replace(_1,y1)}function y1(i,t){let e=ue[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return df(e)}var x1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function R0(i){return i.replace(x1,v1)}function v1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function P0(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var S1={[Ga]:"SHADOWMAP_TYPE_PCF",[Eo]:"SHADOWMAP_TYPE_VSM"};function M1(i){return S1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var b1={[Co]:"ENVMAP_MODE_REFRACTION"};function w1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":b1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var T1={[qc]:"ENVMAP_BLENDING_MULTIPLY",[Vg]:"ENVMAP_BLENDING_MIX",[Hg]:"ENVMAP_BLENDING_ADD"};function E1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":T1[i.combine]||"ENVMAP_BLENDING_NONE"}function A1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=M1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=w1(e),u=E1(e),d=p1(e),f=m1(r),p=s.createProgram(),y,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ja).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ja).join(`
`),m.length>0&&(m+=`
`)):(y=[P0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ja).join(`
`),m=[P0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Zi?"#define TONE_MAPPING":"",e.toneMapping!==Zi?ue.tonemapping_pars_fragment:"",e.toneMapping!==Zi?d1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ue.colorspace_pars_fragment,h1("linearToOutputTexel",e.outputColorSpace),f1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ja).join(`
`)),o=df(o),o=A0(o,e),o=C0(o,e),a=df(a),a=A0(a,e),a=C0(a,e),o=R0(o),a=R0(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===Kd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Kd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=g+y+o,M=g+m+a,x=w0(s,s.VERTEX_SHADER,_),C=w0(s,s.FRAGMENT_SHADER,M);s.attachShader(p,x),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(P){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(x)||"",V=s.getShaderInfoLog(C)||"",U=L.trim(),G=O.trim(),Z=V.trim(),X=!0,ct=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(X=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,x,C);else{let B=E0(s,x,"vertex"),$=E0(s,C,"fragment");te("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+U+`
`+B+`
`+$)}else U!==""?$t("WebGLProgram: Program Info Log:",U):(G===""||Z==="")&&(ct=!1);ct&&(P.diagnostics={runnable:X,programLog:U,vertexShader:{log:G,prefix:y},fragmentShader:{log:Z,prefix:m}})}s.deleteShader(x),s.deleteShader(C),v=new Io(s,p),b=g1(s,p)}let v;this.getUniforms=function(){return v===void 0&&T(this),v};let b;this.getAttributes=function(){return b===void 0&&T(this),b};let R=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return R===!1&&(R=s.getProgramParameter(p,o1)),R},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=a1++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=x,this.fragmentShader=C,this}var C1=0,ff=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new pf(t),e.set(t,n)),n}},pf=class{constructor(t){this.id=C1++,this.code=t,this.usedTimes=0}};function R1(i){return i===$s||i===$a||i===Ya}function P1(i,t,e,n,s,r){let o=new ga,a=new ff,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,b,R,P,L,O){let V=P.fog,U=L.geometry,G=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,Z=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,X=t.get(v.envMap||G,Z),ct=d[v.type],B=n.precision;v.precision!==null&&(B=n.getMaxPrecision(v.precision),B!==v.precision&&$t("WebGLProgram.getParameters:",v.precision,"not supported, using",B,"instead."));let $=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,et=$!==void 0?$.length:0,ht=0;U.morphAttributes.position!==void 0&&(ht=1),U.morphAttributes.normal!==void 0&&(ht=2),U.morphAttributes.color!==void 0&&(ht=3);let at,Q,mt,yt;if(ct){let Ct=Ki[ct];at=Ct.vertexShader,Q=Ct.fragmentShader}else{at=v.vertexShader,Q=v.fragmentShader;let Ct=a.getVertexShaderStage(v),ae=a.getFragmentShaderStage(v);a.update(v,Ct,ae),mt=Ct.id,yt=ae.id}let At=i.getRenderTarget(),Mt=i.state.buffers.depth.getReversed(),Ht=L.isInstancedMesh===!0,se=L.isBatchedMesh===!0,Gt=!!v.map,de=!!v.matcap,le=!!X,ne=le&&X.isPMREMTexture===!0,qe=!!v.aoMap,ke=!!v.lightMap,an=!!v.bumpMap&&v.wireframe===!1,Ne=!!v.normalMap,wn=!!v.displacementMap,Se=!!v.emissiveMap,gn=!!v.metalnessMap,Ke=!!v.roughnessMap,ln=v.anisotropy>0,z=v.clearcoat>0,Rt=v.diffuseRoughness>0,Yt=v.dispersion>0,re=v.retroreflectivity>0,bt=v.iridescence>0,Fe=v.sheen>0,zt=v.transmission>0,qt=ln&&!!v.anisotropyMap,I=z&&!!v.clearcoatMap,w=z&&!!v.clearcoatNormalMap,Y=z&&!!v.clearcoatRoughnessMap,dt=Rt&&!!v.diffuseRoughnessMap,ot=bt&&!!v.iridescenceMap,_t=bt&&!!v.iridescenceThicknessMap,xt=Fe&&!!v.sheenColorMap,nt=Fe&&!!v.sheenRoughnessMap,st=!!v.specularMap,pt=!!v.specularColorMap,k=!!v.specularIntensityMap,rt=zt&&!!v.transmissionMap,it=zt&&!!v.thicknessMap,wt=!!v.gradientMap,gt=!!v.alphaMap,St=v.alphaTest>0,Vt=!!v.alphaHash,Kt=!!v.extensions,ut=Zi;v.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(ut=i.toneMapping);let Ot=ne?X.isCompressedCubeTexture?X.image[0].mipmaps:X.mipmaps:null,jt={shaderID:ct,shaderType:v.type,shaderName:v.name,vertexShader:at,fragmentShader:Q,defines:v.defines,customVertexShaderID:mt,customFragmentShaderID:yt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:B,batching:se,batchingColor:se&&L._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&L.instanceColor!==null,instancingMorph:Ht&&L.morphTexture!==null,outputColorSpace:At===null?i.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:ve.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Gt,matcap:de,envMap:le,envMapMode:le&&X.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ot.length-1:null,envMapSize:ne?Ot[0].width:null,aoMap:qe,lightMap:ke,bumpMap:an,normalMap:Ne,displacementMap:wn,emissiveMap:Se,normalMapObjectSpace:Ne&&v.normalMapType===qg,normalMapTangentSpace:Ne&&v.normalMapType===Dh,packedNormalMap:Ne&&v.normalMapType===Dh&&R1(v.normalMap.format),metalnessMap:gn,roughnessMap:Ke,anisotropy:ln,anisotropyMap:qt,clearcoat:z,clearcoatMap:I,clearcoatNormalMap:w,clearcoatRoughnessMap:Y,diffuseRoughness:Rt,diffuseRoughnessMap:dt,dispersion:Yt,retroreflection:re,iridescence:bt,iridescenceMap:ot,iridescenceThicknessMap:_t,sheen:Fe,sheenColorMap:xt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:pt,specularIntensityMap:k,transmission:zt,transmissionMap:rt,thicknessMap:it,gradientMap:wt,opaque:v.transparent===!1&&v.blending===Ao&&v.alphaToCoverage===!1,alphaMap:gt,alphaTest:St,alphaHash:Vt,combine:v.combine,mapUv:Gt&&f(v.map.channel),aoMapUv:qe&&f(v.aoMap.channel),lightMapUv:ke&&f(v.lightMap.channel),bumpMapUv:an&&f(v.bumpMap.channel),normalMapUv:Ne&&f(v.normalMap.channel),displacementMapUv:wn&&f(v.displacementMap.channel),emissiveMapUv:Se&&f(v.emissiveMap.channel),metalnessMapUv:gn&&f(v.metalnessMap.channel),roughnessMapUv:Ke&&f(v.roughnessMap.channel),anisotropyMapUv:qt&&f(v.anisotropyMap.channel),clearcoatMapUv:I&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:dt&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:xt&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:nt&&f(v.sheenRoughnessMap.channel),specularMapUv:st&&f(v.specularMap.channel),specularColorMapUv:pt&&f(v.specularColorMap.channel),specularIntensityMapUv:k&&f(v.specularIntensityMap.channel),transmissionMapUv:rt&&f(v.transmissionMap.channel),thicknessMapUv:it&&f(v.thicknessMap.channel),alphaMapUv:gt&&f(v.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ne||ln),vertexNormals:!!U.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!U.attributes.uv&&(Gt||gt),fog:!!V,useFog:v.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||U.attributes.normal===void 0&&Ne===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Mt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:ht,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:O.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:ut,decodeVideoTexture:Gt&&v.map.isVideoTexture===!0&&ve.getTransfer(v.map.colorSpace)===Ce,decodeVideoTextureEmissive:Se&&v.emissiveMap.isVideoTexture===!0&&ve.getTransfer(v.emissiveMap.colorSpace)===Ce,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===yi,flipSided:v.side===Yn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Kt&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Kt&&v.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return jt.vertexUv1s=l.has(1),jt.vertexUv2s=l.has(2),jt.vertexUv3s=l.has(3),l.clear(),jt}function y(v){let b=[];if(v.shaderID?b.push(v.shaderID):(b.push(v.customVertexShaderID),b.push(v.customFragmentShaderID)),v.defines!==void 0)for(let R in v.defines)b.push(R),b.push(v.defines[R]);return v.isRawShaderMaterial===!1&&(m(b,v),g(b,v),b.push(i.outputColorSpace)),b.push(v.customProgramCacheKey),b.join()}function m(v,b){v.push(b.precision),v.push(b.outputColorSpace),v.push(b.envMapMode),v.push(b.envMapPMREM),v.push(b.envMapMaxLod),v.push(b.envMapSize),v.push(b.mapUv),v.push(b.alphaMapUv),v.push(b.lightMapUv),v.push(b.aoMapUv),v.push(b.bumpMapUv),v.push(b.normalMapUv),v.push(b.displacementMapUv),v.push(b.emissiveMapUv),v.push(b.metalnessMapUv),v.push(b.roughnessMapUv),v.push(b.anisotropyMapUv),v.push(b.clearcoatMapUv),v.push(b.clearcoatNormalMapUv),v.push(b.clearcoatRoughnessMapUv),v.push(b.diffuseRoughnessMapUv),v.push(b.iridescenceMapUv),v.push(b.iridescenceThicknessMapUv),v.push(b.sheenColorMapUv),v.push(b.sheenRoughnessMapUv),v.push(b.specularMapUv),v.push(b.specularColorMapUv),v.push(b.specularIntensityMapUv),v.push(b.transmissionMapUv),v.push(b.thicknessMapUv),v.push(b.combine),v.push(b.fogExp2),v.push(b.sizeAttenuation),v.push(b.morphTargetsCount),v.push(b.numSunLights),v.push(b.numDirLights),v.push(b.numPointLights),v.push(b.numSpotLights),v.push(b.numSpotLightMaps),v.push(b.numHemiLights),v.push(b.numRectAreaLights),v.push(b.numSunLightShadows),v.push(b.numDirLightShadows),v.push(b.numPointLightShadows),v.push(b.numSpotLightShadows),v.push(b.numSpotLightShadowsWithMaps),v.push(b.numLightProbes),v.push(b.numLightProbeGrids),v.push(b.shadowMapType),v.push(b.toneMapping),v.push(b.numClippingPlanes),v.push(b.numClipIntersection),v.push(b.depthPacking)}function g(v,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function _(v){let b=d[v.type],R;if(b){let P=Ki[b];R=u0.clone(P.uniforms)}else R=v.uniforms;return R}function M(v,b){let R=h.get(b);return R!==void 0?++R.usedTimes:(R=new A1(i,b,v,s),c.push(R),h.set(b,R)),R}function x(v){if(--v.usedTimes===0){let b=c.indexOf(v);c[b]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function C(v){a.remove(v)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:_,acquireProgram:M,releaseProgram:x,releaseShaderCache:C,programs:c,dispose:T}}function I1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function L1(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function I0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function L0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,y,m,g){let _=i[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:m,group:g},i[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=y,_.renderOrder=d.renderOrder,_.z=m,_.group=g),t++,_}function l(d,f,p,y,m,g,_){_.reversedDepth===!0&&(m=-m);let M=a(d,f,p,y,m,g);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):e.push(M)}function c(d,f,p,y,m,g){let _=a(d,f,p,y,m,g);p.transmission>0?n.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function h(d,f){e.length>1&&e.sort(d||L1),n.length>1&&n.sort(f||I0),s.length>1&&s.sort(f||I0)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function D1(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new L0,i.set(n,[o])):s>=r.length?(o=new L0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function N1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new W,color:new Zt};break;case"SpotLight":e={position:new W,direction:new W,color:new Zt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new W,color:new Zt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new W,skyColor:new Zt,groundColor:new Zt};break;case"RectAreaLight":e={color:new Zt,position:new W,halfWidth:new W,halfHeight:new W};break}return i[t.id]=e,e}}}function U1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var F1=0;function O1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function B1(i){let t=new N1,e=U1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new W);let s=new W,r=new Re,o=new Re;function a(c){let h=0,u=0,d=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let f=0,p=0,y=0,m=0,g=0,_=0,M=0,x=0,C=0,T=0,v=0,b=0,R=0,P=0;c.sort(O1);for(let O=0,V=c.length;O<V;O++){let U=c[O],G=U.color,Z=U.intensity,X=U.distance,ct=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===$s?ct=U.shadow.map.texture:ct=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=G.r*Z,u+=G.g*Z,d+=G.b*Z;else if(U.isLightProbe){for(let B=0;B<9;B++)n.probe[B].addScaledVector(U.sh.coefficients[B],Z);P++}else if(U.isSunLight){let B=t.get(U);if(B.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let $=U.shadow,et=e.get(U);et.shadowIntensity=$.intensity,et.shadowBias=$.bias,et.shadowNormalBias=$.normalBias,et.shadowRadius=$.radius,et.shadowMapSize.copy($.mapSize).multiply($.getFrameExtents()),n.sunShadow[p]=et,n.sunShadowMap[p]=ct;let ht=$.getViewportCount();for(let at=0;at<ht;at++)n.sunShadowMatrix[y+at]=$.getMatrix(at),n.sunShadowCascade[y+at]=$._cascadeData[at];y+=ht,p++}n.sun[f]=B,f++}else if(U.isDirectionalLight){let B=t.get(U);if(B.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let $=U.shadow,et=e.get(U);et.shadowIntensity=$.intensity,et.shadowBias=$.bias,et.shadowNormalBias=$.normalBias,et.shadowRadius=$.radius,et.shadowMapSize=$.mapSize,n.directionalShadow[m]=et,n.directionalShadowMap[m]=ct,n.directionalShadowMatrix[m]=U.shadow.matrix,C++}n.directional[m]=B,m++}else if(U.isSpotLight){let B=t.get(U);B.position.setFromMatrixPosition(U.matrixWorld),B.color.copy(G).multiplyScalar(Z),B.distance=X,B.coneCos=Math.cos(U.angle),B.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),B.decay=U.decay,n.spot[_]=B;let $=U.shadow;if(U.map&&(n.spotLightMap[b]=U.map,b++,$.updateMatrices(U),U.castShadow&&R++),n.spotLightMatrix[_]=$.matrix,U.castShadow){let et=e.get(U);et.shadowIntensity=$.intensity,et.shadowBias=$.bias,et.shadowNormalBias=$.normalBias,et.shadowRadius=$.radius,et.shadowMapSize=$.mapSize,n.spotShadow[_]=et,n.spotShadowMap[_]=ct,v++}_++}else if(U.isRectAreaLight){let B=t.get(U);B.color.copy(G).multiplyScalar(Z),B.halfWidth.set(U.width*.5,0,0),B.halfHeight.set(0,U.height*.5,0),n.rectArea[M]=B,M++}else if(U.isPointLight){let B=t.get(U);if(B.color.copy(U.color).multiplyScalar(U.intensity),B.distance=U.distance,B.decay=U.decay,U.castShadow){let $=U.shadow,et=e.get(U);et.shadowIntensity=$.intensity,et.shadowBias=$.bias,et.shadowNormalBias=$.normalBias,et.shadowRadius=$.radius,et.shadowMapSize=$.mapSize,et.shadowCameraNear=$.camera.near,et.shadowCameraFar=$.camera.far,n.pointShadow[g]=et,n.pointShadowMap[g]=ct,n.pointShadowMatrix[g]=U.shadow.matrix,T++}n.point[g]=B,g++}else if(U.isHemisphereLight){let B=t.get(U);B.skyColor.copy(U.color).multiplyScalar(Z),B.groundColor.copy(U.groundColor).multiplyScalar(Z),n.hemi[x]=B,x++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Lt.LTC_FLOAT_1,n.rectAreaLTC2=Lt.LTC_FLOAT_2):(n.rectAreaLTC1=Lt.LTC_HALF_1,n.rectAreaLTC2=Lt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==_||L.rectAreaLength!==M||L.hemiLength!==x||L.numSunShadows!==p||L.numDirectionalShadows!==C||L.numPointShadows!==T||L.numSpotShadows!==v||L.numSpotMaps!==b||L.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=m,n.spot.length=_,n.rectArea.length=M,n.point.length=g,n.hemi.length=x,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+b-R,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=R,n.numLightProbes=P,L.sunLength=f,L.directionalLength=m,L.pointLength=g,L.spotLength=_,L.rectAreaLength=M,L.hemiLength=x,L.numSunShadows=p,L.numDirectionalShadows=C,L.numPointShadows=T,L.numSpotShadows=v,L.numSpotMaps=b,L.numLightProbes=P,n.version=F1++)}function l(c,h){let u=0,d=0,f=0,p=0,y=0,m=0,g=h.matrixWorldInverse;for(let _=0,M=c.length;_<M;_++){let x=c[_];if(x.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(x.matrixWorld),C.direction.transformDirection(g),u++}else if(x.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),d++}else if(x.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(x.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(x.isRectAreaLight){let C=n.rectArea[y];C.position.setFromMatrixPosition(x.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(x.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(x.width*.5,0,0),C.halfHeight.set(0,x.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(x.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(x.matrixWorld),C.position.applyMatrix4(g),f++}else if(x.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(x.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function D0(i){let t=new B1(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function k1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new D0(i),t.set(s,[a])):r>=o.length?(a=new D0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var z1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,G1=`uniform sampler2D shadow_pass;
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
}`,V1=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],H1=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],N0=new Re,Za=new W,lf=new W;function W1(i,t,e){let n=new ks,s=new Xt,r=new Xt,o=new Ye,a=new Lc,l=new Dc,c={},h=e.maxTextureSize,u={[Yi]:Yn,[Yn]:Yi,[yi]:yi},d=new $i({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xt},radius:{value:4}},vertexShader:z1,fragmentShader:G1}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new nn;p.setAttribute("position",new on(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Nn(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ga;let g=this.type;this.render=function(T,v,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;this.type===bg&&($t("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ga);let R=i.getRenderTarget(),P=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),O=i.state;O.setBlending(xr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let V=g!==this.type;V&&v.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(G=>G.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,G=T.length;U<G;U++){let Z=T[U],X=Z.shadow;if(X===void 0){$t("WebGLShadowMap:",Z,"has no shadow.");continue}if(X.autoUpdate===!1&&X.needsUpdate===!1)continue;s.copy(X.mapSize);let ct=X.getFrameExtents();s.multiply(ct),r.copy(X.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,X.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,X.mapSize.y=r.y));let B=i.state.buffers.depth.getReversed();if(X.camera._reversedDepth=B,X.map===null||V===!0){if(X.map!==null&&(X.map.depthTexture!==null&&(X.map.depthTexture.dispose(),X.map.depthTexture=null),X.map.dispose()),this.type===Eo){if(Z.isPointLight){$t("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}X.map=new hi(s.x,s.y,{format:$s,type:Li,minFilter:$n,magFilter:$n,generateMipmaps:!1}),X.map.texture.name=Z.name+".shadowMap",X.map.depthTexture=new _s(s.x,s.y,xi),X.map.depthTexture.name=Z.name+".shadowMapDepth",X.map.depthTexture.format=fs,X.map.depthTexture.compareFunction=null,X.map.depthTexture.minFilter=Pn,X.map.depthTexture.magFilter=Pn}else Z.isPointLight?(X.map=new Ka(s.x),X.map.depthTexture=new Ta(s.x,Ii)):(X.map=new hi(s.x,s.y),X.map.depthTexture=new _s(s.x,s.y,Ii)),X.map.depthTexture.name=Z.name+".shadowMap",X.map.depthTexture.format=fs,this.type===Ga?(X.map.depthTexture.compareFunction=B?Zd:Yd,X.map.depthTexture.minFilter=$n,X.map.depthTexture.magFilter=$n):(X.map.depthTexture.compareFunction=null,X.map.depthTexture.minFilter=Pn,X.map.depthTexture.magFilter=Pn);X.camera.updateProjectionMatrix()}X.map.isWebGLCubeRenderTarget!==!0&&(X.map.width!==s.x||X.map.height!==s.y)&&X.map.setSize(s.x,s.y);let $=X.map.isWebGLCubeRenderTarget?6:X.getViewportCount();Z.isPointLight!==!0&&X.updateMatrices(Z,b);let et=(X.camera.layers.mask&4294967294)!==0?X.camera.layers:b.layers;for(let ht=0;ht<$;ht++){let at=X.getCamera(ht);if(Z.isPointLight){let Q=X.camera,mt=X.matrix,yt=Z.distance||Q.far;yt!==Q.far&&(Q.far=yt,Q.updateProjectionMatrix()),Za.setFromMatrixPosition(Z.matrixWorld),Q.position.copy(Za),lf.copy(Q.position),lf.add(V1[ht]),Q.up.copy(H1[ht]),Q.lookAt(lf),Q.updateMatrixWorld(),mt.makeTranslation(-Za.x,-Za.y,-Za.z),N0.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),X._frustum.setFromProjectionMatrix(N0,Q.coordinateSystem,Q.reversedDepth)}if(X.map.isWebGLCubeRenderTarget)i.setRenderTarget(X.map,ht),i.clear();else{ht===0&&(i.setRenderTarget(X.map),i.clear());let Q=X.getViewport(ht);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),O.viewport(o)}n=X.getFrustum(ht),x(v,b,at,Z,et,this.type)}X.isPointLightShadow!==!0&&this.type===Eo&&_(X,b),X.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(R,P,L)};function _(T,v){let b=t.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new hi(s.x,s.y,{format:$s,type:Li}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(v,null,b,d,y,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(v,null,b,f,y,null)}function M(T,v,b,R){let P=null,L=b.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(L!==void 0)P=L;else if(P=b.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let O=P.uuid,V=v.uuid,U=c[O];U===void 0&&(U={},c[O]=U);let G=U[V];G===void 0&&(G=P.clone(),U[V]=G,v.addEventListener("dispose",C)),P=G}if(P.visible=v.visible,P.wireframe=v.wireframe,R===Eo?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:u[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,b.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let O=i.properties.get(P);O.light=b}return P}function x(T,v,b,R,P,L){if(T.visible===!1)return;if(T.layers.test(P)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&L===Eo)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,T.matrixWorld);let U=t.update(T),G=T.material;if(Array.isArray(G)){let Z=U.groups;for(let X=0,ct=Z.length;X<ct;X++){let B=Z[X],$=G[B.materialIndex];if($&&$.visible){let et=M(T,$,R,L);T.onBeforeShadow(i,T,v,b,U,et,B),i.renderBufferDirect(b,null,U,et,T,B),T.onAfterShadow(i,T,v,b,U,et,B)}}}else if(G.visible){let Z=M(T,G,R,L);T.onBeforeShadow(i,T,v,b,U,Z,null),i.renderBufferDirect(b,null,U,Z,T,null),T.onAfterShadow(i,T,v,b,U,Z,null)}}let V=T.children;for(let U=0,G=V.length;U<G;U++)x(V[U],v,b,R,P,L)}function C(T){T.target.removeEventListener("dispose",C);for(let b in c){let R=c[b],P=T.target.uuid;P in R&&(R[P].dispose(),delete R[P])}}}function X1(i,t){function e(){let k=!1,rt=new Ye,it=null,wt=new Ye(0,0,0,0);return{setMask:function(gt){it!==gt&&!k&&(i.colorMask(gt,gt,gt,gt),it=gt)},setLocked:function(gt){k=gt},setClear:function(gt,St,Vt,Kt,ut){ut===!0&&(gt*=Kt,St*=Kt,Vt*=Kt),rt.set(gt,St,Vt,Kt),wt.equals(rt)===!1&&(i.clearColor(gt,St,Vt,Kt),wt.copy(rt))},reset:function(){k=!1,it=null,wt.set(-1,0,0,0)}}}function n(){let k=!1,rt=!1,it=null,wt=null,gt=null;return{setReversed:function(St){if(rt!==St){let Vt=t.get("EXT_clip_control");St?Vt.clipControlEXT(Vt.LOWER_LEFT_EXT,Vt.ZERO_TO_ONE_EXT):Vt.clipControlEXT(Vt.LOWER_LEFT_EXT,Vt.NEGATIVE_ONE_TO_ONE_EXT),rt=St;let Kt=gt;gt=null,this.setClear(Kt)}},getReversed:function(){return rt},setTest:function(St){St?Mt(i.DEPTH_TEST):Ht(i.DEPTH_TEST)},setMask:function(St){it!==St&&!k&&(i.depthMask(St),it=St)},setFunc:function(St){if(rt&&(St=i0[St]),wt!==St){switch(St){case pc:i.depthFunc(i.NEVER);break;case mc:i.depthFunc(i.ALWAYS);break;case gc:i.depthFunc(i.LESS);break;case po:i.depthFunc(i.LEQUAL);break;case _c:i.depthFunc(i.EQUAL);break;case yc:i.depthFunc(i.GEQUAL);break;case xc:i.depthFunc(i.GREATER);break;case vc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}wt=St}},setLocked:function(St){k=St},setClear:function(St){gt!==St&&(gt=St,rt&&(St=1-St),i.clearDepth(St))},reset:function(){k=!1,it=null,wt=null,gt=null,rt=!1}}}function s(){let k=!1,rt=null,it=null,wt=null,gt=null,St=null,Vt=null,Kt=null,ut=null;return{setTest:function(Ot){k||(Ot?Mt(i.STENCIL_TEST):Ht(i.STENCIL_TEST))},setMask:function(Ot){rt!==Ot&&!k&&(i.stencilMask(Ot),rt=Ot)},setFunc:function(Ot,jt,Ct){(it!==Ot||wt!==jt||gt!==Ct)&&(i.stencilFunc(Ot,jt,Ct),it=Ot,wt=jt,gt=Ct)},setOp:function(Ot,jt,Ct){(St!==Ot||Vt!==jt||Kt!==Ct)&&(i.stencilOp(Ot,jt,Ct),St=Ot,Vt=jt,Kt=Ct)},setLocked:function(Ot){k=Ot},setClear:function(Ot){ut!==Ot&&(i.clearStencil(Ot),ut=Ot)},reset:function(){k=!1,rt=null,it=null,wt=null,gt=null,St=null,Vt=null,Kt=null,ut=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],y=null,m=!1,g=null,_=null,M=null,x=null,C=null,T=null,v=null,b=new Zt(0,0,0),R=0,P=!1,L=null,O=null,V=null,U=null,G=null,Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),X=!1,ct=0,B=i.getParameter(i.VERSION);B.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(B)[1]),X=ct>=1):B.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(B)[1]),X=ct>=2);let $=null,et={},ht=i.getParameter(i.SCISSOR_BOX),at=i.getParameter(i.VIEWPORT),Q=new Ye().fromArray(ht),mt=new Ye().fromArray(at);function yt(k,rt,it,wt){let gt=new Uint8Array(4),St=i.createTexture();i.bindTexture(k,St),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Vt=0;Vt<it;Vt++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,wt,0,i.RGBA,i.UNSIGNED_BYTE,gt):i.texImage2D(rt+Vt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,gt);return St}let At={};At[i.TEXTURE_2D]=yt(i.TEXTURE_2D,i.TEXTURE_2D,1),At[i.TEXTURE_CUBE_MAP]=yt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[i.TEXTURE_2D_ARRAY]=yt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),At[i.TEXTURE_3D]=yt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(i.DEPTH_TEST),o.setFunc(po),an(!1),Ne(Cd),Mt(i.CULL_FACE),qe(xr);function Mt(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function Ht(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function se(k,rt){return d[k]!==rt?(i.bindFramebuffer(k,rt),d[k]=rt,k===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=rt),k===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Gt(k,rt){let it=p,wt=!1;if(k){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let gt=k.textures;if(it.length!==gt.length||it[0]!==i.COLOR_ATTACHMENT0){for(let St=0,Vt=gt.length;St<Vt;St++)it[St]=i.COLOR_ATTACHMENT0+St;it.length=gt.length,wt=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,wt=!0);wt&&i.drawBuffers(it)}function de(k){return y!==k?(i.useProgram(k),y=k,!0):!1}let le={[vr]:i.FUNC_ADD,[Tg]:i.FUNC_SUBTRACT,[Eg]:i.FUNC_REVERSE_SUBTRACT};le[Ag]=i.MIN,le[Cg]=i.MAX;let ne={[Rg]:i.ZERO,[Pg]:i.ONE,[Ig]:i.SRC_COLOR,[Ld]:i.SRC_ALPHA,[Og]:i.SRC_ALPHA_SATURATE,[Ug]:i.DST_COLOR,[Dg]:i.DST_ALPHA,[Lg]:i.ONE_MINUS_SRC_COLOR,[Dd]:i.ONE_MINUS_SRC_ALPHA,[Fg]:i.ONE_MINUS_DST_COLOR,[Ng]:i.ONE_MINUS_DST_ALPHA,[Bg]:i.CONSTANT_COLOR,[kg]:i.ONE_MINUS_CONSTANT_COLOR,[zg]:i.CONSTANT_ALPHA,[Gg]:i.ONE_MINUS_CONSTANT_ALPHA};function qe(k,rt,it,wt,gt,St,Vt,Kt,ut,Ot){if(k===xr){m===!0&&(Ht(i.BLEND),m=!1);return}if(m===!1&&(Mt(i.BLEND),m=!0),k!==wg){if(k!==g||Ot!==P){if((_!==vr||C!==vr)&&(i.blendEquation(i.FUNC_ADD),_=vr,C=vr),Ot)switch(k){case Ao:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Rd:i.blendFunc(i.ONE,i.ONE);break;case Pd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Id:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:te("WebGLState: Invalid blending: ",k);break}else switch(k){case Ao:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Rd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Pd:te("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Id:te("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:te("WebGLState: Invalid blending: ",k);break}M=null,x=null,T=null,v=null,b.set(0,0,0),R=0,g=k,P=Ot}return}gt=gt||rt,St=St||it,Vt=Vt||wt,(rt!==_||gt!==C)&&(i.blendEquationSeparate(le[rt],le[gt]),_=rt,C=gt),(it!==M||wt!==x||St!==T||Vt!==v)&&(i.blendFuncSeparate(ne[it],ne[wt],ne[St],ne[Vt]),M=it,x=wt,T=St,v=Vt),(Kt.equals(b)===!1||ut!==R)&&(i.blendColor(Kt.r,Kt.g,Kt.b,ut),b.copy(Kt),R=ut),g=k,P=!1}function ke(k,rt){k.side===yi?Ht(i.CULL_FACE):Mt(i.CULL_FACE);let it=k.side===Yn;rt&&(it=!it),an(it),k.blending===Ao&&k.transparent===!1?qe(xr):qe(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let wt=k.stencilWrite;a.setTest(wt),wt&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Se(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Mt(i.SAMPLE_ALPHA_TO_COVERAGE):Ht(i.SAMPLE_ALPHA_TO_COVERAGE)}function an(k){L!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),L=k)}function Ne(k){k!==Sg?(Mt(i.CULL_FACE),k!==O&&(k===Cd?i.cullFace(i.BACK):k===Mg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ht(i.CULL_FACE),O=k}function wn(k){k!==V&&(X&&i.lineWidth(k),V=k)}function Se(k,rt,it){k?(Mt(i.POLYGON_OFFSET_FILL),(U!==rt||G!==it)&&(U=rt,G=it,o.getReversed()&&(rt=-rt,it=-it),i.polygonOffset(rt,it))):Ht(i.POLYGON_OFFSET_FILL)}function gn(k){k?Mt(i.SCISSOR_TEST):Ht(i.SCISSOR_TEST)}function Ke(k){k===void 0&&(k=i.TEXTURE0+Z-1),$!==k&&(i.activeTexture(k),$=k)}function ln(k,rt,it){it===void 0&&($===null?it=i.TEXTURE0+Z-1:it=$);let wt=et[it];wt===void 0&&(wt={type:void 0,texture:void 0},et[it]=wt),(wt.type!==k||wt.texture!==rt)&&($!==it&&(i.activeTexture(it),$=it),i.bindTexture(k,rt||At[k]),wt.type=k,wt.texture=rt)}function z(){let k=et[$];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Rt(){try{i.compressedTexImage2D(...arguments)}catch(k){te("WebGLState:",k)}}function Yt(){try{i.compressedTexImage3D(...arguments)}catch(k){te("WebGLState:",k)}}function re(){try{i.texSubImage2D(...arguments)}catch(k){te("WebGLState:",k)}}function bt(){try{i.texSubImage3D(...arguments)}catch(k){te("WebGLState:",k)}}function Fe(){try{i.compressedTexSubImage2D(...arguments)}catch(k){te("WebGLState:",k)}}function zt(){try{i.compressedTexSubImage3D(...arguments)}catch(k){te("WebGLState:",k)}}function qt(){try{i.texStorage2D(...arguments)}catch(k){te("WebGLState:",k)}}function I(){try{i.texStorage3D(...arguments)}catch(k){te("WebGLState:",k)}}function w(){try{i.texImage2D(...arguments)}catch(k){te("WebGLState:",k)}}function Y(){try{i.texImage3D(...arguments)}catch(k){te("WebGLState:",k)}}function dt(k){return u[k]!==void 0?u[k]:i.getParameter(k)}function ot(k,rt){u[k]!==rt&&(i.pixelStorei(k,rt),u[k]=rt)}function _t(k){Q.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),Q.copy(k))}function xt(k){mt.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),mt.copy(k))}function nt(k,rt){let it=c.get(rt);it===void 0&&(it=new WeakMap,c.set(rt,it));let wt=it.get(k);wt===void 0&&(wt=i.getUniformBlockIndex(rt,k.name),i.uniformBlockBinding(rt,wt,wt),it.set(k,wt))}function st(k,rt,it){let gt=c.get(rt).get(k);l[gt]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,gt,it),l[gt]=it)}function pt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},$=null,et={},d={},l={},f=new WeakMap,p=[],y=null,m=!1,g=null,_=null,M=null,x=null,C=null,T=null,v=null,b=new Zt(0,0,0),R=0,P=!1,L=null,O=null,V=null,U=null,G=null,Q.set(0,0,i.canvas.width,i.canvas.height),mt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Ht,bindFramebuffer:se,drawBuffers:Gt,useProgram:de,setBlending:qe,setMaterial:ke,setFlipSided:an,setCullFace:Ne,setLineWidth:wn,setPolygonOffset:Se,setScissorTest:gn,activeTexture:Ke,bindTexture:ln,unbindTexture:z,compressedTexImage2D:Rt,compressedTexImage3D:Yt,texImage2D:w,texImage3D:Y,pixelStorei:ot,getParameter:dt,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:qt,texStorage3D:I,texSubImage2D:re,texSubImage3D:bt,compressedTexSubImage2D:Fe,compressedTexSubImage3D:zt,scissor:_t,viewport:xt,reset:pt}}function q1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xt,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,y=new FinalizationRegistry(I=>p.delete(I)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,w){return m?new OffscreenCanvas(I,w):pa("canvas")}function _(I,w,Y){let dt=1,ot=qt(I);if((ot.width>Y||ot.height>Y)&&(dt=Y/Math.max(ot.width,ot.height)),dt<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let _t=Math.floor(dt*ot.width),xt=Math.floor(dt*ot.height);d===void 0&&(d=g(_t,xt));let nt=w?g(_t,xt):d;return nt.width=_t,nt.height=xt,nt.getContext("2d").drawImage(I,0,0,_t,xt),$t("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+_t+"x"+xt+")."),nt}else return"data"in I&&$t("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),I;return I}function M(I){return I.generateMipmaps}function x(I){i.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(I,w,Y,dt,ot,_t=!1){if(I!==null){if(i[I]!==void 0)return i[I];$t("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let xt;dt&&(xt=t.get("EXT_texture_norm16"),xt||$t("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=w;if(w===i.RED&&(Y===i.FLOAT&&(nt=i.R32F),Y===i.HALF_FLOAT&&(nt=i.R16F),Y===i.UNSIGNED_BYTE&&(nt=i.R8),Y===i.UNSIGNED_SHORT&&xt&&(nt=xt.R16_EXT),Y===i.SHORT&&xt&&(nt=xt.R16_SNORM_EXT)),w===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.R8UI),Y===i.UNSIGNED_SHORT&&(nt=i.R16UI),Y===i.UNSIGNED_INT&&(nt=i.R32UI),Y===i.BYTE&&(nt=i.R8I),Y===i.SHORT&&(nt=i.R16I),Y===i.INT&&(nt=i.R32I)),w===i.RG&&(Y===i.FLOAT&&(nt=i.RG32F),Y===i.HALF_FLOAT&&(nt=i.RG16F),Y===i.UNSIGNED_BYTE&&(nt=i.RG8),Y===i.UNSIGNED_SHORT&&xt&&(nt=xt.RG16_EXT),Y===i.SHORT&&xt&&(nt=xt.RG16_SNORM_EXT)),w===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RG8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RG16UI),Y===i.UNSIGNED_INT&&(nt=i.RG32UI),Y===i.BYTE&&(nt=i.RG8I),Y===i.SHORT&&(nt=i.RG16I),Y===i.INT&&(nt=i.RG32I)),w===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),Y===i.UNSIGNED_INT&&(nt=i.RGB32UI),Y===i.BYTE&&(nt=i.RGB8I),Y===i.SHORT&&(nt=i.RGB16I),Y===i.INT&&(nt=i.RGB32I)),w===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),Y===i.UNSIGNED_INT&&(nt=i.RGBA32UI),Y===i.BYTE&&(nt=i.RGBA8I),Y===i.SHORT&&(nt=i.RGBA16I),Y===i.INT&&(nt=i.RGBA32I)),w===i.RGB&&(Y===i.UNSIGNED_SHORT&&xt&&(nt=xt.RGB16_EXT),Y===i.SHORT&&xt&&(nt=xt.RGB16_SNORM_EXT),Y===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),Y===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),w===i.RGBA){let st=_t?fa:ve.getTransfer(ot);Y===i.FLOAT&&(nt=i.RGBA32F),Y===i.HALF_FLOAT&&(nt=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(nt=st===Ce?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT&&xt&&(nt=xt.RGBA16_EXT),Y===i.SHORT&&xt&&(nt=xt.RGBA16_SNORM_EXT),Y===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function v(I,w){let Y;return I?w===null||w===Ii||w===Mr?Y=i.DEPTH24_STENCIL8:w===xi?Y=i.DEPTH32F_STENCIL8:w===Ro&&(Y=i.DEPTH24_STENCIL8,$t("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Ii||w===Mr?Y=i.DEPTH_COMPONENT24:w===xi?Y=i.DEPTH_COMPONENT32F:w===Ro&&(Y=i.DEPTH_COMPONENT16),Y}function b(I,w){return M(I)===!0||I.isFramebufferTexture&&I.minFilter!==Pn&&I.minFilter!==$n?Math.log2(Math.max(w.width,w.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?w.mipmaps.length:1}function R(I){let w=new WeakRef(I);n.get(I).__ref=w,p.add(w),y.register(I,w,w)}function P(I){let w=n.get(I).__ref;w!==void 0&&(p.delete(w),y.unregister(w))}function L(I){V(I.target)}function O(I){U(I.target)}function V(I){I.removeEventListener("dispose",L),P(I),Z(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&u.delete(I)}function U(I){I.removeEventListener("dispose",O),P(I),ct(I)}function G(){for(let I of p){let w=I.deref();w!==void 0&&(w.isRenderTarget===!0?U(w):V(w))}p.clear(),u.clear()}function Z(I){let w=n.get(I);if(w.__webglInit===void 0)return;let Y=I.source,dt=f.get(Y);if(dt){let ot=dt[w.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&X(I),Object.keys(dt).length===0&&f.delete(Y)}n.remove(I)}function X(I){let w=n.get(I);i.deleteTexture(w.__webglTexture);let Y=I.source,dt=f.get(Y);delete dt[w.__cacheKey],o.memory.textures--}function ct(I){let w=n.get(I);w.__depthDisposeCallback&&w.__depthDisposeCallback();let Y=I.depthTexture;if(Y&&Y.renderTarget===I&&V(Y),I.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(w.__webglFramebuffer[ot]))for(let _t=0;_t<w.__webglFramebuffer[ot].length;_t++)i.deleteFramebuffer(w.__webglFramebuffer[ot][_t]);else i.deleteFramebuffer(w.__webglFramebuffer[ot]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[ot])}else{if(Array.isArray(w.__webglFramebuffer))for(let ot=0;ot<w.__webglFramebuffer.length;ot++)i.deleteFramebuffer(w.__webglFramebuffer[ot]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ot=0;ot<w.__webglColorRenderbuffer.length;ot++)w.__webglColorRenderbuffer[ot]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[ot]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let dt=I.textures;for(let ot=0,_t=dt.length;ot<_t;ot++){let xt=n.get(dt[ot]);xt.__webglTexture&&(i.deleteTexture(xt.__webglTexture),o.memory.textures--),n.remove(dt[ot])}n.remove(I)}let B=0;function $(){B=0}function et(){return B}function ht(I){B=I}function at(){let I=B;return I>=s.maxTextures&&$t("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),B+=1,I}function Q(I){let w=[];return w.push(I.wrapS),w.push(I.wrapT),w.push(I.wrapR||0),w.push(I.magFilter),w.push(I.minFilter),w.push(I.anisotropy),w.push(I.internalFormat),w.push(I.format),w.push(I.type),w.push(I.generateMipmaps),w.push(I.mipmapsAutoUpdate),w.push(I.premultiplyAlpha),w.push(I.flipY),w.push(I.unpackAlignment),w.push(I.colorSpace),w.join()}function mt(I,w){let Y=n.get(I);if(I.isVideoTexture&&Fe(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&Y.__version!==I.version){let dt=I.image;if(dt===null)$t("WebGLRenderer: Texture marked for update but no image data found.");else if(dt.complete===!1)$t("WebGLRenderer: Texture marked for update but image is incomplete");else{ke(Y,I,w);return}}else I.isExternalTexture&&(Y.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+w)}function yt(I,w){let Y=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&Y.__version!==I.version){ke(Y,I,w);return}else I.isExternalTexture&&(Y.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+w)}function At(I,w){let Y=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&Y.__version!==I.version){ke(Y,I,w);return}e.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+w)}function Mt(I,w){let Y=n.get(I);if(I.version>0&&Y.__version!==I.version){an(Y,I,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+w)}let Ht={[Sc]:i.REPEAT,[Wi]:i.CLAMP_TO_EDGE,[Mc]:i.MIRRORED_REPEAT},se={[Pn]:i.NEAREST,[Wg]:i.NEAREST_MIPMAP_NEAREST,[Va]:i.NEAREST_MIPMAP_LINEAR,[$n]:i.LINEAR,[Zc]:i.LINEAR_MIPMAP_NEAREST,[ys]:i.LINEAR_MIPMAP_LINEAR},Gt={[Yg]:i.NEVER,[Jd]:i.ALWAYS,[Zg]:i.LESS,[Yd]:i.LEQUAL,[Jg]:i.EQUAL,[Zd]:i.GEQUAL,[Kg]:i.GREATER,[jg]:i.NOTEQUAL};function de(I,w){if(w.type===xi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===$n||w.magFilter===Zc||w.magFilter===Va||w.magFilter===ys||w.minFilter===$n||w.minFilter===Zc||w.minFilter===Va||w.minFilter===ys)&&$t("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,Ht[w.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,Ht[w.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,Ht[w.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,se[w.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,se[w.minFilter]),w.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Gt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Pn||w.minFilter!==Va&&w.minFilter!==ys||w.type===xi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");i.texParameterf(I,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function le(I,w){let Y=!1;I.__webglInit===void 0&&(I.__webglInit=!0,w.addEventListener("dispose",L),R(w));let dt=w.source,ot=f.get(dt);ot===void 0&&(ot={},f.set(dt,ot));let _t=Q(w);if(_t!==I.__cacheKey){ot[_t]===void 0&&(ot[_t]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),ot[_t].usedTimes++;let xt=ot[I.__cacheKey];xt!==void 0&&(ot[I.__cacheKey].usedTimes--,xt.usedTimes===0&&X(w)),I.__cacheKey=_t,I.__webglTexture=ot[_t].texture}return Y}function ne(I,w,Y){return Math.floor(Math.floor(I/Y)/w)}function qe(I,w,Y,dt){let _t=I.updateRanges;if(_t.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,Y,dt,w.data);else{_t.sort((k,rt)=>k.start-rt.start);let xt=0;for(let k=1;k<_t.length;k++){let rt=_t[xt],it=_t[k],wt=rt.start+rt.count,gt=ne(it.start,w.width,4),St=ne(rt.start,w.width,4);it.start<=wt+1&&gt===St&&ne(it.start+it.count-1,w.width,4)===gt?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++xt,_t[xt]=it)}_t.length=xt+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),pt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let k=0,rt=_t.length;k<rt;k++){let it=_t[k],wt=Math.floor(it.start/4),gt=Math.ceil(it.count/4),St=wt%w.width,Vt=Math.floor(wt/w.width),Kt=gt,ut=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,St),e.pixelStorei(i.UNPACK_SKIP_ROWS,Vt),e.texSubImage2D(i.TEXTURE_2D,0,St,Vt,Kt,ut,Y,dt,w.data)}I.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,pt)}}function ke(I,w,Y){let dt=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(dt=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(dt=i.TEXTURE_3D);let ot=le(I,w),_t=w.source;e.bindTexture(dt,I.__webglTexture,i.TEXTURE0+Y);let xt=n.get(_t);if(_t.version!==xt.__version||ot===!0){if(e.activeTexture(i.TEXTURE0+Y),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ut=ve.getPrimaries(ve.workingColorSpace),Ot=w.colorSpace===vs?null:ve.getPrimaries(w.colorSpace),jt=w.colorSpace===vs||ut===Ot?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,jt)}e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let st=_(w.image,!1,s.maxTextureSize);st=zt(w,st);let pt=r.convert(w.format,w.colorSpace),k=r.convert(w.type),rt=T(w.internalFormat,pt,k,w.normalized,w.colorSpace,w.isVideoTexture);de(dt,w);let it,wt=w.mipmaps,gt=w.isVideoTexture!==!0,St=xt.__version===void 0||ot===!0,Vt=_t.dataReady,Kt=b(w,st);if(w.isDepthTexture)rt=v(w.format===xs,w.type),St&&(gt?e.texStorage2D(i.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,pt,k,null));else if(w.isDataTexture)if(wt.length>0){gt&&St&&e.texStorage2D(i.TEXTURE_2D,Kt,rt,wt[0].width,wt[0].height);for(let ut=0,Ot=wt.length;ut<Ot;ut++)it=wt[ut],gt?Vt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,pt,k,it.data):e.texImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,pt,k,it.data);w.generateMipmaps=!1}else gt?(St&&e.texStorage2D(i.TEXTURE_2D,Kt,rt,st.width,st.height),Vt&&qe(w,st,pt,k)):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,pt,k,st.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){gt&&St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Kt,rt,wt[0].width,wt[0].height,st.depth);for(let ut=0,Ot=wt.length;ut<Ot;ut++)if(it=wt[ut],w.format!==Di)if(pt!==null)if(gt){if(Vt)if(w.layerUpdates.size>0){let jt=of(it.width,it.height,w.format,w.type);for(let Ct of w.layerUpdates){let ae=it.data.subarray(Ct*jt/it.data.BYTES_PER_ELEMENT,(Ct+1)*jt/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,Ct,it.width,it.height,1,pt,ae)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,pt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ut,rt,it.width,it.height,st.depth,0,it.data,0,0);else $t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else gt?Vt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,pt,k,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ut,rt,it.width,it.height,st.depth,0,pt,k,it.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{gt&&St&&e.texStorage2D(i.TEXTURE_2D,Kt,rt,wt[0].width,wt[0].height);for(let ut=0,Ot=wt.length;ut<Ot;ut++)it=wt[ut],w.format!==Di?pt!==null?gt?Vt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,pt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,it.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):gt?Vt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,pt,k,it.data):e.texImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,pt,k,it.data)}else if(w.isDataArrayTexture)if(gt){if(St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Kt,rt,st.width,st.height,st.depth),Vt)if(w.layerUpdates.size>0){let ut=of(st.width,st.height,w.format,w.type);for(let Ot of w.layerUpdates){let jt=st.data.subarray(Ot*ut/st.data.BYTES_PER_ELEMENT,(Ot+1)*ut/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ot,st.width,st.height,1,pt,k,jt)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,pt,k,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,pt,k,st.data);else if(w.isData3DTexture)gt?(St&&e.texStorage3D(i.TEXTURE_3D,Kt,rt,st.width,st.height,st.depth),Vt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,pt,k,st.data)):e.texImage3D(i.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,pt,k,st.data);else if(w.isFramebufferTexture){if(St)if(gt)e.texStorage2D(i.TEXTURE_2D,Kt,rt,st.width,st.height);else{let ut=st.width,Ot=st.height;for(let jt=0;jt<Kt;jt++)e.texImage2D(i.TEXTURE_2D,jt,rt,ut,Ot,0,pt,k,null),ut>>=1,Ot>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let ut=i.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),st.parentNode!==ut){ut.appendChild(st),u.add(w),ut.onpaint=Ot=>{let jt=Ot.changedElements;for(let Ct of u)jt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ut.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let jt=i.RGBA,Ct=i.RGBA,ae=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,jt,Ct,ae,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(wt.length>0){if(gt&&St){let ut=qt(wt[0]);e.texStorage2D(i.TEXTURE_2D,Kt,rt,ut.width,ut.height)}for(let ut=0,Ot=wt.length;ut<Ot;ut++)it=wt[ut],gt?Vt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,pt,k,it):e.texImage2D(i.TEXTURE_2D,ut,rt,pt,k,it);w.generateMipmaps=!1}else if(gt){if(St){let ut=qt(st);e.texStorage2D(i.TEXTURE_2D,Kt,rt,ut.width,ut.height)}Vt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,pt,k,st)}else e.texImage2D(i.TEXTURE_2D,0,rt,pt,k,st);M(w)&&w.mipmapsAutoUpdate===!0&&x(dt),xt.__version=_t.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function an(I,w,Y){if(w.image.length!==6)return;let dt=le(I,w),ot=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+Y);let _t=n.get(ot);if(ot.version!==_t.__version||dt===!0){e.activeTexture(i.TEXTURE0+Y);let xt=ve.getPrimaries(ve.workingColorSpace),nt=w.colorSpace===vs?null:ve.getPrimaries(w.colorSpace),st=w.colorSpace===vs||xt===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let pt=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!pt&&!k?rt[Ct]=_(w.image[Ct],!0,s.maxCubemapSize):rt[Ct]=k?w.image[Ct].image:w.image[Ct],rt[Ct]=zt(w,rt[Ct]);let it=rt[0],wt=r.convert(w.format,w.colorSpace),gt=r.convert(w.type),St=T(w.internalFormat,wt,gt,w.normalized,w.colorSpace),Vt=w.isVideoTexture!==!0,Kt=_t.__version===void 0||dt===!0,ut=ot.dataReady,Ot=b(w,it);de(i.TEXTURE_CUBE_MAP,w);let jt;if(w.isDepthTexture){if(St=v(w.format===xs,w.type),Kt)if(Vt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,St,it.width,it.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,it.width,it.height,0,wt,gt,null)}else if(pt){Vt&&Kt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,St,it.width,it.height);for(let Ct=0;Ct<6;Ct++){jt=rt[Ct].mipmaps;for(let ae=0;ae<jt.length;ae++){let ze=jt[ae];w.format!==Di?wt!==null?Vt?ut&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,0,0,ze.width,ze.height,wt,ze.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,St,ze.width,ze.height,0,ze.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Vt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,0,0,ze.width,ze.height,wt,gt,ze.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae,St,ze.width,ze.height,0,wt,gt,ze.data)}}}else{if(jt=w.mipmaps,Vt&&Kt){jt.length>0&&Ot++;let Ct=qt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Ot,St,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(k){Vt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,wt,gt,rt[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,rt[Ct].width,rt[Ct].height,0,wt,gt,rt[Ct].data);for(let ae=0;ae<jt.length;ae++){let zn=jt[ae].image[Ct].image;Vt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,0,0,zn.width,zn.height,wt,gt,zn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,St,zn.width,zn.height,0,wt,gt,zn.data)}}else{Vt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,wt,gt,rt[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,wt,gt,rt[Ct]);for(let ae=0;ae<jt.length;ae++){let ze=jt[ae];Vt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,0,0,wt,gt,ze.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ae+1,St,wt,gt,ze.image[Ct])}}}M(w)&&w.mipmapsAutoUpdate===!0&&x(i.TEXTURE_CUBE_MAP),_t.__version=ot.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function Ne(I,w,Y,dt,ot,_t){let xt=r.convert(Y.format,Y.colorSpace),nt=r.convert(Y.type),st=T(Y.internalFormat,xt,nt,Y.normalized,Y.colorSpace),pt=n.get(w),k=n.get(Y);if(k.__renderTarget=w,!pt.__hasExternalTextures){let rt=Math.max(1,w.width>>_t),it=Math.max(1,w.height>>_t);ot===i.TEXTURE_3D||ot===i.TEXTURE_2D_ARRAY?e.texImage3D(ot,_t,st,rt,it,w.depth,0,xt,nt,null):e.texImage2D(ot,_t,st,rt,it,0,xt,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,I),bt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,dt,ot,k.__webglTexture,0,re(w)):(ot===i.TEXTURE_2D||ot>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,dt,ot,k.__webglTexture,_t),e.bindFramebuffer(i.FRAMEBUFFER,null)}function wn(I,w,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,I),w.depthBuffer){let dt=w.depthTexture,ot=dt&&dt.isDepthTexture?dt.type:null,_t=v(w.stencilBuffer,ot),xt=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;bt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,re(w),_t,w.width,w.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,re(w),_t,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,_t,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,xt,i.RENDERBUFFER,I)}else{let dt=w.textures;for(let ot=0;ot<dt.length;ot++){let _t=dt[ot],xt=r.convert(_t.format,_t.colorSpace),nt=r.convert(_t.type),st=T(_t.internalFormat,xt,nt,_t.normalized,_t.colorSpace);bt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,re(w),st,w.width,w.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,re(w),st,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,st,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Se(I,w,Y){let dt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,I),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=n.get(w.depthTexture);ot.__renderTarget=w;let _t=dt?w.depthTexture.image[0]:w.depthTexture.image;(!ot.__webglTexture||_t.width!==w.width||_t.height!==w.height)&&(_t.width=w.width,_t.height=w.height,w.depthTexture.needsUpdate=!0),dt?Mt(w.depthTexture,0):mt(w.depthTexture,0);let xt=ot.__webglTexture,nt=re(w),st=dt?i.TEXTURE_CUBE_MAP_POSITIVE_X+Y:i.TEXTURE_2D,pt=w.depthTexture.format===xs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===fs)bt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pt,st,xt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,pt,st,xt,0);else if(w.depthTexture.format===xs)bt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pt,st,xt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,pt,st,xt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gn(I){let w=n.get(I),Y=I.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==I.depthTexture){let dt=I.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),dt){let ot=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,dt.removeEventListener("dispose",ot)};dt.addEventListener("dispose",ot),w.__depthDisposeCallback=ot}w.__boundDepthTexture=dt}if(I.depthTexture&&!w.__autoAllocateDepthBuffer)if(Y)for(let dt=0;dt<6;dt++)Se(w.__webglFramebuffer[dt],I,dt);else I.texture.mipmaps.length>0?Se(w.__webglFramebuffer[0],I,0):Se(w.__webglFramebuffer,I,0);else if(Y){w.__webglDepthbuffer=[];for(let dt=0;dt<6;dt++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[dt]),w.__webglDepthbuffer[dt]===void 0)w.__webglDepthbuffer[dt]=i.createRenderbuffer(),wn(w.__webglDepthbuffer[dt],I,!1);else{let ot=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=w.__webglDepthbuffer[dt];i.bindRenderbuffer(i.RENDERBUFFER,_t),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,_t)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),wn(w.__webglDepthbuffer,I,!1);else{let ot=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_t),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,_t)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ke(I,w,Y){let dt=n.get(I);w!==void 0&&Ne(dt.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&gn(I)}function ln(I){let w=I.texture,Y=n.get(I),dt=n.get(w);I.addEventListener("dispose",O),R(I);let ot=I.textures,_t=I.isWebGLCubeRenderTarget===!0,xt=ot.length>1;if(xt||(dt.__webglTexture===void 0&&(dt.__webglTexture=i.createTexture()),dt.__version=w.version,o.memory.textures++),_t){Y.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0){Y.__webglFramebuffer[nt]=[];for(let st=0;st<w.mipmaps.length;st++)Y.__webglFramebuffer[nt][st]=i.createFramebuffer()}else Y.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(w.mipmaps.length>0){Y.__webglFramebuffer=[];for(let nt=0;nt<w.mipmaps.length;nt++)Y.__webglFramebuffer[nt]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(xt)for(let nt=0,st=ot.length;nt<st;nt++){let pt=n.get(ot[nt]);pt.__webglTexture===void 0&&(pt.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&bt(I)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let nt=0;nt<ot.length;nt++){let st=ot[nt];Y.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[nt]);let pt=r.convert(st.format,st.colorSpace),k=r.convert(st.type),rt=T(st.internalFormat,pt,k,st.normalized,st.colorSpace,I.isXRRenderTarget===!0),it=re(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,rt,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,Y.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),wn(Y.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_t){e.bindTexture(i.TEXTURE_CUBE_MAP,dt.__webglTexture),de(i.TEXTURE_CUBE_MAP,w);for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Ne(Y.__webglFramebuffer[nt][st],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Ne(Y.__webglFramebuffer[nt],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);M(w)?x(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(xt){for(let nt=0,st=ot.length;nt<st;nt++){let pt=ot[nt],k=n.get(pt),rt=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(rt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,k.__webglTexture),de(rt,pt),Ne(Y.__webglFramebuffer,I,pt,i.COLOR_ATTACHMENT0+nt,rt,0),M(pt)&&x(rt)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(nt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,dt.__webglTexture),de(nt,w),w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Ne(Y.__webglFramebuffer[st],I,w,i.COLOR_ATTACHMENT0,nt,st);else Ne(Y.__webglFramebuffer,I,w,i.COLOR_ATTACHMENT0,nt,0);M(w)?x(nt):w.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&gn(I)}function z(I){let w=I.textures;for(let Y=0,dt=w.length;Y<dt;Y++){let ot=w[Y];if(M(ot)&&ot.mipmapsAutoUpdate===!0){let _t=C(I),xt=n.get(ot).__webglTexture;e.bindTexture(_t,xt),x(_t),e.unbindTexture()}}}let Rt=[];function Yt(I){if(I.samples>0){if(bt(I)===!1){let w=I.textures,Y=I.width,dt=I.height,ot=i.COLOR_BUFFER_BIT,_t=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xt=n.get(I),nt=w.length>1;if(nt)for(let pt=0;pt<w.length;pt++)e.bindFramebuffer(i.FRAMEBUFFER,xt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,xt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,xt.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,xt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,xt.__webglFramebuffer);for(let pt=0;pt<w.length;pt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ot|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ot|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,xt.__webglColorRenderbuffer[pt]);let k=n.get(w[pt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,Y,dt,0,0,Y,dt,ot,i.NEAREST),l===!0&&(Rt.length=0,Rt.push(i.COLOR_ATTACHMENT0+pt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Rt.push(_t),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let pt=0;pt<w.length;pt++){e.bindFramebuffer(i.FRAMEBUFFER,xt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.RENDERBUFFER,xt.__webglColorRenderbuffer[pt]);let k=n.get(w[pt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,xt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.TEXTURE_2D,k,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,xt.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let w=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function re(I){return Math.min(s.maxSamples,I.samples)}function bt(I){let w=n.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Fe(I){let w=o.render.frame;h.get(I)!==w&&(h.set(I,w),I.update())}function zt(I,w){let Y=I.colorSpace,dt=I.format,ot=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||Y!==da&&Y!==vs&&(ve.getTransfer(Y)===Ce?(dt!==Di||ot!==Kn)&&$t("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):te("WebGLTextures: Unsupported texture color space:",Y)),w}function qt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=at,this.resetTextureUnits=$,this.getTextureUnits=et,this.setTextureUnits=ht,this.setTexture2D=mt,this.setTexture2DArray=yt,this.setTexture3D=At,this.setTextureCube=Mt,this.rebindTextures=Ke,this.setupRenderTarget=ln,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=gn,this.setupFrameBufferTexture=Ne,this.useMultisampledRTT=bt,this.dispose=G}function $1(i,t){function e(n,s=vs){let r,o=ve.getTransfer(s);if(n===Kn)return i.UNSIGNED_BYTE;if(n===Kc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===jc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Wd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Xd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Vd)return i.BYTE;if(n===Hd)return i.SHORT;if(n===Ro)return i.UNSIGNED_SHORT;if(n===Jc)return i.INT;if(n===Ii)return i.UNSIGNED_INT;if(n===xi)return i.FLOAT;if(n===Li)return i.HALF_FLOAT;if(n===qd)return i.ALPHA;if(n===$d)return i.RGB;if(n===Di)return i.RGBA;if(n===fs)return i.DEPTH_COMPONENT;if(n===xs)return i.DEPTH_STENCIL;if(n===Qc)return i.RED;if(n===th)return i.RED_INTEGER;if(n===$s)return i.RG;if(n===eh)return i.RG_INTEGER;if(n===nh)return i.RGBA_INTEGER;if(n===Ha||n===Wa||n===Xa||n===qa)if(o===Ce)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ha)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ha)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===ih||n===sh||n===rh||n===oh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===ih)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===sh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===rh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===oh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ah||n===lh||n===ch||n===hh||n===uh||n===$a||n===dh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===ah||n===lh)return o===Ce?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===ch)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===hh)return r.COMPRESSED_R11_EAC;if(n===uh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===$a)return r.COMPRESSED_RG11_EAC;if(n===dh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===fh||n===ph||n===mh||n===gh||n===_h||n===yh||n===xh||n===vh||n===Sh||n===Mh||n===bh||n===wh||n===Th||n===Eh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===fh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ph)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===mh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===gh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===_h)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===yh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===xh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===vh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Sh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Mh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===bh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===wh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Th)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Eh)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ah||n===Ch||n===Rh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Ah)return o===Ce?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ch)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Rh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ph||n===Ih||n===Ya||n===Lh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ph)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ih)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ya)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Lh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Mr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Y1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Z1=`
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

}`,mf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Ea(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new $i({vertexShader:Y1,fragmentShader:Z1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Nn(new _r(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},gf=class extends Pi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,y=typeof XRWebGLBinding<"u",m=new mf,g={},_=e.getContextAttributes(),M=null,x=null,C=[],T=[],v=new Xt,b=null,R=null,P=new qn;P.viewport=new Ye;let L=new qn;L.viewport=new Ye;let O=[P,L],V=new Xc,U=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let mt=C[Q];return mt===void 0&&(mt=new xo,C[Q]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(Q){let mt=C[Q];return mt===void 0&&(mt=new xo,C[Q]=mt),mt.getGripSpace()},this.getHand=function(Q){let mt=C[Q];return mt===void 0&&(mt=new xo,C[Q]=mt),mt.getHandSpace()};function Z(Q){let mt=T.indexOf(Q.inputSource);if(mt===-1)return;let yt=C[mt];yt!==void 0&&(yt.update(Q.inputSource,Q.frame,c||o),yt.dispatchEvent({type:Q.type,data:Q.inputSource}))}function X(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",X),s.removeEventListener("inputsourceschange",ct);for(let Q=0;Q<C.length;Q++){let mt=T[Q];mt!==null&&(T[Q]=null,C[Q].disconnect(mt))}U=null,G=null,m.reset();for(let Q in g)delete g[Q];if(t.setRenderTarget(M),f=null,d=null,u=null,s=null,x=null,at.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(v.width,v.height,!1),R!==null){let Q=R.camera;Q.fov=R.fov,Q.zoom=R.zoom,Q.updateProjectionMatrix(),R=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&$t("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&$t("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",X),s.addEventListener("inputsourceschange",ct),_.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,At=null,Mt=null;_.depth&&(Mt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=_.stencil?xs:fs,At=_.stencil?Mr:Ii);let Ht={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ht),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),x=new hi(d.textureWidth,d.textureHeight,{format:Di,type:Kn,depthTexture:new _s(d.textureWidth,d.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let yt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,yt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),x=new hi(f.framebufferWidth,f.framebufferHeight,{format:Di,type:Kn,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),at.setContext(s),at.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ct(Q){for(let mt=0;mt<Q.removed.length;mt++){let yt=Q.removed[mt],At=T.indexOf(yt);At>=0&&(T[At]=null,C[At].disconnect(yt))}for(let mt=0;mt<Q.added.length;mt++){let yt=Q.added[mt],At=T.indexOf(yt);if(At===-1){for(let Ht=0;Ht<C.length;Ht++)if(Ht>=T.length){T.push(yt),At=Ht;break}else if(T[Ht]===null){T[Ht]=yt,At=Ht;break}if(At===-1)break}let Mt=C[At];Mt&&Mt.connect(yt)}}function B(Q,mt){mt===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(mt.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let mt=Q.near,yt=Q.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(yt=m.depthFar)),V.near=L.near=P.near=mt,V.far=L.far=P.far=yt,(U!==V.near||G!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),U=V.near,G=V.far),V.layers.mask=Q.layers.mask|6,P.layers.mask=V.layers.mask&-5,L.layers.mask=V.layers.mask&-3;let At=Q.parent,Mt=V.cameras;B(V,At);for(let Ht=0;Ht<Mt.length;Ht++)B(Mt[Ht],At);V.projectionMatrix.copy(P.projectionMatrix),V.projectionMatrixInverse.copy(P.projectionMatrixInverse),R===null&&Q.isPerspectiveCamera&&(R={camera:Q,fov:Q.fov,zoom:Q.zoom}),$(Q,V,At)};function $(Q,mt,yt){yt===null?Q.matrix.copy(mt.matrixWorld):(Q.matrix.copy(yt.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(mt.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(mt.projectionMatrix),Q.projectionMatrixInverse.copy(mt.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=_o*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(V)},this.getCameraTexture=function(Q){return g[Q]};let et=null;function ht(Q,mt){if(h=mt.getViewerPose(c||o),p=mt,h!==null){let yt=h.views;f!==null&&(t.setRenderTargetFramebuffer(x,f.framebuffer),t.setRenderTarget(x));let At=!1;yt.length!==V.cameras.length&&(V.cameras.length=0,At=!0);for(let Gt=0;Gt<yt.length;Gt++){let de=yt[Gt],le=null;if(f!==null)le=f.getViewport(de);else{let qe=u.getViewSubImage(d,de);le=qe.viewport,Gt===0&&(t.setRenderTargetTextures(x,qe.colorTexture,qe.depthStencilTexture),t.setRenderTarget(x))}let ne=O[Gt];ne===void 0&&(ne=new qn,ne.layers.enable(Gt),ne.viewport=new Ye,O[Gt]=ne),ne.matrix.fromArray(de.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(de.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(le.x,le.y,le.width,le.height),Gt===0&&(V.matrix.copy(ne.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),At===!0&&V.cameras.push(ne)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Gt=u.getDepthInformation(yt[0]);Gt&&Gt.isValid&&Gt.texture&&m.init(Gt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&y){t.state.unbindTexture(),u=n.getBinding();for(let Gt=0;Gt<yt.length;Gt++){let de=yt[Gt].camera;if(de){let le=g[de];le||(le=new Ea,g[de]=le);let ne=u.getCameraImage(de);le.sourceTexture=ne}}}}for(let yt=0;yt<C.length;yt++){let At=T[yt],Mt=C[yt];At!==null&&Mt!==void 0&&Mt.update(At,mt,c||o)}et&&et(Q,mt),mt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:mt}),p=null}let at=new U0;at.setAnimationLoop(ht),this.setAnimationLoop=function(Q){et=Q},this.dispose=function(){}}},J1=new Re,X0=new ee;X0.set(-1,0,0,0,1,0,0,0,1);function K1(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,nf(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,_,M,x){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,x)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),y(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,_,M):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Yn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Yn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let _=t.get(g),M=_.envMap,x=_.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(J1.makeRotationFromEuler(x)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(X0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,_,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*_,m.scale.value=M*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,_){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Yn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function y(m,g){let _=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function j1(i,t,e,n){let s={},r={};function o(_,M){let x=M.program;n.uniformBlockBinding(_,x,s[_.id])}function a(_,M){let x=s[_.id];x===void 0&&(p(_),x=l(_),s[_.id]=x,_.addEventListener("dispose",m));let C=M.program;n.updateUBOMapping(_,C);let T=t.render.frame;r[_.id]!==T&&(c(_),r[_.id]=T)}function l(_){let M=i.createBuffer(),x=_.__size,C=_.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,x,C),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(_){let M=s[_.id],x=_.uniforms,C=_.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let T=0,v=x.length;T<v;T++){let b=x[T];if(Array.isArray(b))for(let R=0,P=b.length;R<P;R++)h(b[R],T,R,C);else h(b,T,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(_,M,x,C){if(d(_,M,x,C)===!0){let T=_.__offset,v=_.value;if(Array.isArray(v)){let b=0;for(let R=0;R<v.length;R++){let P=v[R],L=y(P,!0);u(P,_.__data,b),b+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,_.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,_.__data)}}function u(_,M,x){typeof _=="number"||typeof _=="boolean"?M[x]=_:_.isMatrix3?(M[x]=_.elements[0],M[x+1]=_.elements[1],M[x+2]=_.elements[2],M[x+3]=0,M[x+4]=_.elements[3],M[x+5]=_.elements[4],M[x+6]=_.elements[5],M[x+7]=0,M[x+8]=_.elements[6],M[x+9]=_.elements[7],M[x+10]=_.elements[8],M[x+11]=0):ArrayBuffer.isView(_)?M.set(_.subarray(0,M.length-x),x):_.toArray(M,x)}function d(_,M,x,C){let T=_.value,v=M+"_"+x;if(Array.isArray(T)){C[v]===void 0&&(C[v]=[]);let b=C[v],R=!1;for(let P=0;P<T.length;P++)f(T[P],b,P)===!0&&(R=!0);return R}return f(T,C,v)}function f(_,M,x){if(M[x]===void 0)return typeof _=="number"||typeof _=="boolean"?M[x]=_:ArrayBuffer.isView(_)?M[x]=_.slice():M[x]=_.clone(),!0;{let C=M[x];if(typeof _=="number"||typeof _=="boolean"){if(C!==_)return M[x]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(C.equals(_)===!1)return C.copy(_),!0}}return!1}function p(_){let M=_.uniforms,x=0,C=16;for(let v=0,b=M.length;v<b;v++){let R=Array.isArray(M[v])?M[v]:[M[v]];for(let P=0,L=R.length;P<L;P++){let O=R[P],V=Array.isArray(O.value)?O.value:[O.value],U=Array.isArray(M[v])||Array.isArray(O.value),G=x;for(let X=0,ct=V.length;X<ct;X++){let B=V[X],$=y(B,U),et=x%C,ht=et%$.boundary,at=et+ht;x+=ht,at!==0&&C-at<$.storage&&(x+=C-at),X===0&&(G=x),x+=$.storage}let Z=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new Z((x-G)/Float32Array.BYTES_PER_ELEMENT),O.__offset=G}}let T=x%C;return T>0&&(x+=C-T),_.__size=x,_.__cache={},this}function y(_,M){let x={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(x.boundary=4,x.storage=4):_.isVector2?(x.boundary=8,x.storage=8):_.isVector3||_.isColor?(x.boundary=16,x.storage=12):_.isVector4?(x.boundary=16,x.storage=16):_.isMatrix3?(x.boundary=16,x.storage=48):_.isMatrix4?(x.boundary=16,x.storage=64):_.isTexture?$t("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(x.boundary=16,x.storage=_.byteLength):$t("WebGLRenderer: Unsupported uniform value type.",_),M===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}function m(_){let M=_.target;M.removeEventListener("dispose",m),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let _ in s)i.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:g}}var Q1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ji=null;function tT(){return Ji===null&&(Ji=new Sa(Q1,16,16,$s,Li),Ji.name="DFG_LUT",Ji.minFilter=$n,Ji.magFilter=$n,Ji.wrapS=Wi,Ji.wrapT=Wi,Ji.generateMipmaps=!1,Ji.needsUpdate=!0),Ji}var Bh=class{constructor(t={}){let{canvas:e=t0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Kn}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let y=f,m=new Set([nh,eh,th]),g=new Set([Kn,Ii,Ro,Mr,Kc,jc]),_=new Uint32Array(4),M=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},C=null,T=null,v=[],b=[],R=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Zi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,L=!1,O=null,V=null,U=null,G=null;this._outputColorSpace=li;let Z=0,X=0,ct=null,B=-1,$=null,et=new Ye,ht=new Ye,at=null,Q=new Zt(0),mt=0,yt=e.width,At=e.height,Mt=1,Ht=null,se=null,Gt=new Ye(0,0,yt,At),de=new Ye(0,0,yt,At),le=!1,ne=new ks,qe=new Ac,ke=!1,an=!1,Ne=new Re,wn=new W,Se=new Ye,gn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ke=!1;function ln(){return ct===null?Mt:1}let z=n;function Rt(A,H){return e.getContext(A,H)}let Yt,re,bt,Fe,zt,qt,I,w,Y,dt,ot,_t,xt,nt,st,pt,k,rt,it,wt,gt,St,Vt;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",jt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),z===null){let H="webgl2";if(z=Rt(H,A),z===null)throw Rt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Kt()}catch(A){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),te("WebGLRenderer: "+A.message),A}function Kt(){Yt=new uw(z),Yt.init(),gt=new $1(z,Yt),re=new tw(z,Yt,t,gt),bt=new X1(z,Yt),re.reversedDepthBuffer&&d&&bt.buffers.depth.setReversed(!0),V=z.createFramebuffer(),U=z.createFramebuffer(),G=z.createFramebuffer(),Fe=new pw(z),zt=new I1,qt=new q1(z,Yt,bt,zt,re,gt,Fe),I=new hw(P),w=new gS(z),St=new jb(z,w),Y=new dw(z,w,Fe,St),dt=new gw(z,Y,w,St,Fe),rt=new mw(z,re,qt),st=new ew(zt),ot=new P1(P,I,Yt,re,St,st),_t=new K1(P,zt),xt=new D1,nt=new k1(Yt),k=new Kb(P,I,bt,dt,p,l),pt=new W1(P,dt,re),Vt=new j1(z,Fe,re,bt),it=new Qb(z,Yt,Fe),wt=new fw(z,Yt,Fe),Fe.programs=ot.programs,P.capabilities=re,P.extensions=Yt,P.properties=zt,P.renderLists=xt,P.shadowMap=pt,P.state=bt,P.info=Fe}y!==Kn&&(R=new yw(y,e.width,e.height,a,s,r));let ut=new gf(P,z);this.xr=ut,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let A=Yt.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Yt.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(A){A!==void 0&&(Mt=A,this.setSize(yt,At,!1))},this.getSize=function(A){return A.set(yt,At)},this.setSize=function(A,H,tt=!0){if(ut.isPresenting){$t("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=A,At=H,e.width=Math.floor(A*Mt),e.height=Math.floor(H*Mt),tt===!0&&(e.style.width=A+"px",e.style.height=H+"px"),R!==null&&R.setSize(e.width,e.height),this.setViewport(0,0,A,H)},this.getDrawingBufferSize=function(A){return A.set(yt*Mt,At*Mt).floor()},this.setDrawingBufferSize=function(A,H,tt){yt=A,At=H,Mt=tt,e.width=Math.floor(A*tt),e.height=Math.floor(H*tt),this.setViewport(0,0,A,H)},this.setEffects=function(A){if(y===Kn){te("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let H=0;H<A.length;H++)if(A[H].isOutputPass===!0){$t("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}R.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(et)},this.getViewport=function(A){return A.copy(Gt)},this.setViewport=function(A,H,tt,J){A.isVector4?Gt.set(A.x,A.y,A.z,A.w):Gt.set(A,H,tt,J),bt.viewport(et.copy(Gt).multiplyScalar(ln()).round())},this.getScissor=function(A){return A.copy(de)},this.setScissor=function(A,H,tt,J){A.isVector4?de.set(A.x,A.y,A.z,A.w):de.set(A,H,tt,J),bt.scissor(ht.copy(de).multiplyScalar(ln()).round())},this.getScissorTest=function(){return le},this.setScissorTest=function(A){bt.setScissorTest(le=A)},this.setOpaqueSort=function(A){Ht=A},this.setTransparentSort=function(A){se=A},this.getClearColor=function(A){return A.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(A=!0,H=!0,tt=!0){let J=0;if(A){let K=!1;if(ct!==null){let Tt=ct.texture.format;K=m.has(Tt)}if(K){let Tt=ct.texture.type,Pt=g.has(Tt),Et=k.getClearColor(),It=k.getClearAlpha(),kt=Et.r,Qt=Et.g,fe=Et.b;Pt?(_[0]=kt,_[1]=Qt,_[2]=fe,_[3]=It,z.clearBufferuiv(z.COLOR,0,_)):(M[0]=kt,M[1]=Qt,M[2]=fe,M[3]=It,z.clearBufferiv(z.COLOR,0,M))}else J|=z.COLOR_BUFFER_BIT}H&&(J|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),tt&&(J|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&z.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),O=A},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),k.dispose(),xt.dispose(),nt.dispose(),qt.dispose(),zt.dispose(),I.dispose(),dt.dispose(),Y.dispose(),St.dispose(),Vt.dispose(),ot.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",sl),ut.removeEventListener("sessionend",Ni),ji.stop()};function Ot(A){A.preventDefault(),jd("WebGLRenderer: Context Lost."),L=!0}function jt(){jd("WebGLRenderer: Context Restored."),L=!1;let A=Fe.autoReset,H=pt.enabled,tt=pt.autoUpdate,J=pt.needsUpdate,K=pt.type;Kt(),Fe.autoReset=A,pt.enabled=H,pt.autoUpdate=tt,pt.needsUpdate=J,pt.type=K}function Ct(A){te("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ae(A){let H=A.target;H.removeEventListener("dispose",ae),ze(H)}function ze(A){zn(A),zt.remove(A)}function zn(A){let H=zt.get(A).programs;H!==void 0&&(H.forEach(function(tt){ot.releaseProgram(tt)}),A.isShaderMaterial&&ot.releaseShaderCache(A))}this.renderBufferDirect=function(A,H,tt,J,K,Tt){H===null&&(H=gn);let Pt=K.isMesh&&K.matrixWorld.determinantAffine()<0,Et=ko(A,H,tt,J,K);bt.setMaterial(J,Pt);let It=tt.index,kt=1;if(J.wireframe===!0){if(It=Y.getWireframeAttribute(tt),It===void 0)return;kt=2}let Qt=tt.drawRange,fe=tt.attributes.position,Bt=Qt.start*kt,pe=(Qt.start+Qt.count)*kt;Tt!==null&&(Bt=Math.max(Bt,Tt.start*kt),pe=Math.min(pe,(Tt.start+Tt.count)*kt)),It!==null?(Bt=Math.max(Bt,0),pe=Math.min(pe,It.count)):fe!=null&&(Bt=Math.max(Bt,0),pe=Math.min(pe,fe.count));let Ze=pe-Bt;if(Ze<0||Ze===1/0)return;St.setup(K,J,Et,tt,It);let Ie,Le=it;if(It!==null&&(Ie=w.get(It),Le=wt,Le.setIndex(Ie)),K.isMesh)J.wireframe===!0?(bt.setLineWidth(J.wireframeLinewidth*ln()),Le.setMode(z.LINES)):Le.setMode(z.TRIANGLES);else if(K.isLine){let _n=J.linewidth;_n===void 0&&(_n=1),bt.setLineWidth(_n*ln()),K.isLineSegments?Le.setMode(z.LINES):K.isLineLoop?Le.setMode(z.LINE_LOOP):Le.setMode(z.LINE_STRIP)}else K.isPoints?Le.setMode(z.POINTS):K.isSprite&&Le.setMode(z.TRIANGLES);if(K.isBatchedMesh)if(Yt.get("WEBGL_multi_draw"))Le.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let _n=K._multiDrawStarts,Ut=K._multiDrawCounts,cn=K._multiDrawCount,ye=It?w.get(It).bytesPerElement:1,ts=zt.get(J).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)ts.setValue(z,"_gl_DrawID",hn),Le.render(_n[hn]/ye,Ut[hn])}else if(K.isInstancedMesh)Le.renderInstances(Bt,Ze,K.count);else if(tt.isInstancedBufferGeometry){let _n=tt._maxInstanceCount!==void 0?tt._maxInstanceCount:1/0,Ut=Math.min(tt.instanceCount,_n);Le.renderInstances(Bt,Ze,Ut)}else Le.render(Bt,Ze)};function Fo(A,H,tt,J){O!==null&&A.isNodeMaterial&&O.setObject(J,A),ke===!0&&st.setState(A,tt,!1),A.transparent===!0&&A.side===yi&&A.forceSinglePass===!1?(A.side=Yn,A.needsUpdate=!0,Ui(A,H,J),A.side=Yi,A.needsUpdate=!0,Ui(A,H,J),A.side=yi):Ui(A,H,J)}this.compile=function(A,H,tt=null){tt===null&&(tt=A),O!==null&&O.renderStart(A,H,tt),T=nt.get(tt),T.init(H),b.push(T),tt.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),A!==tt&&A.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),T.setupLights(),O!==null&&O.updateLights(T.state.lightsArray),an=this.localClippingEnabled,ke=st.init(this.clippingPlanes,an),ke===!0&&st.setGlobalState(this.clippingPlanes,H),O!==null&&pt.render(T.state.shadowsArray,tt,H);let J=new Set;return A.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Tt=K.material;if(Tt)if(Array.isArray(Tt))for(let Pt=0;Pt<Tt.length;Pt++){let Et=Tt[Pt];Fo(Et,tt,H,K),J.add(Et)}else Fo(Tt,tt,H,K),J.add(Tt)}),T=b.pop(),O!==null&&O.renderEnd(),J},this.compileAsync=function(A,H,tt=null){let J=this.compile(A,H,tt);return new Promise(K=>{function Tt(){if(J.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&J.delete(Pt)}),J.size===0){K(A);return}setTimeout(Tt,10)}Yt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Tr=null;function Qh(A){Tr&&Tr(A)}function sl(){ji.stop()}function Ni(){ji.start()}let ji=new U0;ji.setAnimationLoop(Qh),typeof self<"u"&&ji.setContext(self),this.setAnimationLoop=function(A){Tr=A,ut.setAnimationLoop(A),A===null?ji.stop():ji.start()},ut.addEventListener("sessionstart",sl),ut.addEventListener("sessionend",Ni),this.render=function(A,H){if(H!==void 0&&H.isCamera!==!0){te("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;O!==null&&O.renderStart(A,H);let tt=ut.enabled===!0&&ut.isPresenting===!0,J=R!==null&&(ct===null||tt)&&R.begin(P,ct);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(R===null||R.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(H),H=ut.getCamera()),A.isScene===!0&&A.onBeforeRender(P,A,H,ct),T=nt.get(A,b.length),T.init(H),T.state.textureUnits=qt.getTextureUnits(),b.push(T),Ne.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?qe.setFromArrayCamera(H):ne.setFromProjectionMatrix(Ne,_i,H.reversedDepth),an=this.localClippingEnabled,ke=st.init(this.clippingPlanes,an),C=xt.get(A,v.length),C.init(),v.push(C),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let Pt=P.xr.getDepthSensingMesh();Pt!==null&&Qi(Pt,H,-1/0,P.sortObjects)}Qi(A,H,0,P.sortObjects),C.finish(),O!==null&&O.updateLights(T.state.lightsArray),P.sortObjects===!0&&C.sort(Ht,se),Ke=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Ke&&k.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),ke===!0&&st.beginShadows();let K=T.state.shadowsArray;if(pt.render(K,A,H),ke===!0&&st.endShadows(),(J&&R.hasRenderPass())===!1){let Pt=C.opaque,Et=C.transmissive;if(T.setupLights(),H.isArrayCamera){let It=H.cameras;if(Et.length>0)for(let kt=0,Qt=It.length;kt<Qt;kt++){let fe=It[kt];vi(Pt,Et,A,fe)}Ke&&k.render(A);for(let kt=0,Qt=It.length;kt<Qt;kt++){let fe=It[kt];Oo(C,A,fe,fe.viewport)}}else Et.length>0&&vi(Pt,Et,A,H),Ke&&k.render(A),Oo(C,A,H)}ct!==null&&X===0&&(qt.updateMultisampleRenderTarget(ct),qt.updateRenderTargetMipmap(ct)),J&&R.end(P),A.isScene===!0&&A.onAfterRender(P,A,H),St.resetDefaultState(),B=-1,$=null,b.pop(),b.length>0?(T=b[b.length-1],qt.setTextureUnits(T.state.textureUnits),ke===!0&&st.setGlobalState(P.clippingPlanes,T.state.camera)):T=null,v.pop(),v.length>0?C=v[v.length-1]:C=null,O!==null&&O.renderEnd()};function Qi(A,H,tt,J){if(A.visible===!1)return;if(A.layers.test(H.layers)){if(A.isGroup)tt=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(H);else if(A.isLight)T.pushLight(A),A.castShadow&&T.pushShadow(A);else if(A.isSprite){let Pt=H.isArrayCamera?qe:ne;if(!A.frustumCulled||A.intersectsFrustum(Pt)){J&&Se.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ne);let Et=dt.update(A),It=A.material;It.visible&&C.push(A,Et,It,tt,Se.z,null,H)}}else if(A.isMesh||A.isLine||A.isPoints){let Pt=H.isArrayCamera?qe:ne;if(!A.frustumCulled||A.intersectsFrustum(Pt)){let Et=dt.update(A),It=A.material;if(J&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),Se.copy(A.boundingSphere.center)):(Et.boundingSphere===null&&Et.computeBoundingSphere(),Se.copy(Et.boundingSphere.center)),Se.applyMatrix4(A.matrixWorld).applyMatrix4(Ne)),Array.isArray(It)){let kt=Et.groups;for(let Qt=0,fe=kt.length;Qt<fe;Qt++){let Bt=kt[Qt],pe=It[Bt.materialIndex];pe&&pe.visible&&C.push(A,Et,pe,tt,Se.z,Bt,H)}}else It.visible&&C.push(A,Et,It,tt,Se.z,null,H)}}}let Tt=A.children;for(let Pt=0,Et=Tt.length;Pt<Et;Pt++)Qi(Tt[Pt],H,tt,J)}function Oo(A,H,tt,J){let{opaque:K,transmissive:Tt,transparent:Pt}=A;T.setupLightsView(tt),ke===!0&&st.setGlobalState(P.clippingPlanes,tt),J&&bt.viewport(et.copy(J)),K.length>0&&je(K,H,tt),Tt.length>0&&je(Tt,H,tt),Pt.length>0&&je(Pt,H,tt),bt.buffers.depth.setTest(!0),bt.buffers.depth.setMask(!0),bt.buffers.color.setMask(!0),bt.setPolygonOffset(!1)}function vi(A,H,tt,J){if((tt.isScene===!0?tt.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[J.id]===void 0){let Bt=Yt.has("EXT_color_buffer_half_float")||Yt.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[J.id]=new hi(1,1,{generateMipmaps:!0,type:Bt?Li:Kn,minFilter:ys,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ve.workingColorSpace})}let Tt=T.state.transmissionRenderTarget[J.id],Pt=J.viewport||et;Tt.setSize(Pt.z*P.transmissionResolutionScale,Pt.w*P.transmissionResolutionScale);let Et=P.getRenderTarget(),It=P.getActiveCubeFace(),kt=P.getActiveMipmapLevel();P.setRenderTarget(Tt),P.getClearColor(Q),mt=P.getClearAlpha(),mt<1&&P.setClearColor(16777215,.5),P.clear(),Ke&&k.render(tt);let Qt=P.toneMapping;P.toneMapping=Zi;let fe=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),T.setupLightsView(J),ke===!0&&st.setGlobalState(P.clippingPlanes,J),je(A,tt,J),qt.updateMultisampleRenderTarget(Tt),qt.updateRenderTargetMipmap(Tt),Yt.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let pe=0,Ze=H.length;pe<Ze;pe++){let Ie=H[pe],{object:Le,geometry:_n,material:Ut,group:cn}=Ie;if(Ut.side===yi&&Le.layers.test(J.layers)){let ye=Ut.side;Ut.side=Yn,Ut.needsUpdate=!0,sn(Le,tt,J,_n,Ut,cn),Ut.side=ye,Ut.needsUpdate=!0,Bt=!0}}Bt===!0&&(qt.updateMultisampleRenderTarget(Tt),qt.updateRenderTargetMipmap(Tt))}P.setRenderTarget(Et,It,kt),P.setClearColor(Q,mt),fe!==void 0&&(J.viewport=fe),P.toneMapping=Qt}function je(A,H,tt){let J=H.isScene===!0?H.overrideMaterial:null;for(let K=0,Tt=A.length;K<Tt;K++){let Pt=A[K],{object:Et,geometry:It,group:kt}=Pt,Qt=Pt.material;Qt.allowOverride===!0&&J!==null&&(Qt=J),Et.layers.test(tt.layers)&&sn(Et,H,tt,It,Qt,kt)}}function sn(A,H,tt,J,K,Tt){O!==null&&K.isNodeMaterial&&O.setObject(A,K),A.onBeforeRender(P,H,tt,J,K,Tt),A.modelViewMatrix.multiplyMatrices(tt.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),K.onBeforeRender(P,H,tt,J,A,Tt),K.transparent===!0&&K.side===yi&&K.forceSinglePass===!1?(K.side=Yn,K.needsUpdate=!0,P.renderBufferDirect(tt,H,J,K,A,Tt),K.side=Yi,K.needsUpdate=!0,P.renderBufferDirect(tt,H,J,K,A,Tt),K.side=yi):P.renderBufferDirect(tt,H,J,K,A,Tt),A.onAfterRender(P,H,tt,J,K,Tt)}function rn(A){let H=0;for(let tt of A)tt.texture!==null&&H++;return H}function Ui(A,H,tt){H.isScene!==!0&&(H=gn);let J=zt.get(A),K=T.state.lights,Tt=T.state.shadowsArray,Pt=K.state.version,Et=ot.getParameters(A,K.state,Tt,H,tt,T.state.lightProbeGridArray),It=ot.getProgramCacheKey(Et),kt=J.programs;J.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?H.environment:null,J.fog=H.fog;let Qt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;J.envMap=I.get(A.envMap||J.environment,Qt),J.envMapRotation=J.environment!==null&&A.envMap===null?H.environmentRotation:A.envMapRotation,kt===void 0&&(A.addEventListener("dispose",ae),kt=new Map,J.programs=kt,J.programVariants=new Map);let fe=kt.get(It);if(fe!==void 0){if(J.currentProgram===fe&&J.lightsStateVersion===Pt)return Bo(A,Et),fe}else Et.uniforms=ot.getUniforms(A),O!==null&&A.isNodeMaterial&&O.build(A,tt,Et),A.onBeforeCompile(Et,P),fe=ot.acquireProgram(Et,It),kt.set(It,fe),J.uniforms=Et.uniforms;let Bt=J.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Bt.clippingPlanes=st.uniform),Bo(A,Et),J.needsLights=bs(A),J.lightsStateVersion=Pt,J.needsLights&&(Bt.ambientLightColor.value=K.state.ambient,Bt.lightProbe.value=K.state.probe,Bt.sunLights.value=K.state.sun,Bt.sunLightShadows.value=K.state.sunShadow,Bt.directionalLights.value=K.state.directional,Bt.directionalLightShadows.value=K.state.directionalShadow,Bt.spotLights.value=K.state.spot,Bt.spotLightShadows.value=K.state.spotShadow,Bt.rectAreaLights.value=K.state.rectArea,Bt.ltc_1.value=K.state.rectAreaLTC1,Bt.ltc_2.value=K.state.rectAreaLTC2,Bt.pointLights.value=K.state.point,Bt.pointLightShadows.value=K.state.pointShadow,Bt.hemisphereLights.value=K.state.hemi,Bt.sunShadowMatrix.value=K.state.sunShadowMatrix,Bt.sunShadowCascade.value=K.state.sunShadowCascade,Bt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Bt.spotLightMatrix.value=K.state.spotLightMatrix,Bt.spotLightMap.value=K.state.spotLightMap,Bt.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=rn(T.state.lightProbeGridArray),J.currentProgram=fe,J.uniformsList=null,fe}function Qn(A,H,tt,J,K){let Tt=zt.get(A),Pt=Tt.currentProgram.id+","+J+","+K,Et=Tt.programVariants.get(Pt);return Et===void 0?(Et=Ui(A,H,tt),Tt.programVariants.set(Pt,Et)):(Tt.currentProgram=Et,Tt.uniformsList=null,Tt.outputColorSpace=J,Tt.toneMapping=K),Et}function Ms(A){if(A.uniformsList===null){let H=A.currentProgram.getUniforms();A.uniformsList=Io.seqWithValue(H.seq,A.uniforms)}return A.uniformsList}function Bo(A,H){let tt=zt.get(A);tt.outputColorSpace=H.outputColorSpace,tt.batching=H.batching,tt.batchingColor=H.batchingColor,tt.instancing=H.instancing,tt.instancingColor=H.instancingColor,tt.instancingMorph=H.instancingMorph,tt.skinning=H.skinning,tt.morphTargets=H.morphTargets,tt.morphNormals=H.morphNormals,tt.morphColors=H.morphColors,tt.morphTargetsCount=H.morphTargetsCount,tt.numClippingPlanes=H.numClippingPlanes,tt.numIntersection=H.numClipIntersection,tt.vertexAlphas=H.vertexAlphas,tt.vertexTangents=H.vertexTangents,tt.toneMapping=H.toneMapping}function ko(A,H,tt,J,K){H.isScene!==!0&&(H=gn),qt.resetTextureUnits();let Tt=H.fog,Pt=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?H.environment:null,Et=ct===null?P.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:ve.workingColorSpace,It=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,kt=I.get(J.envMap||Pt,It),Qt=J.vertexColors===!0&&!!tt.attributes.color&&tt.attributes.color.itemSize===4,fe=!!tt.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Bt=!!tt.morphAttributes.position,pe=!!tt.morphAttributes.normal,Ze=!!tt.morphAttributes.color,Ie=Zi;J.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Ie=P.toneMapping);let Le=tt.morphAttributes.position||tt.morphAttributes.normal||tt.morphAttributes.color,_n=Le!==void 0?Le.length:0,Ut=zt.get(J),cn=T.state.lights;if(ke===!0&&(an===!0||A!==$)){let De=A===$&&J.id===B;st.setState(J,A,De)}let ye=!1,ts=!1;J.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==cn.state.version||K.isBatchedMesh&&Ut.batching===!1||!K.isBatchedMesh&&Ut.batching===!0||K.isBatchedMesh&&Ut.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ut.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ut.instancing===!1||!K.isInstancedMesh&&Ut.instancing===!0||K.isSkinnedMesh&&Ut.skinning===!1||!K.isSkinnedMesh&&Ut.skinning===!0||K.isInstancedMesh&&Ut.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ut.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ut.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ut.instancingMorph===!1&&K.morphTexture!==null||Ut.envMap!==kt||J.fog===!0&&Ut.fog!==Tt||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==Qt||Ut.vertexTangents!==fe||Ut.morphTargets!==Bt||Ut.morphNormals!==pe||Ut.morphColors!==Ze||Ut.morphTargetsCount!==_n||Ut.numLightProbeGrids!==rn(T.state.lightProbeGridArray)?ye=!0:(Ut.outputColorSpace!==Et||Ut.toneMapping!==Ie)&&(ts=!0):(ye=!0,Ut.__version=J.version);let hn=Ut.currentProgram;(ye===!0||ts===!0)&&(hn=ts===!0?Qn(J,H,K,Et,Ie):Ui(J,H,K),O&&J.isNodeMaterial&&O.onUpdateProgram(J,hn,Ut));let Cr=!1,Fi=!1,es=!1,ce=hn.getUniforms(),Qe=Ut.uniforms;if(bt.useProgram(hn.program)&&(Cr=!0,Fi=!0,es=!0),J.id!==B&&(B=J.id,Fi=!0),Cr||$!==A){bt.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ce.setValue(z,"projectionMatrix",A.projectionMatrix),ce.setValue(z,"viewMatrix",A.matrixWorldInverse);let un=ce.map.cameraPosition;un!==void 0&&un.setValue(z,wn.setFromMatrixPosition(A.matrixWorld)),re.logarithmicDepthBuffer&&ce.setValue(z,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&ce.setValue(z,"isOrthographic",A.isOrthographicCamera===!0),$!==A&&($=A,Fi=!0,es=!0)}if(Ut.needsLights&&(cn.state.sunShadowMap.length>0&&ce.setValue(z,"sunShadowMap",cn.state.sunShadowMap,qt),cn.state.directionalShadowMap.length>0&&ce.setValue(z,"directionalShadowMap",cn.state.directionalShadowMap,qt),cn.state.spotShadowMap.length>0&&ce.setValue(z,"spotShadowMap",cn.state.spotShadowMap,qt),cn.state.pointShadowMap.length>0&&ce.setValue(z,"pointShadowMap",cn.state.pointShadowMap,qt)),K.isSkinnedMesh){ce.setOptional(z,K,"bindMatrix"),ce.setOptional(z,K,"bindMatrixInverse");let De=K.skeleton;De&&(De.boneTexture===null&&De.computeBoneTexture(),ce.setValue(z,"boneTexture",De.boneTexture,qt))}K.isBatchedMesh&&(ce.setOptional(z,K,"batchingTexture"),ce.setValue(z,"batchingTexture",K._matricesTexture,qt),ce.setOptional(z,K,"batchingIdTexture"),ce.setValue(z,"batchingIdTexture",K._indirectTexture,qt),ce.setOptional(z,K,"batchingColorTexture"),K._colorsTexture!==null&&ce.setValue(z,"batchingColorTexture",K._colorsTexture,qt));let Gn=tt.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&rt.update(K,tt,hn),(Fi||Ut.receiveShadow!==K.receiveShadow)&&(Ut.receiveShadow=K.receiveShadow,ce.setValue(z,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&H.environment!==null&&(Qe.envMapIntensity.value=H.environmentIntensity),Qe.dfgLUT!==void 0&&(Qe.dfgLUT.value=tT()),Fi){if(ce.setValue(z,"toneMappingExposure",P.toneMappingExposure),Ut.needsLights&&Er(Qe,es),Tt&&J.fog===!0&&_t.refreshFogUniforms(Qe,Tt),_t.refreshMaterialUniforms(Qe,J,Mt,At,T.state.transmissionRenderTarget[A.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let De=x,un=0;for(let Un of T.state.lightProbeGridArray)Un.texture!==null&&(De.textures[un]=Un.texture,De.min[un]=Un.boundingBox.min,De.max[un]=Un.boundingBox.max,De.resolution[un]=Un.resolution,un++);for(let Un in De)De[Un].length=un;Qe.probesSH.value=De.textures,Qe.probesMin.value=De.min,Qe.probesMax.value=De.max,Qe.probesResolution.value=De.resolution}Io.upload(z,Ms(Ut),Qe,qt)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Io.upload(z,Ms(Ut),Qe,qt),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&ce.setValue(z,"center",K.center),ce.setValue(z,"modelViewMatrix",K.modelViewMatrix),ce.setValue(z,"normalMatrix",K.normalMatrix),ce.setValue(z,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let De=J.uniformsGroups;for(let un=0,Un=De.length;un<Un;un++){let rl=De[un];Vt.update(rl,hn),Vt.bind(rl,hn)}}return hn}function Er(A,H){A.ambientLightColor.needsUpdate=H,A.lightProbe.needsUpdate=H,A.sunLights.needsUpdate=H,A.sunLightShadows.needsUpdate=H,A.directionalLights.needsUpdate=H,A.directionalLightShadows.needsUpdate=H,A.pointLights.needsUpdate=H,A.pointLightShadows.needsUpdate=H,A.spotLights.needsUpdate=H,A.spotLightShadows.needsUpdate=H,A.rectAreaLights.needsUpdate=H,A.hemisphereLights.needsUpdate=H}function bs(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return X},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(A,H,tt){let J=zt.get(A);J.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),zt.get(A.texture).__webglTexture=H,zt.get(A.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:tt,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,H){let tt=zt.get(A);tt.__webglFramebuffer=H,tt.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(A,H=0,tt=0){ct=A,Z=H,X=tt;let J=null,K=!1,Tt=!1;if(A){let Et=zt.get(A);if(Et.__useDefaultFramebuffer!==void 0){bt.bindFramebuffer(z.FRAMEBUFFER,Et.__webglFramebuffer),et.copy(A.viewport),ht.copy(A.scissor),at=A.scissorTest,bt.viewport(et),bt.scissor(ht),bt.setScissorTest(at),B=-1;return}else if(Et.__webglFramebuffer===void 0)qt.setupRenderTarget(A);else if(Et.__hasExternalTextures)qt.rebindTextures(A,zt.get(A.texture).__webglTexture,zt.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let Qt=A.depthTexture;if(Et.__boundDepthTexture!==Qt){if(Qt!==null&&zt.has(Qt)&&(A.width!==Qt.image.width||A.height!==Qt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qt.setupDepthRenderbuffer(A)}}let It=A.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Tt=!0);let kt=zt.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(kt[H])?J=kt[H][tt]:J=kt[H],K=!0):A.samples>0&&qt.useMultisampledRTT(A)===!1?J=zt.get(A).__webglMultisampledFramebuffer:Array.isArray(kt)?J=kt[tt]:J=kt,et.copy(A.viewport),ht.copy(A.scissor),at=A.scissorTest}else et.copy(Gt).multiplyScalar(Mt).floor(),ht.copy(de).multiplyScalar(Mt).floor(),at=le;if(tt!==0&&(J=V),bt.bindFramebuffer(z.FRAMEBUFFER,J)&&bt.drawBuffers(A,J),bt.viewport(et),bt.scissor(ht),bt.setScissorTest(at),K){let Et=zt.get(A.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+H,Et.__webglTexture,tt)}else if(Tt){let Et=H;for(let It=0;It<A.textures.length;It++){let kt=zt.get(A.textures[It]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+It,kt.__webglTexture,tt,Et)}}else if(A!==null&&tt!==0){let Et=zt.get(A.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Et.__webglTexture,tt)}B=-1};function Ar(A){let H=zt.get(A);return(H.__readFormat!==A.format||H.__readType!==A.type)&&(H.__readFormat=A.format,H.__readType=A.type,H.__formatReadable=re.textureFormatReadable(A.format),H.__typeReadable=re.textureTypeReadable(A.type)),H}this.readRenderTargetPixels=function(A,H,tt,J,K,Tt,Pt,Et=0){if(!(A&&A.isWebGLRenderTarget)){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){bt.bindFramebuffer(z.FRAMEBUFFER,It);try{let kt=A.textures[Et],Qt=kt.format,fe=kt.type;A.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Et);let Bt=Ar(kt);if(Bt.__formatReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=A.width-J&&tt>=0&&tt<=A.height-K&&z.readPixels(H,tt,J,K,gt.convert(Qt),gt.convert(fe),Tt)}finally{let kt=ct!==null?zt.get(ct).__webglFramebuffer:null;bt.bindFramebuffer(z.FRAMEBUFFER,kt)}}},this.readRenderTargetPixelsAsync=async function(A,H,tt,J,K,Tt,Pt,Et=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(H>=0&&H<=A.width-J&&tt>=0&&tt<=A.height-K){bt.bindFramebuffer(z.FRAMEBUFFER,It);let kt=A.textures[Et],Qt=kt.format,fe=kt.type;A.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Et);let Bt=Ar(kt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pe=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,pe),z.bufferData(z.PIXEL_PACK_BUFFER,Tt.byteLength,z.STREAM_READ),z.readPixels(H,tt,J,K,gt.convert(Qt),gt.convert(fe),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let Ze=ct!==null?zt.get(ct).__webglFramebuffer:null;bt.bindFramebuffer(z.FRAMEBUFFER,Ze);let Ie=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await n0(z,Ie,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,pe),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Tt),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(pe),z.deleteSync(Ie),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,H=null,tt=0){let J=Math.pow(2,-tt),K=Math.floor(A.image.width*J),Tt=Math.floor(A.image.height*J),Pt=H!==null?H.x:0,Et=H!==null?H.y:0;qt.setTexture2D(A,0),z.copyTexSubImage2D(z.TEXTURE_2D,tt,0,0,Pt,Et,K,Tt),bt.unbindTexture()},this.copyTextureToTexture=function(A,H,tt=null,J=null,K=0,Tt=0){let Pt,Et,It,kt,Qt,fe,Bt,pe,Ze,Ie=A.isCompressedTexture?A.mipmaps[Tt]:A.image;if(tt!==null)Pt=tt.max.x-tt.min.x,Et=tt.max.y-tt.min.y,It=tt.isBox3?tt.max.z-tt.min.z:1,kt=tt.min.x,Qt=tt.min.y,fe=tt.isBox3?tt.min.z:0;else{let ce=Math.pow(2,-K);Pt=Math.floor(Ie.width*ce),Et=Math.floor(Ie.height*ce),A.isDataArrayTexture?It=Ie.depth:A.isData3DTexture?It=Math.floor(Ie.depth*ce):It=1,kt=0,Qt=0,fe=0}J!==null?(Bt=J.x,pe=J.y,Ze=J.z):(Bt=0,pe=0,Ze=0);let Le=gt.convert(H.format),_n=gt.convert(H.type),Ut;H.isData3DTexture?(qt.setTexture3D(H,0),Ut=z.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(qt.setTexture2DArray(H,0),Ut=z.TEXTURE_2D_ARRAY):(qt.setTexture2D(H,0),Ut=z.TEXTURE_2D),bt.activeTexture(z.TEXTURE0),bt.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,H.flipY),bt.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),bt.pixelStorei(z.UNPACK_ALIGNMENT,H.unpackAlignment);let cn=bt.getParameter(z.UNPACK_ROW_LENGTH),ye=bt.getParameter(z.UNPACK_IMAGE_HEIGHT),ts=bt.getParameter(z.UNPACK_SKIP_PIXELS),hn=bt.getParameter(z.UNPACK_SKIP_ROWS),Cr=bt.getParameter(z.UNPACK_SKIP_IMAGES);bt.pixelStorei(z.UNPACK_ROW_LENGTH,Ie.width),bt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Ie.height),bt.pixelStorei(z.UNPACK_SKIP_PIXELS,kt),bt.pixelStorei(z.UNPACK_SKIP_ROWS,Qt),bt.pixelStorei(z.UNPACK_SKIP_IMAGES,fe);let Fi=A.isDataArrayTexture||A.isData3DTexture,es=H.isDataArrayTexture||H.isData3DTexture;if(A.isDepthTexture){let ce=zt.get(A),Qe=zt.get(H),Gn=zt.get(ce.__renderTarget),De=zt.get(Qe.__renderTarget);bt.bindFramebuffer(z.READ_FRAMEBUFFER,Gn.__webglFramebuffer),bt.bindFramebuffer(z.DRAW_FRAMEBUFFER,De.__webglFramebuffer);for(let un=0;un<It;un++)Fi&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,zt.get(A).__webglTexture,K,fe+un),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,zt.get(H).__webglTexture,Tt,Ze+un)),z.blitFramebuffer(kt,Qt,kt+Pt,Qt+Et,Bt,pe,Bt+Pt,pe+Et,z.DEPTH_BUFFER_BIT,z.NEAREST);bt.bindFramebuffer(z.READ_FRAMEBUFFER,null),bt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(K!==0||A.isRenderTargetTexture||zt.has(A)){let ce=zt.get(A),Qe=zt.get(H);bt.bindFramebuffer(z.READ_FRAMEBUFFER,U),bt.bindFramebuffer(z.DRAW_FRAMEBUFFER,G);for(let Gn=0;Gn<It;Gn++)Fi?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ce.__webglTexture,K,fe+Gn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ce.__webglTexture,K),es?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Qe.__webglTexture,Tt,Ze+Gn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Qe.__webglTexture,Tt),K!==0?z.blitFramebuffer(kt,Qt,kt+Pt,Qt+Et,Bt,pe,Bt+Pt,pe+Et,z.COLOR_BUFFER_BIT,z.NEAREST):es?z.copyTexSubImage3D(Ut,Tt,Bt,pe,Ze+Gn,kt,Qt,Pt,Et):z.copyTexSubImage2D(Ut,Tt,Bt,pe,kt,Qt,Pt,Et);bt.bindFramebuffer(z.READ_FRAMEBUFFER,null),bt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else es?A.isDataTexture||A.isData3DTexture?z.texSubImage3D(Ut,Tt,Bt,pe,Ze,Pt,Et,It,Le,_n,Ie.data):H.isCompressedArrayTexture?z.compressedTexSubImage3D(Ut,Tt,Bt,pe,Ze,Pt,Et,It,Le,Ie.data):z.texSubImage3D(Ut,Tt,Bt,pe,Ze,Pt,Et,It,Le,_n,Ie):A.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Tt,Bt,pe,Pt,Et,Le,_n,Ie.data):A.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Tt,Bt,pe,Ie.width,Ie.height,Le,Ie.data):z.texSubImage2D(z.TEXTURE_2D,Tt,Bt,pe,Pt,Et,Le,_n,Ie);bt.pixelStorei(z.UNPACK_ROW_LENGTH,cn),bt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ye),bt.pixelStorei(z.UNPACK_SKIP_PIXELS,ts),bt.pixelStorei(z.UNPACK_SKIP_ROWS,hn),bt.pixelStorei(z.UNPACK_SKIP_IMAGES,Cr),Tt===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&z.generateMipmap(Ut),bt.unbindTexture()},this.initRenderTarget=function(A){zt.get(A).__webglFramebuffer===void 0&&qt.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?qt.setTextureCube(A,0):A.isData3DTexture?qt.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?qt.setTexture2DArray(A,0):qt.setTexture2D(A,0),bt.unbindTexture()},this.resetState=function(){Z=0,X=0,ct=null,bt.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return _i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var q0={type:"change"},yf={type:"start"},Y0={type:"end"},Gh=new fr,$0=new ci,eT=Math.cos(70*Nh.DEG2RAD),bn=new W,jn=2*Math.PI,Ee={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},_f=1e-6,Vh=class extends za{constructor(t,e=null){super(t,e),this.state=Ee.NONE,this.target=new W,this.cursor=new W,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Xs.ROTATE,MIDDLE:Xs.DOLLY,RIGHT:Xs.PAN},this.touches={ONE:qs.ROTATE,TWO:qs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new W,this._lastQuaternion=new In,this._lastTargetPosition=new W,this._quat=new In().setFromUnitVectors(t.up,new W(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new To,this._sphericalDelta=new To,this._scale=1,this._panOffset=new W,this._rotateStart=new Xt,this._rotateEnd=new Xt,this._rotateDelta=new Xt,this._panStart=new Xt,this._panEnd=new Xt,this._panDelta=new Xt,this._dollyStart=new Xt,this._dollyEnd=new Xt,this._dollyDelta=new Xt,this._dollyDirection=new W,this._mouse=new Xt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=iT.bind(this),this._onPointerDown=nT.bind(this),this._onPointerUp=sT.bind(this),this._onContextMenu=uT.bind(this),this._onMouseWheel=aT.bind(this),this._onKeyDown=lT.bind(this),this._onTouchStart=cT.bind(this),this._onTouchMove=hT.bind(this),this._onMouseDown=rT.bind(this),this._onMouseMove=oT.bind(this),this._interceptControlDown=dT.bind(this),this._interceptControlUp=fT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ee.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(q0),this.update(),this.state=Ee.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;bn.copy(e).sub(this.target),bn.applyQuaternion(this._quat),this._spherical.setFromVector3(bn),this.autoRotate&&this.state===Ee.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=jn:n>Math.PI&&(n-=jn),s<-Math.PI?s+=jn:s>Math.PI&&(s-=jn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(bn.setFromSpherical(this._spherical),bn.applyQuaternion(this._quatInverse),e.copy(this.target).add(bn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=bn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new W(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new W(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=bn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Gh.origin.copy(this.object.position),Gh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Gh.direction))<eT?this.object.lookAt(this.target):($0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Gh.intersectPlane($0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>_f||8*(1-this._lastQuaternion.dot(this.object.quaternion))>_f||this._lastTargetPosition.distanceToSquared(this.target)>_f?(this.dispatchEvent(q0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?jn/60*this.autoRotateSpeed*t:jn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){bn.setFromMatrixColumn(e,0),bn.multiplyScalar(-t),this._panOffset.add(bn)}_panUp(t,e){this.screenSpacePanning===!0?bn.setFromMatrixColumn(e,1):(bn.setFromMatrixColumn(e,0),bn.crossVectors(this.object.up,bn)),bn.multiplyScalar(t),this._panOffset.add(bn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;bn.copy(s).sub(this.target);let r=bn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Xt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function nT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function iT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function sT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Y0),this.state=Ee.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function rT(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Xs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ee.DOLLY;break;case Xs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ee.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ee.ROTATE}break;case Xs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ee.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ee.PAN}break;default:this.state=Ee.NONE}this.state!==Ee.NONE&&this.dispatchEvent(yf)}function oT(i){switch(this.state){case Ee.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ee.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ee.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function aT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ee.NONE||(i.preventDefault(),this.dispatchEvent(yf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Y0))}function lT(i){this.enabled!==!1&&this._handleKeyDown(i)}function cT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case qs.ROTATE:if(this.enableRotate===!1){this.state=Ee.NONE;break}this._handleTouchStartRotate(i),this.state=Ee.TOUCH_ROTATE;break;case qs.PAN:if(this.enablePan===!1){this.state=Ee.NONE;break}this._handleTouchStartPan(i),this.state=Ee.TOUCH_PAN;break;default:this.state=Ee.NONE}break;case 2:switch(this.touches.TWO){case qs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ee.TOUCH_DOLLY_PAN;break;case qs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ee.TOUCH_DOLLY_ROTATE;break;default:this.state=Ee.NONE}break;default:this.state=Ee.NONE}this.state!==Ee.NONE&&this.dispatchEvent(yf)}function hT(i){switch(this._trackPointer(i),this.state){case Ee.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ee.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ee.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ee.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ee.NONE}}function uT(i){this.enabled!==!1&&i.preventDefault()}function dT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function fT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Qa(i,t=!1){let e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new nn;l.morphTargetsRelative=a;let c=0;for(let h=0;h<i.length;++h){let u=i[h],d=0,f=0;if(e!==(u.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in u.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(u.attributes[p]),d++}if(d!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==u.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in u.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(u.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(u.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=u.index.count;else if(u.attributes.position!==void 0)p=u.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,h),c+=p}}if(e){let h=0,u=[];for(let d=0;d<i.length;++d){let f=i[d].index;for(let p=0;p<f.count;++p)u.push(f.getX(p)+h);h+=i[d].attributes.position.count}l.setIndex(u)}for(let h in r){let u=Z0(r[h]);if(!u)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,u)}for(let h in o){let u=o[h][0].length;if(u!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let d=0;d<u;++d){let f=[];for(let y=0;y<o[h].length;++y)f.push(o[h][y][d]);let p=Z0(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(p)}}}return l}function Z0(i){let t,e,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new on(o,e,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let u=l/e;for(let d=0,f=h.count;d<f;d++)for(let p=0;p<e;p++){let y=h.getComponent(d,p);a.setComponent(d+u,p,y)}}else o.set(h.array,l);l+=h.count*e}return s!==void 0&&(a.gpuType=s),a}function J0(i,t){let e=[],n=i==="tanker"?new qi(.34,.26,.6):new qi(.2,.12,.28);if(t){for(let r of[Math.PI/4,-Math.PI/4])e.push(new _r(.34,1.3).rotateX(-Math.PI/2).rotateY(r));e.push(new Aa(.3,3).rotateX(-Math.PI/2).rotateY(Math.PI/2).scale(.6,1,1).translate(0,.02,-.3))}else{for(let[r,o]of[[1,1],[1,-1],[-1,1],[-1,-1]]){let a=new Gs(.22,.22,.03,10).translate(.32*r,.05,.32*o);e.push(a,new qi(.06,.05,.45).translate(0,0,.22).rotateY(Math.atan2(r,o)))}e.push(new So(.09,.3,6).rotateX(-Math.PI/2).translate(0,.02,-.28))}(!t||i!=="pursuer")&&e.push(n);let s=new gr(.22).translate(0,.28,0);return i!=="target"?Qa(e):Qa([...e,s].map(r=>r.index?r.toNonIndexed():r))}var pT=16;function mT(i,t,e){let n=Math.max(Math.ceil(i.length/pT),1),s=i.filter((d,f)=>f%n===0).map(([d,f])=>new Xt(f,d));bo.isClockWise(s)&&s.reverse();let[r,o]=[-t,-Math.max(e,t+.05)],[a,l,c]=[[],[],[]];s.forEach((d,f)=>{let p=s[(f+1)%s.length],y=d.distanceTo(p)||1;for(let[m,g]of[[d,o],[p,o],[p,r],[d,r]])a.push(m.x,g,-m.y),l.push((p.y-d.y)/y,0,(p.x-d.x)/y);c.push(...[0,1,2,0,2,3].map(m=>4*f+m))});let h=a.length/3;for(let d of s)a.push(d.x,r,-d.y),l.push(0,1,0);for(let d of bo.triangulateShape(s,[]))c.push(...d.map(f=>h+f));let u=new nn;return u.setAttribute("position",new on(new Float32Array(a),3)),u.setAttribute("normal",new on(new Float32Array(l),3)),u.setIndex(c)}function xf(i,t){return i.deleteAttribute("uv"),i.index||i.setIndex([...Array(i.attributes.position.count).keys()]),i.translate(t[1],-t[2],-t[0])}function K0(i,t,e){let n=i.map(r=>r.kind==="sphere"?xf(new Ia(r.radius_m??.5,20,14),r.centre_ned):r.outline_ne.length?mT(r.outline_ne,r.top_d,r.bottom_d):xf(new gr(.3),r.centre_ned));if(n.push(...t.map(r=>xf(new Gs(1,1,.1,24),r.p_ned))),!n.length)return null;let s=new yr({color:e,transparent:!0,opacity:.6,side:Yi,depthWrite:!1});return new Nn(Qa(n),s)}var Do=40,j0=24e3,gT=32,_T=.8,Q0=48,yT=401,t_=254,xT=new W(-.35,.5,.72),vT=.88,ST=.5,e_=5,MT=8,Zn=(i,t=new W)=>t.set(i[1],-i[2],-i[0]);function n_(i,t){let[e,n,s]=[i.heading_rad,i.pitch_rad,i.roll_rad].map(l=>(l??0)/2),r=vf[0].set(0,-Math.sin(e),0,Math.cos(e)),o=vf[1].set(Math.sin(n),0,0,Math.cos(n)),a=vf[2].set(0,0,-Math.sin(s),Math.cos(s));return t.copy(r).multiply(o).multiply(a)}var vf=[new In,new In,new In],Hh=class{constructor(t,e,n){this.canvas=t,this.names=e,this.renderer=new Bh({canvas:t,antialias:!1,powerPreference:"low-power"}),this.scene=new _a,this.camera=new qn(50,1,.05,5e3),this.controls=new Vh(this.camera,t),this.controls.maxPolarAngle=.97*Math.PI,this.controls.addEventListener("change",()=>this.dirty=!0),this.dirty=!0,this.mode="free";let s=new Fa(16777215,2.2);s.position.set(30,80,20),this.scene.add(new Oa(16777215,1.3),s),this.material=new yr({side:yi}),this.bodies=new Map,this.lines=this.#e(0),this.paths=this.#e(0),this.scene.add(this.lines,this.paths),this.fixed=new us,this.scene.add(this.fixed),this.madeOf=null,this.world=null,this.pathsOf={version:-1,until_s:NaN,chosen:null,dark:!1,at:0},this.size=1,this.grid_m=0,this.solid=null,this.places=[],this.target=new W,this.framed=!1,this.framedOf="",this.touched=!1,this.controls.addEventListener("start",()=>this.touched=!0),this.width=0,this.height=0;let r=[0,0];t.addEventListener("pointerdown",o=>r=[o.clientX,o.clientY]),t.addEventListener("pointerup",o=>{Math.hypot(o.clientX-r[0],o.clientY-r[1])>4||n(tr(this.places,o.offsetX,o.offsetY),o)}),t.addEventListener("keydown",o=>this.#t(o))}#t(t){let e={ArrowLeft:[.1,0],ArrowRight:[-.1,0],ArrowUp:[0,.08],ArrowDown:[0,-.08]}[t.key],n=this.camera.position.clone().sub(this.controls.target);if(e){let s=Math.hypot(n.x,n.z),r=Math.atan2(n.x,n.z)-e[0],o=Math.min(Math.max(Math.atan2(n.y,s)+e[1],-.2),1.5),a=n.length();n.set(a*Math.cos(o)*Math.sin(r),a*Math.sin(o),a*Math.cos(o)*Math.cos(r))}else if(t.key==="+"||t.key==="-")n.multiplyScalar(t.key==="+"?.85:1.18);else return t.key==="0"?void this.whole():void 0;this.camera.position.copy(this.controls.target).add(n),this.touched=!0,this.controls.update(),this.dirty=!0,t.preventDefault(),t.stopPropagation()}whole(){this.framed=this.touched=!1,this.mode="free",this.dirty=!0}#e(t){let e=new nn;e.setAttribute("position",new on(new Float32Array(3*t),3)),e.setAttribute("color",new on(new Float32Array(3*t),3));let n=new pr(e,new zs({vertexColors:!0,transparent:!0,opacity:.9}));return n.frustumCulled=!1,n}#i(t,e,n){let s=t.geometry;if(s.attributes.position.array.length<e.length){s.dispose();let a=new nn,l=Math.ceil(e.length*1.5);a.setAttribute("position",new on(new Float32Array(l-l%3),3)),a.setAttribute("color",new on(new Float32Array(l-l%3),3)),t.geometry=a}let{position:r,color:o}=t.geometry.attributes;r.array.set(e),o.array.set(n),r.needsUpdate=o.needsUpdate=!0,t.geometry.setDrawRange(0,e.length/3)}#s(t,e){let n=t.sessionAt(e),s=n?.wind,r=`${JSON.stringify(s??0)} ${JSON.stringify(t.session?.plans??0)} ${t.session?.vehicles.length} ${he().dark}`;if(this.madeOf===r&&this.world===n&&this.fixed.children.length)return;[this.madeOf,this.world]=[r,n];for(let g of this.fixed.children)(g instanceof Nn||g instanceof pr)&&g.geometry.dispose();this.fixed.clear();let o=he(),a=Kr(t)??[[-10,10],[-10,10]],l=Math.max(a[0][1]-a[0][0],a[1][1]-a[1][0],10),c=Ol(l/6),h=2*Math.ceil(.75*l/c),u=new Ba(h*c,h,o.grid,o.grid),d=g=>Math.round((g[0]+g[1])/2/c)*c;u.position.set(d(a[1]),0,-d(a[0])),this.fixed.add(u),this.solid=K0(n?.obstacles??[],t.session?.bases??[],o.solid),this.solid&&this.fixed.add(this.solid);let f=[],p=[],y=(g,_,M)=>g.slice(1).forEach((x,C)=>{let T=Zn(g[C]),v=Zn(x),b=Math.min(Math.max(Math.round(T.distanceTo(v)/M),1),yT);for(let R=0;R<b;R+=2)f.push(...T.clone().lerp(v,R/b).toArray(),...T.clone().lerp(v,Math.min(R+1,b)/b).toArray()),p.push(..._.toArray(),..._.toArray())});for(let g of n?.vehicles??[])y(g.path_ned,new Zt(o.soft),.8);for(let{points:g,colour:_}of Dm(t.session))y(g,new Zt(_),Math.max(l/150,.8));if(s){let g=(s.from_deg+180)*Math.PI/180,_=new W(Math.sin(g),0,-Math.cos(g)),M=new W((a[1][0]+a[1][1])/2,.12*l,-(a[0][0]+a[0][1])/2),x=.14*l,C=M.clone().addScaledVector(_,-.62*l);this.fixed.add(new ka(_,C,x,o.ink,.3*x,.14*x))}let m=this.#e(0);this.#i(m,f,p),this.fixed.add(m),this.grid_m=c,this.size=Math.min(Math.max(l/45,.6),4),this.scene.background=new Zt(o.paper)}#n(t){let[e,n,s]=Kr(t)??[[-4,4],[-4,4],[0,0]],r=e.flatMap(l=>n.flatMap(c=>s.map(h=>Zn([l,c,-h]).project(this.camera)))),[o,a]=[r.map(l=>l.x),r.map(l=>l.y)];return{x0:Math.min(...o),x1:Math.max(...o),y0:Math.min(...a),y1:Math.max(...a),behind:r.some(l=>l.z>1)}}#r(t){let{x0:e,x1:n,y0:s,y1:r,behind:o}=this.#n(t);return!o&&e>-1&&n<1&&s>-1&&r<1&&Math.max(n-e,r-s)>2*ST}#a(t){let e=Kr(t);if(!e||!t.count)return;let[[n,s],[r,o],[a,l]]=e;this.target.set((r+o)/2,(a+l)/2,-(n+s)/2);let c=Math.tan(this.camera.fov*Math.PI/360),[h,u]=[new W,new W],d=4*Math.max(s-n,o-r,l-a,e_);for(let f=0;f<MT;f+=1){this.camera.position.copy(xT).setLength(d).add(this.target),this.camera.lookAt(this.target),this.camera.updateMatrixWorld();let{x0:p,x1:y,y0:m,y1:g}=this.#n(t);this.camera.matrixWorld.extractBasis(h,u,new W),this.target.addScaledVector(h,.5*(p+y)*d*c*this.camera.aspect).addScaledVector(u,.5*(m+g)*d*c),d=Math.max(d*Math.max(y-p,g-m)/(2*vT),e_)}this.controls.target.copy(this.target),this.controls.update(),this.framed=!0}draw(t,e,{chosen:n,selected:s,paths:r,until_s:o,trail_s:a,ghosts:l}){let c=this.canvas.getBoundingClientRect();if(!c.width||!c.height)return;(this.width!==c.width||this.height!==c.height)&&([this.width,this.height]=[c.width,c.height],this.renderer.setPixelRatio(Math.min(window.devicePixelRatio||1,2)),this.renderer.setSize(c.width,c.height,!1),this.camera.aspect=c.width/c.height,this.camera.updateProjectionMatrix()),this.#s(t,e.t_s);let h=`${Kr(t)} ${this.camera.aspect}`;(!this.framed||this.mode==="free"&&!this.touched&&this.framedOf!==h&&!this.#r(t))&&(this.#a(t),this.framedOf=h),this.#c(e,n),this.#h(t,e,l,o,r),this.paths.visible=r,r&&this.#u(t,o,a,n),this.#d(e,n),this.renderer.render(this.scene,this.camera),this.#f(e,n,s),l.length&&this.#o(l,o)}#l(t,e,n,s){let r=.35*this.size;for(let o of t){for(let c of o.at(e)?.vehicles??[]){if(!c.p_ned)continue;let h=Zn(c.p_ned),u=[[r,0,0],[0,0,r],[-r,0,0],[0,0,-r]].map(([d,f,p])=>h.clone().add(new W(d,f,p)));u.forEach((d,f)=>s(d,u[(f+1)%4]));for(let d of[r,-r])for(let f of u)s(f,h.clone().add(new W(0,d,0)))}let a=n?Fn(o.t_s,e+1e-6,o.count)+1:0,l=Math.max(Math.ceil(a*o.columns.size/j0),1);for(let c of o.columns.values()){let{n:h,e:u,d}=c;for(let f=0;f+l<a;f+=2*l)!Ls(c,f)&&!Ls(c,f+l)&&s(Zn([h[f],u[f],d[f]]),Zn([h[f+l],u[f+l],d[f+l]]))}}}#o(t,e){let n=lr(this.names),s=new W;n.font="11px system-ui, sans-serif",n.fillStyle=he().soft;for(let r of t.flatMap(o=>o.at(e)?.vehicles??[]))r.p_ned&&(Zn(r.p_ned,s).project(this.camera),s.z<=1&&n.fillText(`(${r.sysid})`,(s.x+1)/2*this.width+9,(1-s.y)/2*this.height+14))}#c(t,e){let n=new Map([["pursuer",0],["target",0],["tanker",0]]),s=new Re,r=new In,o=new W,a=new W,l=new Zt,c=t.vehicles.length>Do;for(let h of t.vehicles){if(!h.p_ned||this.mode==="first"&&h.sysid===e)continue;let u=n.has(h.role)?h.role:"pursuer",d=`${u} ${c}`,f=this.bodies.get(d);f||(f=new Ma(J0(u,c),this.material,t_+1),f.frustumCulled=!1,this.bodies.set(d,f),this.scene.add(f));let p=n.get(u)??0;if(p>t_)continue;let y=this.size*(h.sysid===e?1.35:1);f.setMatrixAt(p,s.compose(Zn(h.p_ned,o),n_(h,r),a.setScalar(y))),f.setColorAt(p,l.set(h.alive?pn(h.sysid):he().solid)),n.set(u,p+1)}for(let[h,u]of this.bodies)u.count=h.endsWith(String(c))?n.get(h.split(" ")[0])??0:0,u.instanceMatrix.needsUpdate=!0,u.instanceColor&&(u.instanceColor.needsUpdate=!0)}#h(t,e,n,s,r){let o=[],a=[],l=he(),[c,h,u]=[new Zt(l.soft),new Zt(l.warn),new Zt(l.crowd.replace(/,[^,]*\)$/,")").replace("rgba","rgb"))],d=(m,g,_)=>{o.push(m.x,m.y,m.z,g.x,g.y,g.z),a.push(_.r,_.g,_.b,_.r,_.g,_.b)},f=new Map,p=e.vehicles.length<=Do,y=t.session?.ring_m??null;for(let m of e.vehicles){if(!m.p_ned)continue;let g=Zn(m.p_ned);if(f.set(m.sysid,g),p&&d(g,g.clone().setY(0),u),p&&m.aim_ned&&d(g,Zn(m.aim_ned),c),m.role==="target"&&y!==null)for(let _=0;_<Q0;_+=1){let[M,x]=[_,_+1].map(C=>2*Math.PI*C/Q0);d(new W(g.x+y*Math.cos(M),g.y,g.z+y*Math.sin(M)),new W(g.x+y*Math.cos(x),g.y,g.z+y*Math.sin(x)),c)}}for(let m of t.session?.bases??[])f.set(`base ${m.name}`,Zn(m.p_ned));for(let m of e.services){let g=f.get(m.tanker??`base ${m.base}`),_=f.get(m.receiver);if(!g||!_)continue;let M=m.phase==="transfer"?1:9;for(let x=0;x<M;x+=2)d(g.clone().lerp(_,x/M),g.clone().lerp(_,(x+1)/M),h);if(m.phase==="transfer")for(let x of[-.06,.06])d(g.clone().add(new W(0,x,0)),_.clone().add(new W(0,x,0)),h)}for(let m of e.traffic){let g=Zn(m.p_ned),_=.6*this.size,[M,x]=[g.clone().setY(g.y+_),g.clone().setY(g.y-_)],C=[[_,0],[0,_],[-_,0],[0,-_]].map(([T,v])=>new W(g.x+T,g.y,g.z+v));C.forEach((T,v)=>{d(M,T,h),d(x,T,h),d(T,C[(v+1)%4],h)})}this.#l(n,s,r,(m,g)=>d(m,g,c)),this.#i(this.lines,o,a)}#u(t,e,n,s){let r=he().dark,o=this.pathsOf,a=performance.now();if(o.version===t.version&&o.until_s===e&&o.chosen===s&&o.dark===r||t.columns.size>Do&&a-o.at<900&&o.chosen===s&&o.dark===r&&e>=o.until_s)return;this.pathsOf={version:t.version,until_s:e,chosen:s,dark:r,at:a};let l=Fn(t.t_s,e+1e-6,t.count)+1,c=Fn(t.t_s,e-n,t.count)+1,h=[],u=[],d=new Zt(he().paper),f=t.columns.size>Do,[p,y]=[new Zt,new Zt];for(let[m,g]of t.columns){let{n:_,e:M,d:x}=g,C=new Zt(pn(m));(s===null?f:m!==s)&&C.lerp(d,f?.6:.45);let T=m===s?0:c,v=Math.max(Math.ceil((l-T)/(f?gT:j0/t.columns.size)),1),b=(R,P)=>P.copy(C).lerp(d,m===s||!c?0:_T*(l-1-R)/(l-T));for(let R=T;R<l-1;R+=v){let P=Math.min(R+v,l-1);Ls(g,R)||Ls(g,P)||(h.push(M[R],-x[R],-_[R],M[P],-x[P],-_[P]),u.push(...b(R,p).toArray(),...b(P,y).toArray()))}}this.#i(this.paths,h,u)}#d(t,e){let n=t.vehicles.find(r=>r.sysid===e);if(this.controls.enabled=this.mode!=="first"||!n?.p_ned,!n?.p_ned||this.mode==="free"){this.controls.update();return}let s=Zn(n.p_ned);if(this.mode==="follow"){let r=this.camera.position.clone().sub(this.controls.target),o=Math.min(r.length(),14*this.size);this.controls.target.copy(s),this.camera.position.copy(s).add(r.setLength(Math.max(o,2*this.size))),this.camera.lookAt(s);return}n_(n,this.camera.quaternion),this.camera.position.copy(s).add(new W(0,.12,0).applyQuaternion(this.camera.quaternion))}#f(t,e,n){let s=Math.min(window.devicePixelRatio||1,2),{width:r,height:o}=this,a=t.vehicles.length>Do;this.names.width!==Math.round(r*s)&&(this.names.width=Math.round(r*s)),this.names.height!==Math.round(o*s)&&(this.names.height=Math.round(o*s));let l=lr(this.names);l.setTransform(s,0,0,s,0,0),l.clearRect(0,0,r,o),l.font=`600 ${Yr(12)}px system-ui, sans-serif`;let c=Yr(a?5:8),{ink:h,paper:u,soft:d,warn:f}=he(),p=new W;this.places=[];let y=[],m=(M,x,C,T)=>{y.some(([v,b])=>Math.abs(v-x)<24&&Math.abs(b-C)<13)||(y.push([x,C]),l.lineWidth=3,l.strokeStyle=u,l.strokeText(M,x+9,C-7),l.fillStyle=T,l.fillText(M,x+9,C-7))},g=[...t.vehicles].sort((M,x)=>+(x.sysid===e)-+(M.sysid===e)||x.severity-M.severity);for(let M of g){if(!M.p_ned||(Zn(M.p_ned,p).project(this.camera),p.z>1))continue;let[x,C]=[(p.x+1)/2*r,(1-p.y)/2*o];this.places.push({sysid:M.sysid,x,y:C}),Dl(l,M,x,C,c),n.has(M.sysid)&&(M.sysid!==e||this.mode!=="first")&&(l.strokeStyle=h,l.lineWidth=M.sysid===e?2.5:1.5,l.beginPath(),l.arc(x,C,15,0,2*Math.PI),l.stroke()),y.length<Do&&(!a||M.sysid===e||M.severity>1||M.role!=="pursuer")&&m(String(M.sysid),x,C,h)}for(let M of t.traffic)Zn(M.p_ned,p).project(this.camera),p.z<=1&&m(M.callsign,(p.x+1)/2*r,(1-p.y)/2*o,f);let _=this.camera.getWorldDirection(p);Ul(l,r-20,20,Math.atan2(-_.x,-_.z)),this.grid_m&&(l.font="12px system-ui, sans-serif",l.textAlign="right",l.fillStyle=d,l.fillText(`squares of ${this.grid_m} m`,r-14,o-10),l.textAlign="left")}};var Sf=14,tl=[];function i_(i){tl=i}function wr(i){let t=tl.findIndex(e=>e.name===i.condition);return t<0?tl.length:t}function bT(i,t){return i.slice(0,Sf).map((n,s)=>`${n.sysid}${n.figure?` (${n.figure}${s||!t?"":` ${t}`})`:""}`).join(", ")+(i.length>Sf?` and ${i.length-Sf} more`:"")}var Wh=class{constructor(t){this.well=N("p",{class:"well"}),this.stale=!1,this.parts=new Map;let e=N("ul");for(let{name:n,title:s}of tl){let[r,o]=[N("b"),N("span",{class:"figures-of"})],a=N("button",{type:"button",onclick:()=>t(this.parts.get(n)?.sysids??[])},N("span",{class:"sign","aria-hidden":"true"},Hu[n]??""),r,o),l=N("li",{class:n,"data-condition":n,"data-title":s},a);l.hidden=!0,e.append(l),this.parts.set(n,{item:l,button:a,count:r,text:o,sysids:[]})}this.counts=N("p",{class:"unseen","aria-live":"polite"}),this.all=N("div",{class:"all"}),this.element=N("section",{class:"strip","aria-label":"trouble"},this.well,e,this.all,this.counts)}show(t){let e=[];for(let{name:r,title:o,unit:a}of tl){let l=this.parts.get(r);if(!l)continue;let c=t.vehicles.filter(u=>u.condition===r).sort((u,d)=>d.urgency-u.urgency||u.sysid-d.sysid);if(l.sysids=c.map(u=>u.sysid),l.item.hidden!==!c.length&&(l.item.hidden=!c.length),!c.length)continue;let h=`${o}: ${bT(c,a)}`;me(l.count,String(c.length)),me(l.text,h),l.button.title=`${h}. Click to select.`,e.push(`${c.length} ${o.toLowerCase()}`)}let n=t.vehicles.filter(r=>r.armed).length,s=e.length||this.stale?"":`All well · ${Qs(t.vehicles.length)}, ${n} armed`;this.well.hidden!==!s&&(this.well.hidden=!s),me(this.well,s),me(this.counts,e.join(", "))}};var Xh=10,Ys=[{key:"id",name:"id",text:i=>String(i.sysid),sort:i=>i.sysid},{key:"trouble",name:"trouble",word:!0,text:i=>i.trouble.join(", ")||i.note||(i.landed?"landed":""),sort:i=>wr(i)+(i.condition||i.landed?0:.5)},{key:"state",name:"state",word:!0,folds:!0,text:i=>i.state||(i.alive?"–":"lost"),sort:i=>i.state},{key:"mode",name:"mode",word:!0,folds:!0,text:i=>Vi(i)||"–",sort:Vi},{key:"role",name:"role",word:!0,folds:!0,text:i=>i.role,sort:i=>i.role},{key:"battery",name:"battery %",text:i=>oe(i.battery===null?null:100*i.battery,0),sort:i=>i.battery??-1},{key:"height",name:"height m",text:i=>oe(i.height_m,1),sort:i=>i.height_m??-1e9},{key:"speed",name:"speed m/s",text:i=>oe(i.speed_m_s,1),sort:i=>i.speed_m_s??-1},{key:"target",name:"target m",text:i=>oe(i.target_m,1),sort:i=>i.target_m??-1}],wT=Ys.filter(i=>i.folds),s_=i=>[i.word&&"word",i.folds&&"folds",i.key==="trouble"&&"trouble"].filter(Boolean).join(" "),qh=class{constructor(t,e){this.choose=e,this.by="trouble",this.down=!1,this.rows=new Map,this.filter=N("input",{type:"search",placeholder:"filter, e.g. tanker, served, 12","aria-label":"filter vehicles",oninput:()=>this.again()}),this.goto=N("input",{type:"text",inputmode:"numeric",size:4,placeholder:"id","aria-label":"go to vehicle"});let n=N("form",{class:"goto",onsubmit:r=>{r.preventDefault();let o=Number(this.goto.value);this.rows.has(o)&&e(o,!0),this.goto.setCustomValidity(this.rows.has(o)?"":"There is no such vehicle."),this.goto.reportValidity()}},this.goto,N("button",{type:"submit"},"go to"));this.goto.addEventListener("input",()=>this.goto.setCustomValidity("")),this.totals=N("p",{class:"totals small","aria-live":"off"}),this.histogram=N("div",{class:"histogram",role:"img","aria-label":"batteries: not known yet"}),this.heads=Ys.map(r=>{let o=N("button",{type:"button",onclick:()=>this.sortBy(r.key)},r.name);return N("th",{scope:"col",class:s_(r)},o)}),this.body=N("tbody");let s=N("table",{class:"fleet"},N("thead",{},N("tr",{},...this.heads)),this.body);t.append(N("div",{class:"tools"},this.filter,n),this.totals,this.histogram,N("div",{class:"scroll fleet-scroll",tabindex:0,role:"region","aria-label":"vehicles"},s)),this.sortBy("trouble",!1)}sortBy(t,e=!0){this.down=e&&this.by===t&&!this.down,this.by=t,this.heads.forEach((n,s)=>{Ys[s].key===t?n.setAttribute("aria-sort",this.down?"descending":"ascending"):n.removeAttribute("aria-sort")}),this.again()}again(){this.last&&this.show(this.last.snapshot,this.last.chosen,this.last.picked)}show(t,e,n){let s=this.last?.picked!==n;this.last={snapshot:t,chosen:e,picked:n};let r=this.filter.value.trim().toLowerCase(),o=Ys.find(c=>c.key===this.by)??Ys[0],a=[...t.vehicles].sort((c,h)=>{let[u,d]=[o.sort(c),o.sort(h)],f=u<d?-1:u>d?1:c.sysid-h.sysid;return this.down?-f:f}),l=[];for(let c of a){let h=this.rows.get(c.sysid)??this.#t(c);Ys.forEach((y,m)=>me(h.texts[m],y.text(c))),me(h.sign,Pm(c)),me(h.folded,wT.map(y=>y.text(c)).filter(y=>y!=="–").join(" · "));let u=pn(c.sysid);h.colour!==u&&(h.swatch.style.background=h.colour=u);let d=`${c.sysid} ${c.role} ${c.label} ${c.state} ${c.mode} ${c.mode_name} ${c.note} ${c.trouble.join(" ")}`.toLowerCase(),f=r!==""&&!r.split(/\s+/).every(y=>/^\d+$/.test(y)?String(c.sysid).startsWith(y):d.includes(y));h.row.hidden!==f&&(h.row.hidden=f);let p=String(n.has(c.sysid));h.row.getAttribute("aria-selected")!==p&&h.row.setAttribute("aria-selected",p),h.row.className!==c.condition&&(h.row.className=c.condition),l.push(h.row)}(l.some((c,h)=>this.body.children[h]!==c)||this.body.children.length!==l.length)&&this.body.replaceChildren(...l),this.#e(t),s&&e!==null&&this.rows.get(e)?.row.scrollIntoView({block:"nearest"})}get shown(){return[...this.rows].filter(([,t])=>!t.row.hidden).sort(([,t],[,e])=>t.row.rowIndex-e.row.rowIndex).map(([t])=>t)}between(t,e,n){if(!(n.target instanceof Node&&this.body.contains(n.target)))return null;let{shown:s}=this,[r,o]=[s.indexOf(t),s.indexOf(e)].sort((a,l)=>a-l);return r<0?null:s.slice(r,o+1)}#t(t){let e=N("i",{class:"swatch"}),n=N("span",{class:"sign","aria-hidden":"true"}),s=N("small",{class:"folded"}),r=Ys.map((h,u)=>u?N("span"):N("button",{type:"button",class:"link"})),o=Ys.map((h,u)=>{let d={id:[e],trouble:[n]}[h.key]??[];return N("td",{class:s_(h)},...d,r[u],h.key==="trouble"?s:null)}),a=h=>this.choose(t.sysid,!1,h),c={row:N("tr",{onclick:a,onkeydown:h=>{h.key!=="Enter"||!(h.shiftKey||h.ctrlKey||h.metaKey)||(h.preventDefault(),a(h))}},...o),texts:r,sign:n,folded:s,swatch:e,colour:""};return this.rows.set(t.sysid,c),c}#e(t){let e=new Map,n=new Array(Xh).fill(0);for(let a of t.vehicles){let l=Vi(a)||a.state||"unknown";e.set(l,(e.get(l)??0)+1),a.battery!==null&&Number.isFinite(a.battery)&&(n[Math.min(Math.max(Math.floor(Xh*a.battery),0),Xh-1)]+=1)}let s=[...e].sort((a,l)=>l[1]-a[1]).map(([a,l])=>`${l} ${a}`);me(this.totals,`${Qs(t.vehicles.length)}: ${s.join(", ")}`);let r=Math.max(...n,1);for(;this.histogram.children.length<Xh;)this.histogram.append(N("span"));n.forEach((a,l)=>{let c=this.histogram.children[l];c.style.height=`${100*a/r}%`,c.title=`${a} with ${10*l} to ${10*l+10} %`,c.className=l<2?"low":""});let o=n[0]+n[1];this.histogram.setAttribute("aria-label",`batteries, by tenths from empty to full: ${n.join(", ")}; ${o} below 20 %`)}};var TT=100;function el(){let i=Number.parseFloat(new URLSearchParams(location.hash.slice(1)).get("t")??"");return Number.isFinite(i)?i:null}var $h=class{constructor(t,e){this.player=e,this.marks=N("canvas",{class:"marks","aria-hidden":"true"}),this.slider=N("input",{type:"range",min:0,max:1,step:.1,value:0,"aria-label":"time",oninput:()=>{this.dragged_at=performance.now(),e.seek(Number(this.slider.value))}}),this.dragged_at=-1/0,this.play=N("button",{type:"button",onclick:()=>e.toggle()},"pause"),this.slower=N("button",{type:"button","aria-label":"slower",onclick:()=>e.faster(-1)},"−"),this.quicker=N("button",{type:"button","aria-label":"faster",onclick:()=>e.faster(1)},"+"),this.speed=N("span",{class:"value"}),this.time=N("span",{class:"value time"}),this.live=N("button",{type:"button",class:"live",onclick:()=>e.newest?.()},"live"),this.live.hidden=!e.newest,this.marked="",t.append(N("div",{class:"tools"},this.play,this.slower,this.speed,this.quicker,this.time,this.live),N("div",{class:"line"},this.marks,this.slider))}show({now_s:t,begin_s:e,end_s:n,playing:s,speed:r,following:o,events:a}){me(this.play,s?"pause":"play"),me(this.speed,r),me(this.time,`${bi(t)} of ${bi(n)}`),this.live.setAttribute("aria-pressed",String(o));let[l,c]=[e.toFixed(1),Math.max(n,e+.1).toFixed(1)];this.slider.min!==l&&(this.slider.min=l),this.slider.max!==c&&(this.slider.max=c),performance.now()-this.dragged_at>4*TT&&(this.slider.value=t.toFixed(1)),this.slider.setAttribute("aria-valuetext",bi(t));let u=`${this.marks.clientWidth} ${a.length} ${l} ${c} ${he().dark}`;if(u===this.marked)return;this.marked=u;let{width:d,height:f,scale:p}=ll(this.marks),y=lr(this.marks),{bad:m,warn:g,soft:_}=he();y.setTransform(p,0,0,p,0,0),y.clearRect(0,0,d,f);let M=Math.max(n-e,.1);for(let x of["info","warning","critical"]){y.fillStyle=x==="info"?_:x==="warning"?g:m;let C=x==="info"?.4:x==="warning"?.7:1;for(let T of a)T.level!==x||T.t_s<e||T.t_s>n||y.fillRect((T.t_s-e)/M*d-.75,f*(1-C),1.5,f*C)}}};var Ss=[.1,.25,.5,1,2,5,10,20,50,100],Zs=16,ET=20,AT=500,CT=300,RT=200,PT=[{title:"Distance to target",unit:"m",digits:2,channel:"target",zero:!0},{title:"Battery",unit:"%",digits:1,channel:"battery",zero:!0},{title:"Height",unit:"m",digits:2,channel:"height"},{title:"Speed",unit:"m/s",digits:2,channel:"speed",zero:!0},{title:"State v of each competitor",unit:"",digits:3,channel:"v",range:[-.03,1.06]},{title:"Frames lost so far",unit:"",digits:0,channel:"lost",zero:!0}],No=class{constructor(t,{charts:e,player:n}){this.flight=new $r,this.time=new Il,this.at_s=null,this.chosen=null,this.selected=new Set,this.shown=new Set,this.given=!1,this.paths=!0,this.whole_paths=!1,this.view="space",this.player=n,this.playing=!0,this.speed="",this.begin_s=void 0,this.end_s=void 0,this.dirty=!0,this.drawn_ms=0,this.frames=0,this.after=[],this.current=null,this.paneled=null,this.paneledFor=null,this.charted=-1,this.charted_at=0,this.shown_at=0,this.time.seek=_=>n.seek(_),this.drawnFirst=()=>{},this.first=new Promise(_=>this.drawnFirst=()=>_(null));let s=(_,M)=>this.pick(_,M);this.strip=new Wh(_=>this.select(_));let r=N("canvas",{class:"space",tabindex:0,role:"img","aria-label":"the fleet in space; arrow keys turn, + and − zoom, 0 shows everything, b selects all in the picture"}),o=N("canvas",{class:"names","aria-hidden":"true"}),a=N("canvas",{class:"map",tabindex:0,role:"img","aria-label":"the fleet from above, north up; arrow keys move, + and − zoom, 0 shows everything, b selects all in the picture"});this.views={space:N("button",{type:"button",onclick:()=>this.show("space")},"3-D",Cs("3")),map:N("button",{type:"button",onclick:()=>this.show("map")},"map",Cs("M"))},this.camera=N("select",{"aria-label":"camera",onchange:()=>this.setCamera(this.camera.value)},N("option",{value:"free"},"free view"),N("option",{value:"follow"},"follow chosen"),N("option",{value:"first"},"from its eyes"));let l=N("button",{type:"button",onclick:()=>this.whole()},"show all",Cs("0"));this.pathsButton=N("button",{type:"button","aria-pressed":"true",onclick:()=>this.togglePaths()},"paths",Cs("V")),this.wind=N("span",{class:"soft wind"});let c=N("div",{class:"picture"},r,o,a);this.box=new cl(c,{places:()=>this.places,take:(_,M)=>this.select(M?[...new Set([...this.selected,..._])]:_),pick:s}),this.hover=new Nl(c,()=>({places:this.places,rows:this.current?.vehicles??[]}));let h=N("div",{class:"tools"},this.views.space,this.views.map,this.camera,l,this.pathsButton,this.box.button,this.wind),u=N("section",{class:"card scene","aria-label":"picture"},h,c),d=N("section",{class:"card time-line","aria-label":"time"}),f=N("section",{class:"card","aria-label":"fleet"},N("h2",{},"Fleet")),p=N("section",{class:"card vehicle","aria-label":"vehicle"},N("h2",{},"Vehicle")),y=N("section",{class:"card contest","aria-label":"competition and refuelling"},N("h2",{},"Competition and refuelling")),m=N("section",{class:"card","aria-label":"events"},N("h2",{},"Events"));this.vehicleAt=N("div",{class:"vehicle-page"}),this.orders=N("div",{class:"tools orders"}),this.selection=N("p",{class:"small selection","aria-live":"polite"}),p.append(this.selection,this.orders,this.vehicleAt),this.contestAt=N("div"),y.append(this.contestAt),this.plansAt=N("div",{class:"plans"}),this.plansCard=N("section",{class:"card","aria-label":"missions and fences"},N("h2",{},"Missions and fences"),this.plansAt),this.plansCard.hidden=!0,t.append(N("div",{class:"flight"},N("div",{class:"wide"},u,d),N("div",{class:"narrow"},f,p),N("div",{class:"narrow"},this.plansCard,y,m))),this.map=new Jr(a,s);try{this.space=new Hh(r,o,s)}catch{this.space=null,this.views.space.disabled=!0}this.timeline=new $h(d,n),this.table=new qh(f,(_,M,x)=>{this.pick(_,x),M&&this.setCamera("follow")}),this.events=new kl(m,_=>{_.sysid>0&&_.sysid<255&&this.choose(_.sysid),n.seek(_.t_s)}),this.charts=[],this.picker=null,e&&this.#t(t),this.show(this.space?"space":"map"),Al(()=>{this.dirty=!0,this.charted_at=0,this.space&&(this.space.pathsOf.version=-1),this.table.again(),this.fillPicker()}),new ResizeObserver(()=>this.dirty=!0).observe(c);let g=()=>{requestAnimationFrame(g),this.#s()};requestAnimationFrame(g)}#t(t){this.picker=N("fieldset",{class:"picker"},N("legend",{},"Vehicles:"));let e=N("div",{class:"figures"});t.append(N("section",{class:"charts","aria-label":"charts"},N("h2",{},"Over time"),this.picker,e));let n=new IntersectionObserver(s=>{for(let r of s){let o=this.charts.find(a=>a.div===r.target);o&&(o.seen=r.isIntersecting),this.charted_at=0}});for(let s of PT){let r=N("div",{class:"plot",role:"img","aria-label":`${s.title} over time`});e.append(N("figure",{},r)),this.charts.push({chart:new qr(r,this.time,o=>this.label(o)),div:r,make:()=>this.#e(s),seen:!1}),n.observe(r)}}#e(t){let{flight:e}=this,n=e.t_s.subarray(0,e.count),s=[];for(let[u,d]of e.columns){let f=d[t.channel].subarray(0,e.count);this.shown.has(u)&&f.some(p=>!Number.isNaN(p))&&s.push({id:u,x:n,y:f})}let r=e.newest?.goal,o=t.channel==="target"&&r?.pursue_within_m?[{y:r.pursue_within_m,label:`goal: within ${r.pursue_within_m} m`}]:[],a=e.columns.size>Zs?this.#i(t.channel):void 0,l=t.channel==="battery"||t.channel==="v"?[...e.newest?.history??[],...e.newest?.services??[]]:[],c=t.channel==="v"?l.map(u=>({t_s:u.decided_at_s,id:u.receiver,label:`→ ${u.receiver}`})):[],h=t.channel!=="battery"?[]:(e.newest?.history??[]).filter(u=>u.start_s!==null&&this.shown.has(u.receiver)).map(u=>({from:u.start_s??0,to:u.end_s??e.last_s,id:u.receiver}));return{panels:[{...t,limits:o,lines:s,own:[],band:a}],marks:c,spans:h}}#i(t){let{flight:e}=this,n=Math.max(Math.floor(e.count/CT),1),s=[...e.columns.values()].map(c=>c[t]),[r,o,a,l]=[[],[],[],[]];for(let c=0;c<e.count;c+=n){let h=Float32Array.from(s,u=>u[c]).filter(u=>!Number.isNaN(u)).sort();r.push(e.t_s[c]),o.push(h[0]??NaN),a.push(h[h.length>>1]??NaN),l.push(h[h.length-1]??NaN)}return{least:{x:r,y:o},median:{x:r,y:a},greatest:{x:r,y:l},count:s.length}}label(t){return this.flight.session?.vehicles.find(e=>e.sysid===t)?.label??`vehicle ${t}`}members(){let t=this.flight.session?.vehicles??[];El(t),this.given||(this.shown=new Set(t.length>Zs?[]:t.map(n=>n.sysid))),this.space&&(this.space.madeOf=null),this.plansCard.hidden=!Zr(this.flight.session).length;let e=this.flight.session?.wind;me(this.wind,e?`wind ${oe(e.speed_m_s,1)} m/s from ${oe(e.from_deg,0)}°`:""),this.fillPicker(),this.dirty=!0}fillPicker(){if(!this.picker)return;let t=this.flight.session?.vehicles??[],n=(t.length>Zs?t.filter(s=>this.shown.has(s.sysid)):t).map(s=>{let r=N("i",{class:"swatch"});return r.style.background=pn(s.sysid),N("button",{type:"button","aria-pressed":String(this.shown.has(s.sysid)),onclick:()=>this.toggle(s.sysid)},r,s.label)});if(this.picker.replaceChildren(N("legend",{},t.length>Zs?"Drawn singly:":"Vehicles:"),...n),t.length>Zs){let s=N("select",{"aria-label":"draw one more vehicle singly",onchange:()=>s.value&&this.toggle(Number(s.value))},N("option",{value:""},"one more …"),...t.filter(o=>!this.shown.has(o.sysid)).map(o=>N("option",{value:o.sysid},o.label)));this.picker.append(s,N("span",{class:"small soft"},"The ground is from the least to the greatest of all vehicles, dotted their median."))}}toggle(t){this.shown.delete(t)||this.shown.add(t),this.given=!0,this.fillPicker(),this.charted_at=0,this.after.forEach(e=>e())}choose(t){this.select(t===null?[]:[t])}pick(t,e){if(t===null||!(e?.shiftKey||e?.ctrlKey||e?.metaKey))return this.choose(t);let n=e.shiftKey&&this.chosen!==null?this.table.between(this.chosen,t,e):null;if(n)return this.select([...new Set([t,...n,...this.selected])]);let s=[...this.selected].filter(r=>r!==t);this.select(this.selected.has(t)?s:[t,...s])}get ghosts(){return this.flight.ghosts}set ghosts(t){this.flight.ghosts=t,this.flight.version+=1,this.space&&(this.space.madeOf=null),this.dirty=!0}get places(){return(this.view==="space"?this.space?.places:this.map.places)??[]}selectInPicture(){let{width:t,height:e}=(this.view==="space"&&this.space?this.space.canvas:this.map.canvas).getBoundingClientRect();this.select(cu(this.places,[0,0],[t,e]))}selectAll(){this.select(this.table.shown)}select(t){let e=t[0]??null;this.chosen=e,this.selected=new Set(t),me(this.selection,t.length>1?`${t.length} vehicles selected: hold, return and land go to all of them.`:""),(this.flight.session?.vehicles.length??0)>Zs&&e!==null&&!this.shown.has(e)&&this.toggle(e),e===null&&this.setCamera("free"),this.dirty=!0}chooseNext(t){let e=(this.flight.session?.vehicles??[]).map(s=>s.sysid).sort((s,r)=>s-r);if(!e.length)return;let n=this.chosen===null?t>0?-1:0:e.indexOf(this.chosen);this.choose(e[(n+t+e.length)%e.length])}show(t){this.view=t==="space"&&this.space?"space":"map";for(let[e,n]of Object.entries(this.views))n.setAttribute("aria-pressed",String(e===this.view));this.map.canvas.hidden=this.view!=="map",this.space&&(this.space.canvas.hidden=this.space.names.hidden=this.view!=="space"),this.setCamera(this.camera.value)}setCamera(t){this.camera.value=t,this.space&&(this.space.mode=t),this.map.follow=t!=="free",this.dirty=!0}nextCamera(){let t=["free","follow","first"];this.setCamera(t[(t.indexOf(this.camera.value)+1)%t.length])}whole(){this.setCamera("free"),this.map.whole(),this.space?.whole(),this.dirty=!0}togglePaths(){this.paths=!this.paths,this.pathsButton.setAttribute("aria-pressed",String(this.paths)),this.dirty=!0}nextTheme(){ar()}present(){let{flight:t,at_s:e}=this;return e===null?t.newest:t.at(e)}#s(){let t=performance.now(),e=(this.view==="space"?this.space?.dirty:this.map.dirty)??!1;if(!this.dirty&&!e)return void this.#n(t);let n=this.present();if(!n)return;this.dirty=!1,this.map.dirty=!1,this.space&&(this.space.dirty=!1);let s=this.at_s??n.t_s,r={chosen:this.chosen,selected:this.selected,paths:this.paths,until_s:s,trail_s:this.whole_paths&&!this.playing?1/0:ET,ghosts:this.ghosts};this.view==="space"?this.space?.draw(this.flight,n,r):this.map.draw(this.flight,n,r),this.frames+=1,this.drawnFirst(),this.current=n,this.hover.show(),this.time.begin_s=this.flight.first_s,this.time.end_s=Math.max(this.flight.last_s,this.end_s??0),this.time.setNow(s),this.timeline.show({now_s:s,begin_s:this.begin_s??this.flight.first_s,end_s:this.end_s??Math.max(this.flight.last_s,n.t_s),playing:this.playing,speed:this.speed,following:this.at_s===null,events:this.flight.events}),this.#n(t)}#n(t){let e=this.current;if(e&&t-this.shown_at>(this.flight.columns.size>Zs?2.5:1)*RT&&this.paneled!==e){this.shown_at=t,this.paneled=e,this.table.show(e,this.chosen,this.selected);let n=this.player.newest!==null;this.strip.show(n&&this.flight.newest||e),Fm(this.plansAt,this.flight.session,e),zm(this.contestAt,e,s=>this.label(s)),Zu(this.vehicleAt,e,this.chosen,this.flight.session),this.events.show(this.flight.events,this.at_s??1/0,s=>this.label(s));return}if(e&&this.paneledFor!==this.selected&&(this.paneledFor=this.selected,this.table.show(e,this.chosen,this.selected),Zu(this.vehicleAt,e,this.chosen,this.flight.session)),this.charts.length&&t-this.charted_at>(this.flight.columns.size>Zs?2:1)*AT&&this.charted!==this.flight.version){this.charted_at=t,this.charted=this.flight.version;for(let n of this.charts)n.seen&&n.chart.draw(n.make(),this.shown)}this.charted_at===0&&(this.charted=-1)}};var r_=[.25,.5,1,2,4],IT=4401,LT="skytender",Yh=class{constructor(t,e,n){this.restart=n,this.take=t,this.changed=e,this.state="connecting",this.heard=0,this.heard_ms=performance.now(),this.sent=0,this.tries=0,this.socket=null,this.waiting=new Map,this.token=new URLSearchParams(location.hash.slice(1)).get("token")??""}open(){let t=location.protocol==="https:"?"wss":"ws",e=new WebSocket(`${t}://${location.host}/stream`,[LT,`token.${this.token||"none"}`]);this.socket=e,e.onopen=()=>{this.tries=0,this.#e("open")},e.onmessage=n=>{let s=JSON.parse(n.data);for(let r of Array.isArray(s)?s:[s])this.#t(r)},e.onclose=n=>{if(this.state!=="ended"){if(this.#i(),n.code===IT)return void this.#e("refused");this.#e("lost"),setTimeout(()=>this.open(),1e3*r_[Math.min(this.tries,r_.length-1)]),this.tries+=1}}}#t(t){if(this.heard_ms=performance.now(),t.type==="reply"){let e=this.waiting.get(String(t.id));this.waiting.delete(String(t.id)),e?.(t.ok,t.text);return}if(t.type==="session"&&t.events!==void 0){let e=t.told??0,n=e<this.heard,s=Math.min(e-(n?0:this.heard),t.events.length);this.heard=e,n&&this.restart(),t={...t,events:t.events.slice(t.events.length-s)}}else t.type==="snapshot"?this.heard+=t.events.length:t.type==="end"&&this.#e("ended");this.take(t)}get silent_s(){return .001*(performance.now()-this.heard_ms)}send(t,e){if(this.state!=="open"||!this.socket)return e?.(!1,`${this.state==="ended"?"The session has ended":"There is no connection"}: it was not sent.`),!1;this.sent+=1;let n=`page-${this.sent}`;return e&&this.waiting.set(n,e),this.socket.send(JSON.stringify({...t,id:n})),!0}#e(t){this.state=t,this.changed(t)}#i(){for(let t of this.waiting.values())t(!1,"The connection was lost before an answer came.");this.waiting.clear()}};var o_={whole:680,half:332},DT=30;async function l_(i,t){let e=atob((i.getElementById(t)?.textContent??"").trim()),n=Uint8Array.from(e,r=>r.charCodeAt(0)),s=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(s).arrayBuffer()}function Zh(i){document.documentElement.dataset[i]=String(Math.round(performance.now()))}function Mf(i,t,e,n,s){let r=new Uint16Array(i,t,e),o=new Float64Array(e),a=(s-n)/65534;for(let l=0;l<e;l+=1)o[l]=r[l]===65535?NaN:n+a*r[l];return o}function c_(i,t){let e=n=>({...n,x:Mf(t,n.at,n.n,0,i.end_s),y:Mf(t,n.at+2*n.n,n.n,n.low,n.high)});for(let n of Object.values(i.figures))for(let s of n.panels??[])if(s.lines=s.lines.map(e),s.own=s.own.map(e),s.band)for(let r of["least","median","greatest"])s.band[r]=e(s.band[r]);return n=>Float32Array.from(Mf(t,n.at,n.n,n.low,n.high))}async function NT(i){let t=new DOMParser().parseFromString(await i.text(),"text/html"),e=t.getElementById("model")?.textContent,n=e?JSON.parse(e):null;if(!n?.flight)throw new Error("it carries no flight");let s=new $r;return u_(s,n,n.flight,c_(n,await l_(t,"series"))),{flight:s,figures:n.figures}}function UT(i,t){let e=N("span",{class:"small soft",role:"status"}),n=N("input",{type:"file",accept:".html",multiple:!0,"aria-label":"reports to compare with",onchange:async()=>{let s=[...n.files??[]],r=[],o=[],a=[];for(let l of s)try{let c=await NT(l);r.push(c.flight),o.push(c.figures),a.push(`${c.flight.session?.name??l.name}, ${c.flight.last_s.toFixed(1)} s`)}catch(c){a.push(`${l.name} is no report that can be compared (${c.message})`)}e.textContent=a.length?`In grey, ids in brackets: ${a.join("; ")}`:"",i.ghosts=r,t(o)}});return N("label",{class:"small compare"},"compare with other reports ",n," ",e)}function a_({x:i,y:t},e){return Float32Array.from(e,n=>{let s=Fn(i,n);if(s<0)return NaN;let r=Math.min(s+1,i.length-1),o=i[r]-i[s],a=t[s]+(o>0?(n-i[s])/o:0)*(t[r]-t[s]);return Number.isNaN(a)?t[s]:a})}async function h_(i,t){let e=JSON.parse(document.getElementById("model")?.textContent??"{}"),n=await l_(document,"series");Zh("unpacked");let s=c_(e,n);El(e.vehicles.map(R=>({sysid:R.id,role:R.role,colour:R.colour})));let r=new Set(e.chosen),o=R=>e.vehicles.find(P=>P.id===R)?.label??String(R),a=document.getElementById("app"),l=a&&e.flight?FT(a,e,e.flight,s):null,c=l?.time??new bf(e.end_s);if(c.begin_s=0,c.end_s=e.end_s,l){l.shown=r,l.given=!0,l.after.push(()=>x());let R=t(l,[],()=>{}),P=N("div",{class:"tools only-screen"},N("button",{type:"button",onclick:()=>ar()},"dark / light"),N("button",{type:"button",onclick:()=>R.showModal()},"keys ?"),UT(l,d));l.strip.element.classList.add("only-screen"),a?.before(N("div",{class:"over-flight"},P,l.strip.element))}let h=[];for(let R of document.querySelectorAll(".plot[data-figure]")){let P=e.figures[R.dataset.figure??""];!P&&R.dataset.figure!=="flight"||h.push({div:R,draw:u(R,P),drawn:!1})}function u(R,P){if(R.dataset.figure==="flight")return()=>f(R);if(P.kind==="timeline")return()=>Em(R,P,c);if(P.kind==="ledger")return()=>Am(R,P,r,o);let L=new qr(R,c,o);return O=>L.draw(P,r,O)}function d(R){for(let[P,L]of Object.entries(e.figures))L.panels?.forEach((O,V)=>{O.ghosts=R.flatMap(U=>U[P]?.panels?.[V]?.lines??[])});m()}function f(R){if(!l)return;let P=N("canvas",{class:"still"});R.replaceChildren(P);let L=l.flight.at(e.end_s);L&&new Jr(P,()=>{}).draw(l.flight,L,{chosen:null,selected:new Set,paths:!0,until_s:e.end_s,trail_s:1/0,shown:r}),R.dataset.lines=String(r.size)}let p=R=>R.classList.contains("only-print");function y(R,P){R.drawn||R.div.replaceChildren(),R.draw(P),R.drawn=!0}let m=()=>h.filter(R=>R.drawn&&!p(R.div)).forEach(R=>y(R)),g=document.querySelector("fieldset.picker");function _(){g.querySelectorAll("button, select").forEach(O=>O.remove());let R=e.many?[...r].sort((O,V)=>O-V):e.vehicles.map(O=>O.id);for(let O of R){let V=N("i",{class:"swatch"});V.style.background=pn(O),g.append(N("button",{type:"button","aria-pressed":String(r.has(O)),onclick:()=>M(O)},V,o(O)))}if(!e.many)return;let P=e.vehicles.filter(O=>!r.has(O.id)).map(O=>N("option",{value:O.id},O.label)),L=N("select",{"aria-label":"show one more vehicle",onchange:()=>L.value&&M(Number(L.value))},N("option",{value:""},"show one more …"),...P);g.append(L)}function M(R){r.delete(R)||r.add(R),x()}function x(){_(),m(),l&&(l.dirty=!0)}_(),GT(),l&&await l.first,Zh("first");let C=h.filter(R=>!p(R.div)),T=new Set(C);for(let R of C)y(R),T.delete(R),await new Promise(P=>{setTimeout(P)});Zh("flat"),requestAnimationFrame(()=>requestAnimationFrame(()=>Zh("all"))),Al(()=>{_(),m()});let v=document.body.clientWidth,b=!1;return window.addEventListener("resize",()=>{b||document.body.clientWidth===v||(v=document.body.clientWidth,m())}),window.addEventListener("beforeprint",()=>{b=!0,Vu(!0);for(let R of h)y(R,R.div.closest(".pair")?o_.half:o_.whole)}),window.addEventListener("afterprint",()=>{b=!1,Vu(!1),m()}),l}var bf=class{constructor(t){this.begin_s=0,this.end_s=t,this.now_s=NaN,this.zoom=null,this.charts=new Set}get range(){return this.zoom??[0,this.end_s]}setZoom(t){this.zoom=t;let[e,n]=this.range;for(let s of this.charts)for(let r of s.plots)r.setScale("x",{min:e,max:n})}setNow(){}seek(){}point(){}};function FT(i,t,e,n){let s={playing:!1,speed:5,at:performance.now()},r={seek:c=>{o.at_s=Math.min(Math.max(c,0),e.end_s),o.dirty=!0},toggle:()=>{s.playing=!s.playing,s.playing&&(o.at_s??e.end_s)>=e.end_s&&(o.at_s=0),s.at=performance.now(),a()},faster:c=>{s.speed=Ss[Math.min(Math.max(Ss.indexOf(s.speed)+c,0),Ss.length-1)],a()},newest:null},o=new No(i,{charts:!1,player:r});o.whole_paths=!0;let a=()=>{o.playing=s.playing,o.speed=`×${s.speed}`,o.dirty=!0};u_(o.flight,t,e,n),o.begin_s=0,o.end_s=e.end_s,o.members(),a();let l=()=>r.seek(el()??e.end_s);return l(),addEventListener("hashchange",()=>el()!==null&&l()),setInterval(()=>{let c=performance.now();s.playing&&(o.at_s=Math.min((o.at_s??0)+.001*(c-s.at)*s.speed,e.end_s),o.at_s>=e.end_s&&(s.playing=!1),a()),s.at=c},DT),o}function u_(i,t,e,n){i.session=e.session;let s=e.solids??[];i.worlds=(e.worlds??[]).map(([c,h,u])=>({t_s:c,session:{...e.session,obstacles:h.map(d=>s[d]),vehicles:e.session.vehicles.map(d=>({...d,path_ned:u[String(d.sysid)]??d.path_ned}))}})),i.events=e.events,i.count=i.capacity=e.count,i.t_s=Float64Array.from({length:e.count},(c,h)=>h*e.end_s/(e.count-1)),i.share=new Float32Array(e.count).fill(NaN);let r=(c,h)=>new Map((t.figures[c]?.panels[h]?.lines??[]).map(u=>[u.id,u])),o={battery:r("battery",0),v:r("contest",0),lost:r("link",1)},a=r("motion",0),l=t.figures.contest?.panels[1]?.own[0];l&&(i.share=a_(l,i.t_s));for(let c of e.vehicles){let h={};for(let f of rs)h[f]=null;[h.n,h.e,h.d]=c.p.map(n),h.height=h.d.map(f=>-f);for(let f of["heading","roll","pitch"])h[f]=c[f]?n(c[f]):new Float32Array(e.count).fill(NaN);h.age=n(c.age);for(let[f,p]of Object.entries(o)){let y=p.get(c.sysid);h[f]=y?kT(y,i.t_s):null}let u=a.get(c.sysid);h.speed=u?zT(a_(u,i.t_s)):null;let d=new Float32Array(e.count).fill(NaN);for(let f of rs)h[f]??=d;i.columns.set(c.sysid,h),i.words.set(c.sysid,BT(e,String(c.sysid)))}for(let[c,h]of Object.entries(e.targets))OT(i,Number(c),h);for(let c of e.traffic)i.traffic.set(c.callsign,c.p.map(n));i.newest={type:"snapshot",t_s:e.end_s,duration_s:e.session.duration_s,speed:null,phase:"ended",vehicles:[],traffic:[],competition:{v:{},tau:{},leader:null,share:null,runner_up:null,threshold:e.threshold},services:[],history:e.history,refuelled:e.history.length,goal:e.goal,inspected:{},events:[]},i.version+=1}function OT(i,t,e){let n=i.columns.get(t);if(!n)return;let s=e.map(([r])=>r);n.target=Float32Array.from(i.t_s.subarray(0,i.count),(r,o)=>{let a=i.columns.get(e[Math.max(Fn(s,r),0)][1]);return a?Math.hypot(a.n[o]-n.n[o],a.e[o]-n.e[o],a.d[o]-n.d[o]):NaN})}function BT(i,t){let[e,n]=[i.words[t]??[],i.health?.of[t]??[]],s=new jo;s.t_s=[...new Set([...e,...n].map(([a])=>a))].sort((a,l)=>a-l);let[r,o]=[0,0];return s.rows=s.t_s.map(a=>{for(;r+1<e.length&&e[r+1][0]<=a;)r+=1;for(;o+1<n.length&&n[o+1][0]<=a;)o+=1;let[,l="",c=!0,h=!0]=e[r]??[],u=n[o]?i.health.rows[n[o][1]]:{};return{mode_name:l,armed:c,landed:!h,alive:u.condition!=="dead",...u}}),s}function kT({x:i,y:t},e){return Float32Array.from(e,n=>t[Fn(i,n)]??NaN)}function zT(i){for(let t=1;t<i.length;t+=1)Number.isNaN(i[t])&&(i[t]=i[t-1]);return i}function GT(){for(let i of document.querySelectorAll("table.sorts")){let t=[...i.tHead?.rows[0].cells??[]];t.forEach((e,n)=>{let s=()=>{let r=e.getAttribute("aria-sort")!=="ascending";t.forEach(l=>l.removeAttribute("aria-sort")),e.setAttribute("aria-sort",r?"ascending":"descending");let o=l=>l.cells[n].textContent??"",a=[...i.tBodies[0].rows].sort((l,c)=>o(l).localeCompare(o(c),void 0,{numeric:!0}));i.tBodies[0].append(...r?a:a.reverse())};e.replaceChildren(N("button",{type:"button",onclick:s},e.textContent??""))})}}var VT=800,wf=.14,Tf={dead:[880,660,880],silent:[880,660],failing:[880,660],low:[520]},Jh=class{constructor(){this.button=N("button",{type:"button","aria-pressed":"false",title:"a sound where a vehicle dies, falls silent, fails or runs low",onclick:()=>this.toggle()},"sound"),this.audio=null,this.rung=0,this.at=-1/0,this.known=new Map}toggle(){this.audio?(this.audio.close(),this.audio=null):(this.audio=new AudioContext,this.#t(Tf.low)),this.button.setAttribute("aria-pressed",String(this.audio!==null))}watch(t){let e=t.vehicles.filter(n=>wr(n)<(this.known.get(n.sysid)??1/0)&&Tf[n.condition]).sort((n,s)=>wr(n)-wr(s))[0];this.known=new Map(t.vehicles.map(n=>[n.sysid,wr(n)])),!(!e||!this.audio||performance.now()-this.at<VT)&&(this.at=performance.now(),this.rung+=1,this.#t(Tf[e.condition]))}#t(t){let e=this.audio;t.forEach((n,s)=>{let[r,o]=[e.createOscillator(),e.createGain()],a=e.currentTime+s*wf;r.frequency.value=n,o.gain.setValueAtTime(.25,a),o.gain.exponentialRampToValueAtTime(.001,a+wf),r.connect(o).connect(e.destination),r.start(a),r.stop(a+wf)})}};var Uo=Math.PI/180,d_=6378137,f_=.00669438;function HT(i){let t=1-f_*Math.sin(i*Uo)**2;return[Uo*d_*(1-f_)/t**1.5,Uo*d_*Math.cos(i*Uo)/Math.sqrt(t)]}var WT=(i,t)=>(i+180)/360*t,XT=(i,t)=>(1-Math.asinh(Math.tan(i*Uo))/Math.PI)/2*t,qT=(i,t)=>Math.atan(Math.sinh(Math.PI*(1-2*i/t)))/Uo,Kh=class{constructor(t,e){this.template=t,this.arrived=e,this.kept=new Map;let n=new URL(t.replace(/[{}]/g,"")).hostname;this.credit=/(^|\.)openstreetmap\.org$/.test(n)?"© OpenStreetMap contributors":`map: ${n}`}draw(t,e,n,s,r,o){let[a,l]=e;if(Math.abs(a)>85)return;let[c,h]=HT(a),u=Math.min(Math.max(Math.round(Math.log2(360*h*n.perMetre/256)),0),19),d=2**u,[f,p]=[n.height/2/n.perMetre,n.width/2/n.perMetre],[y,m]=[-p,p].map(M=>Math.floor(WT(l+(n.e+M)/h,d))),[g,_]=[f,-f].map(M=>Math.min(Math.max(Math.floor(XT(a+(n.n+M)/c,d)),0),d-1));if(!((m-y+1)*(_-g+1)>80)){for(let M=g;M<=_;M+=1){let[x,C]=[M,M+1].map(T=>r((qT(T,d)-a)*c));for(let T=y;T<=m;T+=1){let v=this.#t(u,(T%d+d)%d,M);if(!v.complete||!v.naturalWidth)continue;let[b,R]=[T,T+1].map(P=>s((360*P/d-180-l)*h));t.drawImage(v,b,x,R-b,C-x)}}t.font="11px system-ui, sans-serif",t.lineWidth=3,t.strokeStyle=o.paper,t.strokeText(this.credit,5,14),t.fillStyle=o.ink,t.fillText(this.credit,5,14)}}#t(t,e,n){let s=this.template.replace("{z}",String(t)).replace("{x}",String(e)).replace("{y}",String(n)),r=this.kept.get(s);return r||(r=new Image,r.referrerPolicy="origin",r.onload=this.arrived,r.src=s,this.kept.size>=400&&this.kept.delete(this.kept.keys().next().value??""),this.kept.set(s,r),r)}};var p_="skytender-tour",nl=[[".strip","Trouble stands here: how many vehicles are dead, silent, failing, low or warned, and how badly. A click selects them."],[".picture","The fleet, in space (key 3) or on a map (key M). Drag to move, click a vehicle to select it, drag with Shift held to select all in a box."],[".fleet-scroll","Every vehicle, those in trouble first. Shift or Ctrl adds to the selection; orders then go to all selected vehicles."],[".top","Orders ask first, and list which vehicles cannot obey. Keys stand on their buttons; the key ? lists them all."],[".time-line","The line of time: go back while the flight goes on, and return with “live”. Marks are events."]],jh=class{constructor(){this.step=-1,this.text=N("p",{"aria-live":"polite"}),this.count=N("b",{class:"small soft"}),this.next=N("button",{type:"button",class:"primary",onclick:()=>this.go(this.step+1)},"Next"),this.element=N("section",{class:"tour","aria-label":"tour"},this.count,this.text,N("div",{class:"tools"},this.next,N("button",{type:"button",onclick:()=>this.end()},"Close tour"))),this.element.hidden=!0,document.body.append(this.element)}first(){try{if(localStorage.getItem(p_))return}catch{return}this.go(0)}go(t){if(t>=nl.length)return this.end();this.#t(t),this.element.hidden=!1,me(this.count,`${t+1} of ${nl.length}`),me(this.text,nl[t][1]),me(this.next,t+1<nl.length?"Next":"Done")}end(){this.#t(-1),this.element.hidden=!0;try{localStorage.setItem(p_,"seen")}catch{}}#t(t){document.querySelector(".pointed")?.classList.remove("pointed"),this.step=t,t>=0&&document.querySelector(nl[t][0])?.classList.add("pointed")}};var $T=[["space","pause, or go on"],["← →","10 s back or on (replay, report, or back in a live flight)"],["< >","slower, faster"],["End","back to the newest"],["[ ]","the vehicle before, after"],["g","go to a vehicle by its id"],["/","filter vehicles"],["3 m","in space, map"],["c","camera: free, follow, from its eyes"],["0","show everything"],["+ − 0","in picture and figures: nearer, farther, everything"],["v","paths on or off"],["b","select all that are in the picture"],["a","select all that the table shows"],["ctrl↵ ⇧↵","on an id in the table: add it to the selection; it and those between"],["Esc","select none"],["d","dark or light"],["?","this page"]],m_=10,YT=3,ZT={session:"live",monitor:"monitor",replay:"replay"};function g_(i,t,e){let n=N("dialog",{class:"ask","aria-label":"keys"}),s=[...$T,...t.map(o=>[o.key.toUpperCase(),o.what,o.command])].map(([o,a,l])=>N("tr",l?{"data-order":l}:{},N("th",{scope:"row"},o),N("td",{class:"word"},a)));n.append(N("h2",{},"Keys"),N("table",{},N("tbody",{},...s)),N("form",{method:"dialog"},N("button",{},"Close"))),document.body.append(n);let r={" ":()=>i.player.toggle(),ArrowLeft:()=>i.player.seek((i.time.now_s??0)-m_),ArrowRight:()=>i.player.seek(i.time.now_s+m_),"<":()=>i.player.faster(-1),">":()=>i.player.faster(1),End:()=>i.player.newest?.(),"[":()=>i.chooseNext(-1),"]":()=>i.chooseNext(1),g:()=>i.table.goto.focus(),"/":()=>i.table.filter.focus(),3:()=>i.show("space"),m:()=>i.show("map"),c:()=>i.nextCamera(),0:()=>i.whole(),v:()=>i.togglePaths(),d:()=>ar(),b:()=>i.selectInPicture(),a:()=>i.selectAll(),Escape:()=>i.choose(null),"?":()=>n.showModal()};return document.addEventListener("keydown",o=>{let a=o.target;if(o.ctrlKey||o.metaKey||o.altKey||a.closest("dialog"))return;if(a.matches("input:not([type=range]), select, textarea")){o.key==="Escape"&&a.blur();return}if(a.matches("input[type=range]")&&o.key.startsWith("Arrow")||a.matches("button, summary")&&(o.key===" "||o.key==="Enter"))return;let l=t.find(c=>c.key.toUpperCase()===o.key&&o.shiftKey);if(l)e(l);else if(r[o.key])r[o.key]();else return;o.preventDefault()}),n}function JT(i){let t=new Map;for(let{role:e}of i)t.set(e,(t.get(e)??0)+1);return[...t].map(([e,n])=>`${n} ${e||"vehicle"}${n===1?"":"s"}`).join(", ")||"Vehicles"}function KT(i){let t=document.getElementById("app"),e=N("h1",{},"Starting …"),n=N("span",{class:"badge"}),s=N("span",{class:"badge phase"}),[r,o]=[N("b",{class:"bad"}),N("span")],a=N("p",{class:"soft small goal-line"},r,o),l=N("button",{type:"button"},"keys ?"),c=N("button",{type:"button",onclick:()=>ar()},"dark / light",Cs("D")),h=new Jh,u=N("a",{target:"_blank"},"Open the report");u.hidden=!0;let d=N("span"),f=N("p",{class:"connection",role:"alert"},d," ",u);f.hidden=!0;let p=N("div",{class:"tools orders"}),y=N("header",{class:"top"},N("div",{class:"tools"},e,n,s,N("span",{class:"gap"}),p,h.button,c,l),a,f);t.before(y);let m=!1,g=!1,_,M=!1,x="",C=!1,T={seek:B=>{m?G.send({command:"seek",t_s:B},v):(b.at_s=B>=b.flight.last_s-.05?null:Math.max(B,b.flight.first_s),b.dirty=!0)},toggle:()=>{m?G.send({command:_?.paused||b.flight.newest?.phase==="ended"?"resume":"pause"},v):L(i.orders.find(B=>B.command==="pause"))},faster:B=>{if(!m)return void R.notice("Speed can be changed only in a replay.");let $=_?.speed??1,et=Ss.reduce((ht,at,Q)=>Math.abs(at-$)<Math.abs(Ss[ht]-$)?Q:ht,0);G.send({command:"speed",speed:Ss[Math.min(Math.max(et+B,0),Ss.length-1)]},v)},newest:()=>{b.at_s=null,b.dirty=!0}},v=(B,$)=>{B||R.notice($,"bad")},b=new No(t,{charts:!0,player:T});y.append(b.strip.element),i.tiles&&(b.map.tiles=new Kh(i.tiles,()=>b.map.dirty=!0));let R=new Bl(i.orders,(B,$)=>G.send(B,$)),P=()=>new Map((b.flight.session?.vehicles??[]).map(B=>[B.sysid,B.plan_b])),L=B=>{let $=G.state==="ended"?"The session has ended: it takes no commands.":M?"":m?"A recording takes no commands.":"View-only link: commands are disabled.";if($)return void R.notice($,"bad");if(!R.takes(B))return void R.notice(`A monitor takes no ${B.name}: it knows hold, return and land.`,"bad");B.of_many&&b.selected.size>1?R.askMany(B,[...b.selected],!1,O,()=>b.flight.newest,P()):R.ask(B,b.chosen,O,()=>b.flight.newest)},O=B=>b.label(B),V=N("p",{class:"starting",role:"status"},"The session is starting.");t.querySelector(".picture")?.append(V);for(let B of[p,b.orders,b.strip.all,n,s])B.hidden=!0;for(let B of i.orders.filter($=>$.of_many&&$.command!=="land")){let $=()=>(b.flight.newest?.vehicles??[]).map(et=>et.sysid);b.strip.all.append(N("button",{type:"button",title:`${B.name} all vehicles`,onclick:()=>R.askMany(B,$(),!0,O,()=>b.flight.newest,P())},`all: ${B.name}`))}l.addEventListener("click",g_(b,i.orders,L).showModal.bind(document.querySelector("dialog[aria-label=keys]")));let U=new Map;for(let B of i.orders){let $=N("button",{type:"button",title:`${B.what} (Shift+${B.key.toUpperCase()})`,onclick:()=>L(B)},B.name,Cs(`⇧${B.key.toUpperCase()}`));(B.of_vehicle?b.orders:p).append($),U.set(B,$)}let G=new Yh(B=>{if(B.type==="session"){b.flight.begin(B),b.flight.tell(B.events??[]),m=B.source==="replay";let $=el();m&&!g&&$!==null&&T.seek($),g=!0,M=!!B.control&&!m,R.monitors=B.source==="monitor";for(let[et,ht]of U){let at=document.querySelector(`dialog tr[data-order=${et.command}]`);ht.hidden=!R.takes(et),at&&(at.hidden=ht.hidden)}document.title=`${B.name} – Skytender`,me(e,B.name);for(let et of[p,b.orders,b.strip.all])et.hidden=!M;Z(),me(V,`${JT(B.vehicles)} ${B.vehicles.length===1?"starts":"start"}; they are shown here as soon as they report.`),b.timeline.live.hidden=m,b.members()}else if(B.type==="snapshot"){_=B.replay,b.flight.take(B),b.flight.tell(B.events),h.watch(B),m?(b.begin_s=_?.from_s,b.end_s=_?.to_s,b.playing=!_?.paused&&B.phase!=="ended",b.speed=`×${_?.speed??1}`):(b.playing=B.phase!=="paused",b.speed=B.speed?`×${B.speed.toFixed(B.speed<10?1:0)}`:""),Z(),V.hidden=!0,me(s,`${B.phase} ${bi(B.t_s)}${B.duration_s?` of ${bi(B.duration_s)}`:""}`);let{goal:$}=B,et=$.pursue_for_s&&$.pursue_held_s!==null?`pursuit held ${$.pursue_held_s.toFixed(0)} of ${$.pursue_for_s.toFixed(0)} s`:"",ht=$.refuelled_at_least?`${B.refuelled} refuelled, at least ${$.refuelled_at_least} wanted`:B.refuelled?`${B.refuelled} refuelled`:"",at=$.broken.map(Q=>Q.text);me(r,at.length?`${at.length} ${at.length===1?"goal":"goals"} failed: ${at.join("; ")}. `:""),me(o,[et,ht].filter(Boolean).join("; ")),a.title=a.textContent??"",b.dirty=!0}else if(B.type==="end"){C=b.flight.newest?.phase!=="ended",x=`The session has ${C?"broken off":"ended"}: ${B.text.replace(/\.$/,"")}. The page keeps what it has seen.`,C||me(r,"");for(let $ of[p,b.orders,b.strip.all])$.hidden=!0;Z()}else B.type==="report"&&(u.href=B.path,u.hidden=!1,Z())},()=>Z(),()=>b.flight.clear()),Z=()=>{let $={connecting:"",open:"",ended:x,lost:"The connection is lost; the page tries again by itself. What is shown is the last that came.",refused:"This link lacks its token, or the token is of another session: open the whole link that `gcs` printed."}[G.state];f.hidden=!$,f.className=`connection ${G.state==="ended"&&!C?"soft":"bad"}`,me(d,$),G.state==="refused"&&me(e,"no entry"),G.state==="ended"&&!b.flight.session&&me(e,"no session"),(G.state==="refused"||G.state==="ended")&&(V.hidden=!0),X(),document.documentElement.dataset.connection=G.state},X=()=>{let{session:B,newest:$}=b.flight,et=G.state==="open"&&!m&&$!==null&&G.silent_s>=YT,ht=G.state==="ended",at=G.state==="lost"?"not connected":et?`no news for ${G.silent_s.toFixed(0)} s`:ht&&C?"broken off":"",Q=at!==""||ht;n.hidden=!B||ht&&!at,n.className=`badge ${at?et?"warn":"bad":""}`,B&&me(n,at||ZT[B.source]),s.hidden=!$||at!=="",b.strip.stale!==Q&&(b.strip.stale=Q,b.paneled=null,b.dirty=!0),!(!Q||b.speed==="")&&(b.speed="",b.dirty=!0)};setInterval(X,500),G.open();let ct=new jh;return ct.first(),document.querySelector("dialog[aria-label=keys] form")?.append(N("button",{onclick:()=>ct.go(0)},"Show the tour")),Object.assign(b,{operator:R,sound:h})}Sm();var il=JSON.parse(document.getElementById("config")?.textContent??"{}");vm(il.palette);i_(il.conditions);var jT=il.source==="report"?h_(il,g_):KT(il);Object.assign(window,{skytender:jT});})();
