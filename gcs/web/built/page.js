/* of sources 29b6aac313b1a6de */
"use strict";(()=>{var T_="uplot",E_="u-hz",A_="u-vt",R_="u-title",C_="u-wrap",P_="u-under",I_="u-over",L_="u-axis",js="u-off",D_="u-select",N_="u-cursor-x",U_="u-cursor-y",F_="u-cursor-pt",O_="u-legend",B_="u-live",k_="u-inline",z_="u-series",G_="u-marker",$d="u-label",V_="u-value",ko="width",zo="height";var Zd="bottom",Ir="left",uu="right",Ru="#000",Jd=Ru+"0",fu="mousemove",Kd="mousedown",du="mouseup",jd="mouseenter",Qd="mouseleave",tp="dblclick",H_="resize",W_="scroll",ep="change",fl="dppxchange",Cu="--",Br=typeof window<"u",yu=Br?document:null,Dr=Br?window:null,X_=Br?navigator:null,Le,ll;function xu(){let i=devicePixelRatio;Le!=i&&(Le=i,ll&&Su(ep,ll,xu),ll=matchMedia(`(min-resolution: ${Le-.001}dppx) and (max-resolution: ${Le+.001}dppx)`),Qs(ep,ll,xu),Dr.dispatchEvent(new CustomEvent(fl)))}function ei(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function vu(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Je(i,t,e){i.style[t]=e+"px"}function wi(i,t,e,n){let s=yu.createElement(i);return t!=null&&ei(s,t),e?.insertBefore(s,n),s}function gi(i,t){return wi("div",i,t)}var np=new WeakMap;function Vi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=np.get(i);r!=o&&(i.style.transform=r,np.set(i,r),t<0||e<0||t>n||e>s?ei(i,js):vu(i,js))}var ip=new WeakMap;function sp(i,t,e){let n=t+e,s=ip.get(i);n!=s&&(ip.set(i,n),i.style.background=t,i.style.borderColor=e)}var rp=new WeakMap;function op(i,t,e,n){let s=t+""+e,r=rp.get(i);s!=r&&(rp.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Pu={passive:!0},q_={...Pu,capture:!0};function Qs(i,t,e,n){t.addEventListener(i,e,n?q_:Pu)}function Su(i,t,e,n){t.removeEventListener(i,e,Pu)}Br&&xu();function Ti(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ni((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Np(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Up=i=>i!=null,Fp=i=>i!=null&&i>0,ml=Np(Up),Y_=Np(Fp);function $_(i,t,e,n=0,s=!1){let r=s?Y_:ml,o=s?Fp:Up;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??We,l??-We]}function gl(i,t,e,n){let s=cp(i),r=cp(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?ns:Op,a=s==1?ni:_i,l=r==1?_i:ni,c=a(o(xn(i))),h=l(o(xn(t))),u=Nr(e,c),f=Nr(e,h);return e==10&&(c<0&&(u=Xe(u,-c)),h<0&&(f=Xe(f,-h))),n||e==2?(i=u*s,t=f*r):(i=Gp(i,u),t=_l(t,f)),[i,t]}function Iu(i,t,e,n){let s=gl(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Lu=.1,ap={mode:3,pad:Lu},Vo={pad:0,soft:null,mode:0},Z_={min:Vo,max:Vo};function dl(i,t,e,n){return yl(e)?lp(i,t,e):(Vo.pad=e,Vo.soft=n?0:null,Vo.mode=n?3:0,lp(i,t,Z_))}function Pe(i,t){return i??t}function J_(i,t,e){for(t=Pe(t,0),e=Pe(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function lp(i,t,e){let n=e.min,s=e.max,r=Pe(n.pad,0),o=Pe(s.pad,0),a=Pe(n.hard,-We),l=Pe(s.hard,We),c=Pe(n.soft,We),h=Pe(s.soft,-We),u=Pe(n.mode,0),f=Pe(s.mode,0),d=t-i,p=ns(d),_=Wn(xn(i),xn(t)),m=ns(_),g=xn(m-p);(d<1e-24||g>10)&&(d=0,(i==0||t==0)&&(d=1e-24,u==2&&c!=We&&(r=0),f==2&&h!=-We&&(o=0)));let y=d||_||1e3,M=ns(y),x=Nr(10,ni(M)),R=y*(d==0?i==0?.1:1:r),E=Xe(Gp(i-R,x/10),24),v=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:We,b=Wn(a,E<v&&i>=v?v:Ei(v,E)),I=y*(d==0?t==0?.1:1:o),T=Xe(_l(t+I,x/10),24),P=t<=h&&(f==1||f==3&&T>=h||f==2&&T<=h)?h:-We,O=Ei(l,T>P&&t<=P?P:Wn(P,T));return b==O&&b==0&&(O=100),[b,O]}var K_=new Intl.NumberFormat(Br?X_.language:"en-US"),Du=i=>K_.format(i),ii=Math,ul=ii.PI,xn=ii.abs,ni=ii.floor,yn=ii.round,_i=ii.ceil,Ei=ii.min,Wn=ii.max,Nr=ii.pow,cp=ii.sign,ns=ii.log10,Op=ii.log2,j_=(i,t=1)=>ii.sinh(i)*t,pu=(i,t=1)=>ii.asinh(i/t),We=1/0;function hp(i){return(ns((i^i>>31)-(i>>31))|0)+1}function Mu(i,t,e){return Ei(Wn(i,t),e)}function Bp(i){return typeof i=="function"}function Ee(i){return Bp(i)?i:()=>i}var Q_=()=>{},kp=i=>i,zp=(i,t)=>t,ty=i=>null,up=i=>!0,fp=(i,t)=>i==t,ey=/\.\d*?(?=9{6,}|0{6,})/gm,tr=i=>{if(Hp(i)||Rs.has(i))return i;let t=`${i}`,e=t.match(ey);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${tr(s)}e${r}`}return Xe(i,n)};function Js(i,t){return tr(Xe(tr(i/t))*t)}function _l(i,t){return tr(_i(tr(i/t))*t)}function Gp(i,t){return tr(ni(tr(i/t))*t)}function Xe(i,t=0){if(Hp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return yn(n)/e}var Rs=new Map;function Vp(i){return((""+i).split(".")[1]||"").length}function Wo(i,t,e,n){let s=[],r=n.map(Vp);for(let o=t;o<e;o++){let a=xn(o),l=Xe(Nr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Xe(h,u);s.push(f),Rs.set(f,u)}}return s}var Ho={},Nu=[],Ur=[null,null],As=Array.isArray,Hp=Number.isInteger,ny=i=>i===void 0;function dp(i){return typeof i=="string"}function yl(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function iy(i){return i!=null&&typeof i=="object"}var sy=Object.getPrototypeOf(Uint8Array),Wp="__proto__";function Fr(i,t=yl){let e;if(As(i)){let n=i.find(s=>s!=null);if(As(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Fr(i[s],t)}else e=i.slice()}else if(i instanceof sy)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Wp&&(e[n]=Fr(i[n],t))}else e=i;return e}function dn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Wp&&(yl(i[s])?dn(i[s],Fr(n[s])):i[s]=Fr(n[s]))}return i}var ry=0,oy=1,ay=2;function ly(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function cy(i,t){if(fy(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return dy(o[0])||(o=uy(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:oy,d=[];for(let p=0;p<h.length;p++){let _=h[p],m=r.get(l[p]);_===null?f!=ry&&(u[m]=_,f==ay&&d.push(m)):u[m]=_}ly(u,d,s),n.push(u)}}return n}var hy=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function uy(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function fy(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function dy(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Wn(1,ni((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Xp=["January","February","March","April","May","June","July","August","September","October","November","December"],qp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Yp(i){return i.slice(0,3)}var py=qp.map(Yp),my=Xp.map(Yp),gy={MMMM:Xp,MMM:my,WWWW:qp,WWW:py};function Bo(i){return(i<10?"0":"")+i}function _y(i){return(i<10?"00":i<100?"0":"")+i}var yy={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Bo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Bo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Bo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Bo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Bo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>_y(i.getMilliseconds())};function Uu(i,t){t=t||gy;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?yy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var xy=new Intl.DateTimeFormat().resolvedOptions().timeZone;function vy(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==xy?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var $p=i=>i%1==0,pl=[1,2,2.5,5],Sy=Wo(10,-32,0,pl),Zp=Wo(10,0,32,pl),My=Zp.filter($p),Ks=Sy.concat(Zp),Fu=`
`,Jp="{YYYY}",pp=Fu+Jp,Kp="{M}/{D}",Go=Fu+Kp,cl=Go+"/{YY}",jp="{aa}",by="{h}:{mm}",Lr=by+jp,mp=Fu+Lr,gp=":{ss}",Fe=null;function Qp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Wo(10,0,3,pl).filter($p):Wo(10,-3,0,pl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Jp,Fe,Fe,Fe,Fe,Fe,Fe,1],[s*28,"{MMM}",pp,Fe,Fe,Fe,Fe,Fe,1],[s,Kp,pp,Fe,Fe,Fe,Fe,Fe,1],[n,"{h}"+jp,cl,Fe,Go,Fe,Fe,Fe,1],[e,Lr,cl,Fe,Go,Fe,Fe,Fe,1],[t,gp,cl+" "+Lr,Fe,Go+" "+Lr,Fe,mp,Fe,1],[i,gp+".{fff}",cl+" "+Lr,Fe,Go+" "+Lr,Fe,mp,Fe,1]];function h(u){return(f,d,p,_,m,g)=>{let y=[],M=m>=o,x=m>=r&&m<o,R=u(p),E=Xe(R*i,3),v=mu(R.getFullYear(),M?0:R.getMonth(),x||M?1:R.getDate()),b=Xe(v*i,3);if(x||M){let I=x?m/r:0,T=M?m/o:0,P=E==b?E:Xe(mu(v.getFullYear()+T,v.getMonth()+I,1)*i,3),O=new Date(yn(P/i)),H=O.getFullYear(),N=O.getMonth();for(let V=0;P<=_;V++){let Y=mu(H+T*V,N+I*V,1),W=Y-u(Xe(Y*i,3));P=Xe((+Y+W)*i,3),P<=_&&y.push(P)}}else{let I=m>=s?s:m,T=ni(p)-ni(E),P=b+T+_l(E-b,I);y.push(P);let O=u(P),H=O.getHours()+O.getMinutes()/e+O.getSeconds()/n,N=m/n,V=f.axes[d]._space,Y=g/V;for(;P=Xe(P+m,i==1?0:3),!(P>_);)if(N>1){let W=ni(Xe(H+N,6))%24,Q=u(P).getHours()-W;Q>1&&(Q=-1),P-=Q*n,H=(H+N)%24;let et=y[y.length-1];Xe((P-et)/m,3)*Y>=.7&&y.push(P)}else y.push(P)}return y}}return[l,c,h]}var[wy,Ty,Ey]=Qp(1),[Ay,Ry,Cy]=Qp(.001);Wo(2,-53,53,[1]);function _p(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function yp(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,h,u,f,d;return n.map(p=>{let _=i(p),m=_.getFullYear(),g=_.getMonth(),y=_.getDate(),M=_.getHours(),x=_.getMinutes(),R=_.getSeconds(),E=m!=l&&a[2]||g!=c&&a[3]||y!=h&&a[4]||M!=u&&a[5]||x!=f&&a[6]||R!=d&&a[7]||a[1];return l=m,c=g,h=y,u=M,f=x,d=R,E(_)})}}function Py(i,t){let e=Uu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function mu(i,t,e){return new Date(i,t,e)}function xp(i,t){return t(i)}var Iy="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function vp(i,t){return(e,n,s,r)=>r==null?Cu:t(i(n))}function Ly(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Dy(i,t){return i.series[t].fill(i,t)}var Ny={show:!0,live:!0,isolate:!1,mount:Q_,markers:{show:!0,width:2,stroke:Ly,fill:Dy,dash:"solid"},idx:null,idxs:null,values:[]};function Uy(i,t){let e=i.cursor.points,n=gi(),s=e.size(i,t);Je(n,ko,s),Je(n,zo,s);let r=s/-2;Je(n,"marginLeft",r),Je(n,"marginTop",r);let o=e.width(i,t,s);return o&&Je(n,"borderWidth",o),n}function Fy(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Oy(i,t){let e=i.series[t].points;return e._stroke||e._fill}function By(i,t){return i.series[t].points.size}var gu=[0,0];function ky(i,t,e){return gu[0]=t,gu[1]=e,gu}function hl(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function _u(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var zy={show:!0,x:!0,y:!0,lock:!1,move:ky,points:{one:!1,show:Uy,size:By,width:0,stroke:Oy,fill:Fy},bind:{mousedown:hl,mouseup:hl,click:hl,dblclick:hl,mousemove:_u,mouseleave:_u,mouseenter:_u},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},tm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ou=dn({},tm,{filter:zp}),em=dn({},Ou,{size:10}),nm=dn({},tm,{show:!1}),Bu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',im="bold "+Bu,sm=1.5,Sp={show:!0,scale:"x",stroke:Ru,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:im,side:2,grid:Ou,ticks:em,border:nm,font:Bu,lineGap:sm,rotate:0},Gy="Value",Vy="Time",Mp={show:!0,scale:"x",auto:!1,sorted:1,min:We,max:-We,idxs:[]};function Hy(i,t,e,n,s){return t.map(r=>r==null?"":Du(r))}function Wy(i,t,e,n,s,r,o){let a=[],l=Rs.get(s)||0;e=o?e:Xe(_l(e,s),l);for(let c=e;c<=n;c=Xe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function bu(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?ns:Op,h=ni(c(e));s=Nr(l,h),l==10&&(s=Ks[Ti(s,Ks)]);let u=e,f=s*l;l==10&&(f=Ks[Ti(f,Ks)]);do a.push(u),u=u+s,l==10&&!Rs.has(u)&&(u=Xe(u,Rs.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=Ks[Ti(f,Ks)]));while(u<=n);return a}function Xy(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?bu(i,t,Wn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?bu(i,t,Wn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var rm=/./,qy=/[12357]/,Yy=/[125]/,bp=/1/,wu=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function $y(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?rm:l(7,o)-h>=c?qy:l(5,o)-h>=c?Yy:bp;if(u==bp){let f=xn(l(1,o)-h);if(f<c)return wu(t.slice().reverse(),a.distr,u,_i(c/f)).reverse()}return wu(t,a.distr,u,1)}function Zy(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=xn(l(1,o)-l(2,o));return c<a?wu(t.slice().reverse(),3,rm,_i(a/c)).reverse():t}function Jy(i,t,e,n){return n==null?Cu:t==null?"":Du(t)}var wp={show:!0,scale:"y",stroke:Ru,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:im,side:3,grid:Ou,ticks:em,border:nm,font:Bu,lineGap:sm,rotate:0};function Ky(i,t){let e=3+(i||1)*2;return Xe(e*t,3)}function jy(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=xn(o-r),l=i.series[t],c=a/(l.points.space*Le);return n[1]-n[0]<=c}var Tp={scale:null,auto:!0,sorted:0,min:We,max:-We},om=(i,t,e,n,s)=>s,Ep={show:!0,auto:!0,sorted:0,gaps:om,alpha:1,facets:[dn({},Tp,{scale:"x"}),dn({},Tp,{scale:"y"})]},Ap={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:om,alpha:1,points:{show:jy,filter:null},values:null,min:We,max:-We,idxs:[],path:null,clip:null};function Qy(i,t,e,n,s){return e/10}var am={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},tx=dn({},am,{time:!1,ori:1}),Rp={};function lm(i,t){let e=Rp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Rp[i]=e)),e}var Or=1,Tu=2;function er(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,p=a.width,_=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,g,f,d,p,_,vl,kr,Ml,hm,fm):e(s,l,c,h,u,g,m,d,f,_,p,Sl,zr,Gu,um,dm)}function ku(i,t){let e=0,n=0,s=Pe(i.bands,Nu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function ex(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function is(i,t,e,n,s,r){return er(i,t,(o,a,l,c,h,u,f,d,p,_,m)=>{let g=o.pxRound,y=c.dir*(c.ori==0?1:-1),M=c.ori==0?kr:zr,x,R;y==1?(x=e,R=n):(x=n,R=e);let E=g(u(a[x],c,_,d)),v=g(f(l[x],h,m,p)),b=g(u(a[R],c,_,d)),I=g(f(r==1?h.max:h.min,h,m,p)),T=new Path2D(s);return M(T,b,I),M(T,E,I),M(T,E,v),T})}function xl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Ml:Gu,l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function nx(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function zu(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[u]),p=f==u?d:r(i[f]),_=u-s;d=o<=0&&_>=0&&_<l?r(i[_]):d;let g=f+s;p=o>=0&&g>=0&&g<l?r(i[g]):p,p>=d&&a.push([d,p])}return a}function Cp(i){return i==0?kp:i==1?yn:t=>Js(t,i)}function cm(i){let t=i==0?vl:Sl,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ei(c,a/2,l/2),h=Ei(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var vl=(i,t,e)=>{i.moveTo(t,e)},Sl=(i,t,e)=>{i.moveTo(e,t)},kr=(i,t,e)=>{i.lineTo(t,e)},zr=(i,t,e)=>{i.lineTo(e,t)},Ml=cm(0),Gu=cm(1),hm=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},um=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},fm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},dm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function pm(i){return(t,e,n,s,r)=>er(t,e,(o,a,l,c,h,u,f,d,p,_,m)=>{let{pxRound:g,points:y}=o,M,x;c.ori==0?(M=vl,x=hm):(M=Sl,x=um);let R=Xe(y.width*Le,3),E=(y.size-y.width)/2*Le,v=Xe(E*2,3),b=new Path2D,I=new Path2D,{left:T,top:P,width:O,height:H}=t.bbox;Ml(I,T-v,P-v,O+v*2,H+v*2);let N=V=>{if(l[V]!=null){let Y=g(u(a[V],c,_,d)),W=g(f(l[V],h,m,p));M(b,Y+E,W),x(b,Y,W,E,0,ul*2)}};if(r)r.forEach(N);else for(let V=n;V<=s;V++)N(V);return{stroke:R>0?b:null,fill:b,clip:I,flags:Or|Tu}})}function mm(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var ix=mm(kr),sx=mm(zr);function gm(i){let t=Pe(i?.alignGaps,0);return(e,n,s,r)=>er(e,n,(o,a,l,c,h,u,f,d,p,_,m)=>{[s,r]=ml(l,s,r);let g=o.pxRound,y=H=>g(u(H,c,_,d)),M=H=>g(f(H,h,m,p)),x,R;c.ori==0?(x=kr,R=ix):(x=zr,R=sx);let E=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Or},b=v.stroke,I=!1;if(r-s>=_*4){let H=ht=>e.posToVal(ht,c.key,!0),N=null,V=null,Y,W,ct,J=y(a[E==1?s:r]),Q=y(a[s]),et=y(a[r]),dt=H(E==1?Q+1:et-1);for(let ht=E==1?s:r;ht>=s&&ht<=r;ht+=E){let tt=a[ht],xt=(E==1?tt<dt:tt>dt)?J:y(tt),Lt=l[ht];xt==J?Lt!=null?(W=Lt,N==null?(x(b,xt,M(W)),Y=N=V=W):W<N?N=W:W>V&&(V=W)):Lt===null&&(I=!0):(N!=null&&R(b,J,M(N),M(V),M(Y),M(W)),Lt!=null?(W=Lt,x(b,xt,M(W)),N=V=Y=W):(N=V=null,Lt===null&&(I=!0)),J=xt,dt=H(J+E))}N!=null&&N!=V&&ct!=J&&R(b,J,M(N),M(V),M(Y),M(W))}else for(let H=E==1?s:r;H>=s&&H<=r;H+=E){let N=l[H];N===null?I=!0:N!=null&&x(b,y(a[H]),M(N))}let[P,O]=ku(e,n);if(o.fill!=null||P!=0){let H=v.fill=new Path2D(b),N=o.fillTo(e,n,o.min,o.max,P),V=M(N),Y=y(a[s]),W=y(a[r]);E==-1&&([W,Y]=[Y,W]),x(H,W,V),x(H,Y,V)}if(!o.spanGaps){let H=[];I&&H.push(...zu(a,l,s,r,E,y,t)),v.gaps=H=o.gaps(e,n,s,r,H),v.clip=xl(H,c.ori,d,p,_,m)}return O!=0&&(v.band=O==2?[is(e,n,s,r,b,-1),is(e,n,s,r,b,1)]:is(e,n,s,r,b,O)),v})}function rx(i){let t=Pe(i.align,1),e=Pe(i.ascDesc,!1),n=Pe(i.alignGaps,0),s=Pe(i.extend,!1);return(r,o,a,l)=>er(r,o,(c,h,u,f,d,p,_,m,g,y,M)=>{[a,l]=ml(u,a,l);let x=c.pxRound,{left:R,width:E}=r.bbox,v=Q=>x(p(Q,f,y,m)),b=Q=>x(_(Q,d,M,g)),I=f.ori==0?kr:zr,T={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Or},P=T.stroke,O=f.dir*(f.ori==0?1:-1),H=b(u[O==1?a:l]),N=v(h[O==1?a:l]),V=N,Y=N;s&&t==-1&&(Y=R,I(P,Y,H)),I(P,N,H);for(let Q=O==1?a:l;Q>=a&&Q<=l;Q+=O){let et=u[Q];if(et==null)continue;let dt=v(h[Q]),ht=b(et);t==1?I(P,dt,H):I(P,V,ht),I(P,dt,ht),H=ht,V=dt}let W=V;s&&t==1&&(W=R+E,I(P,W,H));let[ct,J]=ku(r,o);if(c.fill!=null||ct!=0){let Q=T.fill=new Path2D(P),et=c.fillTo(r,o,c.min,c.max,ct),dt=b(et);I(Q,W,dt),I(Q,Y,dt)}if(!c.spanGaps){let Q=[];Q.push(...zu(h,u,a,l,O,v,n));let et=c.width*Le/2,dt=e||t==1?et:-et,ht=e||t==-1?-et:et;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ht}),T.gaps=Q=c.gaps(r,o,a,l,Q),T.clip=xl(Q,f.ori,m,g,y,M)}return J!=0&&(T.band=J==2?[is(r,o,a,l,P,-1),is(r,o,a,l,P,1)]:is(r,o,a,l,P,J)),T})}function Pp(i,t,e,n,s,r,o=We){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=xn(i[l]-i[a]);h<c&&(c=h,o=xn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function ox(i){i=i||Ho;let t=Pe(i.size,[.6,We,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ee(s),o=1-t[0],a=Pe(t[1],We),l=Pe(t[2],1),c=Pe(i.disp,Ho),h=Pe(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,p,_,m)=>er(d,p,(g,y,M,x,R,E,v,b,I,T,P)=>{let O=g.pxRound,H=e,N=n*Le,V=a*Le,Y=l*Le,W,ct;x.ori==0?[W,ct]=r(d,p):[ct,W]=r(d,p);let J=x.dir*(x.ori==0?1:-1),Q=x.ori==0?Ml:Gu,et=x.ori==0?h:(Mt,Xt,he,Tt,Ue,$t,Qt)=>{h(Mt,Xt,he,Ue,Tt,Qt,$t)},dt=Pe(d.bands,Nu).find(Mt=>Mt.series[0]==p),ht=dt!=null?dt.dir:0,tt=g.fillTo(d,p,g.min,g.max,ht),gt=O(v(tt,R,P,I)),xt,Lt,wt,Vt=T,ie=O(g.width*Le),Jt=!1,se=null,ne=null,ot=null,vt=null;u!=null&&(ie==0||f!=null)&&(Jt=!0,se=u.values(d,p,_,m),ne=new Map,new Set(se).forEach(Mt=>{Mt!=null&&ne.set(Mt,new Path2D)}),ie>0&&(ot=f.values(d,p,_,m),vt=new Map,new Set(ot).forEach(Mt=>{Mt!=null&&vt.set(Mt,new Path2D)})));let{x0:yt,size:Bt}=c;if(yt!=null&&Bt!=null){H=1,y=yt.values(d,p,_,m),yt.unit==2&&(y=y.map(he=>d.posToVal(b+he*T,x.key,!0)));let Mt=Bt.values(d,p,_,m);Bt.unit==2?Lt=Mt[0]*T:Lt=E(Mt[0],x,T,b)-E(0,x,T,b),Vt=Pp(y,M,E,x,T,b,Vt),wt=Vt-Lt+N}else Vt=Pp(y,M,E,x,T,b,Vt),wt=Vt*o+N,Lt=Vt-wt;wt<1&&(wt=0),ie>=Lt/2&&(ie=0),wt<5&&(O=kp);let Dt=wt>0,ee=Vt-wt-(Dt?ie:0);Lt=O(Mu(ee,Y,V)),xt=(H==0?Lt/2:H==J?0:Lt)-H*J*((H==0?N/2:0)+(Dt?ie/2:0));let kt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},me=Jt?null:new Path2D,fe=null;if(dt!=null)fe=d.data[dt.series[1]];else{let{y0:Mt,y1:Xt}=c;Mt!=null&&Xt!=null&&(M=Xt.values(d,p,_,m),fe=Mt.values(d,p,_,m))}let _e=W*Lt,B=ct*Lt;for(let Mt=J==1?_:m;Mt>=_&&Mt<=m;Mt+=J){let Xt=M[Mt];if(Xt==null)continue;if(fe!=null){let q=fe[Mt]??0;if(Xt-q==0)continue;gt=v(q,R,P,I)}let he=x.distr!=2||c!=null?y[Mt]:Mt,Tt=E(he,x,T,b),Ue=v(Pe(Xt,tt),R,P,I),$t=O(Tt-xt),Qt=O(Wn(Ue,gt)),L=O(Ei(Ue,gt)),w=Qt-L;if(Xt!=null){let q=Xt<0?B:_e,ft=Xt<0?_e:B;Jt?(ie>0&&ot[Mt]!=null&&Q(vt.get(ot[Mt]),$t,L+ni(ie/2),Lt,Wn(0,w-ie),q,ft),se[Mt]!=null&&Q(ne.get(se[Mt]),$t,L+ni(ie/2),Lt,Wn(0,w-ie),q,ft)):Q(me,$t,L+ni(ie/2),Lt,Wn(0,w-ie),q,ft),et(d,p,Mt,$t-ie/2,L,Lt+ie,w)}}return ie>0?kt.stroke=Jt?vt:me:Jt||(kt._fill=g.width==0?g._fill:g._stroke??g._fill,kt.width=0),kt.fill=Jt?ne:me,kt})}function ax(i,t){let e=Pe(t?.alignGaps,0);return(n,s,r,o)=>er(n,s,(a,l,c,h,u,f,d,p,_,m,g)=>{[r,o]=ml(c,r,o);let y=a.pxRound,M=W=>y(f(W,h,m,p)),x=W=>y(d(W,u,g,_)),R,E,v;h.ori==0?(R=vl,v=kr,E=fm):(R=Sl,v=zr,E=dm);let b=h.dir*(h.ori==0?1:-1),I=M(l[b==1?r:o]),T=I,P=[],O=[];for(let W=b==1?r:o;W>=r&&W<=o;W+=b)if(c[W]!=null){let J=l[W],Q=M(J);P.push(T=Q),O.push(x(c[W]))}let H={stroke:i(P,O,R,v,E,y),fill:null,clip:null,band:null,gaps:null,flags:Or},N=H.stroke,[V,Y]=ku(n,s);if(a.fill!=null||V!=0){let W=H.fill=new Path2D(N),ct=a.fillTo(n,s,a.min,a.max,V),J=x(ct);v(W,T,J),v(W,I,J)}if(!a.spanGaps){let W=[];W.push(...zu(l,c,r,o,b,M,e)),H.gaps=W=a.gaps(n,s,r,o,W),H.clip=xl(W,h.ori,p,_,m,g)}return Y!=0&&(H.band=Y==2?[is(n,s,r,o,N,-1),is(n,s,r,o,N,1)]:is(n,s,r,o,N,Y)),H})}function lx(i){return ax(cx,i)}function cx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}var Eu=new Set;function Ip(){for(let i of Eu)i.syncRect(!0)}Br&&(Qs(H_,Dr,Ip),Qs(W_,Dr,Ip,!0),Qs(fl,Dr,()=>{vn.pxRatio=Le}));var hx=gm(),ux=pm();function Lp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Au(r,o,t,e))}function fx(i,t){return i.map((e,n)=>n==0?{}:dn({},t,e))}function Au(i,t,e,n){return dn({},t==0?e:n,i)}function _m(i,t,e){return t==null?Ur:[t,e]}var dx=_m;function px(i,t,e){return t==null?Ur:dl(t,e,Lu,!0)}function ym(i,t,e,n){return t==null?Ur:gl(t,e,i.scales[n].log,!1)}var mx=ym;function xm(i,t,e,n){return t==null?Ur:Iu(t,e,i.scales[n].log,!1)}var gx=xm;function _x(i,t,e,n,s){let r=Wn(hp(i),hp(t)),o=t-i,a=Ti(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Rs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Dp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=yn((e=+s)*Le))+"px"),[i,t,e]}function yx(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Xe(t[2]*Le,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function vn(i,t,e){let n={mode:Pe(i.mode,1)},s=n.mode;function r(S,A,D,U){let X=A.valToPct(S);return U+D*(A.dir==-1?1-X:X)}function o(S,A,D,U){let X=A.valToPct(S);return U+D*(A.dir==-1?X:1-X)}function a(S,A,D,U){return A.ori==0?r(S,A,D,U):o(S,A,D,U)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=gi(T_);if(i.id!=null&&(c.id=i.id),ei(c,i.class),i.title){let S=gi(R_,c);S.textContent=i.title}let h=wi("canvas"),u=n.ctx=h.getContext("2d"),f=gi(C_,c);Qs("click",f,S=>{S.target===p&&(Ye!=Er||je!=Ar)&&Dn.click(n,S)},!0);let d=n.under=gi(P_,f);f.appendChild(h);let p=n.over=gi(I_,f);i=Fr(i);let _=+Pe(i.pxAlign,1),m=Cp(_);(i.plugins||[]).forEach(S=>{S.opts&&(i=S.opts(n,i)||i)});let g=i.ms||.001,y=n.series=s==1?Lp(i.series||[],Mp,Ap,!1):fx(i.series||[null],Ep),M=n.axes=Lp(i.axes||[],Sp,wp,!0),x=n.scales={},R=n.bands=i.bands||[];R.forEach(S=>{S.fill=Ee(S.fill||null),S.dir=Pe(S.dir,-1)});let E=s==2?y[1].facets[0].scale:y[0].scale,v={axes:ts,series:be},b=(i.drawOrder||["axes","series"]).map(S=>v[S]);function I(S){let A=S.distr==3?D=>ns(D>0?D:S.clamp(n,D,S.min,S.max,S.key)):S.distr==4?D=>pu(D,S.asinh):S.distr==100?D=>S.fwd(D):D=>D;return D=>{let U=A(D),{_min:X,_max:K}=S,lt=K-X;return(U-X)/lt}}function T(S){let A=x[S];if(A==null){let D=(i.scales||Ho)[S]||Ho;if(D.from!=null){T(D.from);let U=dn({},x[D.from],D,{key:S});U.valToPct=I(U),x[S]=U}else{A=x[S]=dn({},S==E?am:tx,D),A.key=S;let U=A.time,X=A.range,K=As(X);if((S!=E||s==2&&!U)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?ap:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?ap:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&yl(X))){let lt=X;X=(pt,At,zt)=>At==null?Ur:dl(At,zt,lt)}A.range=Ee(X||(U?dx:S==E?A.distr==3?mx:A.distr==4?gx:_m:A.distr==3?ym:A.distr==4?xm:px)),A.auto=Ee(K?!1:A.auto),A.clamp=Ee(A.clamp||Qy),A._min=A._max=null,A.valToPct=I(A)}}}T("x"),T("y"),s==1&&y.forEach(S=>{T(S.scale)}),M.forEach(S=>{T(S.scale)});for(let S in i.scales)T(S);let P=x[E],O=P.distr,H,N;P.ori==0?(ei(c,E_),H=r,N=o):(ei(c,A_),H=o,N=r);let V={};for(let S in x){let A=x[S];(A.min!=null||A.max!=null)&&(V[S]={min:A.min,max:A.max},A.min=A.max=null)}let Y=i.tzDate||(S=>new Date(yn(S/g))),W=i.fmtDate||Uu,ct=g==1?Ey(Y):Cy(Y),J=yp(Y,_p(g==1?Ty:Ry,W)),Q=vp(Y,xp(Iy,W)),et=[],dt=n.legend=dn({},Ny,i.legend),ht=n.cursor=dn({},zy,{drag:{y:s==2}},i.cursor),tt=dt.show,gt=ht.show,xt=dt.markers;dt.idxs=et,xt.width=Ee(xt.width),xt.dash=Ee(xt.dash),xt.stroke=Ee(xt.stroke),xt.fill=Ee(xt.fill);let Lt,wt,Vt,ie=[],Jt=[],se,ne=!1,ot={};if(dt.live){let S=y[1]?y[1].values:null;ne=S!=null,se=ne?S(n,1,0):{_:0};for(let A in se)ot[A]=Cu}if(tt)if(Lt=wi("table",O_,c),Vt=wi("tbody",null,Lt),dt.mount(n,Lt),ne){wt=wi("thead",null,Lt,Vt);let S=wi("tr",null,wt);wi("th",null,S);for(var vt in se)wi("th",$d,S).textContent=vt}else ei(Lt,k_),dt.live&&ei(Lt,B_);let yt={show:!0},Bt={show:!1};function Dt(S,A){if(A==0&&(ne||!dt.live||s==2))return Ur;let D=[],U=wi("tr",z_,Vt,Vt.childNodes[A]);ei(U,S.class),S.show||ei(U,js);let X=wi("th",null,U);if(xt.show){let pt=gi(G_,X);if(A>0){let At=xt.width(n,A);At&&(pt.style.border=At+"px "+xt.dash(n,A)+" "+xt.stroke(n,A)),pt.style.background=xt.fill(n,A)}}let K=gi($d,X);S.label instanceof HTMLElement?K.appendChild(S.label):K.textContent=S.label,A>0&&(xt.show||(K.style.color=S.width>0?xt.stroke(n,A):xt.fill(n,A)),kt("click",X,pt=>{if(ht._lock)return;ae(pt);let At=y.indexOf(S);if((pt.ctrlKey||pt.metaKey)!=dt.isolate){let zt=y.some((Gt,Wt)=>Wt>0&&Wt!=At&&Gt.show);y.forEach((Gt,Wt)=>{Wt>0&&Bi(Wt,zt?Wt==At?yt:Bt:yt,!0,fn.setSeries)})}else Bi(At,{show:!S.show},!0,fn.setSeries)},!1),le&&kt(jd,X,pt=>{ht._lock||(ae(pt),Bi(y.indexOf(S),Cr,!0,fn.setSeries))},!1));for(var lt in se){let pt=wi("td",V_,U);pt.textContent="--",D.push(pt)}return[U,D]}let ee=new Map;function kt(S,A,D,U=!0){let X=ee.get(A)||{},K=ht.bind[S](n,A,D,U);K&&(Qs(S,A,X[S]=K),ee.set(A,X))}function me(S,A,D){let U=ee.get(A)||{};for(let X in U)(S==null||X==S)&&(Su(X,A,U[X]),delete U[X]);S==null&&ee.delete(A)}let fe=0,_e=0,B=0,Mt=0,Xt=0,he=0,Tt=Xt,Ue=he,$t=B,Qt=Mt,L=0,w=0,q=0,ft=0;n.bbox={};let at=!1,bt=!1,Et=!1,nt=!1,st=!1,mt=!1;function k(S,A,D){(D||S!=n.width||A!=n.height)&&rt(S,A),ye(!1),Et=!0,bt=!0,Un()}function rt(S,A){n.width=fe=B=S,n.height=_e=Mt=A,Xt=he=0,Rt(),Kt();let D=n.bbox;L=D.left=Js(Xt*Le,.5),w=D.top=Js(he*Le,.5),q=D.width=Js(B*Le,.5),ft=D.height=Js(Mt*Le,.5)}let it=3;function Ct(){let S=!1,A=0;for(;!S;){A++;let D=br(A),U=Oi(A);S=A==it||D&&U,S||(rt(n.width,n.height),bt=!0)}}function St({width:S,height:A}){k(S,A)}n.setSize=St;function Rt(){let S=!1,A=!1,D=!1,U=!1;M.forEach((X,K)=>{if(X.show&&X._show){let{side:lt,_size:pt}=X,At=lt%2,zt=X.label!=null?X.labelSize:0,Gt=pt+zt;Gt>0&&(At?(B-=Gt,lt==3?(Xt+=Gt,U=!0):D=!0):(Mt-=Gt,lt==0?(he+=Gt,S=!0):A=!0))}}),Ui[0]=S,Ui[1]=D,Ui[2]=A,Ui[3]=U,B-=Si[1]+Si[3],Xt+=Si[3],Mt-=Si[2]+Si[0],he+=Si[0]}function Kt(){let S=Xt+B,A=he+Mt,D=Xt,U=he;function X(K,lt){switch(K){case 1:return S+=lt,S-lt;case 2:return A+=lt,A-lt;case 3:return D-=lt,D+lt;case 0:return U-=lt,U+lt}}M.forEach((K,lt)=>{if(K.show&&K._show){let pt=K.side;K._pos=X(pt,K._size),K.label!=null&&(K._lpos=X(pt,K.labelSize))}})}if(ht.dataIdx==null){let S=ht.hover,A=S.skip=new Set(S.skip??[]);A.add(void 0);let D=S.prox=Ee(S.prox),U=S.bias??=0;ht.dataIdx=(X,K,lt,pt)=>{if(K==0)return lt;let At=lt,zt=D(X,K,lt,pt)??We,Gt=zt>=0&&zt<We,Wt=P.ori==0?B:Mt,pe=ht.left,Ie=t[0],Ce=t[K];if(A.has(Ce[lt])){At=null;let we=null,re=null,jt;if(U==0||U==-1)for(jt=lt;we==null&&jt-- >0;)A.has(Ce[jt])||(we=jt);if(U==0||U==1)for(jt=lt;re==null&&jt++<Ce.length;)A.has(Ce[jt])||(re=jt);if(we!=null||re!=null)if(Gt){let Ze=we==null?-1/0:H(Ie[we],P,Wt,0),rn=re==null?1/0:H(Ie[re],P,Wt,0),Rn=pe-Ze,He=rn-pe;Rn<=He?Rn<=zt&&(At=we):He<=zt&&(At=re)}else At=re==null?we:we==null?re:lt-we<=re-lt?we:re}else Gt&&xn(pe-H(Ie[lt],P,Wt,0))>zt&&(At=null);return At}}let ae=S=>{ht.event=S};ht.idxs=et,ht._lock=!1;let ut=ht.points;ut.show=Ee(ut.show),ut.size=Ee(ut.size),ut.stroke=Ee(ut.stroke),ut.width=Ee(ut.width),ut.fill=Ee(ut.fill);let qt=n.focus=dn({},i.focus||{alpha:.3},ht.focus),le=qt.prox>=0,Nt=le&&ut.one,ge=[],qe=[],kn=[];function Po(S,A){let D=ut.show(n,A);if(D instanceof HTMLElement)return ei(D,F_),ei(D,S.class),Vi(D,-10,-10,B,Mt),p.insertBefore(D,ge[A]),D}function vr(S,A){if(s==1||A>0){let D=s==1&&x[S.scale].time,U=S.value;S.value=D?dp(U)?vp(Y,xp(U,W)):U||Q:U||Jy,S.label=S.label||(D?Vy:Gy)}if(Nt||A>0){S.width=S.width==null?1:S.width,S.paths=S.paths||hx||ty,S.fillTo=Ee(S.fillTo||ex),S.pxAlign=+Pe(S.pxAlign,_),S.pxRound=Cp(S.pxAlign),S.stroke=Ee(S.stroke||null),S.fill=Ee(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let D=Ky(Wn(1,S.width),1),U=S.points=dn({},{size:D,width:Wn(1,D*.2),stroke:S.stroke,space:D*2,paths:ux,_stroke:null,_fill:null},S.points);U.show=Ee(U.show),U.filter=Ee(U.filter),U.fill=Ee(U.fill),U.stroke=Ee(U.stroke),U.paths=Ee(U.paths),U.pxAlign=S.pxAlign}if(tt){let D=Dt(S,A);ie.splice(A,0,D[0]),Jt.splice(A,0,D[1]),dt.values.push(null)}if(gt){et.splice(A,0,null);let D=null;Nt?A==0&&(D=Po(S,A)):A>0&&(D=Po(S,A)),ge.splice(A,0,D),qe.splice(A,0,0),kn.splice(A,0,0)}An("addSeries",A)}function eu(S,A){A=A??y.length,S=s==1?Au(S,A,Mp,Ap):Au(S,A,{},Ep),y.splice(A,0,S),vr(y[A],A)}n.addSeries=eu;function sl(S){if(y.splice(S,1),tt){dt.values.splice(S,1),Jt.splice(S,1);let A=ie.splice(S,1)[0];me(null,A.firstChild),A.remove()}gt&&(et.splice(S,1),ge.splice(S,1)[0].remove(),qe.splice(S,1),kn.splice(S,1)),An("delSeries",S)}n.delSeries=sl;let Ui=[!1,!1,!1,!1];function Ki(S,A){if(S._show=S.show,S.show){let D=S.side%2,U=x[S.scale];U==null&&(S.scale=D?y[1].scale:E,U=x[S.scale]);let X=U.time;S.size=Ee(S.size),S.space=Ee(S.space),S.rotate=Ee(S.rotate),As(S.incrs)&&S.incrs.forEach(lt=>{!Rs.has(lt)&&Rs.set(lt,Vp(lt))}),S.incrs=Ee(S.incrs||(U.distr==2?My:X?g==1?wy:Ay:Ks)),S.splits=Ee(S.splits||(X&&U.distr==1?ct:U.distr==3?bu:U.distr==4?Xy:Wy)),S.stroke=Ee(S.stroke),S.grid.stroke=Ee(S.grid.stroke),S.ticks.stroke=Ee(S.ticks.stroke),S.border.stroke=Ee(S.border.stroke);let K=S.values;S.values=As(K)&&!As(K[0])?Ee(K):X?As(K)?yp(Y,_p(K,W)):dp(K)?Py(Y,K):K||J:K||Hy,S.filter=Ee(S.filter||(U.distr>=3&&U.log==10?$y:U.distr==3&&U.log==2?Zy:zp)),S.font=Dp(S.font),S.labelFont=Dp(S.labelFont),S._size=S.size(n,null,A,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(Ui[A]=!0,S._el=gi(L_,f))}}function ji(S,A,D,U){let[X,K,lt,pt]=D,At=A%2,zt=0;return At==0&&(pt||K)&&(zt=A==0&&!X||A==2&&!lt?yn(Sp.size/3):0),At==1&&(X||lt)&&(zt=A==1&&!K||A==3&&!pt?yn(wp.size/2):0),zt}let Io=n.padding=(i.padding||[ji,ji,ji,ji]).map(S=>Ee(Pe(S,ji))),Si=n._padding=Io.map((S,A)=>S(n,A,Ui,0)),nn,an=null,ln=null,Fi=s==1?y[0].idxs:null,Kn=null,Ss=!1;function Lo(S,A){if(t=S??[],n.data=n._data=t,s==2){nn=0;for(let D=1;D<y.length;D++)nn+=t[D][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),Kn=t[0],nn=Kn.length;let D=t;if(O==2){D=t.slice();let U=D[0]=Array(nn);for(let X=0;X<nn;X++)U[X]=X}n._data=t=D}if(ye(!0),An("setData"),O==2&&(Et=!0),A!==!1){let D=P;D.auto(n,Ss)?Do():ws(E,D.min,D.max),nt=nt||ht.left>=0,mt=!0,Un()}}n.setData=Lo;function Do(){Ss=!0;let S,A;s==1&&(nn>0?(an=Fi[0]=0,ln=Fi[1]=nn-1,S=t[0][an],A=t[0][ln],O==2?(S=an,A=ln):S==A&&(O==3?[S,A]=gl(S,S,P.log,!1):O==4?[S,A]=Iu(S,S,P.log,!1):P.time?A=S+yn(86400/g):[S,A]=dl(S,A,Lu,!0))):(an=Fi[0]=S=null,ln=Fi[1]=A=null)),ws(E,S,A)}let Sr,Ms,Mr,C,G,j,$,Z,Pt,Ut;function It(S,A,D,U,X,K){S??=Jd,D??=Nu,U??="butt",X??=Jd,K??="round",S!=Sr&&(u.strokeStyle=Sr=S),X!=Ms&&(u.fillStyle=Ms=X),A!=Mr&&(u.lineWidth=Mr=A),K!=G&&(u.lineJoin=G=K),U!=j&&(u.lineCap=j=U),D!=C&&u.setLineDash(C=D)}function Ft(S,A,D,U){A!=Ms&&(u.fillStyle=Ms=A),S!=$&&(u.font=$=S),D!=Z&&(u.textAlign=Z=D),U!=Pt&&(u.textBaseline=Pt=U)}function Zt(S,A,D,U,X=0){if(U.length>0&&S.auto(n,Ss)&&(A==null||A.min==null)){let K=Pe(an,0),lt=Pe(ln,U.length-1),pt=D.min==null?$_(U,K,lt,X,S.distr==3):[D.min,D.max];S.min=Ei(S.min,D.min=pt[0]),S.max=Wn(S.max,D.max=pt[1])}}let ue={min:null,max:null};function Me(){for(let U in x){let X=x[U];V[U]==null&&(X.min==null||V[E]!=null&&X.auto(n,Ss))&&(V[U]=ue)}for(let U in x){let X=x[U];V[U]==null&&X.from!=null&&V[X.from]!=null&&(V[U]=ue)}V[E]!=null&&ye(!0);let S={};for(let U in V){let X=V[U];if(X!=null){let K=S[U]=Fr(x[U],iy);if(X.min!=null)dn(K,X);else if(U!=E||s==2)if(nn==0&&K.from==null){let lt=K.range(n,null,null,U);K.min=lt[0],K.max=lt[1]}else K.min=We,K.max=-We}}if(nn>0){y.forEach((U,X)=>{if(s==1){let K=U.scale,lt=V[K];if(lt==null)return;let pt=S[K];if(X==0){let At=pt.range(n,pt.min,pt.max,K);pt.min=At[0],pt.max=At[1],an=Ti(pt.min,t[0]),ln=Ti(pt.max,t[0]),ln-an>1&&(t[0][an]<pt.min&&an++,t[0][ln]>pt.max&&ln--),U.min=Kn[an],U.max=Kn[ln]}else U.show&&U.auto&&Zt(pt,lt,U,t[X],U.sorted);U.idxs[0]=an,U.idxs[1]=ln}else if(X>0&&U.show&&U.auto){let[K,lt]=U.facets,pt=K.scale,At=lt.scale,[zt,Gt]=t[X],Wt=S[pt],pe=S[At];Wt!=null&&Zt(Wt,V[pt],K,zt,K.sorted),pe!=null&&Zt(pe,V[At],lt,Gt,lt.sorted),U.min=lt.min,U.max=lt.max}});for(let U in S){let X=S[U],K=V[U];if(X.from==null&&(K==null||K.min==null)){let lt=X.range(n,X.min==We?null:X.min,X.max==-We?null:X.max,U);X.min=lt[0],X.max=lt[1]}}}for(let U in S){let X=S[U];if(X.from!=null){let K=S[X.from];if(K.min==null)X.min=X.max=null;else{let lt=X.range(n,K.min,K.max,U);X.min=lt[0],X.max=lt[1]}}}let A={},D=!1;for(let U in S){let X=S[U],K=x[U];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let lt=K.distr;K._min=lt==3?ns(K.min):lt==4?pu(K.min,K.asinh):lt==100?K.fwd(K.min):K.min,K._max=lt==3?ns(K.max):lt==4?pu(K.max,K.asinh):lt==100?K.fwd(K.max):K.max,A[U]=D=!0}}if(D){y.forEach((U,X)=>{s==2?X>0&&A.y&&(U._paths=null):A[U.scale]&&(U._paths=null)});for(let U in A)Et=!0,An("setScale",U);gt&&ht.left>=0&&(nt=mt=!0)}for(let U in V)V[U]=null}function Yt(S){let A=Mu(an-1,0,nn-1),D=Mu(ln+1,0,nn-1);for(;S[A]==null&&A>0;)A--;for(;S[D]==null&&D<nn-1;)D++;return[A,D]}function be(){if(nn>0){let S=y.some(A=>A._focus)&&Ut!=qt.alpha;S&&(u.globalAlpha=Ut=qt.alpha),y.forEach((A,D)=>{if(D>0&&A.show&&(tn(D,!1),tn(D,!0),A._paths==null)){let U=Ut;Ut!=A.alpha&&(u.globalAlpha=Ut=A.alpha);let X=s==2?[0,t[D][0].length-1]:Yt(t[D]);A._paths=A.paths(n,D,X[0],X[1]),Ut!=U&&(u.globalAlpha=Ut=U)}}),y.forEach((A,D)=>{if(D>0&&A.show){let U=Ut;Ut!=A.alpha&&(u.globalAlpha=Ut=A.alpha),A._paths!=null&&Be(D,!1);{let X=A._paths!=null?A._paths.gaps:null,K=A.points.show(n,D,an,ln,X),lt=A.points.filter(n,D,K,X);(K||lt)&&(A.points._paths=A.points.paths(n,D,an,ln,lt),Be(D,!0))}Ut!=U&&(u.globalAlpha=Ut=U),An("drawSeries",D)}}),S&&(u.globalAlpha=Ut=1)}}function tn(S,A){let D=A?y[S].points:y[S];D._stroke=D.stroke(n,S),D._fill=D.fill(n,S)}function Be(S,A){let D=A?y[S].points:y[S],{stroke:U,fill:X,clip:K,flags:lt,_stroke:pt=D._stroke,_fill:At=D._fill,_width:zt=D.width}=D._paths;zt=Xe(zt*Le,3);let Gt=null,Wt=zt%2/2;A&&At==null&&(At=zt>0?"#fff":pt);let pe=D.pxAlign==1&&Wt>0;if(pe&&u.translate(Wt,Wt),!A){let Ie=L-zt/2,Ce=w-zt/2,we=q+zt,re=ft+zt;Gt=new Path2D,Gt.rect(Ie,Ce,we,re)}A?Ht(pt,zt,D.dash,D.cap,At,U,X,lt,K):ke(S,pt,zt,D.dash,D.cap,At,U,X,lt,Gt,K),pe&&u.translate(-Wt,-Wt)}function ke(S,A,D,U,X,K,lt,pt,At,zt,Gt){let Wt=!1;At!=0&&R.forEach((pe,Ie)=>{if(pe.series[0]==S){let Ce=y[pe.series[1]],we=t[pe.series[1]],re=(Ce._paths||Ho).band;As(re)&&(re=pe.dir==1?re[0]:re[1]);let jt,Ze=null;Ce.show&&re&&J_(we,an,ln)?(Ze=pe.fill(n,Ie)||K,jt=Ce._paths.clip):re=null,Ht(A,D,U,X,Ze,lt,pt,At,zt,Gt,jt,re),Wt=!0}}),Wt||Ht(A,D,U,X,K,lt,pt,At,zt,Gt)}let _n=Or|Tu;function Ht(S,A,D,U,X,K,lt,pt,At,zt,Gt,Wt){It(S,A,D,U,X),(At||zt||Wt)&&(u.save(),At&&u.clip(At),zt&&u.clip(zt)),Wt?(pt&_n)==_n?(u.clip(Wt),Gt&&u.clip(Gt),Te(X,lt),cn(S,K,A)):pt&Tu?(Te(X,lt),u.clip(Wt),cn(S,K,A)):pt&Or&&(u.save(),u.clip(Wt),Gt&&u.clip(Gt),Te(X,lt),u.restore(),cn(S,K,A)):(Te(X,lt),cn(S,K,A)),(At||zt||Wt)&&u.restore()}function cn(S,A,D){D>0&&(A instanceof Map?A.forEach((U,X)=>{u.strokeStyle=Sr=X,u.stroke(U)}):A!=null&&S&&u.stroke(A))}function Te(S,A){A instanceof Map?A.forEach((D,U)=>{u.fillStyle=Ms=U,u.fill(D)}):A!=null&&S&&u.fill(A)}function Qi(S,A,D,U){let X=M[S],K;if(U<=0)K=[0,0];else{let lt=X._space=X.space(n,S,A,D,U),pt=X._incrs=X.incrs(n,S,A,D,U,lt);K=_x(A,D,pt,U,lt)}return X._found=K}function hn(S,A,D,U,X,K,lt,pt,At,zt){let Gt=lt%2/2;_==1&&u.translate(Gt,Gt),It(pt,lt,At,zt,pt),u.beginPath();let Wt,pe,Ie,Ce,we=X+(U==0||U==3?-K:K);D==0?(pe=X,Ce=we):(Wt=X,Ie=we);for(let re=0;re<S.length;re++)A[re]!=null&&(D==0?Wt=Ie=S[re]:pe=Ce=S[re],u.moveTo(Wt,pe),u.lineTo(Ie,Ce));u.stroke(),_==1&&u.translate(-Gt,-Gt)}function br(S){let A=!0;return M.forEach((D,U)=>{if(!D.show)return;let X=x[D.scale];if(X.min==null){D._show&&(A=!1,D._show=!1,ye(!1));return}else D._show||(A=!1,D._show=!0,ye(!1));let K=D.side,lt=K%2,{min:pt,max:At}=X,[zt,Gt]=Qi(U,pt,At,lt==0?B:Mt);if(Gt==0)return;let Wt=X.distr==2,pe=D._splits=D.splits(n,U,pt,At,zt,Gt,Wt),Ie=X.distr==2?pe.map(jt=>Kn[jt]):pe,Ce=X.distr==2?Kn[pe[1]]-Kn[pe[0]]:zt,we=D._values=D.values(n,D.filter(n,Ie,U,Gt,Ce),U,Gt,Ce);D._rotate=K==2?D.rotate(n,we,U,Gt):0;let re=D._size;D._size=_i(D.size(n,we,U,S)),re!=null&&D._size!=re&&(A=!1)}),A}function Oi(S){let A=!0;return Io.forEach((D,U)=>{let X=D(n,U,Ui,S);X!=Si[U]&&(A=!1),Si[U]=X}),A}function ts(){for(let S=0;S<M.length;S++){let A=M[S];if(!A.show||!A._show)continue;let D=A.side,U=D%2,X,K,lt=A.stroke(n,S),pt=D==0||D==3?-1:1,[At,zt]=A._found;if(A.label!=null){let Vn=A.labelGap*pt,ti=yn((A._lpos+Vn)*Le);Ft(A.labelFont[0],lt,"center",D==2?"top":Zd),u.save(),U==1?(X=K=0,u.translate(ti,yn(w+ft/2)),u.rotate((D==3?-ul:ul)/2)):(X=yn(L+q/2),K=ti);let Zs=Bp(A.label)?A.label(n,S,At,zt):A.label;u.fillText(Zs,X,K),u.restore()}if(zt==0)continue;let Gt=x[A.scale],Wt=U==0?q:ft,pe=U==0?L:w,Ie=A._splits,Ce=Gt.distr==2?Ie.map(Vn=>Kn[Vn]):Ie,we=Gt.distr==2?Kn[Ie[1]]-Kn[Ie[0]]:At,re=A.ticks,jt=A.border,Ze=re.show?re.size:0,rn=yn(Ze*Le),Rn=yn((A.alignTo==2?A._size-Ze-A.gap:A.gap)*Le),He=A._rotate*-ul/180,on=m(A._pos*Le),jn=(rn+Rn)*pt,Gn=on+jn;K=U==0?Gn:0,X=U==1?Gn:0;let pi=A.font[0],Mi=A.align==1?Ir:A.align==2?uu:He>0?Ir:He<0?uu:U==0?"center":D==3?uu:Ir,zi=He||U==1?"middle":D==2?"top":Zd;Ft(pi,lt,Mi,zi);let Qn=A.font[1]*A.lineGap,mi=Ie.map(Vn=>m(a(Vn,Gt,Wt,pe))),bi=A._values;for(let Vn=0;Vn<bi.length;Vn++){let ti=bi[Vn];if(ti!=null){U==0?X=mi[Vn]:K=mi[Vn],ti=""+ti;let Zs=ti.indexOf(`
`)==-1?[ti]:ti.split(/\n/gm);for(let Hn=0;Hn<Zs.length;Hn++){let Yd=Zs[Hn];He?(u.save(),u.translate(X,K+Hn*Qn),u.rotate(He),u.fillText(Yd,0,0),u.restore()):u.fillText(Yd,X,K+Hn*Qn)}}}re.show&&hn(mi,re.filter(n,Ce,S,zt,we),U,D,on,rn,Xe(re.width*Le,3),re.stroke(n,S),re.dash,re.cap);let Gi=A.grid;Gi.show&&hn(mi,Gi.filter(n,Ce,S,zt,we),U,U==0?2:1,U==0?w:L,U==0?ft:q,Xe(Gi.width*Le,3),Gi.stroke(n,S),Gi.dash,Gi.cap),jt.show&&hn([on],[1],U==0?1:0,U==0?1:2,U==1?w:L,U==1?ft:q,Xe(jt.width*Le,3),jt.stroke(n,S),jt.dash,jt.cap)}An("drawAxes")}function ye(S){y.forEach((A,D)=>{D>0&&(A._paths=null,S&&(s==1?(A.min=null,A.max=null):A.facets.forEach(U=>{U.min=null,U.max=null})))})}let sn=!1,zn=!1,ze=[];function un(){zn=!1;for(let S=0;S<ze.length;S++)An(...ze[S]);ze.length=0}function Un(){sn||(hy(Cd),sn=!0)}function rl(S,A=!1){sn=!0,zn=A,S(n),Cd(),A&&ze.length>0&&queueMicrotask(un)}n.batch=rl;function Cd(){if(at&&(Me(),at=!1),Et&&(Ct(),Et=!1),bt){if(Je(d,Ir,Xt),Je(d,"top",he),Je(d,ko,B),Je(d,zo,Mt),Je(p,Ir,Xt),Je(p,"top",he),Je(p,ko,B),Je(p,zo,Mt),Je(f,ko,fe),Je(f,zo,_e),h.width=yn(fe*Le),h.height=yn(_e*Le),M.forEach(({_el:S,_show:A,_size:D,_pos:U,side:X})=>{if(S!=null)if(A){let K=X===3||X===0?D:0,lt=X%2==1;Je(S,lt?"left":"top",U-K),Je(S,lt?"width":"height",D),Je(S,lt?"top":"left",lt?he:Xt),Je(S,lt?"height":"width",lt?Mt:B),vu(S,js)}else ei(S,js)}),Sr=Ms=Mr=G=j=$=Z=Pt=C=null,Ut=1,Fo(!0),Xt!=Tt||he!=Ue||B!=$t||Mt!=Qt){ye(!1);let S=B/$t,A=Mt/Qt;if(gt&&!nt&&ht.left>=0){ht.left*=S,ht.top*=A,wr&&Vi(wr,yn(ht.left),0,B,Mt),Tr&&Vi(Tr,0,yn(ht.top),B,Mt);for(let D=0;D<ge.length;D++){let U=ge[D];U!=null&&(qe[D]*=S,kn[D]*=A,Vi(U,_i(qe[D]),_i(kn[D]),B,Mt))}}if($e.show&&!st&&$e.left>=0&&$e.width>0){$e.left*=S,$e.width*=S,$e.top*=A,$e.height*=A;for(let D in au)Je(Rr,D,$e[D])}Tt=Xt,Ue=he,$t=B,Qt=Mt}An("setSize"),bt=!1}fe>0&&_e>0&&(u.clearRect(0,0,h.width,h.height),An("drawClear"),b.forEach(S=>S()),An("draw")),$e.show&&st&&(ol($e),st=!1),gt&&nt&&($s(null,!0,!1),nt=!1),dt.show&&dt.live&&mt&&(ru(),mt=!1),l||(l=!0,n.status=1,An("ready")),Ss=!1,sn=!1}n.redraw=(S,A)=>{Et=A||!1,S!==!1?ws(E,P.min,P.max):Un()};function nu(S,A){let D=x[S];if(D.from==null){if(nn==0){let U=D.range(n,A.min,A.max,S);A.min=U[0],A.max=U[1]}if(A.min>A.max){let U=A.min;A.min=A.max,A.max=U}if(nn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;S==E&&D.distr==2&&nn>0&&(A.min=Ti(A.min,t[0]),A.max=Ti(A.max,t[0]),A.min==A.max&&A.max++),V[S]=A,at=!0,Un()}}n.setScale=nu;let iu,su,wr,Tr,Pd,Id,Er,Ar,Ld,Dd,Ye,je,bs=!1,Dn=ht.drag,Tn=Dn.x,En=Dn.y;gt&&(ht.x&&(iu=gi(N_,p)),ht.y&&(su=gi(U_,p)),P.ori==0?(wr=iu,Tr=su):(wr=su,Tr=iu),Ye=ht.left,je=ht.top);let $e=n.select=dn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Rr=$e.show?gi(D_,$e.over?p:d):null;function ol(S,A){if($e.show){for(let D in S)$e[D]=S[D],D in au&&Je(Rr,D,S[D]);A!==!1&&An("setSelect")}}n.setSelect=ol;function d_(S){if(y[S].show)tt&&vu(ie[S],js);else if(tt&&ei(ie[S],js),gt){let D=Nt?ge[0]:ge[S];D!=null&&Vi(D,-10,-10,B,Mt)}}function ws(S,A,D){nu(S,{min:A,max:D})}function Bi(S,A,D,U){A.focus!=null&&y_(S),A.show!=null&&y.forEach((X,K)=>{K>0&&(S==K||S==null)&&(X.show=A.show,d_(K),s==2?(ws(X.facets[0].scale,null,null),ws(X.facets[1].scale,null,null)):ws(X.scale,null,null),Un())}),D!==!1&&An("setSeries",S,A),U&&Oo("setSeries",n,S,A)}n.setSeries=Bi;function p_(S,A){dn(R[S],A)}function m_(S,A){S.fill=Ee(S.fill||null),S.dir=Pe(S.dir,-1),A=A??R.length,R.splice(A,0,S)}function g_(S){S==null?R.length=0:R.splice(S,1)}n.addBand=m_,n.setBand=p_,n.delBand=g_;function __(S,A){y[S].alpha=A,gt&&ge[S]!=null&&(ge[S].style.opacity=A),tt&&ie[S]&&(ie[S].style.opacity=A)}let es,Ts,Ys,Cr={focus:!0};function y_(S){if(S!=Ys){let A=S==null,D=qt.alpha!=1;y.forEach((U,X)=>{if(s==1||X>0){let K=A||X==0||X==S;U._focus=A?null:K,D&&__(X,K?1:qt.alpha)}}),Ys=S,D&&Un()}}tt&&le&&kt(Qd,Lt,S=>{ht._lock||(ae(S),Ys!=null&&Bi(null,Cr,!0,fn.setSeries))});function ki(S,A,D){let U=x[A];D&&(S=S/Le-(U.ori==1?he:Xt));let X=B;U.ori==1&&(X=Mt,S=X-S),U.dir==-1&&(S=X-S);let K=U._min,lt=U._max,pt=S/X,At=K+(lt-K)*pt,zt=U.distr;return zt==3?Nr(10,At):zt==4?j_(At,U.asinh):zt==100?U.bwd(At):At}function x_(S,A){let D=ki(S,E,A);return Ti(D,t[0],an,ln)}n.valToIdx=S=>Ti(S,t[0]),n.posToIdx=x_,n.posToVal=ki,n.valToPos=(S,A,D)=>x[A].ori==0?r(S,x[A],D?q:B,D?L:0):o(S,x[A],D?ft:Mt,D?w:0),n.setCursor=(S,A,D)=>{Ye=S.left,je=S.top,$s(null,A,D)};function Nd(S,A){Je(Rr,Ir,$e.left=S),Je(Rr,ko,$e.width=A)}function Ud(S,A){Je(Rr,"top",$e.top=S),Je(Rr,zo,$e.height=A)}let No=P.ori==0?Nd:Ud,Uo=P.ori==1?Nd:Ud;function v_(){if(tt&&dt.live)for(let S=s==2?1:0;S<y.length;S++){if(S==0&&ne)continue;let A=dt.values[S],D=0;for(let U in A)Jt[S][D++].firstChild.nodeValue=A[U]}}function ru(S,A){if(S!=null&&(S.idxs?S.idxs.forEach((D,U)=>{et[U]=D}):ny(S.idx)||et.fill(S.idx),dt.idx=et[0]),tt&&dt.live){for(let D=0;D<y.length;D++)(D>0||s==1&&!ne)&&S_(D,et[D]);v_()}mt=!1,A!==!1&&An("setLegend")}n.setLegend=ru;function S_(S,A){let D=y[S],U=S==0&&O==2?Kn:t[S],X;ne?X=D.values(n,S,A)??ot:(X=D.value(n,A==null?null:U[A],S,A),X=X==null?ot:{_:X}),dt.values[S]=X}function $s(S,A,D){Ld=Ye,Dd=je,[Ye,je]=ht.move(n,Ye,je),ht.left=Ye,ht.top=je,gt&&(wr&&Vi(wr,yn(Ye),0,B,Mt),Tr&&Vi(Tr,0,yn(je),B,Mt));let U,X=an>ln;es=We,Ts=null;let K=P.ori==0?B:Mt,lt=P.ori==1?B:Mt;if(Ye<0||nn==0||X){U=ht.idx=null;for(let pt=0;pt<y.length;pt++){let At=ge[pt];At!=null&&Vi(At,-10,-10,B,Mt)}le&&Bi(null,Cr,!0,S==null&&fn.setSeries),dt.live&&(et.fill(U),mt=!0)}else{let pt,At,zt;s==1&&(pt=P.ori==0?Ye:je,At=ki(pt,E),U=ht.idx=Ti(At,t[0],an,ln),zt=H(t[0][U],P,K,0));let Gt=-10,Wt=-10,pe=0,Ie=0,Ce=!0,we="",re="";for(let jt=s==2?1:0;jt<y.length;jt++){let Ze=y[jt],rn=et[jt],Rn=rn==null?null:s==1?t[jt][rn]:t[jt][1][rn],He=ht.dataIdx(n,jt,U,At),on=He==null?null:s==1?t[jt][He]:t[jt][1][He];if(mt=mt||on!=Rn||He!=rn,et[jt]=He,jt>0&&Ze.show){let jn=He==null?-10:He==U?zt:H(s==1?t[0][He]:t[jt][0][He],P,K,0),Gn=on==null?-10:N(on,s==1?x[Ze.scale]:x[Ze.facets[1].scale],lt,0);if(le&&on!=null){let pi=P.ori==1?Ye:je,Mi=xn(qt.dist(n,jt,He,Gn,pi));if(Mi<es){let zi=qt.bias;if(zi!=0){let Qn=ki(pi,Ze.scale),mi=on>=0?1:-1,bi=Qn>=0?1:-1;bi==mi&&(bi==1?zi==1?on>=Qn:on<=Qn:zi==1?on<=Qn:on>=Qn)&&(es=Mi,Ts=jt)}else es=Mi,Ts=jt}}if(mt||Nt){let pi,Mi;P.ori==0?(pi=jn,Mi=Gn):(pi=Gn,Mi=jn);let zi,Qn,mi,bi,Gi,Vn,ti=!0,Zs=ut.bbox;if(Zs!=null){ti=!1;let Hn=Zs(n,jt);mi=Hn.left,bi=Hn.top,zi=Hn.width,Qn=Hn.height}else mi=pi,bi=Mi,zi=Qn=ut.size(n,jt);if(Vn=ut.fill(n,jt),Gi=ut.stroke(n,jt),Nt)jt==Ts&&es<=qt.prox&&(Gt=mi,Wt=bi,pe=zi,Ie=Qn,Ce=ti,we=Vn,re=Gi);else{let Hn=ge[jt];Hn!=null&&(qe[jt]=mi,kn[jt]=bi,op(Hn,zi,Qn,ti),sp(Hn,Vn,Gi),Vi(Hn,_i(mi),_i(bi),B,Mt))}}}}if(Nt){let jt=qt.prox,Ze=Ys==null?es<=jt:es>jt||Ts!=Ys;if(mt||Ze){let rn=ge[0];rn!=null&&(qe[0]=Gt,kn[0]=Wt,op(rn,pe,Ie,Ce),sp(rn,we,re),Vi(rn,_i(Gt),_i(Wt),B,Mt))}}}if($e.show&&bs)if(S!=null){let[pt,At]=fn.scales,[zt,Gt]=fn.match,[Wt,pe]=S.cursor.sync.scales,Ie=S.cursor.drag;if(Tn=Ie._x,En=Ie._y,Tn||En){let{left:Ce,top:we,width:re,height:jt}=S.select,Ze=S.scales[Wt].ori,rn=S.posToVal,Rn,He,on,jn,Gn,pi=pt!=null&&zt(pt,Wt),Mi=At!=null&&Gt(At,pe);pi&&Tn?(Ze==0?(Rn=Ce,He=re):(Rn=we,He=jt),on=x[pt],jn=H(rn(Rn,Wt),on,K,0),Gn=H(rn(Rn+He,Wt),on,K,0),No(Ei(jn,Gn),xn(Gn-jn))):No(0,K),Mi&&En?(Ze==1?(Rn=Ce,He=re):(Rn=we,He=jt),on=x[At],jn=N(rn(Rn,pe),on,lt,0),Gn=N(rn(Rn+He,pe),on,lt,0),Uo(Ei(jn,Gn),xn(Gn-jn))):Uo(0,lt)}else lu()}else{let pt=xn(Ld-Pd),At=xn(Dd-Id);if(P.ori==1){let pe=pt;pt=At,At=pe}Tn=Dn.x&&pt>=Dn.dist,En=Dn.y&&At>=Dn.dist;let zt=Dn.uni;zt!=null?Tn&&En&&(Tn=pt>=zt,En=At>=zt,!Tn&&!En&&(At>pt?En=!0:Tn=!0)):Dn.x&&Dn.y&&(Tn||En)&&(Tn=En=!0);let Gt,Wt;Tn&&(P.ori==0?(Gt=Er,Wt=Ye):(Gt=Ar,Wt=je),No(Ei(Gt,Wt),xn(Wt-Gt)),En||Uo(0,lt)),En&&(P.ori==1?(Gt=Er,Wt=Ye):(Gt=Ar,Wt=je),Uo(Ei(Gt,Wt),xn(Wt-Gt)),Tn||No(0,K)),!Tn&&!En&&(No(0,0),Uo(0,0))}if(Dn._x=Tn,Dn._y=En,S==null){if(D){if(qd!=null){let[pt,At]=fn.scales;fn.values[0]=pt!=null?ki(P.ori==0?Ye:je,pt):null,fn.values[1]=At!=null?ki(P.ori==1?Ye:je,At):null}Oo(fu,n,Ye,je,B,Mt,U)}if(le){let pt=D&&fn.setSeries,At=qt.prox;Ys==null?es<=At&&Bi(Ts,Cr,!0,pt):es>At?Bi(null,Cr,!0,pt):Ts!=Ys&&Bi(Ts,Cr,!0,pt)}}mt&&(dt.idx=U,ru()),A!==!1&&An("setCursor")}let Es=null;Object.defineProperty(n,"rect",{get(){return Es==null&&Fo(!1),Es}});function Fo(S=!1){S?Es=null:(Es=p.getBoundingClientRect(),An("syncRect",Es))}function Fd(S,A,D,U,X,K,lt){ht._lock||bs&&S!=null&&S.movementX==0&&S.movementY==0||(ou(S,A,D,U,X,K,lt,!1,S!=null),S!=null?$s(null,!0,!0):$s(A,!0,!1))}function ou(S,A,D,U,X,K,lt,pt,At){if(Es==null&&Fo(!1),ae(S),S!=null)D=S.clientX-Es.left,U=S.clientY-Es.top;else{if(D<0||U<0){Ye=-10,je=-10;return}let[zt,Gt]=fn.scales,Wt=A.cursor.sync,[pe,Ie]=Wt.values,[Ce,we]=Wt.scales,[re,jt]=fn.match,Ze=A.axes[0].side%2==1,rn=P.ori==0?B:Mt,Rn=P.ori==1?B:Mt,He=Ze?K:X,on=Ze?X:K,jn=Ze?U:D,Gn=Ze?D:U;if(Ce!=null?D=re(zt,Ce)?a(pe,x[zt],rn,0):-10:D=rn*(jn/He),we!=null?U=jt(Gt,we)?a(Ie,x[Gt],Rn,0):-10:U=Rn*(Gn/on),P.ori==1){let pi=D;D=U,U=pi}}At&&(A==null||A.cursor.event.type==fu)&&((D<=1||D>=B-1)&&(D=Js(D,B)),(U<=1||U>=Mt-1)&&(U=Js(U,Mt))),pt?(Pd=D,Id=U,[Er,Ar]=ht.move(n,D,U)):(Ye=D,je=U)}let au={width:0,height:0,left:0,top:0};function lu(){ol(au,!1)}let Od,Bd,kd,zd;function Gd(S,A,D,U,X,K,lt){bs=!0,Tn=En=Dn._x=Dn._y=!1,ou(S,A,D,U,X,K,lt,!0,!1),S!=null&&(kt(du,yu,Vd,!1),Oo(Kd,n,Er,Ar,B,Mt,null));let{left:pt,top:At,width:zt,height:Gt}=$e;Od=pt,Bd=At,kd=zt,zd=Gt}function Vd(S,A,D,U,X,K,lt){bs=Dn._x=Dn._y=!1,ou(S,A,D,U,X,K,lt,!1,!0);let{left:pt,top:At,width:zt,height:Gt}=$e,Wt=zt>0||Gt>0,pe=Od!=pt||Bd!=At||kd!=zt||zd!=Gt;if(Wt&&pe&&ol($e),Dn.setScale&&Wt&&pe){let Ie=pt,Ce=zt,we=At,re=Gt;if(P.ori==1&&(Ie=At,Ce=Gt,we=pt,re=zt),Tn&&ws(E,ki(Ie,E),ki(Ie+Ce,E)),En)for(let jt in x){let Ze=x[jt];jt!=E&&Ze.from==null&&Ze.min!=We&&ws(jt,ki(we+re,jt),ki(we,jt))}lu()}else ht.lock&&(ht._lock=!ht._lock,$s(A,!0,S!=null));S!=null&&(me(du,yu),Oo(du,n,Ye,je,B,Mt,null))}function M_(S,A,D,U,X,K,lt){if(ht._lock)return;ae(S);let pt=bs;if(bs){let At=!0,zt=!0,Gt=10,Wt,pe;P.ori==0?(Wt=Tn,pe=En):(Wt=En,pe=Tn),Wt&&pe&&(At=Ye<=Gt||Ye>=B-Gt,zt=je<=Gt||je>=Mt-Gt),Wt&&At&&(Ye=Ye<Er?0:B),pe&&zt&&(je=je<Ar?0:Mt),$s(null,!0,!0),bs=!1}Ye=-10,je=-10,et.fill(null),$s(null,!0,!0),pt&&(bs=pt)}function Hd(S,A,D,U,X,K,lt){ht._lock||(ae(S),Do(),lu(),S!=null&&Oo(tp,n,Ye,je,B,Mt,null))}function Wd(){M.forEach(yx),k(n.width,n.height,!0)}Qs(fl,Dr,Wd);let Pr={};Pr.mousedown=Gd,Pr.mousemove=Fd,Pr.mouseup=Vd,Pr.dblclick=Hd,Pr.setSeries=(S,A,D,U)=>{let X=fn.match[2];D=X(n,A,D),D!=-1&&Bi(D,U,!0,!1)},gt&&(kt(Kd,p,Gd),kt(fu,p,Fd),kt(jd,p,S=>{ae(S),Fo(!1)}),kt(Qd,p,M_),kt(tp,p,Hd),Eu.add(n),n.syncRect=Fo);let al=n.hooks=i.hooks||{};function An(S,A,D){zn?ze.push([S,A,D]):S in al&&al[S].forEach(U=>{U.call(null,n,A,D)})}(i.plugins||[]).forEach(S=>{for(let A in S.hooks)al[A]=(al[A]||[]).concat(S.hooks[A])});let Xd=(S,A,D)=>D,fn=dn({key:null,setSeries:!1,filters:{pub:up,sub:up},scales:[E,y[1]?y[1].scale:null],match:[fp,fp,Xd],values:[null,null]},ht.sync);fn.match.length==2&&fn.match.push(Xd),ht.sync=fn;let qd=fn.key,cu=lm(qd);function Oo(S,A,D,U,X,K,lt){fn.filters.pub(S,A,D,U,X,K,lt)&&cu.pub(S,A,D,U,X,K,lt)}cu.sub(n);function b_(S,A,D,U,X,K,lt){fn.filters.sub(S,A,D,U,X,K,lt)&&Pr[S](null,A,D,U,X,K,lt)}n.pub=b_;function w_(){cu.unsub(n),Eu.delete(n),ee.clear(),Su(fl,Dr,Wd),c.remove(),Lt?.remove(),An("destroy")}n.destroy=w_;function hu(){An("init",i,t),Lo(t||i.data,!1),V[E]?nu(E,V[E]):Do(),st=$e.show&&($e.width>0||$e.height>0),nt=mt=!0,k(i.width,i.height)}return y.forEach(vr),M.forEach(Ki),e?e instanceof HTMLElement?(e.appendChild(c),hu()):e(n,hu):hu(),n}vn.assign=dn;vn.fmtNum=Du;vn.rangeNum=dl;vn.rangeLog=gl;vn.rangeAsinh=Iu;vn.orient=er;vn.pxRatio=Le;vn.join=cy;vn.fmtDate=Uu,vn.tzDate=vy;vn.sync=lm;{vn.addGap=nx,vn.clipGaps=xl;let i=vn.paths={points:pm};i.linear=gm,i.stepped=rx,i.bars=ox,i.spline=lx}function F(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===!1||r===null||r===void 0||(s.startsWith("on")?n.addEventListener(s.slice(2),r):s==="class"?n.className=r:n.setAttribute(s,r===!0?"":String(r)));for(let s of e)s!==null&&s!==!1&&n.append(s);return n}function Ge(i,t){i.textContent!==t&&(i.textContent=t)}function xe(i,t,e=""){if(i==null||!Number.isFinite(i))return"–";let n=i.toFixed(t);return`${Number(n)===0?n.replace("-",""):n.replace("-","−")}${e}`}function Ai(i){let t=i<0?"−":"",e=Math.abs(i),n=Math.floor(e/60);return`${t}${n}:${(e-60*n).toFixed(1).padStart(4,"0")}`}function bl(i){let t=i.getBoundingClientRect(),e=Math.min(window.devicePixelRatio||1,2),n=Math.max(Math.round(t.width*e),1),s=Math.max(Math.round(t.height*e),1),r=i.width!==n||i.height!==s;return r&&(i.width=n,i.height=s),{width:t.width,height:t.height,scale:e,changed:r}}var vm=matchMedia("(prefers-color-scheme: dark)"),Cs={light:["#000"],dark:["#fff"],sources:{light:[],dark:[]},alarm:{light:"#000",dark:"#fff"}},wl=new Map,Sm=!1,Mm=new Set;function bm(i){Cs=i}function Tl(i){wl.clear();for(let t of i)wl.set(t.sysid,{index:t.colour,role:t.role})}function El(i){Mm.add(i)}var Vu=()=>Mm.forEach(i=>i());vm.addEventListener("change",Vu);function Hu(i){Sm=i,Vu()}function xx(){let i=document.documentElement.dataset.theme;return i==="light"||i==="dark"?i:"auto"}function nr(){let i=Xo()?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem("skytender-theme",i)}catch{}Vu()}function wm(){try{let i=localStorage.getItem("skytender-theme");(i==="light"||i==="dark")&&(document.documentElement.dataset.theme=i)}catch{}}function Xo(){if(Sm)return!1;let i=xx();return i==="auto"?vm.matches:i==="dark"}function Ae(){return Xo()?{dark:!0,ink:"#e6e9ed",soft:"#a3adb8",grid:"#2b323a",paper:"#12161b",faint:"#1d232a",solid:"#7d8894",band:"rgba(86,180,233,.25)",crowd:"rgba(163,173,184,.35)",bad:"#ff9d7a",warn:"#f0c860",good:"#5fd3ac"}:{dark:!1,ink:"#1b1f24",soft:"#57606a",grid:"#dfe4e9",paper:"#ffffff",faint:"#f3f5f7",solid:"#6b7682",band:"rgba(0,114,178,.18)",crowd:"rgba(87,96,106,.3)",bad:"#a52a00",warn:"#7a5200",good:"#00664b"}}function pn(i){let t=wl.get(i);if(t?.role==="target")return Ae().ink;let e=Xo()?Cs.dark:Cs.light;return e[(t?.index??i-1)%e.length]}var Al=()=>Xo()?Cs.alarm.dark:Cs.alarm.light;function Rl(i){let t=wl.get(i);if(t?.role==="target")return[2,3];if(t?.role==="tanker")return[8,3];let e=Cs.light.length;return[[],[6,4],[2,3],[6,3,2,3]][Math.floor((t?.index??i-1)/e)%4]}function Cl(i){let t=Xo()?Cs.sources.dark:Cs.sources.light;return t[i%t.length]}var vx=165,Sx=52,Tm=9,Mx=[.1,.2,.5,1,2,5,10,20,50,100,200,500,1e3,2e3,5e3,1e4,2e4,5e4],Pl=class{constructor(){this.zoom=null,this.now_s=0,this.end_s=1,this.begin_s=0,this.charts=new Set,this.seek=()=>{},this.point=()=>{}}get range(){return this.zoom??[this.begin_s,Math.max(this.end_s,this.begin_s+.001)]}setZoom(t){this.zoom=t;let[e,n]=this.range;for(let s of this.charts)for(let r of s.plots)r.setScale("x",{min:e,max:n})}setNow(t){if(this.now_s!==t){this.now_s=t;for(let e of this.charts)e.showNow()}}};function bx(i){return Array.from(i,t=>Number.isNaN(t)?null:t)}var Gr=class{constructor(t,e,n){this.div=t,this.time=e,this.label=n,this.plots=[],this.key="",this.figure=null,this.nows=[],e.charts.add(this)}draw(t,e,n=this.div.clientWidth){if(n<=0)return;this.figure=t;let s=t.panels.map(o=>this.#e(o,e)),r=JSON.stringify([n,Ae().dark,Ae().paper,s.map(o=>o.series.map(a=>[a.label,a.stroke,a.dash]))]);r!==this.key&&this.#t(s,r,n),this.plots.forEach((o,a)=>{o.setData(s[a].data,!1);let[l,c]=this.time.range;o.batch(()=>{o.setScale("y",s[a].range()),o.setScale("x",{min:l,max:c})})}),this.div.dataset.lines=String(s.reduce((o,a)=>o+a.series.length-1,0)),this.showNow()}#e(t,e){let{soft:n}=Ae(),s=[{}],r=[],o=(f,d)=>{s.push({spanGaps:!1,points:{show:!1},width:1.6,...d}),r.push([Array.from(f.x),bx(f.y)])};t.band&&(o(t.band.least,{label:"least",stroke:"transparent"}),o(t.band.greatest,{label:"greatest",stroke:"transparent"}),o(t.band.median,{label:`median of ${t.band.count}`,stroke:n,dash:[2,3]}));for(let f of t.lines){let d=f.id;e.has(d)&&o(f,{label:this.label(d),stroke:pn(d),dash:Rl(d)})}t.own.forEach((f,d)=>o(f,{label:f.label,stroke:Cl(d)}));let a=r.length?vn.join(r):[[this.time.begin_s,this.time.end_s]],[l,c]=[1/0,-1/0];for(let[,f]of r)for(let d of f)d!==null&&(d<l&&(l=d),d>c&&(c=d));for(let f of t.limits)l=Math.min(l,f.y),c=Math.max(c,f.y);t.zero&&(l=Math.min(l,0)),l>c&&([l,c]=[0,1]);let h=Math.max((c-l)*.06,10**-t.digits);return{panel:t,series:s,data:a,range:()=>t.range?{min:t.range[0],max:t.range[1]}:{min:t.zero&&l>=0?0:l-h,max:c+h}}}#t(t,e,n){this.key=e,this.close(),this.div.replaceChildren();let{soft:s,grid:r,band:o}=Ae();t.forEach(({panel:a,series:l},c)=>{let h=F("div",{class:"now"}),u=F("div",{class:"tip",hidden:!0}),f=F("p",{class:"panel-title"},a.title,a.unit?` (${a.unit})`:""),d=F("div",{class:"panel"});this.div.append(f,d);let p=c===t.length-1,_="11px system-ui, sans-serif",m=new vn({width:n,height:vx+(p?18:0),series:l,legend:{show:!1},padding:[6,10,0,0],scales:{x:{time:!1,range:(g,y,M)=>[y,M]},y:{range:(g,y,M)=>[y,M]}},axes:[{stroke:s,font:_,grid:{stroke:r,width:1},ticks:{show:!1},incrs:Mx,size:22,label:p?"session time (s)":void 0,labelFont:_,labelSize:18,labelGap:0},{stroke:s,font:_,grid:{stroke:r,width:1},ticks:{show:!1},size:Sx,space:28}],bands:a.band?[{series:[2,1],fill:o}]:[],cursor:{sync:{key:"skytender",setSeries:!1},y:!1,points:{show:!1},drag:{x:!0,y:!1,setScale:!1},bind:{dblclick:()=>()=>(this.time.setZoom(null),null)}},hooks:{drawClear:[g=>this.#n(g)],draw:[g=>this.#s(g,a)],setSelect:[g=>{g.select.width<8||(this.time.setZoom([g.posToVal(g.select.left,"x"),g.posToVal(g.select.left+g.select.width,"x")]),g.setSelect({left:0,top:0,width:0,height:0},!1))}],setCursor:[g=>this.#i(g,a,u)]}},l.map(()=>[]),d);m.over.append(h,u),m.over.addEventListener("click",()=>{m.select.width<8&&m.cursor.left!==void 0&&m.cursor.left>=0&&this.time.seek(m.posToVal(m.cursor.left,"x"))}),this.plots.push(m),this.nows.push(h)})}#n(t){let{ctx:e}=t,{left:n,top:s,width:r,height:o}=t.bbox;e.save(),e.beginPath(),e.rect(n,s,r,o),e.clip(),e.globalAlpha=.13;for(let a of this.figure?.spans??[]){let[l,c]=[t.valToPos(a.from,"x",!0),t.valToPos(a.to,"x",!0)];e.fillStyle=pn(a.id),e.fillRect(l,s,c-l,o)}e.restore()}#s(t,e){let{ctx:n}=t,{left:s,top:r,width:o,height:a}=t.bbox,{ink:l,soft:c,bad:h,paper:u}=Ae(),f=vn.pxRatio;n.save(),n.beginPath(),n.rect(s,r,o,a),n.clip(),n.font=`${11*f}px system-ui, sans-serif`,n.lineWidth=f;let d=(_,m,g,y)=>{n.lineWidth=3*f,n.strokeStyle=u,n.strokeText(_,m,g),n.fillStyle=y,n.fillText(_,m,g),n.lineWidth=f};for(let _ of e.limits){let m=t.valToPos(_.y,"y",!0);n.setLineDash([6*f,4*f]),n.strokeStyle=l,n.beginPath(),n.moveTo(s,m),n.lineTo(s+o,m),n.stroke(),n.setLineDash([]),n.textAlign="right",d(_.label,s+o-4*f,m<r+14*f?m+13*f:m-4*f,c)}n.textAlign="left";let p=-1/0;for(let _ of this.figure?.marks??[]){let m=t.valToPos(_.t_s,"x",!0);n.setLineDash([2*f,3*f]),n.strokeStyle=_.bad?h:c,n.beginPath(),n.moveTo(m,r),n.lineTo(m,r+a),n.stroke(),n.setLineDash([]),!(m-p<34*f)&&(p=m,d(_.label,m+3*f,r+12*f,_.bad?h:_.id!==void 0?pn(_.id):c))}n.restore()}#i(t,e,n){let{left:s,idx:r}=t.cursor,o=t.over.matches(":hover");if(o&&this.time.point(s===void 0||s<0?null:t.posToVal(s,"x")),s===void 0||s<0||r===null||r===void 0||!o)return void(n.hidden=!0);let a=t.posToVal(s,"x"),l=[];for(let u=1;u<t.series.length;u+=1){if(t.series[u].stroke==="transparent")continue;let f=t.data[u],d=r;for(;d>0&&f[d]===void 0;)d-=1;let p=f[d];if(p==null)continue;let _=F("i",{class:"swatch"}),m=t.series[u].stroke;_.style.background=String(typeof m=="function"?m(t,u):m),l.push({value:p,row:F("div",{},_,`${t.series[u].label}: ${xe(p,e.digits)} ${e.unit}`)})}let c=l.length-Tm;n.replaceChildren(F("b",{},`${a.toFixed(1)} s`),...l.slice(0,Tm).map(u=>u.row),c>0?`and ${c} more`:"");for(let u of this.figure?.marks??[])Math.abs(t.valToPos(u.t_s,"x")-s)<5&&n.append(F("div",{},u.text??`${u.id===void 0?u.label:`${this.label(u.id)} is next`}, ${u.t_s.toFixed(1)} s`));n.hidden=!1;let h=s>t.over.clientWidth/2;n.style.left=h?"":`${s+12}px`,n.style.right=h?`${t.over.clientWidth-s+12}px`:""}showNow(){this.plots.forEach((t,e)=>{let n=t.valToPos(this.time.now_s,"x"),s=Number.isFinite(n)&&n>=0&&n<=t.over.clientWidth;this.nows[e].hidden=!s,s&&(this.nows[e].style.transform=`translateX(${n}px)`)})}close(){for(let t of this.plots)t.destroy();this.plots=[],this.nows=[]}},Em=["on the way","in formation","transfer"];function Am(i,t,e){let[n,s]=[e.begin_s,Math.max(e.end_s,e.begin_s+.001)],r=c=>`${(100*(c-n)/(s-n)).toFixed(2)}%`,o=t.rows.map(c=>{let h=F("div",{class:"track"});for(let u of t.bars.filter(f=>f.row===c)){let f=`${Em[u.stage]} ${u.from.toFixed(1)} to ${u.to.toFixed(1)} s, ${u.text}`,d=F("button",{type:"button",class:`bar stage${u.stage}`,title:f,"aria-label":`${c}: ${f}`,onclick:()=>e.seek(u.from)});d.style.left=r(u.from),d.style.width=`max(3px, ${r(n+u.to-u.from)})`,h.append(d)}return F("div",{class:"row"},F("span",{class:"row-name"},c),h)}),a=F("p",{class:"small soft key"},...Em.map((c,h)=>F("span",{},F("i",{class:`swatch stage${h}`}),c))),l=F("div",{class:"row"},F("span",{class:"row-name"},"session time (s)"),F("div",{class:"ends"},F("span",{},n.toFixed(0)),F("span",{},s.toFixed(0))));i.replaceChildren(a,...o,l),i.classList.add("bars"),i.dataset.lines=String(t.bars.length)}function Rm(i,t,e,n){let s=[["initial","initial_j",0],["received","received_j",0],["drawn","drawn_j",1],["given","given_j",1],["remaining","remaining_j",1]],r=t.rows.filter(h=>e.has(h.id)),o=Math.max(...r.map(h=>h.initial_j+h.received_j),1),a=r.flatMap(h=>[0,1].map(u=>{let f=F("div",{class:"track stack"});return s.forEach(([d,p,_],m)=>{let g=h[String(p)];if(_!==u||!(g>0))return;let y=`${d} ${(g/1e3).toFixed(1)} kJ`,M=F("span",{class:"bar",title:y,role:"img","aria-label":y});M.style.width=`${(100*g/o).toFixed(2)}%`,M.style.background=Cl(m),f.append(M)}),F("div",{class:"row"},F("span",{class:"row-name"},u?"went":`${n(h.id)}: came`),f)})),l=s.map(([h],u)=>{let f=F("i",{class:"swatch"});return f.style.background=Cl(u),F("span",{},f,String(h))}),c=F("div",{class:"row"},F("span",{class:"row-name"},"energy (kJ)"),F("div",{class:"ends"},F("span",{},"0"),F("span",{},(o/1e3).toFixed(0))));i.replaceChildren(F("p",{class:"small soft key"},...l),...a,c),i.classList.add("bars"),i.dataset.lines=String(i.querySelectorAll(".bar").length)}var ss=["n","e","d","heading","roll","pitch","speed","height","battery","power","target","v","lost"],wx=new Set(["heading","roll","pitch"]),Tx=4e3,Ex=6e6,Ax=.09,Cm=6e3,Rx=600;function Cx(i){let[t,e,n]=i.p_ned??[NaN,NaN,NaN],s=i.battery===null?NaN:100*i.battery;return[t,e,n,i.heading_rad,i.roll_rad,i.pitch_rad,i.speed_m_s,i.height_m??NaN,s,i.power_w??NaN,i.target_m??NaN,i.v??NaN,i.lost]}var qo=class{constructor(){this.t_s=[],this.rows=[],this.last=""}take(t,e){let{mode:n,stage:s,state:r,alive:o,armed:a,landed:l,note:c,trouble:h,severity:u,condition:f,figure:d,urgency:p,autopilot:_}=e,m={mode:n,stage:s,state:r,alive:o,armed:a,landed:l,note:c,trouble:h,severity:u,condition:f,figure:d,urgency:p,autopilot:_},g=JSON.stringify(m);g!==this.last&&(this.t_s.length&&t<=this.t_s[this.t_s.length-1]||(this.last=g,this.t_s.push(t),this.rows.push(m)))}at(t){let e=si(this.t_s,t);return this.rows[Math.max(e,0)]??{}}};function si(i,t,e=i.length){let n=0,s=e;for(;n<s;){let r=n+s>>1;i[r]<=t?n=r+1:s=r}return n-1}var Il=class i{session=null;worlds=[];newest=null;events=[];count=0;capacity=256;spacing_s=Ax;t_s=new Float64Array(this.capacity);share=new Float32Array(this.capacity);columns=new Map;words=new Map;traffic=new Map;version=0;clear(){Object.assign(this,new i,{version:this.version+1})}get first_s(){return this.count?this.t_s[0]:0}get last_s(){return this.count?this.t_s[this.count-1]:0}begin(t){if(this.session=t,t.source==="replay")return;let e=this.worlds.length?this.newest?.t_s??0:-1/0;for(;this.worlds.length&&this.worlds[this.worlds.length-1].t_s>=e;)this.worlds.pop();this.worlds.push({t_s:e,session:t}),this.worlds.length>Rx&&(this.worlds=this.worlds.filter((n,s)=>s%2===0))}sessionAt(t){let e=si(this.worlds.map(n=>n.t_s),t);return this.worlds[Math.max(e,0)]?.session??this.session}tell(t){t.length&&(this.events.push(...t),this.events.length>Cm&&this.events.splice(0,this.events.length-Cm))}take(t){this.newest=t;let e=t.t_s;for(let r of t.vehicles){let o=this.words.get(r.sysid);o||this.words.set(r.sysid,o=new qo),o.take(e,r)}let n=si(this.t_s,e,this.count),s=r=>r>=0&&r<this.count&&Math.abs(this.t_s[r]-e)<this.spacing_s;s(n)||s(n+1)||(this.#s(),this.#e(n+1,t),this.version+=1)}#e(t,e){let n=t<this.count,s=(a,l)=>{n&&a.copyWithin(t+1,t,this.count),a[t]=l};s(this.t_s,e.t_s),s(this.share,e.competition.share??NaN);let r=new Set;for(let a of e.vehicles){r.add(a.sysid);let l=this.#t(a.sysid);Cx(a).forEach((c,h)=>s(l[ss[h]],c))}for(let[a,l]of this.columns)if(!r.has(a))for(let c of ss)s(l[c],NaN);let o=new Set;for(let a of e.traffic){o.add(a.callsign);let l=this.#n(a.callsign);a.p_ned.forEach((c,h)=>s(l[h],c))}for(let[a,l]of this.traffic)if(!o.has(a))for(let c of l)s(c,NaN);this.count+=1}#t(t){let e=this.columns.get(t);if(!e){e={};for(let n of ss)e[n]=new Float32Array(this.capacity).fill(NaN);this.columns.set(t,e)}return e}#n(t){let e=this.traffic.get(t);return e||(e=[0,1,2].map(()=>new Float32Array(this.capacity).fill(NaN)),this.traffic.set(t,e)),e}#s(){if(this.count<this.capacity)return;let t=Math.min(Tx,Math.max(256,Ex/(ss.length*Math.max(this.columns.size,1))));if(2*this.capacity<=t){this.capacity*=2,this.#i(n=>{let s=new n.constructor(this.capacity).fill(NaN);return s.set(n),s});return}let e=this.count>>1;this.#i(n=>{for(let s=0;s<e;s+=1)n[s]=n[2*s];return n}),this.count=e,this.spacing_s=Math.max(2*this.spacing_s,.9*(this.last_s-this.first_s)/Math.max(e,1))}#i(t){this.t_s=t(this.t_s),this.share=t(this.share);for(let e of this.columns.values())for(let n of ss)e[n]=t(e[n]);for(let e of this.traffic.values())e.forEach((n,s)=>e[s]=t(n))}at(t){let e=this.newest;if(!e||!this.count)return e;let n=Math.max(si(this.t_s,t,this.count),0),s=Math.min(n+1,this.count-1),r=this.t_s[s]-this.t_s[n],o=r>0?Math.min(Math.max((t-this.t_s[n])/r,0),1):0,a=(y,M=!1)=>{let x=y[n],R=y[s];return Number.isNaN(R)||Number.isNaN(x)?o<.5?x:R:(M&&(R=x+Math.atan2(Math.sin(R-x),Math.cos(R-x))),x+o*(R-x))},l=y=>Number.isNaN(y)?null:y,c=new Map((this.session?.vehicles??[]).map(y=>[y.sysid,y])),h=[];for(let[y,M]of this.columns){let x=c.get(y),R={};for(let b of ss)R[b]=l(a(M[b],wx.has(b)));let E=x?.capacity_j??null,v=R.battery===null?null:R.battery/100;h.push({sysid:y,role:x?.role??"",label:x?.label??String(y),autopilot:null,alive:!0,stage:"",mode:"",armed:!0,landed:!1,state:"",note:"",trouble:[],severity:0,condition:"",figure:"",urgency:0,...this.words.get(y)?.at(t),p_ned:R.n===null?null:[R.n,R.e,R.d],v_ned:[0,0,0],speed_m_s:R.speed??0,height_m:R.height,heading_rad:R.heading??0,roll_rad:R.roll??0,pitch_rad:R.pitch??0,aim_ned:null,margin_m:null,age_s:0,heard_s:null,lost:R.lost??0,lost_share:null,target_m:R.target,battery:v,remaining_j:v!==null&&E!==null?v*E:null,power_w:R.power,endurance_s:null,energy_source:"",v:R.v,tau:null})}h.sort((y,M)=>y.sysid-M.sysid);let{services:u,history:f,refuelled:d}=this.#r(t);for(let y of h){if(y.state)continue;let M=u.find(x=>x.receiver===y.sysid||x.tanker===y.sysid);y.state=M?M.tanker===y.sysid?"serves":M.phase==="transfer"?"served":"waits":""}let p=[];for(let[y,M]of this.traffic){let x=M.map(R=>a(R));x.some(Number.isNaN)||p.push({callsign:y,p_ned:x,v_ned:[0,0,0],age_s:0})}let _=Object.fromEntries(h.filter(y=>y.v!==null).map(y=>[y.sysid,y.v])),m=l(this.share[n]),g=Object.keys(_).sort((y,M)=>Number(_[M])-Number(_[y]));return{...e,t_s:t,vehicles:h,traffic:p,events:[],inspected:{},competition:{...e.competition,v:_,tau:{},share:m,leader:m===null||!g.length?null:Number(g[0]),runner_up:g.length>1?Number(g[1]):null},services:u,history:f,refuelled:d,goal:{...e.goal,pursue_held_s:null,broken:e.goal.broken.filter(y=>y.t_s===null||y.t_s<=t)}}}#r(t){let e=this.newest,n=e.history.filter(a=>a.end_s!==null&&a.end_s<=t),s=e.history.filter(a=>a.decided_at_s<=t&&(a.end_s===null||a.end_s>t)),r=e.services.filter(a=>a.decided_at_s<=t);return{services:[...s.map(a=>({receiver:a.receiver,tanker:a.tanker,base:a.base,by:a.by,energy_j:0,decided_at_s:a.decided_at_s,phase:a.start_s!==null&&a.start_s<=t?"transfer":"join",joined_at_s:a.joined_at_s!==null&&a.joined_at_s<=t?a.joined_at_s:null,rendezvous_ned:null,bids:{},why:""})),...r],history:n,refuelled:n.filter(a=>a.energy_j>0).length}}};var Ll=null;function Px(){if(Ll!==null)return Ll;let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info"),e=i&&t?String(i.getParameter(t.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),Ll=!i||/swiftshader|llvmpipe|softpipe|software/i.test(e),Ll}function Vr(i){return i.getContext("2d",{willReadFrequently:Px()})}var Wu={dead:"✕",silent:"⌀",failing:"▲",low:"◔",warned:"△",landed:"▼"},Im=i=>Wu[i.condition||(i.landed?"landed":"")]??"",Ix=3,Dl=2*Math.PI;function Pm(i,t,e,n,s){i.beginPath(),i.moveTo(t,e-.8*s*n),i.lineTo(t+n,e+.8*s*n),i.lineTo(t-n,e+.8*s*n),i.closePath()}function Nl(i,t,e,n,s){let{ink:r,paper:o,soft:a}=Ae(),[l,c]=[1.5*s,Math.max(.35*s,2)];i.setLineDash([]);let h=(f,d)=>{for(let[p,_]of[[o,d+Ix],[f,d]])i.strokeStyle=p,i.lineWidth=_,i.stroke()},u=(f,d)=>{h(d,.75*c),i.fillStyle=f,i.fill()};if(t.condition==="dead"||t.condition==="silent"){let f=.75*l;i.beginPath(),t.condition==="silent"?i.arc(e,n,l,0,Dl):(i.moveTo(e-f,n-f),i.lineTo(e+f,n+f)),i.moveTo(e-f,n+f),i.lineTo(e+f,n-f),h(Al(),c)}else if(t.condition==="failing"||t.condition==="warned"){let f=t.condition==="failing";Pm(i,e,n-2.3*s,(f?1.3:.9)*s,1),u(f?Al():o,f?Al():r)}else t.condition==="low"&&(i.beginPath(),i.arc(e,n,1.1*l,0,Dl),h(a,1),i.beginPath(),i.arc(e,n,1.1*l,-Dl/4,Dl*(Math.min(Math.max(t.battery??0,.02),1)-.25)),h(r,1.3*c));t.landed&&t.condition!=="dead"&&(Pm(i,e,n+2.2*s,.9*s,-1),u(r,r))}var Lx=1e5,Dx=300,Hr=i=>i?.plans??[];function Lm(i){return Hr(i).flatMap(e=>[...e.items.flatMap(n=>n.p_ned?[n.p_ned]:[]),...e.rally_ned,...e.home_ned?[e.home_ned]:[],...e.fence.flatMap(n=>n.outline_ne)]).filter(([e,n])=>Math.hypot(e,n)<Lx).map(([e,n])=>[e,n])}var Yo=i=>i.sysid===null?Ae().ink:pn(i.sysid),Dm=i=>i.items.filter(t=>t.flown&&t.p_ned);function Nm(i){return Hr(i).flatMap(t=>{let e=Dm(t).map(n=>n.p_ned);return[{points:t.home_ned&&e.length?[t.home_ned,...e]:e,colour:Yo(t)},...t.fence.map(n=>({points:n.outline_ne.map(([s,r])=>[s,r,0]),colour:n.inside?Ae().good:Ae().bad})),...t.rally_ned.map(([n,s,r])=>({points:[[n,s,0],[n,s,r]],colour:Ae().good}))]})}function Um(i,t,e,n,s){let{good:r,bad:o,paper:a,ink:l}=Ae();i.save(),i.font="600 10px system-ui, sans-serif",i.textAlign="center",i.textBaseline="middle";for(let c of Hr(t)){for(let p of c.fence)i.strokeStyle=i.fillStyle=p.inside?r:o,i.lineWidth=1.8,i.setLineDash([10,4]),i.beginPath(),p.outline_ne.forEach(([_,m],g)=>i[g?"lineTo":"moveTo"](n(m),s(_))),i.globalAlpha=p.inside?.04:.1,i.fill(),i.globalAlpha=.9,i.stroke();i.globalAlpha=1,i.strokeStyle=Yo(c),i.lineWidth=1.6,i.setLineDash([8,5]),i.beginPath();let h=Dm(c),[u]=h;c.home_ned&&u&&i.moveTo(n(c.home_ned[1]),s(c.home_ned[0])),h.forEach(({p_ned:[p,_]},m)=>i[m||c.home_ned?"lineTo":"moveTo"](n(_),s(p))),i.stroke(),i.setLineDash([]);let f=Fm(c,e);for(let p of c.items.slice(0,Dx)){if(!p.p_ned)continue;let[_,m]=[n(p.p_ned[1]),s(p.p_ned[0])];i.beginPath(),p.flown?i.arc(_,m,8,0,2*Math.PI):i.rect(_-7,m-7,14,14),i.fillStyle=p.number===f?Yo(c):a,i.fill(),i.stroke(),i.fillStyle=p.number===f?a:l,i.fillText(String(p.number),_,m)}let d=c.rally_ned.map(p=>["R",p,r]);c.home_ned&&d.push(["H",c.home_ned,Yo(c)]);for(let[p,[_,m],g]of d)i.beginPath(),[[0,-10],[10,0],[0,10],[-10,0]].forEach(([y,M],x)=>i[x?"lineTo":"moveTo"](n(m)+y,s(_)+M)),i.closePath(),i.fillStyle=a,i.fill(),i.strokeStyle=i.fillStyle=g,i.stroke(),i.fillText(p,n(m),s(_)),i.strokeStyle=Yo(c)}i.restore()}var Fm=(i,t)=>i.sysid===null?void 0:t.vehicles.find(e=>e.sysid===i.sysid)?.mission_item,Xu=(i,t,e)=>i?[`${i} ${i===1?t:e}`]:[];function Om(i,t,e){let n=Hr(t),s=n.map(a=>Fm(a,e)),r=JSON.stringify([n,s]);if(i.dataset.key===r)return;i.dataset.key=r;let o=new Set([...i.querySelectorAll("details[open]")].map(a=>a.getAttribute("data-source")));i.replaceChildren(...n.map((a,l)=>{let c=[...Xu(a.items.length,"item","items"),...Xu(a.fence.length,"fence area","fence areas"),...Xu(a.rally_ned.length,"rally point","rally points")],h=a.items.map(p=>F("tr",{class:p.number===s[l]?"chosen":"","aria-current":p.number===s[l]?"step":null},...[String(p.number),p.command,p.height_m===null?"":`${xe(p.height_m,1)} m`,p.above===null?"":`above ${p.above}`,p.p_ned?`${xe(p.p_ned[0],1)}, ${xe(p.p_ned[1],1)}`:"",p.about].map((_,m)=>F("td",{class:[1,3,5].includes(m)?"word":""},_)))),u=["","command","height","","north, east m","parameters"].map((p,_)=>F("th",{scope:"col",class:[1,3,5].includes(_)?"word":""},p)),f=h.length?[F("div",{class:"scroll",tabindex:0,role:"region","aria-label":`mission of ${a.source}`},F("table",{},F("thead",{},F("tr",{},...u)),F("tbody",{},...h)))]:[],d=F("details",{"data-source":a.source},F("summary",{},F("b",{},a.source),`: ${c.join(", ")||"nothing"}`),...f,...a.left_out.map(p=>F("p",{class:"warn small"},p)));return d.open=i.childElementCount?o.has(a.source):n.length===1,d}))}var Nx=.08,qu=40,Ux=150,Fx=[1,2,5];function Ul(i){let t=10**Math.floor(Math.log10(i));return t*Math.max(...Fx.filter(e=>e*t<=i*1.0001),1)}var Bm=new WeakMap;function $o(i){let t=Bm.get(i);if(t&&t.version===i.version&&t.session===i.session)return t.found;let e=Ox(i);return Bm.set(i,{version:i.version,session:i.session,found:e}),e}function Ox(i){let[t,e,n,s]=[1/0,-1/0,1/0,-1/0],r=(a,l)=>{Number.isNaN(a)||(t=Math.min(t,a),e=Math.max(e,a),n=Math.min(n,l),s=Math.max(s,l))};for(let a of i.columns.values()){let l=Math.max(Math.floor(i.count/100),1);for(let c=0;c<i.count;c+=l)r(a.n[c],a.e[c]);i.count&&r(a.n[i.count-1],a.e[i.count-1])}let o=i.worlds.length?i.worlds.map(a=>a.session):[i.session];for(let a of o.flatMap(l=>l?.obstacles??[])){r(a.centre_ned[0],a.centre_ned[1]);for(let[l,c]of a.outline_ne)r(l,c)}for(let a of i.session?.bases??[])r(a.p_ned[0],a.p_ned[1]);for(let a of o.flatMap(l=>l?.vehicles??[]))for(let[l,c]of a.path_ned)r(l,c);for(let[a,l]of Lm(i.session))r(a,l);return t>e?null:[[t,e],[n,s]]}var Wr=class{constructor(t,e,n=!1){this.canvas=t,this.still=n,this.view=null,this.follow=!1,this.places=[],this.dirty=!0,this.tiles=null;let s=new Map,r=0;t.addEventListener("pointerdown",a=>{t.setPointerCapture(a.pointerId),s.set(a.pointerId,{x:a.offsetX,y:a.offsetY}),r=0}),t.addEventListener("pointermove",a=>{let l=s.get(a.pointerId);if(!l)return;let c={x:a.offsetX,y:a.offsetY},h=[...s].find(([u])=>u!==a.pointerId)?.[1];if(h){let u=f=>Math.hypot(f.x-h.x,f.y-h.y);this.zoom(u(l)/Math.max(u(c),1),(c.x+h.x)/2,(c.y+h.y)/2)}else this.pan(c.x-l.x,c.y-l.y);r+=Math.hypot(c.x-l.x,c.y-l.y),s.set(a.pointerId,c)});let o=a=>{if(s.delete(a.pointerId),a.type!=="pointerup"||r>4)return;let l=this.places.map(c=>({...c,off:Math.hypot(c.x-a.offsetX,c.y-a.offsetY)})).sort((c,h)=>c.off-h.off)[0];e(l&&l.off<24?l.sysid:null,a)};t.addEventListener("pointerup",o),t.addEventListener("pointercancel",o),t.addEventListener("wheel",a=>{a.preventDefault(),this.zoom(Math.exp(a.deltaY*.0015),a.offsetX,a.offsetY)},{passive:!1}),t.addEventListener("keydown",a=>{let l={ArrowLeft:[40,0],ArrowRight:[-40,0],ArrowUp:[0,40],ArrowDown:[0,-40]}[a.key];if(l)this.pan(l[0],l[1]);else if(a.key==="+"||a.key==="-")this.zoom(a.key==="+"?.8:1.25);else if(a.key==="0")this.whole();else return;a.preventDefault(),a.stopPropagation()})}whole(){this.view=null,this.follow=!1,this.dirty=!0}pan(t,e){this.frame&&(this.view??={n:this.frame.n,e:this.frame.e,m:this.frame.m},this.follow=!1,this.view.e-=t/this.frame.perMetre,this.view.n+=e/this.frame.perMetre,this.dirty=!0)}zoom(t,e,n){let s=this.frame;if(!s)return;this.view??={n:s.n,e:s.e,m:s.m};let r=Math.min(Math.max(this.view.m*t,1),1e6),o=1-r/this.view.m;e!==void 0&&n!==void 0&&(this.view.e+=o*(e-s.width/2)/s.perMetre,this.view.n-=o*(n-s.height/2)/s.perMetre),this.view.m=r,this.dirty=!0}draw(t,e,{chosen:n,selected:s,paths:r,until_s:o,trail_s:a,shown:l=null}){let{width:c,height:h,scale:u}=bl(this.canvas),f=Vr(this.canvas),d=Ae();f.setTransform(u,0,0,u,0,0),f.fillStyle=d.paper,f.fillRect(0,0,c,h);let p=$o(t);if(!p)return;let _=this.follow&&n!==null?e.vehicles.find(N=>N.sysid===n)?.p_ned:null,[[m,g],[y,M]]=p,x=Math.max((g-m)/h,(M-y)/c,2/Math.min(c,h))*(1+2*Nx),R={n:(m+g)/2,e:(y+M)/2,m:x*Math.min(c,h)},E=this.view??R;_&&(this.view={n:_[0],e:_[1],m:Math.min(E.m,Math.max(R.m/3,12))},this.view.m<E.m&&E!==R&&(this.view.m=E.m));let{n:v,e:b,m:I}=this.view??R,T=Math.min(c,h)/I;this.frame={n:v,e:b,m:I,perMetre:T,width:c,height:h};let P=N=>c/2+(N-b)*T,O=N=>h/2-(N-v)*T,H=t.session?.origin;this.tiles&&H&&this.tiles.draw(f,H,this.frame,P,O,d),this.#t(f,P,O,T,c,h),this.#n(f,t.sessionAt(e.t_s),P,O,T),Um(f,t.session,e,P,O),r&&this.#s(f,t,P,O,o,a,n,l),this.#r(f,t,e,P,O),this.#a(f,t,e,P,O,T,n,s),this.#l(f,T,c,h),this.#e(f,t,c)}#e(t,e,n){let s=e.session?.wind;if(!s)return;let{ink:r}=Ae(),[o,a]=[n-20,64];t.save(),t.translate(o,a),t.rotate((s.from_deg+180)*Math.PI/180),t.strokeStyle=r,t.lineWidth=2,t.beginPath(),[[0,14],[0,-14]].forEach(([l,c],h)=>t[h?"lineTo":"moveTo"](l,c)),[[-5,-7],[0,-14],[5,-7]].forEach(([l,c],h)=>t[h?"lineTo":"moveTo"](l,c)),t.stroke(),t.restore()}#t(t,e,n,s,r,o){let a=this.frame,l=Ul(110/s)||1,{grid:c,soft:h}=Ae();t.lineWidth=1,t.strokeStyle=c,t.fillStyle=h,t.font="11px system-ui, sans-serif";let u=l<1?1:0,f=Math.ceil((a.e-r/2/s)/l)*l;t.beginPath();for(let p=f;e(p)<r;p+=l)t.moveTo(e(p),0),t.lineTo(e(p),o);let d=Math.ceil((a.n-o/2/s)/l)*l;for(let p=d;n(p)>0;p+=l)t.moveTo(0,n(p)),t.lineTo(r,n(p));t.stroke(),t.textAlign="center";for(let p=f;e(p)<r-30;p+=l)e(p)>40&&t.fillText(`E ${xe(p,u)}`,e(p),o-5);t.textAlign="left";for(let p=d;n(p)>24;p+=l)n(p)<o-24&&t.fillText(`N ${xe(p,u)}`,5,n(p)-3)}#n(t,e,n,s,r){let{solid:o,soft:a,crowd:l}=Ae();t.strokeStyle=o,t.fillStyle=l,t.lineWidth=1.2;for(let c of e?.obstacles??[])if(t.beginPath(),c.outline_ne.length)c.outline_ne.forEach(([h,u],f)=>t[f?"lineTo":"moveTo"](n(u),s(h))),t.fill(),t.stroke();else{let[h,u]=[n(c.centre_ned[1]),s(c.centre_ned[0])];t.moveTo(h-5,u-5),t.lineTo(h+5,u+5),t.moveTo(h+5,u-5),t.lineTo(h-5,u+5),t.stroke()}t.setLineDash([6,5]),t.strokeStyle=a;for(let c of e?.vehicles??[])t.beginPath(),c.path_ned.forEach(([h,u],f)=>t[f?"lineTo":"moveTo"](n(u),s(h))),t.stroke();t.setLineDash([]),t.font="12px system-ui, sans-serif",t.fillStyle=a;for(let c of e?.bases??[]){let[h,u]=[n(c.p_ned[1]),s(c.p_ned[0])];t.strokeStyle=a,t.lineWidth=2,t.strokeRect(h-6,u-6,12,12),t.fillText(`base ${c.name}`,h+9,u+4)}}#s(t,e,n,s,r,o,a,l){let c=e.columns.size>qu,h=si(e.t_s,r+1e-6,e.count)+1,u=si(e.t_s,r-o,e.count)+1,{soft:f}=Ae();t.lineJoin="round";let d=c?0:3;for(let[p,_]of e.columns){if(l&&!l.has(p)&&!c)continue;let m=p===a||(l?.has(p)??!1);t.globalAlpha=m||!c?a===null||m?.95:.45:.35,t.strokeStyle=pn(p),t.lineWidth=m?2.4:1.4,t.setLineDash(c?[]:Rl(p));let g=m||!c?0:u;this.#i(t,_.e,_.n,g,h,Math.max(Math.floor((h-g)/(m||!c?2e3:Ux)),1),n,s);let y=_.n.findIndex(M=>!Number.isNaN(M));!d||y<0||y>=h||(t.setLineDash([]),t.beginPath(),t.arc(n(_.e[y]),s(_.n[y]),d,0,2*Math.PI),t.stroke())}t.globalAlpha=.9,t.strokeStyle=f,t.setLineDash([2,4]);for(let[p,_]of e.traffic.values())this.#i(t,_,p,0,h,Math.max(Math.floor(h/500),1),n,s);t.setLineDash([]),t.globalAlpha=1}#i(t,e,n,s,r,o,a,l){t.beginPath();let c=!1;for(let h=s;h<r;h=h+o<r||h===r-1?h+o:r-1){if(Number.isNaN(n[h])){c=!1;continue}t[c?"lineTo":"moveTo"](a(e[h]),l(n[h])),c=!0}t.stroke()}#r(t,e,n,s,r){let o=new Map(n.vehicles.map(c=>[c.sysid,c.p_ned])),a=new Map((e.session?.bases??[]).map(c=>[c.name,c.p_ned])),{warn:l}=Ae();for(let c of n.services){let h=c.tanker!==null?o.get(c.tanker):a.get(c.base??""),u=o.get(c.receiver);!h||!u||(t.strokeStyle=l,t.lineWidth=c.phase==="transfer"?4:1.5,t.setLineDash(c.phase==="transfer"?[]:[4,4]),t.beginPath(),t.moveTo(s(h[1]),r(h[0])),t.lineTo(s(u[1]),r(u[0])),t.stroke())}t.setLineDash([])}#a(t,e,n,s,r,o,a,l){let c=Ae(),h=e.session?.ring_m??null,u=n.vehicles.length>qu,f=u?5:8;this.places=[];for(let _ of n.vehicles){if(!_.p_ned)continue;let[m,g]=[s(_.p_ned[1]),r(_.p_ned[0])];this.places.push({sysid:_.sysid,x:m,y:g}),_.role==="target"&&h!==null&&(t.strokeStyle=c.soft,t.lineWidth=1,t.setLineDash([3,4]),t.beginPath(),t.arc(m,g,h*o,0,2*Math.PI),t.stroke(),t.setLineDash([])),t.fillStyle=pn(_.sysid),t.strokeStyle=c.paper,t.lineWidth=1.5,t.save(),t.translate(m,g),t.rotate(_.heading_rad),t.beginPath(),_.role==="tanker"?t.rect(-f,-f,2*f,2*f):_.role==="target"?[[0,-1.3],[1.1,0],[0,1.3],[-1.1,0]].forEach(([y,M],x)=>t[x?"lineTo":"moveTo"](y*f,M*f)):[[0,-1.5],[1,1.1],[0,.6],[-1,1.1]].forEach(([y,M],x)=>t[x?"lineTo":"moveTo"](y*f,M*f)),t.closePath(),t.fill(),t.stroke(),t.restore(),Nl(t,_,m,g,f),l.has(_.sysid)&&(t.strokeStyle=c.ink,t.lineWidth=_.sysid===a?2.5:1.5,t.beginPath(),t.arc(m,g,f+8,0,2*Math.PI),t.stroke())}for(let _ of n.traffic){let[m,g]=[s(_.p_ned[1]),r(_.p_ned[0])];t.strokeStyle=c.warn,t.lineWidth=2,t.beginPath(),[[0,-8],[8,6],[-8,6],[0,-8]].forEach(([y,M],x)=>t[x?"lineTo":"moveTo"](m+y,g+M)),t.stroke(),this.#o(t,_.callsign,m,g,c.warn,[])}let d=this.places.map(_=>[_.x-f,_.y-f,_.x+f,_.y+f]),p=n.vehicles.filter(_=>!u||_.sysid===a||_.severity>1||_.role!=="pursuer");p.sort((_,m)=>+(m.sysid===a)-+(_.sysid===a)||m.severity-_.severity),t.font="600 12px system-ui, sans-serif",t.lineJoin="round";for(let _ of p.slice(0,qu))_.p_ned&&this.#o(t,String(_.sysid),s(_.p_ned[1]),r(_.p_ned[0]),c.ink,d)}#o(t,e,n,s,r,o){let a=t.measureText(e).width;for(let[l,c]of[[11,-6],[-11-a,-6],[-a/2,-14],[-a/2,22],[11,14],[-11-a,14]]){let h=[n+l,s+c-10,n+l+a,s+c+3];if(!o.some(u=>h[0]<u[2]&&h[2]>u[0]&&h[1]<u[3]&&h[3]>u[1])){o.push(h),t.lineWidth=3,t.strokeStyle=Ae().paper,t.strokeText(e,n+l,s+c),t.fillStyle=r,t.fillText(e,n+l,s+c);return}}}#l(t,e,n,s){let{ink:r,paper:o}=Ae(),a=Ul(Math.min(160,.4*n)/e),[l,c]=[n-14,s-24],h=l-a*e;for(let[u,f]of[[o,6],[r,2]])t.strokeStyle=u,t.lineWidth=f,t.beginPath(),t.moveTo(h,c-5),t.lineTo(h,c),t.lineTo(l,c),t.lineTo(l,c-5),t.stroke();t.fillStyle=r,t.textAlign="right",t.font="12px system-ui, sans-serif",t.fillText(`${a} m`,l,c-9),t.textAlign="center",t.font="700 13px system-ui, sans-serif",t.fillText("N",n-20,34),t.beginPath(),[[0,-14],[5,0],[0,-4],[-5,0]].forEach(([u,f],d)=>t[d?"lineTo":"moveTo"](n-20+u,20+f)),t.fill(),t.textAlign="left"}};var Bx=300,kx=.35;function Yu(i,t,e){i.dataset.key!==t&&(i.dataset.key=t,i.replaceChildren(...e()))}function zm(i,t,e){let{competition:n,services:s,history:r}=t,o=Object.keys(n.v).map(Number).sort((l,c)=>n.v[c]-n.v[l]||l-c).slice(0,12),a=JSON.stringify([o.map(l=>n.v[l].toFixed(2)),n.leader,n.share?.toFixed(2),s,r.length]);Yu(i,a,()=>{let l=[];if(o.length){let c=n.share===null?"":`, its share ${xe(n.share,2)} of the ${xe(n.threshold,2)} that win`;l.push(F("p",{},n.leader===null?"No vehicle leads yet.":F("b",{},`${e(n.leader)} leads`),c));for(let h of o){let u=F("span",{class:"bar"});u.style.width=`${Math.min(Math.max(100*n.v[h],0),100)}%`,u.style.background=pn(h),l.push(F("div",{class:"row"},F("span",{class:"row-name"},e(h)),F("div",{class:"track stack"},u),F("span",{class:"value"},xe(n.v[h],2))))}}else l.push(F("p",{class:"soft"},"No vehicle competes at this time."));for(let c of s){let h=c.tanker===null?`base ${c.base}`:e(c.tanker),u=c.phase==="transfer"?`${xe(c.energy_j/1e3,1)} kJ so far`:c.joined_at_s===null?"on the way":"in formation";l.push(F("div",{class:"service"},F("b",{},`${h} → ${e(c.receiver)}: ${c.phase}`),` ${u}`,F("p",{class:"small soft"},c.why||`decided at ${c.decided_at_s.toFixed(1)} s by ${c.by}`)))}if(r.length){let c=[...r].reverse().slice(0,12).map(u=>F("tr",{},...[e(u.receiver),u.tanker===null?`base ${u.base}`:e(u.tanker),u.by,xe(u.decided_at_s,1),xe(u.end_s,1),xe(u.energy_j/1e3,1),u.reason].map((f,d)=>F("td",{class:[0,1,2,6].includes(d)?"word":""},f)))),h=["receiver","by","decided by","decided s","done s","kJ","ended"];l.push(F("div",{class:"scroll",tabindex:0,role:"region","aria-label":"refuellings"},F("table",{},F("caption",{},`${r.length} refuellings have ended`),F("thead",{},F("tr",{},...h.map((u,f)=>F("th",{scope:"col",class:[0,1,2,6].includes(f)?"word":""},u)))),F("tbody",{},...c))))}return l})}function zx(i){let t=[],e={critical:0,warning:1,info:2};for(let n of i){let s=t[t.length-1];s&&s.head.sysid===n.sysid&&n.t_s-s.head.t_s<=kx&&e[n.level]>=2&&s.head.level==="info"?s.more.push(n):t.push({head:n,more:[]})}return t}var Fl=class{constructor(t,e){this.go=e,this.search=F("input",{type:"search",placeholder:"search events","aria-label":"search events",oninput:()=>this.again()}),this.level=F("select",{"aria-label":"level of events",onchange:()=>this.again()},F("option",{value:"info"},"all"),F("option",{value:"warning"},"warnings and errors")),this.list=F("ol",{class:"events"}),t.append(F("div",{class:"tools"},this.search,this.level),F("div",{class:"scroll",tabindex:0,role:"region","aria-label":"events"},this.list)),this.key=""}again(){this.key="",this.last&&this.show(this.last.events,this.last.until_s,this.last.label)}show(t,e,n){this.last={events:t,until_s:e,label:n};let s=t.length;for(;s>0&&t[s-1].t_s>e+.05;)s-=1;let r=`${s} ${t.length?t[Math.max(s-1,0)]?.text:""}`;if(r===this.key)return;this.key=r;let o=this.search.value.trim().toLowerCase(),a=this.level.value==="warning",l=[];for(let h=s-1;h>=0&&l.length<Bx;h-=1){let u=t[h];a&&u.level==="info"||o&&!`${km(u,n)} ${u.text}`.toLowerCase().includes(o)||l.push(u)}let c=zx(l.reverse()).reverse().map(({head:h,more:u})=>{let f=_=>[F("time",{},Ai(_.t_s)),F("span",{class:"who"},km(_,n)),F("span",{},_.text)],d=F("li",{class:h.level}),p=F("button",{type:"button",class:"link","aria-label":`go to ${Ai(h.t_s)}`,onclick:()=>this.go(h)},...f(h));return d.append(p),u.length&&d.append(F("details",{},F("summary",{},`and ${u.length} more`),...u.map(_=>F("p",{},...f(_))))),d});this.list.replaceChildren(...c.length?c:[F("li",{class:"soft"},"No events.")])}};function km(i,t){return i.sysid===0?"session":i.sysid===255?"traffic":t(i.sysid)}function $u(i,t,e){let n=t.vehicles.find(a=>a.sysid===e);if(!n){Yu(i,"none",()=>[F("p",{class:"soft"},"Choose a vehicle in the table or in the picture.")]);return}let s=a=>xe(a*180/Math.PI,0,"°"),r=[["state",[n.state,n.stage].filter(Boolean).join(", ")||"–"],["mode",n.mode||"–"],["autopilot",n.autopilot??"–"],["armed",n.armed?n.landed?"armed, landed":"armed, in the air":"disarmed"],["battery",n.battery===null?"–":`${xe(100*n.battery,1)} %${n.remaining_j===null?"":`, ${xe(n.remaining_j/1e3,1)} kJ`}`],...(n.batteries??[]).map(a=>[`battery ${a.id}${a.function?`, ${a.function}`:""}`,`${a.share===null?"–":`${xe(100*a.share,0)} %`}${a.voltage_v===null?"":`, ${xe(a.voltage_v,1)} V`}`]),["power",xe(n.power_w,0," W")],["lasts",n.endurance_s===null?"–":Ai(n.endurance_s)],["north, east",n.p_ned?`${xe(n.p_ned[0],1)}, ${xe(n.p_ned[1],1)} m`:"–"],["height",xe(n.height_m,1," m")],["speed",xe(n.speed_m_s,2," m/s")],["heading",s((n.heading_rad+2*Math.PI)%(2*Math.PI))],["roll, pitch",`${s(n.roll_rad)}, ${s(n.pitch_rad)}`],["to its target",xe(n.target_m,2," m")],["competition",n.v===null?"does not compete":`v ${xe(n.v,2)}${n.tau===null?"":`, τ ${xe(n.tau,2)}`}`],["link",`${n.lost} frames lost${n.lost_share===null?"":`, ${xe(100*n.lost_share,1)} % lately`}`],["position's age",xe(n.age_s,1," s")]],o=`${n.sysid} ${n.trouble.join("|")} ${n.note} ${r.map(([a])=>a).join("|")}`;Yu(i,o,()=>[F("h3",{},n.label),...n.trouble.map(a=>F("p",{class:n.severity>1?"bad":"warn"},a)),n.note?F("p",{class:"soft"},n.note):"",F("dl",{class:"facts"},...r.map(([a])=>F("div",{},F("dt",{},a),F("dd"))))]),i.querySelectorAll("dd").forEach((a,l)=>Ge(a,r[l][1]))}var Gs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Vs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},wg=0,Lf=1,Tg=2;var Ha=1,Eg=2,So=3,Hs=0,Yn=1,fi=2,pr=0,Mo=1,Df=2,Nf=3,Uf=4,Ag=5;var mr=100,Rg=101,Cg=102,Pg=103,Ig=104,Lg=200,Dg=201,Ng=202,Ug=203,Ff=204,Of=205,Fg=206,Og=207,Bg=208,kg=209,zg=210,Gg=211,Vg=212,Hg=213,Wg=214,uc=0,fc=1,dc=2,oo=3,pc=4,mc=5,gc=6,_c=7,Zc=0,Xg=1,qg=2,$i=0,Bf=1,kf=2,zf=3,Gf=4,Vf=5,Hf=6,Wf=7;var Xf=300,gr=301,bo=302,Jc=303,Kc=304,yc=1e3,Wi=1001,xc=1002,In=1003,Yg=1004;var Wa=1005;var qn=1006,jc=1007;var _s=1008;var Zn=1009,qf=1010,Yf=1011,wo=1012,Qc=1013,Li=1014,vi=1015,Di=1016,th=1017,eh=1018,_r=1020,$f=35902,Zf=35899,Jf=1021,Kf=1022,Ni=1023,fs=1026,ys=1027,nh=1028,ih=1029,Ws=1030,sh=1031;var rh=1033,Xa=33776,qa=33777,Ya=33778,$a=33779,oh=35840,ah=35841,lh=35842,ch=35843,hh=36196,uh=37492,fh=37496,dh=37488,ph=37489,Za=37490,mh=37491,gh=37808,_h=37809,yh=37810,xh=37811,vh=37812,Sh=37813,Mh=37814,bh=37815,wh=37816,Th=37817,Eh=37818,Ah=37819,Rh=37820,Ch=37821,Ph=36492,Ih=36494,Lh=36495,Dh=36283,Nh=36284,Ja=36285,Uh=36286;var la=2300,vc=2301,cc=2302,Sf=2303,Mf=2400,bf=2401,wf=2402;var $g=3200;var Fh=0,Zg=1,xs="",ai="srgb",ca="srgb-linear",ha="linear",Oe="srgb";var hc=7680;var Jg=519,Kg=512,jg=513,Qg=514,jf=515,t0=516,e0=517,Qf=518,td=519,n0=35044;var ed="300 es",xi=2e3,ao=2001;function Gx(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Vx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ua(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function i0(){let i=ua("canvas");return i.style.display="block",i}var Gm={},lo=null;function nd(...i){let t="THREE."+i.shift();lo?lo("log",t,...i):console.log(t,...i)}function s0(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function te(...i){i=s0(i);let t="THREE."+i.shift();if(lo)lo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ce(...i){i=s0(i);let t="THREE."+i.shift();if(lo)lo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function ia(...i){let t=i.join(" ");t in Gm||(Gm[t]=!0,te(...i))}function r0(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var o0={[uc]:uc,[dc]:gc,[pc]:pc,[oo]:mc,[fc]:fc,[gc]:dc,[_c]:_c,[mc]:oo},Ii=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Vm=1234567,sa=Math.PI/180,co=180/Math.PI;function yr(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Fn[i&255]+Fn[i>>8&255]+Fn[i>>16&255]+Fn[i>>24&255]+"-"+Fn[t&255]+Fn[t>>8&255]+"-"+Fn[t>>16&15|64]+Fn[t>>24&255]+"-"+Fn[e&63|128]+Fn[e>>8&255]+"-"+Fn[e>>16&255]+Fn[e>>24&255]+Fn[n&255]+Fn[n>>8&255]+Fn[n>>16&255]+Fn[n>>24&255]).toLowerCase()}function ve(i,t,e){return Math.max(t,Math.min(e,i))}function id(i,t){return(i%t+t)%t}function Hx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Wx(i,t,e){return i!==t?(e-i)/(t-i):0}function ra(i,t,e){return(1-e)*i+e*t}function Xx(i,t,e,n){return ra(i,t,1-Math.exp(-e*n))}function qx(i,t=1){return t-Math.abs(id(i,t*2)-t)}function Yx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function $x(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Zx(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Jx(i,t){return i+Math.random()*(t-i)}function Kx(i){return i*(.5-Math.random())}function jx(i){i!==void 0&&(Vm=i);let t=Vm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Qx(i){return i*sa}function tv(i){return i*co}function ev(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function nv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function sd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function iv(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),f=o((t-n)/2),d=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*d,a*h,a*c);break;default:te("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function rd(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function a0(i,t){if(t.constructor===Float32Array)return i;let e=rd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function l0(i,t){if(t.constructor===Float32Array)return i;let e=rd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Oh={DEG2RAD:sa,RAD2DEG:co,generateUUID:yr,clamp:ve,euclideanModulo:id,mapLinear:Hx,inverseLerp:Wx,lerp:ra,damp:Xx,pingpong:qx,smoothstep:Yx,smootherstep:$x,randInt:Zx,randFloat:Jx,randFloatSpread:Kx,seededRandom:jx,degToRad:Qx,radToDeg:tv,isPowerOfTwo:ev,ceilPowerOfTwo:nv,floorPowerOfTwo:sd,setQuaternionFromProperEuler:iv,normalize:l0,denormalize:a0},_t=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ln=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],p=r[o+2],_=r[o+3];if(u!==_||l!==f||c!==d||h!==p){let m=l*f+c*d+h*p+u*_;m<0&&(f=-f,d=-d,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let y=Math.acos(m),M=Math.sin(y);g=Math.sin(g*y)/M,a=Math.sin(a*y)/M,l=l*g+f*a,c=c*g+d*a,h=h*g+p*a,u=u*g+_*a}else{l=l*g+f*a,c=c*g+d*a,h=h*g+p*a,u=u*g+_*a;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*d-c*f,t[e+1]=l*p+h*f+c*u-a*d,t[e+2]=c*p+h*d+a*f-l*u,t[e+3]=h*p-a*u-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"YXZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"ZXY":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"ZYX":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"YZX":this._x=f*h*u+c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u-f*d*p;break;case"XZY":this._x=f*h*u-c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u+f*d*p;break;default:te("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ve(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Hm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Hm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Zu.copy(this).projectOnVector(t),this.sub(Zu)}reflect(t){return this.sub(Zu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Zu=new z,Hm=new Ln,de=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],p=n[8],_=s[0],m=s[3],g=s[6],y=s[1],M=s[4],x=s[7],R=s[2],E=s[5],v=s[8];return r[0]=o*_+a*y+l*R,r[3]=o*m+a*M+l*E,r[6]=o*g+a*x+l*v,r[1]=c*_+h*y+u*R,r[4]=c*m+h*M+u*E,r[7]=c*g+h*x+u*v,r[2]=f*_+d*y+p*R,r[5]=f*m+d*M+p*E,r[8]=f*g+d*x+p*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,p=e*u+n*f+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=u*_,t[1]=(s*c-h*n)*_,t[2]=(a*n-s*o)*_,t[3]=f*_,t[4]=(h*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=d*_,t[7]=(n*l-c*e)*_,t[8]=(o*e-n*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ia("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ju.makeScale(t,e)),this}rotate(t){return ia("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ju.makeRotation(-t)),this}translate(t,e){return ia("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ju.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Ju=new de,Wm=new de().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Xm=new de().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function sv(){let i={enabled:!0,workingColorSpace:ca,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Oe&&(s.r=us(s.r),s.g=us(s.g),s.b=us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Oe&&(s.r=ro(s.r),s.g=ro(s.g),s.b=ro(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===xs?ha:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ca]:{primaries:t,whitePoint:n,transfer:ha,toXYZ:Wm,fromXYZ:Xm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ai},outputColorSpaceConfig:{drawingBufferColorSpace:ai}},[ai]:{primaries:t,whitePoint:n,transfer:Oe,toXYZ:Wm,fromXYZ:Xm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ai}}}),i}var Re=sv();function us(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ro(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Xr,Sc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Xr===void 0&&(Xr=ua("canvas")),Xr.width=t.width,Xr.height=t.height;let s=Xr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Xr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ua("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=us(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(us(e[n]/255)*255):e[n]=us(e[n]);return{data:e,width:t.width,height:t.height}}else return te("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},rv=0,ho=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:rv++}),this.uuid=yr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ku(s[o].image)):r.push(Ku(s[o]))}else r=Ku(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Ku(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Sc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(te("Texture: Unable to serialize Texture."),{})}var ov=0,ju=new z,$n=class i extends Ii{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Wi,s=Wi,r=qn,o=_s,a=Ni,l=Zn,c=i.DEFAULT_ANISOTROPY,h=xs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ov++}),this.uuid=yr(),this.name="",this.source=new ho(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new _t(0,0),this.repeat=new _t(1,1),this.center=new _t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new de,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ju).x}get height(){return this.source.getSize(ju).y}get depth(){return this.source.getSize(ju).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){te(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Xf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case yc:t.x=t.x-Math.floor(t.x);break;case Wi:t.x=t.x<0?0:1;break;case xc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case yc:t.y=t.y-Math.floor(t.y);break;case Wi:t.y=t.y<0?0:1;break;case xc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};$n.DEFAULT_IMAGE=null;$n.DEFAULT_MAPPING=Xf;$n.DEFAULT_ANISOTROPY=1;var Qe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],p=l[9],_=l[2],m=l[6],g=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+_)<.1&&Math.abs(p+m)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(c+1)/2,x=(d+1)/2,R=(g+1)/2,E=(h+f)/4,v=(u+_)/4,b=(p+m)/4;return M>x&&M>R?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=E/n,r=v/n):x>R?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=E/s,r=b/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=v/r,s=b/r),this.set(n,s,r,e),this}let y=Math.sqrt((m-p)*(m-p)+(u-_)*(u-_)+(f-h)*(f-h));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(u-_)/y,this.z=(f-h)/y,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this.w=ve(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this.w=ve(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Mc=class extends Ii{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Qe(0,0,t,e),this.scissorTest=!1,this.viewport=new Qe(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new $n({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:qn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ho(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ci=class extends Mc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},fa=class extends $n{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var bc=class extends $n{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var De=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,f,d,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,d,p,_,m)}set(t,e,n,s,r,o,a,l,c,h,u,f,d,p,_,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=f,g[3]=d,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/qr.setFromMatrixColumn(t,0).length(),r=1/qr.setFromMatrixColumn(t,1).length(),o=1/qr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,p=a*h,_=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=d+p*c,e[5]=f-_*c,e[9]=-a*l,e[2]=_-f*c,e[6]=p+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,d=l*u,p=c*h,_=c*u;e[0]=f+_*a,e[4]=p*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-p,e[6]=_+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,d=l*u,p=c*h,_=c*u;e[0]=f-_*a,e[4]=-o*u,e[8]=p+d*a,e[1]=d+p*a,e[5]=o*h,e[9]=_-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,d=o*u,p=a*h,_=a*u;e[0]=l*h,e[4]=p*c-d,e[8]=f*c+_,e[1]=l*u,e[5]=_*c+f,e[9]=d*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,p=a*l,_=a*c;e[0]=l*h,e[4]=_-f*u,e[8]=p*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*u+p,e[10]=f-_*u}else if(t.order==="XZY"){let f=o*l,d=o*c,p=a*l,_=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+_,e[5]=o*h,e[9]=d*u-p,e[2]=p*u-d,e[6]=a*h,e[10]=_*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(av,t,lv)}lookAt(t,e,n){let s=this.elements;return ri.subVectors(t,e),ri.lengthSq()===0&&(ri.z=1),ri.normalize(),Ps.crossVectors(n,ri),Ps.lengthSq()===0&&(Math.abs(n.z)===1?ri.x+=1e-4:ri.z+=1e-4,ri.normalize(),Ps.crossVectors(n,ri)),Ps.normalize(),Ol.crossVectors(ri,Ps),s[0]=Ps.x,s[4]=Ol.x,s[8]=ri.x,s[1]=Ps.y,s[5]=Ol.y,s[9]=ri.y,s[2]=Ps.z,s[6]=Ol.z,s[10]=ri.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],p=n[2],_=n[6],m=n[10],g=n[14],y=n[3],M=n[7],x=n[11],R=n[15],E=s[0],v=s[4],b=s[8],I=s[12],T=s[1],P=s[5],O=s[9],H=s[13],N=s[2],V=s[6],Y=s[10],W=s[14],ct=s[3],J=s[7],Q=s[11],et=s[15];return r[0]=o*E+a*T+l*N+c*ct,r[4]=o*v+a*P+l*V+c*J,r[8]=o*b+a*O+l*Y+c*Q,r[12]=o*I+a*H+l*W+c*et,r[1]=h*E+u*T+f*N+d*ct,r[5]=h*v+u*P+f*V+d*J,r[9]=h*b+u*O+f*Y+d*Q,r[13]=h*I+u*H+f*W+d*et,r[2]=p*E+_*T+m*N+g*ct,r[6]=p*v+_*P+m*V+g*J,r[10]=p*b+_*O+m*Y+g*Q,r[14]=p*I+_*H+m*W+g*et,r[3]=y*E+M*T+x*N+R*ct,r[7]=y*v+M*P+x*V+R*J,r[11]=y*b+M*O+x*Y+R*Q,r[15]=y*I+M*H+x*W+R*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],d=t[14],p=t[3],_=t[7],m=t[11],g=t[15],y=l*d-c*f,M=a*d-c*u,x=a*f-l*u,R=o*d-c*h,E=o*f-l*h,v=o*u-a*h;return e*(_*y-m*M+g*x)-n*(p*y-m*R+g*E)+s*(p*M-_*R+g*v)-r*(p*x-_*E+m*v)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],d=t[11],p=t[12],_=t[13],m=t[14],g=t[15],y=e*a-n*o,M=e*l-s*o,x=e*c-r*o,R=n*l-s*a,E=n*c-r*a,v=s*c-r*l,b=h*_-u*p,I=h*m-f*p,T=h*g-d*p,P=u*m-f*_,O=u*g-d*_,H=f*g-d*m,N=y*H-M*O+x*P+R*T-E*I+v*b;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return t[0]=(a*H-l*O+c*P)*V,t[1]=(s*O-n*H-r*P)*V,t[2]=(_*v-m*E+g*R)*V,t[3]=(f*E-u*v-d*R)*V,t[4]=(l*T-o*H-c*I)*V,t[5]=(e*H-s*T+r*I)*V,t[6]=(m*x-p*v-g*M)*V,t[7]=(h*v-f*x+d*M)*V,t[8]=(o*O-a*T+c*b)*V,t[9]=(n*T-e*O-r*b)*V,t[10]=(p*E-_*x+g*y)*V,t[11]=(u*x-h*E-d*y)*V,t[12]=(a*I-o*P-l*b)*V,t[13]=(e*P-n*I+s*b)*V,t[14]=(_*M-p*R-m*y)*V,t[15]=(h*R-u*M+f*y)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,p=r*u,_=o*h,m=o*u,g=a*u,y=l*c,M=l*h,x=l*u,R=n.x,E=n.y,v=n.z;return s[0]=(1-(_+g))*R,s[1]=(d+x)*R,s[2]=(p-M)*R,s[3]=0,s[4]=(d-x)*E,s[5]=(1-(f+g))*E,s[6]=(m+y)*E,s[7]=0,s[8]=(p+M)*v,s[9]=(m-y)*v,s[10]=(1-(f+_))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=qr.set(s[0],s[1],s[2]).length(),a=qr.set(s[4],s[5],s[6]).length(),l=qr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ri.copy(this);let c=1/o,h=1/a,u=1/l;return Ri.elements[0]*=c,Ri.elements[1]*=c,Ri.elements[2]*=c,Ri.elements[4]*=h,Ri.elements[5]*=h,Ri.elements[6]*=h,Ri.elements[8]*=u,Ri.elements[9]*=u,Ri.elements[10]*=u,e.setFromRotationMatrix(Ri),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=xi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===xi)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ao)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=xi,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===xi)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===ao)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},qr=new z,Ri=new De,av=new z(0,0,0),lv=new z(1,1,1),Ps=new z,Ol=new z,ri=new z,qm=new De,Ym=new Ln,ds=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ve(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ve(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ve(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ve(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:te("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return qm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(qm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Ym.setFromEuler(this),this.setFromQuaternion(Ym,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ds.DEFAULT_ORDER="XYZ";var da=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},cv=0,$m=new z,Yr=new Ln,rs=new De,Bl=new z,Zo=new z,hv=new z,uv=new Ln,Zm=new z(1,0,0),Jm=new z(0,1,0),Km=new z(0,0,1),jm={type:"added"},fv={type:"removed"},$r={type:"childadded",child:null},Qu={type:"childremoved",child:null},Nn=class i extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:cv++}),this.uuid=yr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new z,e=new ds,n=new Ln,s=new z(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new De},normalMatrix:{value:new de}}),this.matrix=new De,this.matrixWorld=new De,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new da,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Yr.setFromAxisAngle(t,e),this.quaternion.multiply(Yr),this}rotateOnWorldAxis(t,e){return Yr.setFromAxisAngle(t,e),this.quaternion.premultiply(Yr),this}rotateX(t){return this.rotateOnAxis(Zm,t)}rotateY(t){return this.rotateOnAxis(Jm,t)}rotateZ(t){return this.rotateOnAxis(Km,t)}translateOnAxis(t,e){return $m.copy(t).applyQuaternion(this.quaternion),this.position.add($m.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Zm,t)}translateY(t){return this.translateOnAxis(Jm,t)}translateZ(t){return this.translateOnAxis(Km,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(rs.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Bl.copy(t):Bl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Zo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?rs.lookAt(Zo,Bl,this.up):rs.lookAt(Bl,Zo,this.up),this.quaternion.setFromRotationMatrix(rs),s&&(rs.extractRotation(s.matrixWorld),Yr.setFromRotationMatrix(rs),this.quaternion.premultiply(Yr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ce("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(jm),$r.child=t,this.dispatchEvent($r),$r.child=null):ce("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(fv),Qu.child=t,this.dispatchEvent(Qu),Qu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),rs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),rs.multiply(t.parent.matrixWorld)),t.applyMatrix4(rs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(jm),$r.child=t,this.dispatchEvent($r),$r.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zo,t,hv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zo,uv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new z(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var hs=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},dv={type:"move"},uo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new hs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new hs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new hs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,n),g=this._getHandJoint(c,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,p=.005;c.inputState.pinching&&f>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(dv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new hs;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},c0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Is={h:0,s:0,l:0},kl={h:0,s:0,l:0};function tf(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var oe=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ai){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Re.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Re.workingColorSpace){return this.r=t,this.g=e,this.b=n,Re.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Re.workingColorSpace){if(t=id(t,1),e=ve(e,0,1),n=ve(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=tf(o,r,t+1/3),this.g=tf(o,r,t),this.b=tf(o,r,t-1/3)}return Re.colorSpaceToWorking(this,s),this}setStyle(t,e=ai){function n(r){r!==void 0&&parseFloat(r)<1&&te("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:te("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);te("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ai){let n=c0[t.toLowerCase()];return n!==void 0?this.setHex(n,e):te("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=us(t.r),this.g=us(t.g),this.b=us(t.b),this}copyLinearToSRGB(t){return this.r=ro(t.r),this.g=ro(t.g),this.b=ro(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ai){return Re.workingToColorSpace(On.copy(this),t),Math.round(ve(On.r*255,0,255))*65536+Math.round(ve(On.g*255,0,255))*256+Math.round(ve(On.b*255,0,255))}getHexString(t=ai){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Re.workingColorSpace){Re.workingToColorSpace(On.copy(this),e);let n=On.r,s=On.g,r=On.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Re.workingColorSpace){return Re.workingToColorSpace(On.copy(this),e),t.r=On.r,t.g=On.g,t.b=On.b,t}getStyle(t=ai){Re.workingToColorSpace(On.copy(this),t);let e=On.r,n=On.g,s=On.b;return t!==ai?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Is),this.setHSL(Is.h+t,Is.s+e,Is.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Is),t.getHSL(kl);let n=ra(Is.h,kl.h,e),s=ra(Is.s,kl.s,e),r=ra(Is.l,kl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},On=new oe;oe.NAMES=c0;var pa=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ds,this.environmentIntensity=1,this.environmentRotation=new ds,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ci=new z,os=new z,ef=new z,as=new z,Zr=new z,Jr=new z,Qm=new z,nf=new z,sf=new z,rf=new z,of=new Qe,af=new Qe,lf=new Qe,Us=class i{constructor(t=new z,e=new z,n=new z){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ci.subVectors(t,e),s.cross(Ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ci.subVectors(s,e),os.subVectors(n,e),ef.subVectors(t,e);let o=Ci.dot(Ci),a=Ci.dot(os),l=Ci.dot(ef),c=os.dot(os),h=os.dot(ef),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,p=(o*h-a*l)*f;return r.set(1-d-p,p,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,as)===null?!1:as.x>=0&&as.y>=0&&as.x+as.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,as)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,as.x),l.addScaledVector(o,as.y),l.addScaledVector(a,as.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return of.setScalar(0),af.setScalar(0),lf.setScalar(0),of.fromBufferAttribute(t,e),af.fromBufferAttribute(t,n),lf.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(of,r.x),o.addScaledVector(af,r.y),o.addScaledVector(lf,r.z),o}static isFrontFacing(t,e,n,s){return Ci.subVectors(n,e),os.subVectors(t,e),Ci.cross(os).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ci.subVectors(this.c,this.b),os.subVectors(this.a,this.b),Ci.cross(os).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Zr.subVectors(s,n),Jr.subVectors(r,n),nf.subVectors(t,n);let l=Zr.dot(nf),c=Jr.dot(nf);if(l<=0&&c<=0)return e.copy(n);sf.subVectors(t,s);let h=Zr.dot(sf),u=Jr.dot(sf);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Zr,o);rf.subVectors(t,r);let d=Zr.dot(rf),p=Jr.dot(rf);if(p>=0&&d<=p)return e.copy(r);let _=d*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(Jr,a);let m=h*p-d*u;if(m<=0&&u-h>=0&&d-p>=0)return Qm.subVectors(r,s),a=(u-h)/(u-h+(d-p)),e.copy(s).addScaledVector(Qm,a);let g=1/(m+_+f);return o=_*g,a=f*g,e.copy(n).addScaledVector(Zr,o).addScaledVector(Jr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Xi=class{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Pi):Pi.fromBufferAttribute(r,o),Pi.applyMatrix4(t.matrixWorld),this.expandByPoint(Pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),zl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),zl.copy(n.boundingBox)),zl.applyMatrix4(t.matrixWorld),this.union(zl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pi),Pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Jo),Gl.subVectors(this.max,Jo),Kr.subVectors(t.a,Jo),jr.subVectors(t.b,Jo),Qr.subVectors(t.c,Jo),Ls.subVectors(jr,Kr),Ds.subVectors(Qr,jr),ir.subVectors(Kr,Qr);let e=[0,-Ls.z,Ls.y,0,-Ds.z,Ds.y,0,-ir.z,ir.y,Ls.z,0,-Ls.x,Ds.z,0,-Ds.x,ir.z,0,-ir.x,-Ls.y,Ls.x,0,-Ds.y,Ds.x,0,-ir.y,ir.x,0];return!cf(e,Kr,jr,Qr,Gl)||(e=[1,0,0,0,1,0,0,0,1],!cf(e,Kr,jr,Qr,Gl))?!1:(Vl.crossVectors(Ls,Ds),e=[Vl.x,Vl.y,Vl.z],cf(e,Kr,jr,Qr,Gl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ls),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ls=[new z,new z,new z,new z,new z,new z,new z,new z],Pi=new z,zl=new Xi,Kr=new z,jr=new z,Qr=new z,Ls=new z,Ds=new z,ir=new z,Jo=new z,Gl=new z,Vl=new z,sr=new z;function cf(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){sr.fromArray(i,r);let a=s.x*Math.abs(sr.x)+s.y*Math.abs(sr.y)+s.z*Math.abs(sr.z),l=t.dot(sr),c=e.dot(sr),h=n.dot(sr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var mn=new z,Hl=new _t,pv=0,Pn=class extends Ii{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:pv++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=n0,this.updateRanges=[],this.gpuType=vi,this.version=0,this._normalizationScale=t!==void 0?rd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Hl.fromBufferAttribute(this,e),Hl.applyMatrix3(t),this.setXY(e,Hl.x,Hl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):a0(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):l0(t,this.array)}};var ma=class extends Pn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ga=class extends Pn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ve=class extends Pn{constructor(t,e,n){super(new Float32Array(t),e,n)}},mv=new Xi,Ko=new z,hf=new z,ps=class{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):mv.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ko.subVectors(t,this.center);let e=Ko.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Ko,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(hf.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ko.copy(t.center).add(hf)),this.expandByPoint(Ko.copy(t.center).sub(hf))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},gv=0,yi=new De,uf=new Nn,to=new z,oi=new Xi,jo=new Xi,Cn=new z,gn=class i extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:gv++}),this.uuid=yr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Gx(t)?ga:ma)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new de().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return yi.makeRotationFromQuaternion(t),this.applyMatrix4(yi),this}rotateX(t){return yi.makeRotationX(t),this.applyMatrix4(yi),this}rotateY(t){return yi.makeRotationY(t),this.applyMatrix4(yi),this}rotateZ(t){return yi.makeRotationZ(t),this.applyMatrix4(yi),this}translate(t,e,n){return yi.makeTranslation(t,e,n),this.applyMatrix4(yi),this}scale(t,e,n){return yi.makeScale(t,e,n),this.applyMatrix4(yi),this}lookAt(t){return uf.lookAt(t),uf.updateMatrix(),this.applyMatrix4(uf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(to).negate(),this.translate(to.x,to.y,to.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ve(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&te("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Xi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];oi.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,oi.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,oi.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(oi.min),this.boundingBox.expandByPoint(oi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ce('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ps);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){let n=this.boundingSphere.center;if(oi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];jo.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(oi.min,jo.min),oi.expandByPoint(Cn),Cn.addVectors(oi.max,jo.max),oi.expandByPoint(Cn)):(oi.expandByPoint(jo.min),oi.expandByPoint(jo.max))}oi.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Cn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Cn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Cn.fromBufferAttribute(a,c),l&&(to.fromBufferAttribute(t,c),Cn.add(to)),s=Math.max(s,n.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ce('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ce("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let I=0;I<n.count;I++)a[I]=new z,l[I]=new z;let h=new z,u=new z,f=new z,d=new _t,p=new _t,_=new _t,m=new z,g=new z;function y(I,T,P){c[I]=c[T]=c[P]=1,h.fromBufferAttribute(n,I),u.fromBufferAttribute(n,T),f.fromBufferAttribute(n,P),d.fromBufferAttribute(r,I),p.fromBufferAttribute(r,T),_.fromBufferAttribute(r,P),u.sub(h),f.sub(h),p.sub(d),_.sub(d);let O=1/(p.x*_.y-_.x*p.y);isFinite(O)&&(m.copy(u).multiplyScalar(_.y).addScaledVector(f,-p.y).multiplyScalar(O),g.copy(f).multiplyScalar(p.x).addScaledVector(u,-_.x).multiplyScalar(O),a[I].add(m),a[T].add(m),a[P].add(m),l[I].add(g),l[T].add(g),l[P].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let I=0,T=M.length;I<T;++I){let P=M[I],O=P.start,H=P.count;for(let N=O,V=O+H;N<V;N+=3)y(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let x=new z,R=new z,E=new z,v=new z;function b(I){E.fromBufferAttribute(s,I),v.copy(E);let T=a[I];x.copy(T),x.sub(E.multiplyScalar(E.dot(T))).normalize(),R.crossVectors(v,T);let O=R.dot(l[I])<0?-1:1;o.setXYZW(I,x.x,x.y,x.z,O)}for(let I=0,T=n.count;I<T;++I)c[I]&&b(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Pn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,h=new z,u=new z;if(t)for(let f=0,d=t.count;f<d;f+=3){let p=t.getX(f+0),_=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Cn.fromBufferAttribute(t,e),Cn.normalize(),t.setXYZ(e,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,p=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?d=l[_]*a.data.stride+a.offset:d=l[_]*h;for(let g=0;g<h;g++)f[p++]=c[d++]}return new Pn(f,h,u)}if(this.index===null)return te("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var ff=new z,_v=new z,yv=new de,li=class{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=ff.subVectors(n,e).cross(_v.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(ff),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||yv.getNormalMatrix(t),s=this.coplanarPoint(ff).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},xv=0,ms=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:xv++}),this.uuid=yr(),this.name="",this.type="Material",this.blending=Mo,this.side=Hs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ff,this.blendDst=Of,this.blendEquation=mr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new oe(0,0,0),this.blendAlpha=0,this.depthFunc=oo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Jg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hc,this.stencilZFail=hc,this.stencilZPass=hc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){te(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new oe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new li().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new _t().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new _t().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var cs=new z,df=new z,Wl=new z,Xl=new z,lr=class{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,cs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=cs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(cs.copy(this.origin).addScaledVector(this.direction,e),cs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){df.copy(t).add(e).multiplyScalar(.5),Wl.copy(e).sub(t).normalize(),Xl.copy(this.origin).sub(df);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Wl),a=Xl.dot(this.direction),l=-Xl.dot(Wl),c=Xl.lengthSq(),h=Math.abs(1-o*o),u,f,d,p;if(h>0)if(u=o*l-a,f=o*a-l,p=r*h,u>=0)if(f>=-p)if(f<=p){let _=1/h;u*=_,f*=_,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-p?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=p?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(df).addScaledVector(Wl,f),d}intersectSphere(t,e){if(t.radius<0)return null;cs.subVectors(t.center,this.origin);let n=cs.dot(this.direction),s=cs.dot(cs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,cs)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,d=t.z-o.z,p=e.x-o.x,_=e.y-o.y,m=e.z-o.z,g=n.x-o.x,y=n.y-o.y,M=n.z-o.z,x=Math.abs(l),R=Math.abs(c),E=Math.abs(h),v,b,I,T,P,O,H,N,V,Y,W,ct;if(x>=R&&x>=E?(I=l,O=u,V=p,ct=g,l>=0?(v=c,b=h,T=f,P=d,H=_,N=m,Y=y,W=M):(v=h,b=c,T=d,P=f,H=m,N=_,Y=M,W=y)):R>=E?(I=c,O=f,V=_,ct=y,c>=0?(v=h,b=l,T=d,P=u,H=m,N=p,Y=M,W=g):(v=l,b=h,T=u,P=d,H=p,N=m,Y=g,W=M)):(I=h,O=d,V=m,ct=M,h>=0?(v=l,b=c,T=u,P=f,H=p,N=_,Y=g,W=y):(v=c,b=l,T=f,P=u,H=_,N=p,Y=y,W=g)),I===0)return null;let J=v/I,Q=b/I,et=1/I,dt=T-J*O,ht=P-Q*O,tt=H-J*V,gt=N-Q*V,xt=Y-J*ct,Lt=W-Q*ct,wt=xt*gt-Lt*tt,Vt=dt*Lt-ht*xt,ie=tt*ht-gt*dt;if(s){if(wt<0||Vt<0||ie<0)return null}else if((wt<0||Vt<0||ie<0)&&(wt>0||Vt>0||ie>0))return null;let Jt=wt+Vt+ie;if(Jt===0)return null;let se=et*(wt*O+Vt*V+ie*ct);return(Jt>0?se<0:se>0)?null:this.at(se/Jt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},_a=class extends ms{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ds,this.combine=Zc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},tg=new De,rr=new lr,ql=new ps,eg=new z,Yl=new z,$l=new z,Zl=new z,pf=new z,Jl=new z,ng=new z,Kl=new z,Sn=class extends Nn{constructor(t=new gn,e=new _a){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Jl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(pf.fromBufferAttribute(u,t),o?Jl.addScaledVector(pf,h):Jl.addScaledVector(pf.sub(e),h))}e.add(Jl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ql.copy(n.boundingSphere),ql.applyMatrix4(r),rr.copy(t.ray).recast(t.near),!(ql.containsPoint(rr.origin)===!1&&(rr.intersectSphere(ql,eg)===null||rr.origin.distanceToSquared(eg)>(t.far-t.near)**2))&&(tg.copy(r).invert(),rr.copy(t.ray).applyMatrix4(tg),!(n.boundingBox!==null&&rr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,rr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=f.length;p<_;p++){let m=f[p],g=o[m.materialIndex],y=Math.max(m.start,d.start),M=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,R=M;x<R;x+=3){let E=a.getX(x),v=a.getX(x+1),b=a.getX(x+2);s=jl(this,g,t,n,c,h,u,E,v,b),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let m=p,g=_;m<g;m+=3){let y=a.getX(m),M=a.getX(m+1),x=a.getX(m+2);s=jl(this,o,t,n,c,h,u,y,M,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=f.length;p<_;p++){let m=f[p],g=o[m.materialIndex],y=Math.max(m.start,d.start),M=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,R=M;x<R;x+=3){let E=x,v=x+1,b=x+2;s=jl(this,g,t,n,c,h,u,E,v,b),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,d.start),_=Math.min(l.count,d.start+d.count);for(let m=p,g=_;m<g;m+=3){let y=m,M=m+1,x=m+2;s=jl(this,o,t,n,c,h,u,y,M,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function vv(i,t,e,n,s,r,o,a){let l;if(t.side===Yn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Hs,a),l===null)return null;Kl.copy(a),Kl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Kl);return c<e.near||c>e.far?null:{distance:c,point:Kl.clone(),object:i}}function jl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Yl),i.getVertexPosition(l,$l),i.getVertexPosition(c,Zl);let h=vv(i,t,e,n,Yl,$l,Zl,ng);if(h){let u=new z;Us.getBarycoord(ng,Yl,$l,Zl,u),s&&(h.uv=Us.getInterpolatedAttribute(s,a,l,c,u,new _t)),r&&(h.uv1=Us.getInterpolatedAttribute(r,a,l,c,u,new _t)),o&&(h.normal=Us.getInterpolatedAttribute(o,a,l,c,u,new z),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new z,materialIndex:0};Us.getNormal(Yl,$l,Zl,f.normal),h.face=f,h.barycoord=u}return h}var ya=class extends $n{constructor(t=null,e=1,n=1,s,r,o,a,l,c=In,h=In,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var fo=class extends Pn{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},eo=new De,ig=new De,Ql=[],sg=new Xi,Sv=new De,Qo=new Sn,ta=new ps,xa=class extends Sn{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new fo(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Sv)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Xi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,eo),sg.copy(t.boundingBox).applyMatrix4(eo),this.boundingBox.union(sg)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ps),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,eo),ta.copy(t.boundingSphere).applyMatrix4(eo),this.boundingSphere.union(ta)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(Qo.geometry=this.geometry,Qo.material=this.material,Qo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ta.copy(this.boundingSphere),ta.applyMatrix4(n),t.ray.intersectsSphere(ta)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,eo),ig.multiplyMatrices(n,eo),Qo.matrixWorld=ig,Qo.raycast(t,Ql);for(let o=0,a=Ql.length;o<a;o++){let l=Ql[o];l.instanceId=r,l.object=this,e.push(l)}Ql.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new fo(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new ya(new Float32Array(s*this.count),s,this.count,nh,vi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},or=new ps,Mv=new _t(.5,.5),tc=new z,Fs=class{constructor(t=new li,e=new li,n=new li,s=new li,r=new li,o=new li){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=xi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],p=r[8],_=r[9],m=r[10],g=r[11],y=r[12],M=r[13],x=r[14],R=r[15];if(s[0].setComponents(c-o,d-h,g-p,R-y).normalize(),s[1].setComponents(c+o,d+h,g+p,R+y).normalize(),s[2].setComponents(c+a,d+u,g+_,R+M).normalize(),s[3].setComponents(c-a,d-u,g-_,R-M).normalize(),n)s[4].setComponents(l,f,m,x).normalize(),s[5].setComponents(c-l,d-f,g-m,R-x).normalize();else if(s[4].setComponents(c-l,d-f,g-m,R-x).normalize(),e===xi)s[5].setComponents(c+l,d+f,g+m,R+x).normalize();else if(e===ao)s[5].setComponents(l,f,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),or.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),or.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(or)}intersectsSprite(t){or.center.set(0,0,0);let e=Mv.distanceTo(t.center);return or.radius=.7071067811865476+e,or.applyMatrix4(t.matrixWorld),this.intersectsSphere(or)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(tc.x=s.normal.x>0?t.max.x:t.min.x,tc.y=s.normal.y>0?t.max.y:t.min.y,tc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(tc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},rg=new De,wc=class i{constructor(){this.coordinateSystem=xi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];rg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Fs),n[s].setFromProjectionMatrix(rg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Fs),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Os=class extends ms{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new oe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Tc=new z,Ec=new z,og=new De,ea=new lr,ec=new ps,mf=new z,ag=new z,va=class extends Nn{constructor(t=new gn,e=new Os){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Tc.fromBufferAttribute(e,s-1),Ec.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Tc.distanceTo(Ec);t.setAttribute("lineDistance",new Ve(n,1))}else te("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ec.copy(n.boundingSphere),ec.applyMatrix4(s),ec.radius+=r,t.ray.intersectsSphere(ec)===!1)return;og.copy(s).invert(),ea.copy(t.ray).applyMatrix4(og);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=d,m=p-1;_<m;_+=c){let g=h.getX(_),y=h.getX(_+1),M=nc(this,t,ea,l,g,y,_);M&&e.push(M)}if(this.isLineLoop){let _=h.getX(p-1),m=h.getX(d),g=nc(this,t,ea,l,_,m,p-1);g&&e.push(g)}}else{let d=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let _=d,m=p-1;_<m;_+=c){let g=nc(this,t,ea,l,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=nc(this,t,ea,l,p-1,d,p-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function nc(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(Tc.fromBufferAttribute(a,s),Ec.fromBufferAttribute(a,r),e.distanceSqToSegment(Tc,Ec,mf,ag)>n)return;mf.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(mf);if(!(c<t.near||c>t.far))return{distance:c,point:ag.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var lg=new z,cg=new z,cr=class extends va{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)lg.fromBufferAttribute(e,s),cg.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+lg.distanceTo(cg);t.setAttribute("lineDistance",new Ve(n,1))}else te("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Sa=class extends $n{constructor(t=[],e=gr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var gs=class extends $n{constructor(t,e,n=Li,s,r,o,a=In,l=In,c,h=fs,u=1){if(h!==fs&&h!==ys)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ho(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ma=class extends gs{constructor(t,e=Li,n=gr,s,r,o=In,a=In,l,c=fs){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ba=class extends $n{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},qi=class i extends gn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ve(c,3)),this.setAttribute("normal",new Ve(h,3)),this.setAttribute("uv",new Ve(u,2));function p(_,m,g,y,M,x,R,E,v,b,I){let T=x/v,P=R/b,O=x/2,H=R/2,N=E/2,V=v+1,Y=b+1,W=0,ct=0,J=new z;for(let Q=0;Q<Y;Q++){let et=Q*P-H;for(let dt=0;dt<V;dt++){let ht=dt*T-O;J[_]=ht*y,J[m]=et*M,J[g]=N,c.push(J.x,J.y,J.z),J[_]=0,J[m]=0,J[g]=E>0?1:-1,h.push(J.x,J.y,J.z),u.push(dt/v),u.push(1-Q/b),W+=1}}for(let Q=0;Q<b;Q++)for(let et=0;et<v;et++){let dt=f+et+V*Q,ht=f+et+V*(Q+1),tt=f+(et+1)+V*(Q+1),gt=f+(et+1)+V*Q;l.push(dt,ht,gt),l.push(ht,tt,gt),ct+=6}a.addGroup(d,ct,I),d+=ct,f+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var hr=class i extends gn{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],p=0,_=[],m=n/2,g=0;y(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new Ve(u,3)),this.setAttribute("normal",new Ve(f,3)),this.setAttribute("uv",new Ve(d,2));function y(){let x=new z,R=new z,E=0,v=(e-t)/n;for(let b=0;b<=r;b++){let I=[],T=b/r,P=T*(e-t)+t;for(let O=0;O<=s;O++){let H=O/s,N=H*l+a,V=Math.sin(N),Y=Math.cos(N);R.x=P*V,R.y=-T*n+m,R.z=P*Y,u.push(R.x,R.y,R.z),x.set(V,v,Y).normalize(),f.push(x.x,x.y,x.z),d.push(H,1-T),I.push(p++)}_.push(I)}for(let b=0;b<s;b++)for(let I=0;I<r;I++){let T=_[I][b],P=_[I+1][b],O=_[I+1][b+1],H=_[I][b+1];(t>0||I!==0)&&(h.push(T,P,H),E+=3),(e>0||I!==r-1)&&(h.push(P,O,H),E+=3)}c.addGroup(g,E,0),g+=E}function M(x){let R=p,E=new _t,v=new z,b=0,I=x===!0?t:e,T=x===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*T,0),f.push(0,T,0),d.push(.5,.5),p++;let P=p;for(let O=0;O<=s;O++){let N=O/s*l+a,V=Math.cos(N),Y=Math.sin(N);v.x=I*Y,v.y=m*T,v.z=I*V,u.push(v.x,v.y,v.z),f.push(0,T,0),E.x=V*.5+.5,E.y=Y*.5*T+.5,d.push(E.x,E.y),p++}for(let O=0;O<s;O++){let H=R+O,N=P+O;x===!0?h.push(N,N+1,H):h.push(N+1,N,H),b+=3}c.addGroup(g,b,x===!0?1:2),g+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ur=class i extends hr{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ac=class i extends gn{constructor(t=[],e=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:n,detail:s};let r=[],o=[];a(s),c(n),h(),this.setAttribute("position",new Ve(r,3)),this.setAttribute("normal",new Ve(r.slice(),3)),this.setAttribute("uv",new Ve(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(y){let M=new z,x=new z,R=new z;for(let E=0;E<e.length;E+=3)d(e[E+0],M),d(e[E+1],x),d(e[E+2],R),l(M,x,R,y)}function l(y,M,x,R){let E=R+1,v=[];for(let b=0;b<=E;b++){v[b]=[];let I=y.clone().lerp(x,b/E),T=M.clone().lerp(x,b/E),P=E-b;for(let O=0;O<=P;O++)O===0&&b===E?v[b][O]=I:v[b][O]=I.clone().lerp(T,O/P)}for(let b=0;b<E;b++)for(let I=0;I<2*(E-b)-1;I++){let T=Math.floor(I/2);I%2===0?(f(v[b][T+1]),f(v[b+1][T]),f(v[b][T])):(f(v[b][T+1]),f(v[b+1][T+1]),f(v[b+1][T]))}}function c(y){let M=new z;for(let x=0;x<r.length;x+=3)M.x=r[x+0],M.y=r[x+1],M.z=r[x+2],M.normalize().multiplyScalar(y),r[x+0]=M.x,r[x+1]=M.y,r[x+2]=M.z}function h(){let y=new z;for(let M=0;M<r.length;M+=3){y.x=r[M+0],y.y=r[M+1],y.z=r[M+2];let x=m(y)/2/Math.PI+.5,R=g(y)/Math.PI+.5;o.push(x,1-R)}p(),u()}function u(){for(let y=0;y<o.length;y+=6){let M=o[y+0],x=o[y+2],R=o[y+4],E=Math.max(M,x,R),v=Math.min(M,x,R);E>.9&&v<.1&&(M<.2&&(o[y+0]+=1),x<.2&&(o[y+2]+=1),R<.2&&(o[y+4]+=1))}}function f(y){r.push(y.x,y.y,y.z)}function d(y,M){let x=y*3;M.x=t[x+0],M.y=t[x+1],M.z=t[x+2]}function p(){let y=new z,M=new z,x=new z,R=new z,E=new _t,v=new _t,b=new _t;for(let I=0,T=0;I<r.length;I+=9,T+=6){y.set(r[I+0],r[I+1],r[I+2]),M.set(r[I+3],r[I+4],r[I+5]),x.set(r[I+6],r[I+7],r[I+8]),E.set(o[T+0],o[T+1]),v.set(o[T+2],o[T+3]),b.set(o[T+4],o[T+5]),R.copy(y).add(M).add(x).divideScalar(3);let P=m(R);_(E,T+0,y,P),_(v,T+2,M,P),_(b,T+4,x,P)}}function _(y,M,x,R){R<0&&y.x===1&&(o[M]=y.x-1),x.x===0&&x.z===0&&(o[M]=R/2/Math.PI+.5)}function m(y){return Math.atan2(y.z,-y.x)}function g(y){return Math.atan2(-y.y,Math.sqrt(y.x*y.x+y.z*y.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.vertices,t.indices,t.radius,t.detail)}};var hi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){te("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],f=n[s+1]-h,d=(o-h)/f;return(s+d)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new _t:new z);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new z,s=[],r=[],o=[],a=new z,l=new De;for(let d=0;d<=t;d++){let p=d/t;s[d]=this.getTangentAt(p,new z)}r[0]=new z,o[0]=new z;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),f=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let d=1;d<=t;d++){if(r[d]=r[d-1].clone(),o[d]=o[d-1].clone(),a.crossVectors(s[d-1],s[d]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(ve(s[d-1].dot(s[d]),-1,1));r[d].applyMatrix4(l.makeRotationAxis(a,p))}o[d].crossVectors(s[d],r[d])}if(e===!0){let d=Math.acos(ve(r[0].dot(r[t]),-1,1));d/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(d=-d);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],d*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},po=class extends hi{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new _t){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),f=l-this.aX,d=c-this.aY;l=f*h-d*u+this.aX,c=f*u+d*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Rc=class extends po{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function od(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let f=(o-r)/c-(a-r)/(c+h)+(a-o)/h,d=(a-o)/h-(l-o)/(h+u)+(l-a)/u;f*=h,d*=h,s(o,a,f,d)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var hg=new z,ug=new z,gf=new od,_f=new od,yf=new od,Cc=class extends hi{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new z){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(ug.subVectors(s[0],s[1]).add(s[0]),c=ug);let u=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(hg.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=hg),this.curveType==="centripetal"||this.curveType==="chordal"){let d=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),d),_=Math.pow(u.distanceToSquared(f),d),m=Math.pow(f.distanceToSquared(h),d);_<1e-4&&(_=1),p<1e-4&&(p=_),m<1e-4&&(m=_),gf.initNonuniformCatmullRom(c.x,u.x,f.x,h.x,p,_,m),_f.initNonuniformCatmullRom(c.y,u.y,f.y,h.y,p,_,m),yf.initNonuniformCatmullRom(c.z,u.z,f.z,h.z,p,_,m)}else this.curveType==="catmullrom"&&(gf.initCatmullRom(c.x,u.x,f.x,h.x,this.tension),_f.initCatmullRom(c.y,u.y,f.y,h.y,this.tension),yf.initCatmullRom(c.z,u.z,f.z,h.z,this.tension));return n.set(gf.calc(l),_f.calc(l),yf.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new z().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function fg(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function bv(i,t){let e=1-i;return e*e*t}function wv(i,t){return 2*(1-i)*i*t}function Tv(i,t){return i*i*t}function oa(i,t,e,n){return bv(i,t)+wv(i,e)+Tv(i,n)}function Ev(i,t){let e=1-i;return e*e*e*t}function Av(i,t){let e=1-i;return 3*e*e*i*t}function Rv(i,t){return 3*(1-i)*i*i*t}function Cv(i,t){return i*i*i*t}function aa(i,t,e,n,s){return Ev(i,t)+Av(i,e)+Rv(i,n)+Cv(i,s)}var wa=class extends hi{constructor(t=new _t,e=new _t,n=new _t,s=new _t){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new _t){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(aa(t,s.x,r.x,o.x,a.x),aa(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Pc=class extends hi{constructor(t=new z,e=new z,n=new z,s=new z){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new z){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(aa(t,s.x,r.x,o.x,a.x),aa(t,s.y,r.y,o.y,a.y),aa(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Ta=class extends hi{constructor(t=new _t,e=new _t){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new _t){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new _t){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Ic=class extends hi{constructor(t=new z,e=new z){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new z){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new z){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Ea=class extends hi{constructor(t=new _t,e=new _t,n=new _t){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new _t){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(oa(t,s.x,r.x,o.x),oa(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Lc=class extends hi{constructor(t=new z,e=new z,n=new z){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new z){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(oa(t,s.x,r.x,o.x),oa(t,s.y,r.y,o.y),oa(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Aa=class extends hi{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new _t){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(fg(a,l.x,c.x,h.x,u.x),fg(a,l.y,c.y,h.y,u.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new _t().fromArray(s))}return this}},Tf=Object.freeze({__proto__:null,ArcCurve:Rc,CatmullRomCurve3:Cc,CubicBezierCurve:wa,CubicBezierCurve3:Pc,EllipseCurve:po,LineCurve:Ta,LineCurve3:Ic,QuadraticBezierCurve:Ea,QuadraticBezierCurve3:Lc,SplineCurve:Aa}),Dc=class extends hi{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Tf[n](e,t))}return this}getPoint(t,e){let n=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(e.push(h),n=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(new Tf[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},Ra=class extends Dc{constructor(t){super(),this.type="Path",this.currentPoint=new _t,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let n=new Ta(this.currentPoint.clone(),new _t(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){let r=new Ea(this.currentPoint.clone(),new _t(t,e),new _t(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){let a=new wa(this.currentPoint.clone(),new _t(t,e),new _t(n,s),new _t(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),n=new Aa(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){let c=new po(t,e,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},mo=class extends Ra{constructor(t){super(t),this.uuid=yr(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let n=0,s=this.holes.length;n<s;n++)e[n]=this.holes[n].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,n=this.holes.length;e<n;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(new Ra().fromJSON(s))}return this}};function Pv(i,t,e=2){let n=t&&t.length,s=n?t[0]*e:i.length,r=h0(i,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=Uv(i,t,r,e)),i.length>80*e){a=i[0],l=i[1];let h=a,u=l;for(let f=e;f<s;f+=e){let d=i[f],p=i[f+1];d<a&&(a=d),p<l&&(l=p),d>h&&(h=d),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return Ca(r,o,e,a,l,c,0),o}function h0(i,t,e,n,s){let r;if(s===qv(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=dg(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=dg(o/n|0,i[o],i[o+1],r);return r&&go(r,r.next)&&(Ia(r),r=r.next),r}function fr(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(go(e,e.next)||en(e.prev,e,e.next)===0)){if(Ia(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function Ca(i,t,e,n,s,r,o){if(!i)return;!o&&r&&zv(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?Lv(i,n,s,r):Iv(i)){t.push(l.i,i.i,c.i),Ia(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=Dv(fr(i),t),Ca(i,t,e,n,s,r,2)):o===2&&Nv(i,t,e,n,s,r):Ca(fr(i),t,e,n,s,r,1);break}}}function Iv(i){let t=i.prev,e=i,n=i.next;if(en(t,e,n)>=0)return!1;let s=t.x,r=e.x,o=n.x,a=t.y,l=e.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),f=Math.max(s,r,o),d=Math.max(a,l,c),p=n.next;for(;p!==t;){if(p.x>=h&&p.x<=f&&p.y>=u&&p.y<=d&&na(s,a,r,l,o,c,p.x,p.y)&&en(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function Lv(i,t,e,n){let s=i.prev,r=i,o=i.next;if(en(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,f=o.y,d=Math.min(a,l,c),p=Math.min(h,u,f),_=Math.max(a,l,c),m=Math.max(h,u,f),g=Ef(d,p,t,e,n),y=Ef(_,m,t,e,n),M=i.prevZ,x=i.nextZ;for(;M&&M.z>=g&&x&&x.z<=y;){if(M.x>=d&&M.x<=_&&M.y>=p&&M.y<=m&&M!==s&&M!==o&&na(a,h,l,u,c,f,M.x,M.y)&&en(M.prev,M,M.next)>=0||(M=M.prevZ,x.x>=d&&x.x<=_&&x.y>=p&&x.y<=m&&x!==s&&x!==o&&na(a,h,l,u,c,f,x.x,x.y)&&en(x.prev,x,x.next)>=0))return!1;x=x.nextZ}for(;M&&M.z>=g;){if(M.x>=d&&M.x<=_&&M.y>=p&&M.y<=m&&M!==s&&M!==o&&na(a,h,l,u,c,f,M.x,M.y)&&en(M.prev,M,M.next)>=0)return!1;M=M.prevZ}for(;x&&x.z<=y;){if(x.x>=d&&x.x<=_&&x.y>=p&&x.y<=m&&x!==s&&x!==o&&na(a,h,l,u,c,f,x.x,x.y)&&en(x.prev,x,x.next)>=0)return!1;x=x.nextZ}return!0}function Dv(i,t){let e=i;do{let n=e.prev,s=e.next.next;!go(n,s)&&f0(n,e,e.next,s)&&Pa(n,s)&&Pa(s,n)&&(t.push(n.i,e.i,s.i),Ia(e),Ia(e.next),e=i=s),e=e.next}while(e!==i);return fr(e)}function Nv(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&Hv(o,a)){let l=d0(o,a);o=fr(o,o.next),l=fr(l,l.next),Ca(o,t,e,n,s,r,0),Ca(l,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function Uv(i,t,e,n){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*n,l=r<o-1?t[r+1]*n:i.length,c=h0(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(Vv(c))}s.sort(Fv);for(let r=0;r<s.length;r++)e=Ov(s[r],e);return e}function Fv(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function Ov(i,t){let e=Bv(i,t);if(!e)return t;let n=d0(e,i);return fr(n,n.next),fr(e,e.next)}function Bv(i,t){let e=t,n=i.x,s=i.y,r=-1/0,o;if(go(i,e))return e;do{if(go(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let u=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(u<=n&&u>r&&(r=u,o=e.x<e.next.x?e:e.next,u===n))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;e=o;do{if(n>=e.x&&e.x>=l&&n!==e.x&&u0(s<c?n:r,s,l,c,s<c?r:n,s,e.x,e.y)){let u=Math.abs(s-e.y)/(n-e.x);Pa(e,i)&&(u<h||u===h&&(e.x>o.x||e.x===o.x&&kv(o,e)))&&(o=e,h=u)}e=e.next}while(e!==a);return o}function kv(i,t){return en(i.prev,i,t.prev)<0&&en(t.next,i,i.next)<0}function zv(i,t,e,n){let s=i;do s.z===0&&(s.z=Ef(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,Gv(s)}function Gv(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function Ef(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function Vv(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function u0(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function na(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&u0(i,t,e,n,s,r,o,a)}function Hv(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!Wv(i,t)&&(Pa(i,t)&&Pa(t,i)&&Xv(i,t)&&(en(i.prev,i,t.prev)||en(i,t.prev,t))||go(i,t)&&en(i.prev,i,i.next)>0&&en(t.prev,t,t.next)>0)}function en(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function go(i,t){return i.x===t.x&&i.y===t.y}function f0(i,t,e,n){let s=sc(en(i,t,e)),r=sc(en(i,t,n)),o=sc(en(e,n,i)),a=sc(en(e,n,t));return!!(s!==r&&o!==a||s===0&&ic(i,e,t)||r===0&&ic(i,n,t)||o===0&&ic(e,i,n)||a===0&&ic(e,t,n))}function ic(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function sc(i){return i>0?1:i<0?-1:0}function Wv(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&f0(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function Pa(i,t){return en(i.prev,i,i.next)<0?en(i,t,i.next)>=0&&en(i,i.prev,t)>=0:en(i,t,i.prev)<0||en(i,i.next,t)<0}function Xv(i,t){let e=i,n=!1,s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function d0(i,t){let e=Af(i.i,i.x,i.y),n=Af(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function dg(i,t,e,n){let s=Af(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function Ia(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function Af(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function qv(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var Rf=class{static triangulate(t,e,n=2){return Pv(t,e,n)}},ar=class i{static area(t){let e=t.length,n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return i.area(t)<0}static triangulateShape(t,e){let n=[],s=[],r=[];pg(t),mg(n,t);let o=t.length;e.forEach(pg);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,mg(n,e[l]);let a=Rf.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function pg(i){let t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function mg(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}var La=class i extends gn{constructor(t=new mo([new _t(.5,.5),new _t(-.5,.5),new _t(-.5,-.5),new _t(.5,-.5)]),e={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:t,options:e},t=Array.isArray(t)?t:[t];let n=this,s=[],r=[];for(let a=0,l=t.length;a<l;a++){let c=t[a];o(c)}this.setAttribute("position",new Ve(s,3)),this.setAttribute("uv",new Ve(r,2)),this.computeVertexNormals();function o(a){let l=[],c=e.curveSegments!==void 0?e.curveSegments:12,h=e.steps!==void 0?e.steps:1,u=e.depth!==void 0?e.depth:1,f=e.bevelEnabled!==void 0?e.bevelEnabled:!0,d=e.bevelThickness!==void 0?e.bevelThickness:.2,p=e.bevelSize!==void 0?e.bevelSize:d-.1,_=e.bevelOffset!==void 0?e.bevelOffset:0,m=e.bevelSegments!==void 0?e.bevelSegments:3,g=e.extrudePath,y=e.UVGenerator!==void 0?e.UVGenerator:Yv,M,x=!1,R,E,v,b;if(g){M=g.getSpacedPoints(h),x=!0,f=!1;let ot=g.isCatmullRomCurve3?g.closed:!1;R=g.computeFrenetFrames(h,ot),E=new z,v=new z,b=new z}f||(m=0,d=0,p=0,_=0);let I=a.extractPoints(c),T=I.shape,P=I.holes;if(!ar.isClockWise(T)){T=T.reverse();for(let ot=0,vt=P.length;ot<vt;ot++){let yt=P[ot];ar.isClockWise(yt)&&(P[ot]=yt.reverse())}}function H(ot){let yt=10000000000000001e-36,Bt=ot[0];for(let Dt=1;Dt<=ot.length;Dt++){let ee=Dt%ot.length,kt=ot[ee],me=kt.x-Bt.x,fe=kt.y-Bt.y,_e=me*me+fe*fe,B=Math.max(Math.abs(kt.x),Math.abs(kt.y),Math.abs(Bt.x),Math.abs(Bt.y)),Mt=yt*B*B;if(_e<=Mt){ot.splice(ee,1),Dt--;continue}Bt=kt}}H(T),P.forEach(H);let N=P.length,V=T;for(let ot=0;ot<N;ot++){let vt=P[ot];T=T.concat(vt)}function Y(ot,vt,yt){return vt||ce("ExtrudeGeometry: vec does not exist"),ot.clone().addScaledVector(vt,yt)}let W=T.length;function ct(ot,vt,yt){let Bt,Dt,ee,kt=ot.x-vt.x,me=ot.y-vt.y,fe=yt.x-ot.x,_e=yt.y-ot.y,B=kt*kt+me*me,Mt=kt*_e-me*fe;if(Math.abs(Mt)>Number.EPSILON){let Xt=Math.sqrt(B),he=Math.sqrt(fe*fe+_e*_e),Tt=vt.x-me/Xt,Ue=vt.y+kt/Xt,$t=yt.x-_e/he,Qt=yt.y+fe/he,L=(($t-Tt)*_e-(Qt-Ue)*fe)/(kt*_e-me*fe);Bt=Tt+kt*L-ot.x,Dt=Ue+me*L-ot.y;let w=Bt*Bt+Dt*Dt;if(w<=2)return new _t(Bt,Dt);ee=Math.sqrt(w/2)}else{let Xt=!1;kt>Number.EPSILON?fe>Number.EPSILON&&(Xt=!0):kt<-Number.EPSILON?fe<-Number.EPSILON&&(Xt=!0):Math.sign(me)===Math.sign(_e)&&(Xt=!0),Xt?(Bt=-me,Dt=kt,ee=Math.sqrt(B)):(Bt=kt,Dt=me,ee=Math.sqrt(B/2))}return new _t(Bt/ee,Dt/ee)}let J=[];for(let ot=0,vt=V.length,yt=vt-1,Bt=ot+1;ot<vt;ot++,yt++,Bt++)yt===vt&&(yt=0),Bt===vt&&(Bt=0),J[ot]=ct(V[ot],V[yt],V[Bt]);let Q=[],et,dt=J.concat();for(let ot=0,vt=N;ot<vt;ot++){let yt=P[ot];et=[];for(let Bt=0,Dt=yt.length,ee=Dt-1,kt=Bt+1;Bt<Dt;Bt++,ee++,kt++)ee===Dt&&(ee=0),kt===Dt&&(kt=0),et[Bt]=ct(yt[Bt],yt[ee],yt[kt]);Q.push(et),dt=dt.concat(et)}let ht;if(m===0)ht=ar.triangulateShape(V,P);else{let ot=[],vt=[];for(let yt=0;yt<m;yt++){let Bt=yt/m,Dt=d*Math.cos(Bt*Math.PI/2),ee=p*Math.sin(Bt*Math.PI/2)+_;for(let kt=0,me=V.length;kt<me;kt++){let fe=Y(V[kt],J[kt],ee);Vt(fe.x,fe.y,-Dt),Bt===0&&ot.push(fe)}for(let kt=0,me=N;kt<me;kt++){let fe=P[kt];et=Q[kt];let _e=[];for(let B=0,Mt=fe.length;B<Mt;B++){let Xt=Y(fe[B],et[B],ee);Vt(Xt.x,Xt.y,-Dt),Bt===0&&_e.push(Xt)}Bt===0&&vt.push(_e)}}ht=ar.triangulateShape(ot,vt)}let tt=ht.length,gt=p+_;for(let ot=0;ot<W;ot++){let vt=f?Y(T[ot],dt[ot],gt):T[ot];x?(v.copy(R.normals[0]).multiplyScalar(vt.x),E.copy(R.binormals[0]).multiplyScalar(vt.y),b.copy(M[0]).add(v).add(E),Vt(b.x,b.y,b.z)):Vt(vt.x,vt.y,0)}for(let ot=1;ot<=h;ot++)for(let vt=0;vt<W;vt++){let yt=f?Y(T[vt],dt[vt],gt):T[vt];x?(v.copy(R.normals[ot]).multiplyScalar(yt.x),E.copy(R.binormals[ot]).multiplyScalar(yt.y),b.copy(M[ot]).add(v).add(E),Vt(b.x,b.y,b.z)):Vt(yt.x,yt.y,u/h*ot)}for(let ot=m-1;ot>=0;ot--){let vt=ot/m,yt=d*Math.cos(vt*Math.PI/2),Bt=p*Math.sin(vt*Math.PI/2)+_;for(let Dt=0,ee=V.length;Dt<ee;Dt++){let kt=Y(V[Dt],J[Dt],Bt);Vt(kt.x,kt.y,u+yt)}for(let Dt=0,ee=P.length;Dt<ee;Dt++){let kt=P[Dt];et=Q[Dt];for(let me=0,fe=kt.length;me<fe;me++){let _e=Y(kt[me],et[me],Bt);x?Vt(_e.x,_e.y+M[h-1].y,M[h-1].x+yt):Vt(_e.x,_e.y,u+yt)}}}xt(),Lt();function xt(){let ot=s.length/3;if(f){let vt=0,yt=W*vt;for(let Bt=0;Bt<tt;Bt++){let Dt=ht[Bt];ie(Dt[2]+yt,Dt[1]+yt,Dt[0]+yt)}vt=h+m*2,yt=W*vt;for(let Bt=0;Bt<tt;Bt++){let Dt=ht[Bt];ie(Dt[0]+yt,Dt[1]+yt,Dt[2]+yt)}}else{for(let vt=0;vt<tt;vt++){let yt=ht[vt];ie(yt[2],yt[1],yt[0])}for(let vt=0;vt<tt;vt++){let yt=ht[vt];ie(yt[0]+W*h,yt[1]+W*h,yt[2]+W*h)}}n.addGroup(ot,s.length/3-ot,0)}function Lt(){let ot=s.length/3,vt=0;wt(V,vt),vt+=V.length;for(let yt=0,Bt=P.length;yt<Bt;yt++){let Dt=P[yt];wt(Dt,vt),vt+=Dt.length}n.addGroup(ot,s.length/3-ot,1)}function wt(ot,vt){let yt=ot.length;for(;--yt>=0;){let Bt=yt,Dt=yt-1;Dt<0&&(Dt=ot.length-1);for(let ee=0,kt=h+m*2;ee<kt;ee++){let me=W*ee,fe=W*(ee+1),_e=vt+Bt+me,B=vt+Dt+me,Mt=vt+Dt+fe,Xt=vt+Bt+fe;Jt(_e,B,Mt,Xt)}}}function Vt(ot,vt,yt){l.push(ot),l.push(vt),l.push(yt)}function ie(ot,vt,yt){se(ot),se(vt),se(yt);let Bt=s.length/3,Dt=y.generateTopUV(n,s,Bt-3,Bt-2,Bt-1);ne(Dt[0]),ne(Dt[1]),ne(Dt[2])}function Jt(ot,vt,yt,Bt){se(ot),se(vt),se(Bt),se(vt),se(yt),se(Bt);let Dt=s.length/3,ee=y.generateSideWallUV(n,s,Dt-6,Dt-3,Dt-2,Dt-1);ne(ee[0]),ne(ee[1]),ne(ee[3]),ne(ee[1]),ne(ee[2]),ne(ee[3])}function se(ot){s.push(l[ot*3+0]),s.push(l[ot*3+1]),s.push(l[ot*3+2])}function ne(ot){r.push(ot.x),r.push(ot.y)}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes,n=this.parameters.options;return $v(e,n,t)}static fromJSON(t,e){let n=[];for(let r=0,o=t.shapes.length;r<o;r++){let a=e[t.shapes[r]];n.push(a)}let s=t.options.extrudePath;return s!==void 0&&(t.options.extrudePath=new Tf[s.type]().fromJSON(s)),new i(n,t.options)}},Yv={generateTopUV:function(i,t,e,n,s){let r=t[e*3],o=t[e*3+1],a=t[n*3],l=t[n*3+1],c=t[s*3],h=t[s*3+1];return[new _t(r,o),new _t(a,l),new _t(c,h)]},generateSideWallUV:function(i,t,e,n,s,r){let o=t[e*3],a=t[e*3+1],l=t[e*3+2],c=t[n*3],h=t[n*3+1],u=t[n*3+2],f=t[s*3],d=t[s*3+1],p=t[s*3+2],_=t[r*3],m=t[r*3+1],g=t[r*3+2];return Math.abs(a-h)<Math.abs(o-c)?[new _t(o,1-l),new _t(c,1-u),new _t(f,1-p),new _t(_,1-g)]:[new _t(a,1-l),new _t(h,1-u),new _t(d,1-p),new _t(m,1-g)]}};function $v(i,t,e){if(e.shapes=[],Array.isArray(i))for(let n=0,s=i.length;n<s;n++){let r=i[n];e.shapes.push(r.uuid)}else e.shapes.push(i.uuid);return e.options=Object.assign({},t),t.extrudePath!==void 0&&(e.options.extrudePath=t.extrudePath.toJSON()),e}var _o=class i extends Ac{constructor(t=1,e=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new i(t.radius,t.detail)}},dr=class i extends gn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,d=[],p=[],_=[],m=[];for(let g=0;g<h;g++){let y=g*f-o;for(let M=0;M<c;M++){let x=M*u-r;p.push(x,-y,0),_.push(0,0,1),m.push(M/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<a;y++){let M=y+c*g,x=y+c*(g+1),R=y+1+c*(g+1),E=y+1+c*g;d.push(M,x,E),d.push(x,R,E)}this.setIndex(d),this.setAttribute("position",new Ve(p,3)),this.setAttribute("normal",new Ve(_,3)),this.setAttribute("uv",new Ve(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var Da=class i extends gn{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new z,f=new z,d=[],p=[],_=[],m=[];for(let g=0;g<=n;g++){let y=[],M=g/n,x=o+M*a,R=t*Math.cos(x),E=Math.sqrt(t*t-R*R),v=0;g===0&&o===0?v=.5/e:g===n&&l===Math.PI&&(v=-.5/e);for(let b=0;b<=e;b++){let I=b/e,T=s+I*r;u.x=-E*Math.cos(T),u.y=R,u.z=E*Math.sin(T),p.push(u.x,u.y,u.z),f.copy(u).normalize(),_.push(f.x,f.y,f.z),m.push(I+v,1-M),y.push(c++)}h.push(y)}for(let g=0;g<n;g++)for(let y=0;y<e;y++){let M=h[g][y+1],x=h[g][y],R=h[g+1][y],E=h[g+1][y+1];(g!==0||o>0)&&d.push(M,x,E),(g!==n-1||l<Math.PI)&&d.push(x,R,E)}this.setIndex(d),this.setAttribute("position",new Ve(p,3)),this.setAttribute("normal",new Ve(_,3)),this.setAttribute("uv",new Ve(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function xr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(gg(s))s.isRenderTargetTexture?(te("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(gg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Bn(i){let t={};for(let e=0;e<i.length;e++){let n=xr(i[e]);for(let s in n)t[s]=n[s]}return t}function gg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Zv(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function ad(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Re.workingColorSpace}var p0={clone:xr,merge:Bn},Jv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Kv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Yi=class extends ms{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Jv,this.fragmentShader=Kv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=xr(t.uniforms),this.uniformsGroups=Zv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new oe().setHex(s.value);break;case"v2":this.uniforms[n].value=new _t().fromArray(s.value);break;case"v3":this.uniforms[n].value=new z().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Qe().fromArray(s.value);break;case"m3":this.uniforms[n].value=new de().fromArray(s.value);break;case"m4":this.uniforms[n].value=new De().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Nc=class extends Yi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var yo=class extends ms{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new oe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Fh,this.normalScale=new _t(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ds,this.combine=Zc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Uc=class extends ms{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=$g,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Fc=class extends ms{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function no(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function rc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Bs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Oc=class extends Bs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Mf,endingEnd:Mf}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case bf:r=t,a=2*e-n;break;case wf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case bf:o=t,l=2*n-e;break;case wf:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,p=(n-e)/(s-e),_=p*p,m=_*p,g=-f*m+2*f*_-f*p,y=(1+f)*m+(-1.5-2*f)*_+(-.5+f)*p+1,M=(-1-d)*m+(1.5+d)*_+.5*p,x=d*m-d*_;for(let R=0;R!==a;++R)r[R]=g*o[h+R]+y*o[c+R]+M*o[l+R]+x*o[u+R];return r}},Bc=class extends Bs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},kc=class extends Bs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},zc=class extends Bs{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),_=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*p;return r}let f=a*2,d=t-1;for(let p=0;p!==a;++p){let _=o[c+p],m=o[l+p],g=d*f+p*2,y=u[g],M=u[g+1],x=t*f+p*2,R=h[x],E=h[x+1],v=Qv(n,e,y,R,s);r[p]=m0(v,_,M,E,m)}return r}};function m0(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function jv(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Qv(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=m0(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=jv(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ui=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=no(e,this.TimeBufferType),this.values=no(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:no(t.times,Array),values:no(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),rc(t.settings)&&(n.settings={inTangents:no(t.settings.inTangents,Array),outTangents:no(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new kc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Bc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Oc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new zc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case la:e=this.InterpolantFactoryMethodDiscrete;break;case vc:e=this.InterpolantFactoryMethodLinear;break;case cc:e=this.InterpolantFactoryMethodSmooth;break;case Sf:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return te("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return la;case this.InterpolantFactoryMethodLinear:return vc;case this.InterpolantFactoryMethodSmooth:return cc;case this.InterpolantFactoryMethodBezier:return Sf}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;rc(this.settings)&&(_g(this.settings.inTangents,t),_g(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;rc(this.settings)&&(yg(this.settings.inTangents,t),yg(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ce("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ce("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ce("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ce("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Vx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ce("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===cc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,f=u-n,d=u+n;for(let p=0;p!==n;++p){let _=e[u+p];if(_!==e[f+p]||_!==e[d+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,rc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function _g(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function yg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}ui.prototype.ValueTypeName="";ui.prototype.TimeBufferType=Float32Array;ui.prototype.ValueBufferType=Float32Array;ui.prototype.DefaultInterpolation=vc;var ks=class extends ui{constructor(t,e,n){super(t,e,n)}};ks.prototype.ValueTypeName="bool";ks.prototype.ValueBufferType=Array;ks.prototype.DefaultInterpolation=la;ks.prototype.InterpolantFactoryMethodLinear=void 0;ks.prototype.InterpolantFactoryMethodSmooth=void 0;var Gc=class extends ui{constructor(t,e,n,s){super(t,e,n,s)}};Gc.prototype.ValueTypeName="color";var Vc=class extends ui{constructor(t,e,n,s){super(t,e,n,s)}};Vc.prototype.ValueTypeName="number";var Hc=class extends Bs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Ln.slerpFlat(r,0,o,c-a,o,c,l);return r}},Na=class extends ui{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Hc(this.times,this.values,this.getValueSize(),t)}};Na.prototype.ValueTypeName="quaternion";Na.prototype.InterpolantFactoryMethodSmooth=void 0;var zs=class extends ui{constructor(t,e,n){super(t,e,n)}};zs.prototype.ValueTypeName="string";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=la;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Wc=class extends ui{constructor(t,e,n,s){super(t,e,n,s)}};Wc.prototype.ValueTypeName="vector";var Xc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],p=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},g0=new Xc,qc=class{constructor(t){this.manager=t!==void 0?t:g0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};qc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ua=class extends Nn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new oe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var xf=new De,xg=new z,vg=new z,Yc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new _t(512,512),this.mapType=Zn,this.map=null,this.mapPass=null,this.matrix=new De,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Fs,this._frameExtents=new _t(1,1),this._viewportCount=1,this._viewports=[new Qe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;xg.setFromMatrixPosition(t.matrixWorld),e.position.copy(xg),vg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(vg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){xf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(xf,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===ao||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(xf)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},oc=new z,ac=new Ln,Hi=new z,Fa=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new De,this.projectionMatrix=new De,this.projectionMatrixInverse=new De,this.coordinateSystem=xi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(oc,ac,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,ac,Hi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(oc,ac,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,ac,Hi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ns=new z,Sg=new _t,Mg=new _t,Xn=class extends Fa{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=co*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(sa*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return co*2*Math.atan(Math.tan(sa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ns.x,Ns.y).multiplyScalar(-t/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ns.x,Ns.y).multiplyScalar(-t/Ns.z)}getViewSize(t,e){return this.getViewBounds(t,Sg,Mg),e.subVectors(Mg,Sg)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(sa*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Oa=class extends Fa{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Cf=class extends Yc{constructor(){super(new Oa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ba=class extends Ua{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new Cf}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},ka=class extends Ua{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var io=-90,so=1,xo=class extends Nn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Xn(io,so,t,e);s.layers=this.layers,this.add(s);let r=new Xn(io,so,t,e);r.layers=this.layers,this.add(r);let o=new Xn(io,so,t,e);o.layers=this.layers,this.add(o);let a=new Xn(io,so,t,e);a.layers=this.layers,this.add(a);let l=new Xn(io,so,t,e);l.layers=this.layers,this.add(l);let c=new Xn(io,so,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===xi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ao)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=_,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},$c=class extends Xn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var ld="\\[\\]\\.:\\/",tS=new RegExp("["+ld+"]","g"),cd="[^"+ld+"]",eS="[^"+ld.replace("\\.","")+"]",nS=/((?:WC+[\/:])*)/.source.replace("WC",cd),iS=/(WCOD+)?/.source.replace("WCOD",eS),sS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",cd),rS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",cd),oS=new RegExp("^"+nS+iS+sS+rS+"$"),aS=["material","materials","bones","map"],Pf=class{constructor(t,e,n){let s=n||Ke.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ke=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(tS,"")}static parseTrackName(t){let e=oS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);aS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){te("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ce("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ce("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ce("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ce("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ce("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ce("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ke.Composite=Pf;Ke.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ke.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ke.prototype.GetterByBindingType=[Ke.prototype._getValue_direct,Ke.prototype._getValue_array,Ke.prototype._getValue_arrayElement,Ke.prototype._getValue_toArray];Ke.prototype.SetterByBindingTypeAndVersioning=[[Ke.prototype._setValue_direct,Ke.prototype._setValue_direct_setNeedsUpdate,Ke.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_array,Ke.prototype._setValue_array_setNeedsUpdate,Ke.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_arrayElement,Ke.prototype._setValue_arrayElement_setNeedsUpdate,Ke.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_fromArray,Ke.prototype._setValue_fromArray_setNeedsUpdate,Ke.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var fE=new Float32Array(1);var vo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ve(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ve(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var If=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var za=class extends cr{constructor(t=10,e=10,n=4473924,s=8947848){n=new oe(n),s=new oe(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,p=-a;f<=e;f++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let _=f===r?n:s;_.toArray(c,d),d+=3,_.toArray(c,d),d+=3,_.toArray(c,d),d+=3,_.toArray(c,d),d+=3}let h=new gn;h.setAttribute("position",new Ve(l,3)),h.setAttribute("color",new Ve(c,3));let u=new Os({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var bg=new z,lc,vf,Ga=class extends Nn{constructor(t=new z(0,0,1),e=new z(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",lc===void 0&&(lc=new gn,lc.setAttribute("position",new Ve([0,0,0,0,1,0],3)),vf=new ur(.5,1,5,1),vf.translate(0,-.5,0)),this.position.copy(e),this.line=new va(lc,new Os({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Sn(vf,new _a({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(t),this.setLength(n,r,o)}setDirection(t){if(t.y>.99999)this.quaternion.set(0,0,0,1);else if(t.y<-.99999)this.quaternion.set(1,0,0,0);else{bg.set(t.z,0,-t.x).normalize();let e=Math.acos(t.y);this.quaternion.setFromAxisAngle(bg,e)}}setLength(t,e=t*.2,n=e*.2){this.line.scale.set(1,Math.max(1e-4,t-e),1),this.line.updateMatrix(),this.cone.scale.set(n,e,n),this.cone.position.y=t,this.cone.updateMatrix()}setColor(t){this.line.material.color.set(t),this.cone.material.color.set(t)}copy(t){return super.copy(t,!1),this.line.copy(t.line),this.cone.copy(t.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var Va=class extends Ii{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function hd(i,t,e,n){let s=lS(n);switch(e){case Jf:return i*t;case nh:return i*t/s.components*s.byteLength;case ih:return i*t/s.components*s.byteLength;case Ws:return i*t*2/s.components*s.byteLength;case sh:return i*t*2/s.components*s.byteLength;case Kf:return i*t*3/s.components*s.byteLength;case Ni:return i*t*4/s.components*s.byteLength;case rh:return i*t*4/s.components*s.byteLength;case Xa:case qa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ya:case $a:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ah:case ch:return Math.max(i,16)*Math.max(t,8)/4;case oh:case lh:return Math.max(i,8)*Math.max(t,8)/2;case hh:case uh:case dh:case ph:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case fh:case Za:case mh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case gh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case _h:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case yh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case xh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case vh:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Sh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Mh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case bh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case wh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Th:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Eh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Ah:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Rh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Ch:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Ph:case Ih:case Lh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Dh:case Nh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ja:case Uh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function lS(i){switch(i){case Zn:case qf:return{byteLength:1,components:1};case wo:case Yf:case Di:return{byteLength:2,components:1};case th:case eh:return{byteLength:2,components:4};case Li:case Qc:case vi:return{byteLength:4,components:1};case $f:case Zf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?te("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function B0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function mS(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,p)=>d.start-p.start);let f=0;for(let d=1;d<u.length;d++){let p=u[f],_=u[d];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++f,u[f]=_)}u.length=f+1;for(let d=0,p=u.length;d<p;d++){let _=u[d];i.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var gS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,_S=`#ifdef USE_ALPHAHASH
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
#endif`,yS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,xS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,SS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,MS=`#ifdef USE_AOMAP
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
#endif`,bS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,wS=`#ifdef USE_BATCHING
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
#endif`,TS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ES=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,AS=`vec3 objectNormal = vec3( normal );
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
} // validated`,CS=`#ifdef USE_IRIDESCENCE
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
#endif`,PS=`#ifdef USE_BUMPMAP
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
#endif`,IS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,LS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,DS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,NS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,US=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,FS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,OS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,BS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,kS=`#define PI 3.141592653589793
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
} // validated`,zS=`vec3 transformedNormal = objectNormal;
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
#endif`,GS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,VS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,HS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,WS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,XS="gl_FragColor = linearToOutputTexel( gl_FragColor );",qS=`vec4 LinearTransferOETF( in vec4 value ) {
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
#endif`,$S=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ZS=`#ifdef USE_ENVMAP
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
#endif`,JS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,KS=`#ifdef USE_ENVMAP
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
#endif`,jS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,QS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,tM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,eM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,nM=`#ifdef USE_GRADIENTMAP
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
}`,iM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,sM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,rM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,oM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,aM=`#ifdef USE_ENVMAP
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
#endif`,lM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,cM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,hM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,uM=`varying vec3 vViewPosition;
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
#endif`,dM=`uniform sampler2D dfgLUT;
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
}`,pM=`
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
#endif`,mM=`#if defined( RE_IndirectDiffuse )
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
#endif`,gM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,_M=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,yM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,xM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,SM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,MM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,bM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,wM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,TM=`#if defined( USE_POINTS_UV )
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
#endif`,EM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,AM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,RM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,CM=`#if defined( USE_MORPHCOLORS )
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
#endif`,PM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,IM=`#ifdef USE_MORPHTARGETS
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
#endif`,LM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,DM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,NM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,UM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,FM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,OM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,BM=`#ifdef USE_NORMALMAP
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
#endif`,kM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,zM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,GM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,VM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,HM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,WM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,XM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,qM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,YM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,$M=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ZM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,JM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,KM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,jM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,QM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,tb=`float getShadowMask() {
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
}`,eb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,nb=`#ifdef USE_SKINNING
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
#endif`,ib=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sb=`#ifdef USE_SKINNING
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
#endif`,rb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ob=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ab=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,cb=`#ifdef USE_TRANSMISSION
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
#endif`,hb=`#ifdef USE_TRANSMISSION
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
#endif`,ub=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,db=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,mb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gb=`uniform sampler2D t2D;
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
}`,_b=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,yb=`uniform float backgroundBlurriness;
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
}`,xb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Sb=`#include <common>
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
}`,Mb=`#if DEPTH_PACKING == 3200
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
}`,bb=`#define DISTANCE
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
}`,wb=`#define DISTANCE
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
}`,Tb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Eb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ab=`uniform float scale;
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
}`,Cb=`#include <common>
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
}`,Pb=`uniform vec3 diffuse;
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
}`,Ib=`#define LAMBERT
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
}`,Lb=`#define LAMBERT
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
}`,Db=`#define MATCAP
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
}`,Nb=`#define MATCAP
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
}`,Ub=`#define NORMAL
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
}`,Fb=`#define NORMAL
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
}`,Ob=`#define PHONG
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
}`,Bb=`#define PHONG
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
}`,kb=`#define STANDARD
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
}`,zb=`#define STANDARD
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
}`,Gb=`#define TOON
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
}`,Vb=`#define TOON
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
}`,Hb=`uniform float size;
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
}`,Wb=`uniform vec3 diffuse;
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
}`,Xb=`#include <common>
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
}`,qb=`uniform vec3 color;
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
}`,$b=`uniform vec3 diffuse;
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
}`,Se={alphahash_fragment:gS,alphahash_pars_fragment:_S,alphamap_fragment:yS,alphamap_pars_fragment:xS,alphatest_fragment:vS,alphatest_pars_fragment:SS,aomap_fragment:MS,aomap_pars_fragment:bS,batching_pars_vertex:wS,batching_vertex:TS,begin_vertex:ES,beginnormal_vertex:AS,bsdfs:RS,iridescence_fragment:CS,bumpmap_pars_fragment:PS,clipping_planes_fragment:IS,clipping_planes_pars_fragment:LS,clipping_planes_pars_vertex:DS,clipping_planes_vertex:NS,color_fragment:US,color_pars_fragment:FS,color_pars_vertex:OS,color_vertex:BS,common:kS,defaultnormal_vertex:zS,displacementmap_pars_vertex:GS,displacementmap_vertex:VS,emissivemap_fragment:HS,emissivemap_pars_fragment:WS,colorspace_fragment:XS,colorspace_pars_fragment:qS,envmap_fragment:YS,envmap_common_pars_fragment:$S,envmap_pars_fragment:ZS,envmap_pars_vertex:JS,envmap_physical_pars_fragment:aM,envmap_vertex:KS,fog_vertex:jS,fog_pars_vertex:QS,fog_fragment:tM,fog_pars_fragment:eM,gradientmap_pars_fragment:nM,lightmap_pars_fragment:iM,lights_lambert_fragment:sM,lights_lambert_pars_fragment:rM,lights_pars_begin:oM,lights_toon_fragment:lM,lights_toon_pars_fragment:cM,lights_phong_fragment:hM,lights_phong_pars_fragment:uM,lights_physical_fragment:fM,lights_physical_pars_fragment:dM,lights_fragment_begin:pM,lights_fragment_maps:mM,lights_fragment_end:gM,lightprobes_pars_fragment:_M,logdepthbuf_fragment:yM,logdepthbuf_pars_fragment:xM,logdepthbuf_pars_vertex:vM,logdepthbuf_vertex:SM,map_fragment:MM,map_pars_fragment:bM,map_particle_fragment:wM,map_particle_pars_fragment:TM,metalnessmap_fragment:EM,metalnessmap_pars_fragment:AM,morphinstance_vertex:RM,morphcolor_vertex:CM,morphnormal_vertex:PM,morphtarget_pars_vertex:IM,morphtarget_vertex:LM,normal_fragment_begin:DM,normal_fragment_maps:NM,normal_pars_fragment:UM,normal_pars_vertex:FM,normal_vertex:OM,normalmap_pars_fragment:BM,clearcoat_normal_fragment_begin:kM,clearcoat_normal_fragment_maps:zM,clearcoat_pars_fragment:GM,iridescence_pars_fragment:VM,opaque_fragment:HM,packing:WM,premultiplied_alpha_fragment:XM,project_vertex:qM,dithering_fragment:YM,dithering_pars_fragment:$M,roughnessmap_fragment:ZM,roughnessmap_pars_fragment:JM,shadowmap_pars_fragment:KM,shadowmap_pars_vertex:jM,shadowmap_vertex:QM,shadowmask_pars_fragment:tb,skinbase_vertex:eb,skinning_pars_vertex:nb,skinning_vertex:ib,skinnormal_vertex:sb,specularmap_fragment:rb,specularmap_pars_fragment:ob,tonemapping_fragment:ab,tonemapping_pars_fragment:lb,transmission_fragment:cb,transmission_pars_fragment:hb,uv_pars_fragment:ub,uv_pars_vertex:fb,uv_vertex:db,worldpos_vertex:pb,background_vert:mb,background_frag:gb,backgroundCube_vert:_b,backgroundCube_frag:yb,cube_vert:xb,cube_frag:vb,depth_vert:Sb,depth_frag:Mb,distance_vert:bb,distance_frag:wb,equirect_vert:Tb,equirect_frag:Eb,linedashed_vert:Ab,linedashed_frag:Rb,meshbasic_vert:Cb,meshbasic_frag:Pb,meshlambert_vert:Ib,meshlambert_frag:Lb,meshmatcap_vert:Db,meshmatcap_frag:Nb,meshnormal_vert:Ub,meshnormal_frag:Fb,meshphong_vert:Ob,meshphong_frag:Bb,meshphysical_vert:kb,meshphysical_frag:zb,meshtoon_vert:Gb,meshtoon_frag:Vb,points_vert:Hb,points_frag:Wb,shadow_vert:Xb,shadow_frag:qb,sprite_vert:Yb,sprite_frag:$b},Ot={common:{diffuse:{value:new oe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new de},alphaMap:{value:null},alphaMapTransform:{value:new de},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new de}},envmap:{envMap:{value:null},envMapRotation:{value:new de},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new de}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new de}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new de},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new de},normalScale:{value:new _t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new de},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new de}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new de}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new de}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new oe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new oe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new de},alphaTest:{value:0},uvTransform:{value:new de}},sprite:{diffuse:{value:new oe(16777215)},opacity:{value:1},center:{value:new _t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new de},alphaMap:{value:null},alphaMapTransform:{value:new de},alphaTest:{value:0}}},Ji={basic:{uniforms:Bn([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.fog]),vertexShader:Se.meshbasic_vert,fragmentShader:Se.meshbasic_frag},lambert:{uniforms:Bn([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new oe(0)},envMapIntensity:{value:1}}]),vertexShader:Se.meshlambert_vert,fragmentShader:Se.meshlambert_frag},phong:{uniforms:Bn([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new oe(0)},specular:{value:new oe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Se.meshphong_vert,fragmentShader:Se.meshphong_frag},standard:{uniforms:Bn([Ot.common,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.roughnessmap,Ot.metalnessmap,Ot.fog,Ot.lights,{emissive:{value:new oe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Se.meshphysical_vert,fragmentShader:Se.meshphysical_frag},toon:{uniforms:Bn([Ot.common,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.gradientmap,Ot.fog,Ot.lights,{emissive:{value:new oe(0)}}]),vertexShader:Se.meshtoon_vert,fragmentShader:Se.meshtoon_frag},matcap:{uniforms:Bn([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,{matcap:{value:null}}]),vertexShader:Se.meshmatcap_vert,fragmentShader:Se.meshmatcap_frag},points:{uniforms:Bn([Ot.points,Ot.fog]),vertexShader:Se.points_vert,fragmentShader:Se.points_frag},dashed:{uniforms:Bn([Ot.common,Ot.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Se.linedashed_vert,fragmentShader:Se.linedashed_frag},depth:{uniforms:Bn([Ot.common,Ot.displacementmap]),vertexShader:Se.depth_vert,fragmentShader:Se.depth_frag},normal:{uniforms:Bn([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,{opacity:{value:1}}]),vertexShader:Se.meshnormal_vert,fragmentShader:Se.meshnormal_frag},sprite:{uniforms:Bn([Ot.sprite,Ot.fog]),vertexShader:Se.sprite_vert,fragmentShader:Se.sprite_frag},background:{uniforms:{uvTransform:{value:new de},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Se.background_vert,fragmentShader:Se.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new de}},vertexShader:Se.backgroundCube_vert,fragmentShader:Se.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Se.cube_vert,fragmentShader:Se.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Se.equirect_vert,fragmentShader:Se.equirect_frag},distance:{uniforms:Bn([Ot.common,Ot.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Se.distance_vert,fragmentShader:Se.distance_frag},shadow:{uniforms:Bn([Ot.lights,Ot.fog,{color:{value:new oe(0)},opacity:{value:1}}]),vertexShader:Se.shadow_vert,fragmentShader:Se.shadow_frag}};Ji.physical={uniforms:Bn([Ji.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new de},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new de},clearcoatNormalScale:{value:new _t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new de},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new de},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new de},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new de},sheen:{value:0},sheenColor:{value:new oe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new de},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new de},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new de},transmissionSamplerSize:{value:new _t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new de},attenuationDistance:{value:0},attenuationColor:{value:new oe(0)},specularColor:{value:new oe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new de},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new de},anisotropyVector:{value:new _t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new de}}]),vertexShader:Se.meshphysical_vert,fragmentShader:Se.meshphysical_frag};var Bh={r:0,b:0,g:0},Zb=new De,k0=new de;k0.set(-1,0,0,0,1,0,0,0,1);function Jb(i,t,e,n,s,r){let o=new oe(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(y){let M=y.isScene===!0?y.background:null;if(M&&M.isTexture){let x=y.backgroundBlurriness>0;M=t.get(M,x)}return M}function p(y){let M=!1,x=d(y);x===null?m(o,a):x&&x.isColor&&(m(x,1),M=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(y,M){let x=d(M);x&&x.isCubeTexture?(c===void 0&&(c=new Sn(new qi(1,1,1),new Yi({name:"BackgroundCubeMaterial",uniforms:xr(Ji.backgroundCube.uniforms),vertexShader:Ji.backgroundCube.vertexShader,fragmentShader:Ji.backgroundCube.fragmentShader,side:Yn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=x,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Zb.makeRotationFromEuler(M.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(k0),c.material.toneMapped=Re.getTransfer(x.colorSpace)!==Oe,(h!==x||u!==x.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=x,u=x.version,f=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new Sn(new dr(2,2),new Yi({name:"BackgroundMaterial",uniforms:xr(Ji.background.uniforms),vertexShader:Ji.background.vertexShader,fragmentShader:Ji.background.fragmentShader,side:Hs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=Re.getTransfer(x.colorSpace)!==Oe,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||u!==x.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=x,u=x.version,f=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,M){y.getRGB(Bh,ad(i)),e.buffers.color.setClear(Bh.r,Bh.g,Bh.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,M=1){o.set(y),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:p,addToRenderList:_,dispose:g}}function Kb(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(P,O,H,N,V){let Y=!1,W=u(P,N,H,O);r!==W&&(r=W,c(r.object)),Y=d(P,N,H,V),Y&&p(P,N,H,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,x(P,O,H,N),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(P){return i.bindVertexArray(P)}function h(P){return i.deleteVertexArray(P)}function u(P,O,H,N){let V=N.wireframe===!0,Y=n[O.id];Y===void 0&&(Y={},n[O.id]=Y);let W=P.isInstancedMesh===!0?P.id:0,ct=Y[W];ct===void 0&&(ct={},Y[W]=ct);let J=ct[H.id];J===void 0&&(J={},ct[H.id]=J);let Q=J[V];return Q===void 0&&(Q=f(l()),J[V]=Q),Q}function f(P){let O=[],H=[],N=[];for(let V=0;V<e;V++)O[V]=0,H[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:H,attributeDivisors:N,object:P,attributes:{},index:null}}function d(P,O,H,N){let V=r.attributes,Y=O.attributes,W=0,ct=H.getAttributes();for(let J in ct)if(ct[J].location>=0){let et=V[J],dt=Y[J];if(dt===void 0&&(J==="instanceMatrix"&&P.instanceMatrix&&(dt=P.instanceMatrix),J==="instanceColor"&&P.instanceColor&&(dt=P.instanceColor)),et===void 0||et.attribute!==dt||dt&&et.data!==dt.data)return!0;W++}return r.attributesNum!==W||r.index!==N}function p(P,O,H,N){let V={},Y=O.attributes,W=0,ct=H.getAttributes();for(let J in ct)if(ct[J].location>=0){let et=Y[J];et===void 0&&(J==="instanceMatrix"&&P.instanceMatrix&&(et=P.instanceMatrix),J==="instanceColor"&&P.instanceColor&&(et=P.instanceColor));let dt={};dt.attribute=et,et&&et.data&&(dt.data=et.data),V[J]=dt,W++}r.attributes=V,r.attributesNum=W,r.index=N}function _(){let P=r.newAttributes;for(let O=0,H=P.length;O<H;O++)P[O]=0}function m(P){g(P,0)}function g(P,O){let H=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;H[P]=1,N[P]===0&&(i.enableVertexAttribArray(P),N[P]=1),V[P]!==O&&(i.vertexAttribDivisor(P,O),V[P]=O)}function y(){let P=r.newAttributes,O=r.enabledAttributes;for(let H=0,N=O.length;H<N;H++)O[H]!==P[H]&&(i.disableVertexAttribArray(H),O[H]=0)}function M(P,O,H,N,V,Y,W){W===!0?i.vertexAttribIPointer(P,O,H,V,Y):i.vertexAttribPointer(P,O,H,N,V,Y)}function x(P,O,H,N){_();let V=N.attributes,Y=H.getAttributes(),W=O.defaultAttributeValues;for(let ct in Y){let J=Y[ct];if(J.location>=0){let Q=V[ct];if(Q===void 0&&(ct==="instanceMatrix"&&P.instanceMatrix&&(Q=P.instanceMatrix),ct==="instanceColor"&&P.instanceColor&&(Q=P.instanceColor)),Q!==void 0){let et=Q.normalized,dt=Q.itemSize,ht=t.get(Q);if(ht===void 0)continue;let tt=ht.buffer,gt=ht.type,xt=ht.bytesPerElement,Lt=gt===i.INT||gt===i.UNSIGNED_INT||Q.gpuType===Qc;if(Q.isInterleavedBufferAttribute){let wt=Q.data,Vt=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,ie=Q.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let Jt=0;Jt<J.locationSize;Jt++)g(J.location+Jt,wt.meshPerAttribute);P.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let Jt=0;Jt<J.locationSize;Jt++)m(J.location+Jt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Jt=0;Jt<J.locationSize;Jt++)M(J.location+Jt,dt/J.locationSize,gt,et,Vt*xt,(ie+dt/J.locationSize*Jt)*xt,Lt)}else{if(Q.isInstancedBufferAttribute){for(let wt=0;wt<J.locationSize;wt++)g(J.location+wt,Q.meshPerAttribute);P.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let wt=0;wt<J.locationSize;wt++)m(J.location+wt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let wt=0;wt<J.locationSize;wt++)M(J.location+wt,dt/J.locationSize,gt,et,dt*xt,dt/J.locationSize*wt*xt,Lt)}}else if(W!==void 0){let et=W[ct];if(et!==void 0)switch(et.length){case 2:i.vertexAttrib2fv(J.location,et);break;case 3:i.vertexAttrib3fv(J.location,et);break;case 4:i.vertexAttrib4fv(J.location,et);break;default:i.vertexAttrib1fv(J.location,et)}}}}y()}function R(){I();for(let P in n){let O=n[P];for(let H in O){let N=O[H];for(let V in N){let Y=N[V];for(let W in Y)h(Y[W].object),delete Y[W];delete N[V]}}delete n[P]}}function E(P){if(n[P.id]===void 0)return;let O=n[P.id];for(let H in O){let N=O[H];for(let V in N){let Y=N[V];for(let W in Y)h(Y[W].object),delete Y[W];delete N[V]}}delete n[P.id]}function v(P){for(let O in n){let H=n[O];for(let N in H){let V=H[N];if(V[P.id]===void 0)continue;let Y=V[P.id];for(let W in Y)h(Y[W].object),delete Y[W];delete V[P.id]}}}function b(P){for(let O in n){let H=n[O],N=P.isInstancedMesh===!0?P.id:0,V=H[N];if(V!==void 0){for(let Y in V){let W=V[Y];for(let ct in W)h(W[ct].object),delete W[ct];delete V[Y]}delete H[N],Object.keys(H).length===0&&delete n[O]}}}function I(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:T,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:v,initAttributes:_,enableAttribute:m,disableUnusedAttributes:y}}function jb(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];e.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Qb(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Ni&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let b=v===Di&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==Zn&&v!==vi&&!b&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(te("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&te("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&te("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:M,maxFragmentUniforms:x,maxSamples:R,samples:E}}function tw(i){let t=this,e=null,n=0,s=!1,r=!1,o=new li,a=new de,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let p=u.clippingPlanes,_=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let y=r?0:n,M=y*4,x=g.clippingState||null;l.value=x,x=h(p,f,M,d);for(let R=0;R!==M;++R)x[R]=e[R];g.clippingState=x,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,d,p){let _=u!==null?u.length:0,m=null;if(_!==0){if(m=l.value,p!==!0||m===null){let g=d+_*4,y=f.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,x=d;M!==_;++M,x+=4)o.copy(u[M]).applyMatrix4(y,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var Qa=class extends ci{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Sa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new qi(5,5,5),r=new Yi({name:"CubemapFromEquirect",uniforms:xr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Yn,blending:pr});r.uniforms.tEquirect.value=e;let o=new Sn(s,r),a=e.minFilter;return e.minFilter===_s&&(e.minFilter=qn),new xo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},_0=256,ew=3,nw=20,z0=256,G0=16,iw=3,sw=new z,rw=new oe,zh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xo(1,10,null),this._boxMesh=new Sn(new qi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=sw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(rw));let m=new xo(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=p,t.background=_,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=v0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=x0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(_0,sd(t))}_fromTexture(t,e){t.mapping===gr||t.mapping===bo?this._setSize(t.image.length===0?_0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=y0(t,!1,!1),n=Math.log2(t)-ew;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=y0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===gr||t.mapping===bo?(this._cubemapMaterial===null&&(this._cubemapMaterial=v0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=x0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=ow(),this._integrationMaterial=aw());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/G0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-iw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(z0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=lw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function y0(i,t,e){return new Qa(i,{minFilter:_s,generateMipmaps:t,type:Di,colorSpace:ca,depthBuffer:e})}function tl(i,t,e){return new Yi({name:i,uniforms:t,vertexShader:Se.cube_vert,fragmentShader:e,side:Yn,blending:pr,depthTest:!1,depthWrite:!1})}function ow(){return tl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${z0}u

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
	`)}function aw(){return tl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:G0}},`

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
	`)}function lw(){return tl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${nw}
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
	`)}function x0(){return tl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function v0(){return tl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function cw(i){let t=new WeakMap,e=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Jc||d===Kc)if(t.has(f)){let p=t.get(f).texture;return a(p,f.mapping)}else{let p=f.image;if(p&&p.height>0){let _=new Qa(p.height);return _.fromEquirectangularTexture(i,f),t.set(f,_),f.addEventListener("dispose",c),a(_.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,p=d===Jc||d===Kc,_=d===gr||d===bo;if(p||_){let m=e.get(f),g=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return n===null&&(n=new zh(i)),m=p?n.fromEquirectangular(f,m):n.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),m.texture;if(m!==void 0)return m.texture;{let y=f.image;return p&&y&&y.height>0||_&&y&&l(y)?(n===null&&(n=new zh(i)),m=p?n.fromEquirectangular(f):n.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function a(f,d){return d===Jc?f.mapping=gr:d===Kc&&(f.mapping=bo),f}function l(f){let d=0,p=6;for(let _=0;_<p;_++)f[_]!==void 0&&d++;return d===p}function c(f){let d=f.target;d.removeEventListener("dispose",c);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function hw(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&ia("WebGLRenderer: "+n+" extension not supported."),s}}}function uw(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(t.remove(_),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function h(p){let _=p.attributes;for(let m in _)t.update(_[m],i.ARRAY_BUFFER)}function u(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=_!==null?_.array.length:m.array.length/3-1,M=m.count>=65535?ga:ma,x=new M(Math.ceil(y/3)*6,1),R=x.array;if(_!==null){let v=_.array;g=_.version;for(let b=0,I=0;b<y;b+=3){let T=v[b+0],P=v[b+1],O=v[b+2];R[I++]=T,R[I++]=P,R[I++]=P,R[I++]=O,R[I++]=O,R[I++]=T}}else{g=m.version;for(let v=0,b=0;v<y;v+=3){let I=v+0,T=v+1,P=v+2;R[b++]=I,R[b++]=T,R[b++]=T,R[b++]=P,R[b++]=P,R[b++]=I}}x.version=g;let E=r.get(p);E&&t.remove(E),r.set(p,x)}function f(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&u(p)}else u(p);return r.get(p)}function d(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function fw(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),e.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*o,d),e.update(f,n,d))}function h(u,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let _=0;for(let m=0;m<d;m++)_+=f[m];e.update(_,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function dw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ce("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function pw(i,t,e){let n=new WeakMap,s=new Qe;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let I=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",I)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],M=0;d===!0&&(M=1),p===!0&&(M=2),_===!0&&(M=3);let x=a.attributes.position.count*M,R=1;x>t.maxTextureSize&&(R=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);let E=new Float32Array(x*R*4*u),v=new fa(E,x,R,u);v.type=vi,v.needsUpdate=!0;let b=M*4;for(let T=0;T<u;T++){let P=m[T],O=g[T],H=y[T],N=x*R*4*T;for(let V=0;V<P.count;V++){let Y=V*b;d===!0&&(s.fromBufferAttribute(P,V),E[N+Y+0]=s.x,E[N+Y+1]=s.y,E[N+Y+2]=s.z,E[N+Y+3]=0),p===!0&&(s.fromBufferAttribute(O,V),E[N+Y+4]=s.x,E[N+Y+5]=s.y,E[N+Y+6]=s.z,E[N+Y+7]=0),_===!0&&(s.fromBufferAttribute(H,V),E[N+Y+8]=s.x,E[N+Y+9]=s.y,E[N+Y+10]=s.z,E[N+Y+11]=H.itemSize===4?s.w:1)}}f={count:u,texture:v,size:new _t(x,R)},n.set(a,f),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let _=0;_<c.length;_++)d+=c[_];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function mw(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var gw={[Bf]:"LINEAR_TONE_MAPPING",[kf]:"REINHARD_TONE_MAPPING",[zf]:"CINEON_TONE_MAPPING",[Gf]:"ACES_FILMIC_TONE_MAPPING",[Hf]:"AGX_TONE_MAPPING",[Wf]:"NEUTRAL_TONE_MAPPING",[Vf]:"CUSTOM_TONE_MAPPING"};function _w(i,t,e,n,s,r){let o=new ci(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new gn;h.setAttribute("position",new Ve([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ve([0,2,0,0,2,0],2));let u=new Nc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Sn(h,u),d=new Oa(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,y=null,M=[],x=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let v=0;v<M.length;v++){let b=M[v];b.setSize&&b.setSize(R,E)}},this.setEffects=function(R){M=R,x=M.length>0&&M[0].isRenderPass===!0;let E=o.width,v=o.height;M.length>0&&a===null&&(a=new ci(E,v,{type:Di,depthBuffer:!1,stencilBuffer:!1}),l=new ci(E,v,{type:Di,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&M.some(I=>I.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new gs(E,v),r===!0&&(c.format=ys,c.type=_r)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let I=0;I<M.length;I++){let T=M[I];T.setSize&&T.setSize(E,v),b&&T.needsDepthTexture===!0&&T.setDepthTexture&&T.setDepthTexture(c)}},this.begin=function(R,E){if(m||R.toneMapping===$i&&M.length===0)return!1;if(y=E,E!==null){let v=E.width,b=E.height;(o.width!==v||o.height!==b)&&this.setSize(v,b)}return x===!1&&R.setRenderTarget(o),g=R.toneMapping,R.toneMapping=$i,!0},this.hasRenderPass=function(){return x},this.end=function(R,E){R.toneMapping=g,m=!0;let v=o,b=a;for(let I=0;I<M.length;I++){let T=M[I];T.enabled!==!1&&(T.render(R,b,v,E),T.needsSwap!==!1&&(v=b,b=b===a?l:a))}if(p!==R.outputColorSpace||_!==R.toneMapping){p=R.outputColorSpace,_=R.toneMapping,u.defines={},Re.getTransfer(p)===Oe&&(u.defines.SRGB_TRANSFER="");let I=gw[_];I&&(u.defines[I]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(y),R.render(f,d),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var V0=new $n,H0=new gs(1,1),W0=new Ma(1),X0=new fa,q0=new bc,Y0=new Sa,S0=[],M0=[],b0=new Float32Array(16),w0=new Float32Array(9),T0=new Float32Array(4);function Eo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=S0[s];if(r===void 0&&(r=new Float32Array(s),S0[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Mn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function bn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Vh(i,t){let e=M0[t];e===void 0&&(e=new Int32Array(t),M0[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function yw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function xw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2fv(this.addr,t),bn(e,t)}}function vw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Mn(e,t))return;i.uniform3fv(this.addr,t),bn(e,t)}}function Sw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4fv(this.addr,t),bn(e,t)}}function Mw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;T0.set(n),i.uniformMatrix2fv(this.addr,!1,T0),bn(e,n)}}function bw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;w0.set(n),i.uniformMatrix3fv(this.addr,!1,w0),bn(e,n)}}function ww(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;b0.set(n),i.uniformMatrix4fv(this.addr,!1,b0),bn(e,n)}}function Tw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Ew(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2iv(this.addr,t),bn(e,t)}}function Aw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3iv(this.addr,t),bn(e,t)}}function Rw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4iv(this.addr,t),bn(e,t)}}function Cw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Pw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2uiv(this.addr,t),bn(e,t)}}function Iw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3uiv(this.addr,t),bn(e,t)}}function Lw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4uiv(this.addr,t),bn(e,t)}}function Hh(i){return i.version===0&&(i.compareFunction=td,i.needsUpdate=!0),i}function Dw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Hh(H0):r=V0,e.setTexture2D(t||r,s)}function Nw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||q0,s)}function Uw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Hh(W0):r=Y0,e.setTextureCube(t||r,s)}function Fw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||X0,s)}function Ow(i){switch(i){case 5126:return yw;case 35664:return xw;case 35665:return vw;case 35666:return Sw;case 35674:return Mw;case 35675:return bw;case 35676:return ww;case 5124:case 35670:return Tw;case 35667:case 35671:return Ew;case 35668:case 35672:return Aw;case 35669:case 35673:return Rw;case 5125:return Cw;case 36294:return Pw;case 36295:return Iw;case 36296:return Lw;case 35678:case 36198:case 36298:case 36306:case 35682:return Dw;case 35679:case 36299:case 36307:return Nw;case 35680:case 36300:case 36308:case 36293:return Uw;case 36289:case 36303:case 36311:case 36292:return Fw}}function Bw(i,t){i.uniform1fv(this.addr,t)}function kw(i,t){let e=Eo(t,this.size,2);i.uniform2fv(this.addr,e)}function zw(i,t){let e=Eo(t,this.size,3);i.uniform3fv(this.addr,e)}function Gw(i,t){let e=Eo(t,this.size,4);i.uniform4fv(this.addr,e)}function Vw(i,t){let e=Eo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Hw(i,t){let e=Eo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Ww(i,t){let e=Eo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Xw(i,t){i.uniform1iv(this.addr,t)}function qw(i,t){i.uniform2iv(this.addr,t)}function Yw(i,t){i.uniform3iv(this.addr,t)}function $w(i,t){i.uniform4iv(this.addr,t)}function Zw(i,t){i.uniform1uiv(this.addr,t)}function Jw(i,t){i.uniform2uiv(this.addr,t)}function Kw(i,t){i.uniform3uiv(this.addr,t)}function jw(i,t){i.uniform4uiv(this.addr,t)}function Qw(i,t,e){let n=this.cache,s=t.length,r=Vh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Hh(H0):o=V0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function t1(i,t,e){let n=this.cache,s=t.length,r=Vh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||q0,r[o])}function e1(i,t,e){let n=this.cache,s=t.length,r=Vh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Hh(W0):o=Y0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function n1(i,t,e){let n=this.cache,s=t.length,r=Vh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||X0,r[o])}function i1(i){switch(i){case 5126:return Bw;case 35664:return kw;case 35665:return zw;case 35666:return Gw;case 35674:return Vw;case 35675:return Hw;case 35676:return Ww;case 5124:case 35670:return Xw;case 35667:case 35671:return qw;case 35668:case 35672:return Yw;case 35669:case 35673:return $w;case 5125:return Zw;case 36294:return Jw;case 36295:return Kw;case 36296:return jw;case 35678:case 36198:case 36298:case 36306:case 35682:return Qw;case 35679:case 36299:case 36307:return t1;case 35680:case 36300:case 36308:case 36293:return e1;case 36289:case 36303:case 36311:case 36292:return n1}}var dd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Ow(e.type)}},pd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=i1(e.type)}},md=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},ud=/(\w+)(\])?(\[|\.)?/g;function E0(i,t){i.seq.push(t),i.map[t.id]=t}function s1(i,t,e){let n=i.name,s=n.length;for(ud.lastIndex=0;;){let r=ud.exec(n),o=ud.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){E0(e,c===void 0?new dd(a,i,t):new pd(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new md(a),E0(e,u)),e=u}}}var To=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);s1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function A0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var r1=37297,o1=0;function a1(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var R0=new de;function l1(i){Re._getMatrix(R0,Re.workingColorSpace,i);let t=`mat3( ${R0.elements.map(e=>e.toFixed(4))} )`;switch(Re.getTransfer(i)){case ha:return[t,"LinearTransferOETF"];case Oe:return[t,"sRGBTransferOETF"];default:return te("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function C0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+a1(i.getShaderSource(t),a)}else return r}function c1(i,t){let e=l1(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var h1={[Bf]:"Linear",[kf]:"Reinhard",[zf]:"Cineon",[Gf]:"ACESFilmic",[Hf]:"AgX",[Wf]:"Neutral",[Vf]:"Custom"};function u1(i,t){let e=h1[t];return e===void 0?(te("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var kh=new z;function f1(){Re.getLuminanceCoefficients(kh);let i=kh.x.toFixed(4),t=kh.y.toFixed(4),e=kh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function d1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ja).join(`
`)}function p1(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function m1(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function ja(i){return i!==""}function P0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function I0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var g1=/^[ \t]*#include +<([\w\d./]+)>/gm;function gd(i){return i.replace(g1,_1)}function _1(i,t){let e=Se[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return gd(e)}var y1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function L0(i){return i.replace(y1,x1)}function x1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function D0(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var v1={[Ha]:"SHADOWMAP_TYPE_PCF",[So]:"SHADOWMAP_TYPE_VSM"};function S1(i){return v1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var M1={[bo]:"ENVMAP_MODE_REFRACTION"};function b1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":M1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var w1={[Zc]:"ENVMAP_BLENDING_MULTIPLY",[Xg]:"ENVMAP_BLENDING_MIX",[qg]:"ENVMAP_BLENDING_ADD"};function T1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":w1[i.combine]||"ENVMAP_BLENDING_NONE"}function E1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=S1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=b1(e),u=T1(e),f=d1(e),d=p1(r),p=s.createProgram(),_,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(ja).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(ja).join(`
`),m.length>0&&(m+=`
`)):(_=[D0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ja).join(`
`),m=[D0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==$i?"#define TONE_MAPPING":"",e.toneMapping!==$i?Se.tonemapping_pars_fragment:"",e.toneMapping!==$i?u1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Se.colorspace_pars_fragment,c1("linearToOutputTexel",e.outputColorSpace),f1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ja).join(`
`)),o=gd(o),o=P0(o,e),o=I0(o,e),a=gd(a),a=P0(a,e),a=I0(a,e),o=L0(o),a=L0(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===ed?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===ed?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+_+o,M=g+m+a,x=A0(s,s.VERTEX_SHADER,y),R=A0(s,s.FRAGMENT_SHADER,M);s.attachShader(p,x),s.attachShader(p,R),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(T){if(i.debug.checkShaderErrors){let P=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(x)||"",H=s.getShaderInfoLog(R)||"",N=P.trim(),V=O.trim(),Y=H.trim(),W=!0,ct=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(W=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,x,R);else{let J=C0(s,x,"vertex"),Q=C0(s,R,"fragment");ce("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+N+`
`+J+`
`+Q)}else N!==""?te("WebGLProgram: Program Info Log:",N):(V===""||Y==="")&&(ct=!1);ct&&(T.diagnostics={runnable:W,programLog:N,vertexShader:{log:V,prefix:_},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(x),s.deleteShader(R),v=new To(s,p),b=m1(s,p)}let v;this.getUniforms=function(){return v===void 0&&E(this),v};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,r1)),I},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=o1++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=x,this.fragmentShader=R,this}var A1=0,_d=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new yd(t),e.set(t,n)),n}},yd=class{constructor(t){this.id=A1++,this.code=t,this.usedTimes=0}};function R1(i){return i===Ws||i===Za||i===Ja}function C1(i,t,e,n,s,r){let o=new da,a=new _d,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,b,I,T,P,O){let H=T.fog,N=P.geometry,V=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?T.environment:null,Y=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,W=t.get(v.envMap||V,Y),ct=f[v.type],J=n.precision;v.precision!==null&&(J=n.getMaxPrecision(v.precision),J!==v.precision&&te("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,et=Q!==void 0?Q.length:0,dt=0;N.morphAttributes.position!==void 0&&(dt=1),N.morphAttributes.normal!==void 0&&(dt=2),N.morphAttributes.color!==void 0&&(dt=3);let ht,tt,gt,xt;if(ct){let Nt=Ji[ct];ht=Nt.vertexShader,tt=Nt.fragmentShader}else{ht=v.vertexShader,tt=v.fragmentShader;let Nt=a.getVertexShaderStage(v),ge=a.getFragmentShaderStage(v);a.update(v,Nt,ge),gt=Nt.id,xt=ge.id}let Lt=i.getRenderTarget(),wt=i.state.buffers.depth.getReversed(),Vt=P.isInstancedMesh===!0,ie=P.isBatchedMesh===!0,Jt=!!v.map,se=!!v.matcap,ne=!!W,ot=ne&&W.isPMREMTexture===!0,vt=!!v.aoMap,yt=!!v.lightMap,Bt=!!v.bumpMap&&v.wireframe===!1,Dt=!!v.normalMap,ee=!!v.displacementMap,kt=!!v.emissiveMap,me=!!v.metalnessMap,fe=!!v.roughnessMap,_e=v.anisotropy>0,B=v.clearcoat>0,Mt=v.diffuseRoughness>0,Xt=v.dispersion>0,he=v.retroreflectivity>0,Tt=v.iridescence>0,Ue=v.sheen>0,$t=v.transmission>0,Qt=_e&&!!v.anisotropyMap,L=B&&!!v.clearcoatMap,w=B&&!!v.clearcoatNormalMap,q=B&&!!v.clearcoatRoughnessMap,ft=Mt&&!!v.diffuseRoughnessMap,at=Tt&&!!v.iridescenceMap,bt=Tt&&!!v.iridescenceThicknessMap,Et=Ue&&!!v.sheenColorMap,nt=Ue&&!!v.sheenRoughnessMap,st=!!v.specularMap,mt=!!v.specularColorMap,k=!!v.specularIntensityMap,rt=$t&&!!v.transmissionMap,it=$t&&!!v.thicknessMap,Ct=!!v.gradientMap,St=!!v.alphaMap,Rt=v.alphaTest>0,Kt=!!v.alphaHash,ae=!!v.extensions,ut=$i;v.toneMapped&&(Lt===null||Lt.isXRRenderTarget===!0)&&(ut=i.toneMapping);let qt=ot?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,le={shaderID:ct,shaderType:v.type,shaderName:v.name,vertexShader:ht,fragmentShader:tt,defines:v.defines,customVertexShaderID:gt,customFragmentShaderID:xt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:ie,batchingColor:ie&&P._colorsTexture!==null,instancing:Vt,instancingColor:Vt&&P.instanceColor!==null,instancingMorph:Vt&&P.morphTexture!==null,outputColorSpace:Lt===null?i.outputColorSpace:Lt.isXRRenderTarget===!0?Lt.texture.colorSpace:Re.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Jt,matcap:se,envMap:ne,envMapMode:ne&&W.mapping,envMapPMREM:ot,envMapMaxLod:ot?qt.length-1:null,envMapSize:ot?qt[0].width:null,aoMap:vt,lightMap:yt,bumpMap:Bt,normalMap:Dt,displacementMap:ee,emissiveMap:kt,normalMapObjectSpace:Dt&&v.normalMapType===Zg,normalMapTangentSpace:Dt&&v.normalMapType===Fh,packedNormalMap:Dt&&v.normalMapType===Fh&&R1(v.normalMap.format),metalnessMap:me,roughnessMap:fe,anisotropy:_e,anisotropyMap:Qt,clearcoat:B,clearcoatMap:L,clearcoatNormalMap:w,clearcoatRoughnessMap:q,diffuseRoughness:Mt,diffuseRoughnessMap:ft,dispersion:Xt,retroreflection:he,iridescence:Tt,iridescenceMap:at,iridescenceThicknessMap:bt,sheen:Ue,sheenColorMap:Et,sheenRoughnessMap:nt,specularMap:st,specularColorMap:mt,specularIntensityMap:k,transmission:$t,transmissionMap:rt,thicknessMap:it,gradientMap:Ct,opaque:v.transparent===!1&&v.blending===Mo&&v.alphaToCoverage===!1,alphaMap:St,alphaTest:Rt,alphaHash:Kt,combine:v.combine,mapUv:Jt&&d(v.map.channel),aoMapUv:vt&&d(v.aoMap.channel),lightMapUv:yt&&d(v.lightMap.channel),bumpMapUv:Bt&&d(v.bumpMap.channel),normalMapUv:Dt&&d(v.normalMap.channel),displacementMapUv:ee&&d(v.displacementMap.channel),emissiveMapUv:kt&&d(v.emissiveMap.channel),metalnessMapUv:me&&d(v.metalnessMap.channel),roughnessMapUv:fe&&d(v.roughnessMap.channel),anisotropyMapUv:Qt&&d(v.anisotropyMap.channel),clearcoatMapUv:L&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:w&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:bt&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:Et&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(v.sheenRoughnessMap.channel),specularMapUv:st&&d(v.specularMap.channel),specularColorMapUv:mt&&d(v.specularColorMap.channel),specularIntensityMapUv:k&&d(v.specularIntensityMap.channel),transmissionMapUv:rt&&d(v.transmissionMap.channel),thicknessMapUv:it&&d(v.thicknessMap.channel),alphaMapUv:St&&d(v.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Dt||_e),vertexNormals:!!N.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!N.attributes.uv&&(Jt||St),fog:!!H,useFog:v.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||N.attributes.normal===void 0&&Dt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:wt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:dt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:O.filter(Nt=>Nt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&I.length>0,shadowMapType:i.shadowMap.type,toneMapping:ut,decodeVideoTexture:Jt&&v.map.isVideoTexture===!0&&Re.getTransfer(v.map.colorSpace)===Oe,decodeVideoTextureEmissive:kt&&v.emissiveMap.isVideoTexture===!0&&Re.getTransfer(v.emissiveMap.colorSpace)===Oe,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===fi,flipSided:v.side===Yn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:ae&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ae&&v.extensions.multiDraw===!0||ie)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return le.vertexUv1s=l.has(1),le.vertexUv2s=l.has(2),le.vertexUv3s=l.has(3),l.clear(),le}function _(v){let b=[];if(v.shaderID?b.push(v.shaderID):(b.push(v.customVertexShaderID),b.push(v.customFragmentShaderID)),v.defines!==void 0)for(let I in v.defines)b.push(I),b.push(v.defines[I]);return v.isRawShaderMaterial===!1&&(m(b,v),g(b,v),b.push(i.outputColorSpace)),b.push(v.customProgramCacheKey),b.join()}function m(v,b){v.push(b.precision),v.push(b.outputColorSpace),v.push(b.envMapMode),v.push(b.envMapPMREM),v.push(b.envMapMaxLod),v.push(b.envMapSize),v.push(b.mapUv),v.push(b.alphaMapUv),v.push(b.lightMapUv),v.push(b.aoMapUv),v.push(b.bumpMapUv),v.push(b.normalMapUv),v.push(b.displacementMapUv),v.push(b.emissiveMapUv),v.push(b.metalnessMapUv),v.push(b.roughnessMapUv),v.push(b.anisotropyMapUv),v.push(b.clearcoatMapUv),v.push(b.clearcoatNormalMapUv),v.push(b.clearcoatRoughnessMapUv),v.push(b.diffuseRoughnessMapUv),v.push(b.iridescenceMapUv),v.push(b.iridescenceThicknessMapUv),v.push(b.sheenColorMapUv),v.push(b.sheenRoughnessMapUv),v.push(b.specularMapUv),v.push(b.specularColorMapUv),v.push(b.specularIntensityMapUv),v.push(b.transmissionMapUv),v.push(b.thicknessMapUv),v.push(b.combine),v.push(b.fogExp2),v.push(b.sizeAttenuation),v.push(b.morphTargetsCount),v.push(b.numSunLights),v.push(b.numDirLights),v.push(b.numPointLights),v.push(b.numSpotLights),v.push(b.numSpotLightMaps),v.push(b.numHemiLights),v.push(b.numRectAreaLights),v.push(b.numSunLightShadows),v.push(b.numDirLightShadows),v.push(b.numPointLightShadows),v.push(b.numSpotLightShadows),v.push(b.numSpotLightShadowsWithMaps),v.push(b.numLightProbes),v.push(b.numLightProbeGrids),v.push(b.shadowMapType),v.push(b.toneMapping),v.push(b.numClippingPlanes),v.push(b.numClipIntersection),v.push(b.depthPacking)}function g(v,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function y(v){let b=f[v.type],I;if(b){let T=Ji[b];I=p0.clone(T.uniforms)}else I=v.uniforms;return I}function M(v,b){let I=h.get(b);return I!==void 0?++I.usedTimes:(I=new E1(i,b,v,s),c.push(I),h.set(b,I)),I}function x(v){if(--v.usedTimes===0){let b=c.indexOf(v);c[b]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:y,acquireProgram:M,releaseProgram:x,releaseShaderCache:R,programs:c,dispose:E}}function P1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function I1(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function N0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function U0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,p,_,m,g){let y=i[t];return y===void 0?(y={id:f.id,object:f,geometry:d,material:p,materialVariant:o(f),groupOrder:_,renderOrder:f.renderOrder,z:m,group:g},i[t]=y):(y.id=f.id,y.object=f,y.geometry=d,y.material=p,y.materialVariant=o(f),y.groupOrder=_,y.renderOrder=f.renderOrder,y.z=m,y.group=g),t++,y}function l(f,d,p,_,m,g,y){y.reversedDepth===!0&&(m=-m);let M=a(f,d,p,_,m,g);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):e.push(M)}function c(f,d,p,_,m,g){let y=a(f,d,p,_,m,g);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):e.unshift(y)}function h(f,d){e.length>1&&e.sort(f||I1),n.length>1&&n.sort(d||N0),s.length>1&&s.sort(d||N0)}function u(){for(let f=t,d=i.length;f<d;f++){let p=i[f];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function L1(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new U0,i.set(n,[o])):s>=r.length?(o=new U0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function D1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new z,color:new oe};break;case"SpotLight":e={position:new z,direction:new z,color:new oe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new oe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new oe,groundColor:new oe};break;case"RectAreaLight":e={color:new oe,position:new z,halfWidth:new z,halfHeight:new z};break}return i[t.id]=e,e}}}function N1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var U1=0;function F1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function O1(i){let t=new D1,e=N1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new z);let s=new z,r=new De,o=new De;function a(c){let h=0,u=0,f=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let d=0,p=0,_=0,m=0,g=0,y=0,M=0,x=0,R=0,E=0,v=0,b=0,I=0,T=0;c.sort(F1);for(let O=0,H=c.length;O<H;O++){let N=c[O],V=N.color,Y=N.intensity,W=N.distance,ct=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Ws?ct=N.shadow.map.texture:ct=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=V.r*Y,u+=V.g*Y,f+=V.b*Y;else if(N.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(N.sh.coefficients[J],Y);T++}else if(N.isSunLight){let J=t.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,et=e.get(N);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=et,n.sunShadowMap[p]=ct;let dt=Q.getViewportCount();for(let ht=0;ht<dt;ht++)n.sunShadowMatrix[_+ht]=Q.getMatrix(ht),n.sunShadowCascade[_+ht]=Q._cascadeData[ht];_+=dt,p++}n.sun[d]=J,d++}else if(N.isDirectionalLight){let J=t.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,et=e.get(N);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,n.directionalShadow[m]=et,n.directionalShadowMap[m]=ct,n.directionalShadowMatrix[m]=N.shadow.matrix,R++}n.directional[m]=J,m++}else if(N.isSpotLight){let J=t.get(N);J.position.setFromMatrixPosition(N.matrixWorld),J.color.copy(V).multiplyScalar(Y),J.distance=W,J.coneCos=Math.cos(N.angle),J.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),J.decay=N.decay,n.spot[y]=J;let Q=N.shadow;if(N.map&&(n.spotLightMap[b]=N.map,b++,Q.updateMatrices(N),N.castShadow&&I++),n.spotLightMatrix[y]=Q.matrix,N.castShadow){let et=e.get(N);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,n.spotShadow[y]=et,n.spotShadowMap[y]=ct,v++}y++}else if(N.isRectAreaLight){let J=t.get(N);J.color.copy(V).multiplyScalar(Y),J.halfWidth.set(N.width*.5,0,0),J.halfHeight.set(0,N.height*.5,0),n.rectArea[M]=J,M++}else if(N.isPointLight){let J=t.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),J.distance=N.distance,J.decay=N.decay,N.castShadow){let Q=N.shadow,et=e.get(N);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,et.shadowCameraNear=Q.camera.near,et.shadowCameraFar=Q.camera.far,n.pointShadow[g]=et,n.pointShadowMap[g]=ct,n.pointShadowMatrix[g]=N.shadow.matrix,E++}n.point[g]=J,g++}else if(N.isHemisphereLight){let J=t.get(N);J.skyColor.copy(N.color).multiplyScalar(Y),J.groundColor.copy(N.groundColor).multiplyScalar(Y),n.hemi[x]=J,x++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ot.LTC_FLOAT_1,n.rectAreaLTC2=Ot.LTC_FLOAT_2):(n.rectAreaLTC1=Ot.LTC_HALF_1,n.rectAreaLTC2=Ot.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let P=n.hash;(P.sunLength!==d||P.directionalLength!==m||P.pointLength!==g||P.spotLength!==y||P.rectAreaLength!==M||P.hemiLength!==x||P.numSunShadows!==p||P.numDirectionalShadows!==R||P.numPointShadows!==E||P.numSpotShadows!==v||P.numSpotMaps!==b||P.numLightProbes!==T)&&(n.sun.length=d,n.directional.length=m,n.spot.length=y,n.rectArea.length=M,n.point.length=g,n.hemi.length=x,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+b-I,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=I,n.numLightProbes=T,P.sunLength=d,P.directionalLength=m,P.pointLength=g,P.spotLength=y,P.rectAreaLength=M,P.hemiLength=x,P.numSunShadows=p,P.numDirectionalShadows=R,P.numPointShadows=E,P.numSpotShadows=v,P.numSpotMaps=b,P.numLightProbes=T,n.version=U1++)}function l(c,h){let u=0,f=0,d=0,p=0,_=0,m=0,g=h.matrixWorldInverse;for(let y=0,M=c.length;y<M;y++){let x=c[y];if(x.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(x.matrixWorld),R.direction.transformDirection(g),u++}else if(x.isDirectionalLight){let R=n.directional[f];R.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),f++}else if(x.isSpotLight){let R=n.spot[p];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(g),R.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),p++}else if(x.isRectAreaLight){let R=n.rectArea[_];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(g),o.identity(),r.copy(x.matrixWorld),r.premultiply(g),o.extractRotation(r),R.halfWidth.set(x.width*.5,0,0),R.halfHeight.set(0,x.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),_++}else if(x.isPointLight){let R=n.point[d];R.position.setFromMatrixPosition(x.matrixWorld),R.position.applyMatrix4(g),d++}else if(x.isHemisphereLight){let R=n.hemi[m];R.direction.setFromMatrixPosition(x.matrixWorld),R.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function F0(i){let t=new O1(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function B1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new F0(i),t.set(s,[a])):r>=o.length?(a=new F0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var k1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,z1=`uniform sampler2D shadow_pass;
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
}`,G1=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],V1=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],O0=new De,Ka=new z,fd=new z;function H1(i,t,e){let n=new Fs,s=new _t,r=new _t,o=new Qe,a=new Uc,l=new Fc,c={},h=e.maxTextureSize,u={[Hs]:Yn,[Yn]:Hs,[fi]:fi},f=new Yi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new _t},radius:{value:4}},vertexShader:k1,fragmentShader:z1}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let p=new gn;p.setAttribute("position",new Pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Sn(p,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ha;let g=this.type;this.render=function(E,v,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Eg&&(te("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ha);let I=i.getRenderTarget(),T=i.getActiveCubeFace(),P=i.getActiveMipmapLevel(),O=i.state;O.setBlending(pr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let H=g!==this.type;H&&v.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=E.length;N<V;N++){let Y=E[N],W=Y.shadow;if(W===void 0){te("WebGLShadowMap:",Y,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let ct=W.getFrameExtents();s.multiply(ct),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,W.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(W.camera._reversedDepth=J,W.map===null||H===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===So){if(Y.isPointLight){te("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new ci(s.x,s.y,{format:Ws,type:Di,minFilter:qn,magFilter:qn,generateMipmaps:!1}),W.map.texture.name=Y.name+".shadowMap",W.map.depthTexture=new gs(s.x,s.y,vi),W.map.depthTexture.name=Y.name+".shadowMapDepth",W.map.depthTexture.format=fs,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=In,W.map.depthTexture.magFilter=In}else Y.isPointLight?(W.map=new Qa(s.x),W.map.depthTexture=new Ma(s.x,Li)):(W.map=new ci(s.x,s.y),W.map.depthTexture=new gs(s.x,s.y,Li)),W.map.depthTexture.name=Y.name+".shadowMap",W.map.depthTexture.format=fs,this.type===Ha?(W.map.depthTexture.compareFunction=J?Qf:jf,W.map.depthTexture.minFilter=qn,W.map.depthTexture.magFilter=qn):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=In,W.map.depthTexture.magFilter=In);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let Q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Y.isPointLight!==!0&&W.updateMatrices(Y,b);let et=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:b.layers;for(let dt=0;dt<Q;dt++){let ht=W.getCamera(dt);if(Y.isPointLight){let tt=W.camera,gt=W.matrix,xt=Y.distance||tt.far;xt!==tt.far&&(tt.far=xt,tt.updateProjectionMatrix()),Ka.setFromMatrixPosition(Y.matrixWorld),tt.position.copy(Ka),fd.copy(tt.position),fd.add(G1[dt]),tt.up.copy(V1[dt]),tt.lookAt(fd),tt.updateMatrixWorld(),gt.makeTranslation(-Ka.x,-Ka.y,-Ka.z),O0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),W._frustum.setFromProjectionMatrix(O0,tt.coordinateSystem,tt.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)i.setRenderTarget(W.map,dt),i.clear();else{dt===0&&(i.setRenderTarget(W.map),i.clear());let tt=W.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),O.viewport(o)}n=W.getFrustum(dt),x(v,b,ht,Y,et,this.type)}W.isPointLightShadow!==!0&&this.type===So&&y(W,b),W.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(I,T,P)};function y(E,v){let b=t.update(_);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,d.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),E.mapPass===null?E.mapPass=new ci(s.x,s.y,{format:Ws,type:Di}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),f.uniforms.shadow_pass.value=E.map.depthTexture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(v,null,b,f,_,null),d.uniforms.shadow_pass.value=E.mapPass.texture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(v,null,b,d,_,null)}function M(E,v,b,I){let T=null,P=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(P!==void 0)T=P;else if(T=b.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let O=T.uuid,H=v.uuid,N=c[O];N===void 0&&(N={},c[O]=N);let V=N[H];V===void 0&&(V=T.clone(),N[H]=V,v.addEventListener("dispose",R)),T=V}if(T.visible=v.visible,T.wireframe=v.wireframe,I===So?T.side=v.shadowSide!==null?v.shadowSide:v.side:T.side=v.shadowSide!==null?v.shadowSide:u[v.side],T.alphaMap=v.alphaMap,T.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,T.map=v.map,T.clipShadows=v.clipShadows,T.clippingPlanes=v.clippingPlanes,T.clipIntersection=v.clipIntersection,T.displacementMap=v.displacementMap,T.displacementScale=v.displacementScale,T.displacementBias=v.displacementBias,T.wireframeLinewidth=v.wireframeLinewidth,T.linewidth=v.linewidth,b.isPointLight===!0&&T.isMeshDistanceMaterial===!0){let O=i.properties.get(T);O.light=b}return T}function x(E,v,b,I,T,P){if(E.visible===!1)return;if(E.layers.test(T)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&P===So)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let N=t.update(E),V=E.material;if(Array.isArray(V)){let Y=N.groups;for(let W=0,ct=Y.length;W<ct;W++){let J=Y[W],Q=V[J.materialIndex];if(Q&&Q.visible){let et=M(E,Q,I,P);E.onBeforeShadow(i,E,v,b,N,et,J),i.renderBufferDirect(b,null,N,et,E,J),E.onAfterShadow(i,E,v,b,N,et,J)}}}else if(V.visible){let Y=M(E,V,I,P);E.onBeforeShadow(i,E,v,b,N,Y,null),i.renderBufferDirect(b,null,N,Y,E,null),E.onAfterShadow(i,E,v,b,N,Y,null)}}let H=E.children;for(let N=0,V=H.length;N<V;N++)x(H[N],v,b,I,T,P)}function R(E){E.target.removeEventListener("dispose",R);for(let b in c){let I=c[b],T=E.target.uuid;T in I&&(I[T].dispose(),delete I[T])}}}function W1(i,t){function e(){let k=!1,rt=new Qe,it=null,Ct=new Qe(0,0,0,0);return{setMask:function(St){it!==St&&!k&&(i.colorMask(St,St,St,St),it=St)},setLocked:function(St){k=St},setClear:function(St,Rt,Kt,ae,ut){ut===!0&&(St*=ae,Rt*=ae,Kt*=ae),rt.set(St,Rt,Kt,ae),Ct.equals(rt)===!1&&(i.clearColor(St,Rt,Kt,ae),Ct.copy(rt))},reset:function(){k=!1,it=null,Ct.set(-1,0,0,0)}}}function n(){let k=!1,rt=!1,it=null,Ct=null,St=null;return{setReversed:function(Rt){if(rt!==Rt){let Kt=t.get("EXT_clip_control");Rt?Kt.clipControlEXT(Kt.LOWER_LEFT_EXT,Kt.ZERO_TO_ONE_EXT):Kt.clipControlEXT(Kt.LOWER_LEFT_EXT,Kt.NEGATIVE_ONE_TO_ONE_EXT),rt=Rt;let ae=St;St=null,this.setClear(ae)}},getReversed:function(){return rt},setTest:function(Rt){Rt?wt(i.DEPTH_TEST):Vt(i.DEPTH_TEST)},setMask:function(Rt){it!==Rt&&!k&&(i.depthMask(Rt),it=Rt)},setFunc:function(Rt){if(rt&&(Rt=o0[Rt]),Ct!==Rt){switch(Rt){case uc:i.depthFunc(i.NEVER);break;case fc:i.depthFunc(i.ALWAYS);break;case dc:i.depthFunc(i.LESS);break;case oo:i.depthFunc(i.LEQUAL);break;case pc:i.depthFunc(i.EQUAL);break;case mc:i.depthFunc(i.GEQUAL);break;case gc:i.depthFunc(i.GREATER);break;case _c:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ct=Rt}},setLocked:function(Rt){k=Rt},setClear:function(Rt){St!==Rt&&(St=Rt,rt&&(Rt=1-Rt),i.clearDepth(Rt))},reset:function(){k=!1,it=null,Ct=null,St=null,rt=!1}}}function s(){let k=!1,rt=null,it=null,Ct=null,St=null,Rt=null,Kt=null,ae=null,ut=null;return{setTest:function(qt){k||(qt?wt(i.STENCIL_TEST):Vt(i.STENCIL_TEST))},setMask:function(qt){rt!==qt&&!k&&(i.stencilMask(qt),rt=qt)},setFunc:function(qt,le,Nt){(it!==qt||Ct!==le||St!==Nt)&&(i.stencilFunc(qt,le,Nt),it=qt,Ct=le,St=Nt)},setOp:function(qt,le,Nt){(Rt!==qt||Kt!==le||ae!==Nt)&&(i.stencilOp(qt,le,Nt),Rt=qt,Kt=le,ae=Nt)},setLocked:function(qt){k=qt},setClear:function(qt){ut!==qt&&(i.clearStencil(qt),ut=qt)},reset:function(){k=!1,rt=null,it=null,Ct=null,St=null,Rt=null,Kt=null,ae=null,ut=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,p=[],_=null,m=!1,g=null,y=null,M=null,x=null,R=null,E=null,v=null,b=new oe(0,0,0),I=0,T=!1,P=null,O=null,H=null,N=null,V=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ct=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(J)[1]),W=ct>=1):J.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),W=ct>=2);let Q=null,et={},dt=i.getParameter(i.SCISSOR_BOX),ht=i.getParameter(i.VIEWPORT),tt=new Qe().fromArray(dt),gt=new Qe().fromArray(ht);function xt(k,rt,it,Ct){let St=new Uint8Array(4),Rt=i.createTexture();i.bindTexture(k,Rt),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Kt=0;Kt<it;Kt++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,Ct,0,i.RGBA,i.UNSIGNED_BYTE,St):i.texImage2D(rt+Kt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,St);return Rt}let Lt={};Lt[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),Lt[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Lt[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(i.DEPTH_TEST),o.setFunc(oo),Bt(!1),Dt(Lf),wt(i.CULL_FACE),vt(pr);function wt(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function Vt(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function ie(k,rt){return f[k]!==rt?(i.bindFramebuffer(k,rt),f[k]=rt,k===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=rt),k===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Jt(k,rt){let it=p,Ct=!1;if(k){it=d.get(rt),it===void 0&&(it=[],d.set(rt,it));let St=k.textures;if(it.length!==St.length||it[0]!==i.COLOR_ATTACHMENT0){for(let Rt=0,Kt=St.length;Rt<Kt;Rt++)it[Rt]=i.COLOR_ATTACHMENT0+Rt;it.length=St.length,Ct=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,Ct=!0);Ct&&i.drawBuffers(it)}function se(k){return _!==k?(i.useProgram(k),_=k,!0):!1}let ne={[mr]:i.FUNC_ADD,[Rg]:i.FUNC_SUBTRACT,[Cg]:i.FUNC_REVERSE_SUBTRACT};ne[Pg]=i.MIN,ne[Ig]=i.MAX;let ot={[Lg]:i.ZERO,[Dg]:i.ONE,[Ng]:i.SRC_COLOR,[Ff]:i.SRC_ALPHA,[zg]:i.SRC_ALPHA_SATURATE,[Bg]:i.DST_COLOR,[Fg]:i.DST_ALPHA,[Ug]:i.ONE_MINUS_SRC_COLOR,[Of]:i.ONE_MINUS_SRC_ALPHA,[kg]:i.ONE_MINUS_DST_COLOR,[Og]:i.ONE_MINUS_DST_ALPHA,[Gg]:i.CONSTANT_COLOR,[Vg]:i.ONE_MINUS_CONSTANT_COLOR,[Hg]:i.CONSTANT_ALPHA,[Wg]:i.ONE_MINUS_CONSTANT_ALPHA};function vt(k,rt,it,Ct,St,Rt,Kt,ae,ut,qt){if(k===pr){m===!0&&(Vt(i.BLEND),m=!1);return}if(m===!1&&(wt(i.BLEND),m=!0),k!==Ag){if(k!==g||qt!==T){if((y!==mr||R!==mr)&&(i.blendEquation(i.FUNC_ADD),y=mr,R=mr),qt)switch(k){case Mo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Df:i.blendFunc(i.ONE,i.ONE);break;case Nf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Uf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ce("WebGLState: Invalid blending: ",k);break}else switch(k){case Mo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Df:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Nf:ce("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Uf:ce("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ce("WebGLState: Invalid blending: ",k);break}M=null,x=null,E=null,v=null,b.set(0,0,0),I=0,g=k,T=qt}return}St=St||rt,Rt=Rt||it,Kt=Kt||Ct,(rt!==y||St!==R)&&(i.blendEquationSeparate(ne[rt],ne[St]),y=rt,R=St),(it!==M||Ct!==x||Rt!==E||Kt!==v)&&(i.blendFuncSeparate(ot[it],ot[Ct],ot[Rt],ot[Kt]),M=it,x=Ct,E=Rt,v=Kt),(ae.equals(b)===!1||ut!==I)&&(i.blendColor(ae.r,ae.g,ae.b,ut),b.copy(ae),I=ut),g=k,T=!1}function yt(k,rt){k.side===fi?Vt(i.CULL_FACE):wt(i.CULL_FACE);let it=k.side===Yn;rt&&(it=!it),Bt(it),k.blending===Mo&&k.transparent===!1?vt(pr):vt(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ct=k.stencilWrite;a.setTest(Ct),Ct&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),kt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?wt(i.SAMPLE_ALPHA_TO_COVERAGE):Vt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Bt(k){P!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),P=k)}function Dt(k){k!==wg?(wt(i.CULL_FACE),k!==O&&(k===Lf?i.cullFace(i.BACK):k===Tg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Vt(i.CULL_FACE),O=k}function ee(k){k!==H&&(W&&i.lineWidth(k),H=k)}function kt(k,rt,it){k?(wt(i.POLYGON_OFFSET_FILL),(N!==rt||V!==it)&&(N=rt,V=it,o.getReversed()&&(rt=-rt,it=-it),i.polygonOffset(rt,it))):Vt(i.POLYGON_OFFSET_FILL)}function me(k){k?wt(i.SCISSOR_TEST):Vt(i.SCISSOR_TEST)}function fe(k){k===void 0&&(k=i.TEXTURE0+Y-1),Q!==k&&(i.activeTexture(k),Q=k)}function _e(k,rt,it){it===void 0&&(Q===null?it=i.TEXTURE0+Y-1:it=Q);let Ct=et[it];Ct===void 0&&(Ct={type:void 0,texture:void 0},et[it]=Ct),(Ct.type!==k||Ct.texture!==rt)&&(Q!==it&&(i.activeTexture(it),Q=it),i.bindTexture(k,rt||Lt[k]),Ct.type=k,Ct.texture=rt)}function B(){let k=et[Q];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Mt(){try{i.compressedTexImage2D(...arguments)}catch(k){ce("WebGLState:",k)}}function Xt(){try{i.compressedTexImage3D(...arguments)}catch(k){ce("WebGLState:",k)}}function he(){try{i.texSubImage2D(...arguments)}catch(k){ce("WebGLState:",k)}}function Tt(){try{i.texSubImage3D(...arguments)}catch(k){ce("WebGLState:",k)}}function Ue(){try{i.compressedTexSubImage2D(...arguments)}catch(k){ce("WebGLState:",k)}}function $t(){try{i.compressedTexSubImage3D(...arguments)}catch(k){ce("WebGLState:",k)}}function Qt(){try{i.texStorage2D(...arguments)}catch(k){ce("WebGLState:",k)}}function L(){try{i.texStorage3D(...arguments)}catch(k){ce("WebGLState:",k)}}function w(){try{i.texImage2D(...arguments)}catch(k){ce("WebGLState:",k)}}function q(){try{i.texImage3D(...arguments)}catch(k){ce("WebGLState:",k)}}function ft(k){return u[k]!==void 0?u[k]:i.getParameter(k)}function at(k,rt){u[k]!==rt&&(i.pixelStorei(k,rt),u[k]=rt)}function bt(k){tt.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),tt.copy(k))}function Et(k){gt.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),gt.copy(k))}function nt(k,rt){let it=c.get(rt);it===void 0&&(it=new WeakMap,c.set(rt,it));let Ct=it.get(k);Ct===void 0&&(Ct=i.getUniformBlockIndex(rt,k.name),i.uniformBlockBinding(rt,Ct,Ct),it.set(k,Ct))}function st(k,rt,it){let St=c.get(rt).get(k);l[St]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,St,it),l[St]=it)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,et={},f={},l={},d=new WeakMap,p=[],_=null,m=!1,g=null,y=null,M=null,x=null,R=null,E=null,v=null,b=new oe(0,0,0),I=0,T=!1,P=null,O=null,H=null,N=null,V=null,tt.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:Vt,bindFramebuffer:ie,drawBuffers:Jt,useProgram:se,setBlending:vt,setMaterial:yt,setFlipSided:Bt,setCullFace:Dt,setLineWidth:ee,setPolygonOffset:kt,setScissorTest:me,activeTexture:fe,bindTexture:_e,unbindTexture:B,compressedTexImage2D:Mt,compressedTexImage3D:Xt,texImage2D:w,texImage3D:q,pixelStorei:at,getParameter:ft,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Qt,texStorage3D:L,texSubImage2D:he,texSubImage3D:Tt,compressedTexSubImage2D:Ue,compressedTexSubImage3D:$t,scissor:bt,viewport:Et,reset:mt}}function X1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new _t,h=new WeakMap,u=new Set,f,d=new WeakMap,p=new Set,_=new FinalizationRegistry(L=>p.delete(L)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,w){return m?new OffscreenCanvas(L,w):ua("canvas")}function y(L,w,q){let ft=1,at=Qt(L);if((at.width>q||at.height>q)&&(ft=q/Math.max(at.width,at.height)),ft<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let bt=Math.floor(ft*at.width),Et=Math.floor(ft*at.height);f===void 0&&(f=g(bt,Et));let nt=w?g(bt,Et):f;return nt.width=bt,nt.height=Et,nt.getContext("2d").drawImage(L,0,0,bt,Et),te("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+bt+"x"+Et+")."),nt}else return"data"in L&&te("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),L;return L}function M(L){return L.generateMipmaps}function x(L){i.generateMipmap(L)}function R(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(L,w,q,ft,at,bt=!1){if(L!==null){if(i[L]!==void 0)return i[L];te("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let Et;ft&&(Et=t.get("EXT_texture_norm16"),Et||te("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=w;if(w===i.RED&&(q===i.FLOAT&&(nt=i.R32F),q===i.HALF_FLOAT&&(nt=i.R16F),q===i.UNSIGNED_BYTE&&(nt=i.R8),q===i.UNSIGNED_SHORT&&Et&&(nt=Et.R16_EXT),q===i.SHORT&&Et&&(nt=Et.R16_SNORM_EXT)),w===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.R8UI),q===i.UNSIGNED_SHORT&&(nt=i.R16UI),q===i.UNSIGNED_INT&&(nt=i.R32UI),q===i.BYTE&&(nt=i.R8I),q===i.SHORT&&(nt=i.R16I),q===i.INT&&(nt=i.R32I)),w===i.RG&&(q===i.FLOAT&&(nt=i.RG32F),q===i.HALF_FLOAT&&(nt=i.RG16F),q===i.UNSIGNED_BYTE&&(nt=i.RG8),q===i.UNSIGNED_SHORT&&Et&&(nt=Et.RG16_EXT),q===i.SHORT&&Et&&(nt=Et.RG16_SNORM_EXT)),w===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RG8UI),q===i.UNSIGNED_SHORT&&(nt=i.RG16UI),q===i.UNSIGNED_INT&&(nt=i.RG32UI),q===i.BYTE&&(nt=i.RG8I),q===i.SHORT&&(nt=i.RG16I),q===i.INT&&(nt=i.RG32I)),w===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),q===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),q===i.UNSIGNED_INT&&(nt=i.RGB32UI),q===i.BYTE&&(nt=i.RGB8I),q===i.SHORT&&(nt=i.RGB16I),q===i.INT&&(nt=i.RGB32I)),w===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),q===i.UNSIGNED_INT&&(nt=i.RGBA32UI),q===i.BYTE&&(nt=i.RGBA8I),q===i.SHORT&&(nt=i.RGBA16I),q===i.INT&&(nt=i.RGBA32I)),w===i.RGB&&(q===i.UNSIGNED_SHORT&&Et&&(nt=Et.RGB16_EXT),q===i.SHORT&&Et&&(nt=Et.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),w===i.RGBA){let st=bt?ha:Re.getTransfer(at);q===i.FLOAT&&(nt=i.RGBA32F),q===i.HALF_FLOAT&&(nt=i.RGBA16F),q===i.UNSIGNED_BYTE&&(nt=st===Oe?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&Et&&(nt=Et.RGBA16_EXT),q===i.SHORT&&Et&&(nt=Et.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function v(L,w){let q;return L?w===null||w===Li||w===_r?q=i.DEPTH24_STENCIL8:w===vi?q=i.DEPTH32F_STENCIL8:w===wo&&(q=i.DEPTH24_STENCIL8,te("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Li||w===_r?q=i.DEPTH_COMPONENT24:w===vi?q=i.DEPTH_COMPONENT32F:w===wo&&(q=i.DEPTH_COMPONENT16),q}function b(L,w){return M(L)===!0||L.isFramebufferTexture&&L.minFilter!==In&&L.minFilter!==qn?Math.log2(Math.max(w.width,w.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?w.mipmaps.length:1}function I(L){let w=new WeakRef(L);n.get(L).__ref=w,p.add(w),_.register(L,w,w)}function T(L){let w=n.get(L).__ref;w!==void 0&&(p.delete(w),_.unregister(w))}function P(L){H(L.target)}function O(L){N(L.target)}function H(L){L.removeEventListener("dispose",P),T(L),Y(L),L.isVideoTexture&&h.delete(L),L.isHTMLTexture&&u.delete(L)}function N(L){L.removeEventListener("dispose",O),T(L),ct(L)}function V(){for(let L of p){let w=L.deref();w!==void 0&&(w.isRenderTarget===!0?N(w):H(w))}p.clear(),u.clear()}function Y(L){let w=n.get(L);if(w.__webglInit===void 0)return;let q=L.source,ft=d.get(q);if(ft){let at=ft[w.__cacheKey];at.usedTimes--,at.usedTimes===0&&W(L),Object.keys(ft).length===0&&d.delete(q)}n.remove(L)}function W(L){let w=n.get(L);i.deleteTexture(w.__webglTexture);let q=L.source,ft=d.get(q);delete ft[w.__cacheKey],o.memory.textures--}function ct(L){let w=n.get(L);w.__depthDisposeCallback&&w.__depthDisposeCallback();let q=L.depthTexture;if(q&&q.renderTarget===L&&H(q),L.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(w.__webglFramebuffer[at]))for(let bt=0;bt<w.__webglFramebuffer[at].length;bt++)i.deleteFramebuffer(w.__webglFramebuffer[at][bt]);else i.deleteFramebuffer(w.__webglFramebuffer[at]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[at])}else{if(Array.isArray(w.__webglFramebuffer))for(let at=0;at<w.__webglFramebuffer.length;at++)i.deleteFramebuffer(w.__webglFramebuffer[at]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let at=0;at<w.__webglColorRenderbuffer.length;at++)w.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[at]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let ft=L.textures;for(let at=0,bt=ft.length;at<bt;at++){let Et=n.get(ft[at]);Et.__webglTexture&&(i.deleteTexture(Et.__webglTexture),o.memory.textures--),n.remove(ft[at])}n.remove(L)}let J=0;function Q(){J=0}function et(){return J}function dt(L){J=L}function ht(){let L=J;return L>=s.maxTextures&&te("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,L}function tt(L){let w=[];return w.push(L.wrapS),w.push(L.wrapT),w.push(L.wrapR||0),w.push(L.magFilter),w.push(L.minFilter),w.push(L.anisotropy),w.push(L.internalFormat),w.push(L.format),w.push(L.type),w.push(L.generateMipmaps),w.push(L.mipmapsAutoUpdate),w.push(L.premultiplyAlpha),w.push(L.flipY),w.push(L.unpackAlignment),w.push(L.colorSpace),w.join()}function gt(L,w){let q=n.get(L);if(L.isVideoTexture&&Ue(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&q.__version!==L.version){let ft=L.image;if(ft===null)te("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)te("WebGLRenderer: Texture marked for update but image is incomplete");else{yt(q,L,w);return}}else L.isExternalTexture&&(q.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+w)}function xt(L,w){let q=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&q.__version!==L.version){yt(q,L,w);return}else L.isExternalTexture&&(q.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+w)}function Lt(L,w){let q=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&q.__version!==L.version){yt(q,L,w);return}e.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+w)}function wt(L,w){let q=n.get(L);if(L.version>0&&q.__version!==L.version){Bt(q,L,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+w)}let Vt={[yc]:i.REPEAT,[Wi]:i.CLAMP_TO_EDGE,[xc]:i.MIRRORED_REPEAT},ie={[In]:i.NEAREST,[Yg]:i.NEAREST_MIPMAP_NEAREST,[Wa]:i.NEAREST_MIPMAP_LINEAR,[qn]:i.LINEAR,[jc]:i.LINEAR_MIPMAP_NEAREST,[_s]:i.LINEAR_MIPMAP_LINEAR},Jt={[Kg]:i.NEVER,[td]:i.ALWAYS,[jg]:i.LESS,[jf]:i.LEQUAL,[Qg]:i.EQUAL,[Qf]:i.GEQUAL,[t0]:i.GREATER,[e0]:i.NOTEQUAL};function se(L,w){if(w.type===vi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===qn||w.magFilter===jc||w.magFilter===Wa||w.magFilter===_s||w.minFilter===qn||w.minFilter===jc||w.minFilter===Wa||w.minFilter===_s)&&te("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,Vt[w.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,Vt[w.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,Vt[w.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,ie[w.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,ie[w.minFilter]),w.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,Jt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===In||w.minFilter!==Wa&&w.minFilter!==_s||w.type===vi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");i.texParameterf(L,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function ne(L,w){let q=!1;L.__webglInit===void 0&&(L.__webglInit=!0,w.addEventListener("dispose",P),I(w));let ft=w.source,at=d.get(ft);at===void 0&&(at={},d.set(ft,at));let bt=tt(w);if(bt!==L.__cacheKey){at[bt]===void 0&&(at[bt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[bt].usedTimes++;let Et=at[L.__cacheKey];Et!==void 0&&(at[L.__cacheKey].usedTimes--,Et.usedTimes===0&&W(w)),L.__cacheKey=bt,L.__webglTexture=at[bt].texture}return q}function ot(L,w,q){return Math.floor(Math.floor(L/q)/w)}function vt(L,w,q,ft){let bt=L.updateRanges;if(bt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,q,ft,w.data);else{bt.sort((k,rt)=>k.start-rt.start);let Et=0;for(let k=1;k<bt.length;k++){let rt=bt[Et],it=bt[k],Ct=rt.start+rt.count,St=ot(it.start,w.width,4),Rt=ot(rt.start,w.width,4);it.start<=Ct+1&&St===Rt&&ot(it.start+it.count-1,w.width,4)===St?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++Et,bt[Et]=it)}bt.length=Et+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let k=0,rt=bt.length;k<rt;k++){let it=bt[k],Ct=Math.floor(it.start/4),St=Math.ceil(it.count/4),Rt=Ct%w.width,Kt=Math.floor(Ct/w.width),ae=St,ut=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Kt),e.texSubImage2D(i.TEXTURE_2D,0,Rt,Kt,ae,ut,q,ft,w.data)}L.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function yt(L,w,q){let ft=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(ft=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(ft=i.TEXTURE_3D);let at=ne(L,w),bt=w.source;e.bindTexture(ft,L.__webglTexture,i.TEXTURE0+q);let Et=n.get(bt);if(bt.version!==Et.__version||at===!0){if(e.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ut=Re.getPrimaries(Re.workingColorSpace),qt=w.colorSpace===xs?null:Re.getPrimaries(w.colorSpace),le=w.colorSpace===xs||ut===qt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,le)}e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let st=y(w.image,!1,s.maxTextureSize);st=$t(w,st);let mt=r.convert(w.format,w.colorSpace),k=r.convert(w.type),rt=E(w.internalFormat,mt,k,w.normalized,w.colorSpace,w.isVideoTexture);se(ft,w);let it,Ct=w.mipmaps,St=w.isVideoTexture!==!0,Rt=Et.__version===void 0||at===!0,Kt=bt.dataReady,ae=b(w,st);if(w.isDepthTexture)rt=v(w.format===ys,w.type),Rt&&(St?e.texStorage2D(i.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,mt,k,null));else if(w.isDataTexture)if(Ct.length>0){St&&Rt&&e.texStorage2D(i.TEXTURE_2D,ae,rt,Ct[0].width,Ct[0].height);for(let ut=0,qt=Ct.length;ut<qt;ut++)it=Ct[ut],St?Kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,k,it.data):e.texImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,mt,k,it.data);w.generateMipmaps=!1}else St?(Rt&&e.texStorage2D(i.TEXTURE_2D,ae,rt,st.width,st.height),Kt&&vt(w,st,mt,k)):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,mt,k,st.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){St&&Rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ae,rt,Ct[0].width,Ct[0].height,st.depth);for(let ut=0,qt=Ct.length;ut<qt;ut++)if(it=Ct[ut],w.format!==Ni)if(mt!==null)if(St){if(Kt)if(w.layerUpdates.size>0){let le=hd(it.width,it.height,w.format,w.type);for(let Nt of w.layerUpdates){let ge=it.data.subarray(Nt*le/it.data.BYTES_PER_ELEMENT,(Nt+1)*le/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,Nt,it.width,it.height,1,mt,ge)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,mt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ut,rt,it.width,it.height,st.depth,0,it.data,0,0);else te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else St?Kt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,mt,k,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ut,rt,it.width,it.height,st.depth,0,mt,k,it.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{St&&Rt&&e.texStorage2D(i.TEXTURE_2D,ae,rt,Ct[0].width,Ct[0].height);for(let ut=0,qt=Ct.length;ut<qt;ut++)it=Ct[ut],w.format!==Ni?mt!==null?St?Kt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,it.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):St?Kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,mt,k,it.data):e.texImage2D(i.TEXTURE_2D,ut,rt,it.width,it.height,0,mt,k,it.data)}else if(w.isDataArrayTexture)if(St){if(Rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ae,rt,st.width,st.height,st.depth),Kt)if(w.layerUpdates.size>0){let ut=hd(st.width,st.height,w.format,w.type);for(let qt of w.layerUpdates){let le=st.data.subarray(qt*ut/st.data.BYTES_PER_ELEMENT,(qt+1)*ut/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,qt,st.width,st.height,1,mt,k,le)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,k,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,k,st.data);else if(w.isData3DTexture)St?(Rt&&e.texStorage3D(i.TEXTURE_3D,ae,rt,st.width,st.height,st.depth),Kt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,k,st.data)):e.texImage3D(i.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,k,st.data);else if(w.isFramebufferTexture){if(Rt)if(St)e.texStorage2D(i.TEXTURE_2D,ae,rt,st.width,st.height);else{let ut=st.width,qt=st.height;for(let le=0;le<ae;le++)e.texImage2D(i.TEXTURE_2D,le,rt,ut,qt,0,mt,k,null),ut>>=1,qt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let ut=i.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),st.parentNode!==ut){ut.appendChild(st),u.add(w),ut.onpaint=qt=>{let le=qt.changedElements;for(let Nt of u)le.includes(Nt.image)&&(Nt.needsUpdate=!0)},ut.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let le=i.RGBA,Nt=i.RGBA,ge=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,le,Nt,ge,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ct.length>0){if(St&&Rt){let ut=Qt(Ct[0]);e.texStorage2D(i.TEXTURE_2D,ae,rt,ut.width,ut.height)}for(let ut=0,qt=Ct.length;ut<qt;ut++)it=Ct[ut],St?Kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,mt,k,it):e.texImage2D(i.TEXTURE_2D,ut,rt,mt,k,it);w.generateMipmaps=!1}else if(St){if(Rt){let ut=Qt(st);e.texStorage2D(i.TEXTURE_2D,ae,rt,ut.width,ut.height)}Kt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,k,st)}else e.texImage2D(i.TEXTURE_2D,0,rt,mt,k,st);M(w)&&w.mipmapsAutoUpdate===!0&&x(ft),Et.__version=bt.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function Bt(L,w,q){if(w.image.length!==6)return;let ft=ne(L,w),at=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+q);let bt=n.get(at);if(at.version!==bt.__version||ft===!0){e.activeTexture(i.TEXTURE0+q);let Et=Re.getPrimaries(Re.workingColorSpace),nt=w.colorSpace===xs?null:Re.getPrimaries(w.colorSpace),st=w.colorSpace===xs||Et===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,rt=[];for(let Nt=0;Nt<6;Nt++)!mt&&!k?rt[Nt]=y(w.image[Nt],!0,s.maxCubemapSize):rt[Nt]=k?w.image[Nt].image:w.image[Nt],rt[Nt]=$t(w,rt[Nt]);let it=rt[0],Ct=r.convert(w.format,w.colorSpace),St=r.convert(w.type),Rt=E(w.internalFormat,Ct,St,w.normalized,w.colorSpace),Kt=w.isVideoTexture!==!0,ae=bt.__version===void 0||ft===!0,ut=at.dataReady,qt=b(w,it);se(i.TEXTURE_CUBE_MAP,w);let le;if(w.isDepthTexture){if(Rt=v(w.format===ys,w.type),ae)if(Kt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,Rt,it.width,it.height);else for(let Nt=0;Nt<6;Nt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Rt,it.width,it.height,0,Ct,St,null)}else if(mt){Kt&&ae&&e.texStorage2D(i.TEXTURE_CUBE_MAP,qt,Rt,it.width,it.height);for(let Nt=0;Nt<6;Nt++){le=rt[Nt].mipmaps;for(let ge=0;ge<le.length;ge++){let qe=le[ge];w.format!==Ni?Ct!==null?Kt?ut&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge,0,0,qe.width,qe.height,Ct,qe.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge,Rt,qe.width,qe.height,0,qe.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge,0,0,qe.width,qe.height,Ct,St,qe.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge,Rt,qe.width,qe.height,0,Ct,St,qe.data)}}}else{if(le=w.mipmaps,Kt&&ae){le.length>0&&qt++;let Nt=Qt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,qt,Rt,Nt.width,Nt.height)}for(let Nt=0;Nt<6;Nt++)if(k){Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,0,0,rt[Nt].width,rt[Nt].height,Ct,St,rt[Nt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Rt,rt[Nt].width,rt[Nt].height,0,Ct,St,rt[Nt].data);for(let ge=0;ge<le.length;ge++){let kn=le[ge].image[Nt].image;Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge+1,0,0,kn.width,kn.height,Ct,St,kn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge+1,Rt,kn.width,kn.height,0,Ct,St,kn.data)}}else{Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,0,0,Ct,St,rt[Nt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Rt,Ct,St,rt[Nt]);for(let ge=0;ge<le.length;ge++){let qe=le[ge];Kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge+1,0,0,Ct,St,qe.image[Nt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,ge+1,Rt,Ct,St,qe.image[Nt])}}}M(w)&&w.mipmapsAutoUpdate===!0&&x(i.TEXTURE_CUBE_MAP),bt.__version=at.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function Dt(L,w,q,ft,at,bt){let Et=r.convert(q.format,q.colorSpace),nt=r.convert(q.type),st=E(q.internalFormat,Et,nt,q.normalized,q.colorSpace),mt=n.get(w),k=n.get(q);if(k.__renderTarget=w,!mt.__hasExternalTextures){let rt=Math.max(1,w.width>>bt),it=Math.max(1,w.height>>bt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,bt,st,rt,it,w.depth,0,Et,nt,null):e.texImage2D(at,bt,st,rt,it,0,Et,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,L),Tt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ft,at,k.__webglTexture,0,he(w)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ft,at,k.__webglTexture,bt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ee(L,w,q){if(i.bindRenderbuffer(i.RENDERBUFFER,L),w.depthBuffer){let ft=w.depthTexture,at=ft&&ft.isDepthTexture?ft.type:null,bt=v(w.stencilBuffer,at),Et=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Tt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,he(w),bt,w.width,w.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,he(w),bt,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,bt,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Et,i.RENDERBUFFER,L)}else{let ft=w.textures;for(let at=0;at<ft.length;at++){let bt=ft[at],Et=r.convert(bt.format,bt.colorSpace),nt=r.convert(bt.type),st=E(bt.internalFormat,Et,nt,bt.normalized,bt.colorSpace);Tt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,he(w),st,w.width,w.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,he(w),st,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,st,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function kt(L,w,q){let ft=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,L),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(w.depthTexture);at.__renderTarget=w;let bt=ft?w.depthTexture.image[0]:w.depthTexture.image;(!at.__webglTexture||bt.width!==w.width||bt.height!==w.height)&&(bt.width=w.width,bt.height=w.height,w.depthTexture.needsUpdate=!0),ft?wt(w.depthTexture,0):gt(w.depthTexture,0);let Et=at.__webglTexture,nt=he(w),st=ft?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,mt=w.depthTexture.format===ys?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===fs)Tt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,Et,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,Et,0);else if(w.depthTexture.format===ys)Tt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,Et,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,Et,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function me(L){let w=n.get(L),q=L.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==L.depthTexture){let ft=L.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),ft){let at=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,ft.removeEventListener("dispose",at)};ft.addEventListener("dispose",at),w.__depthDisposeCallback=at}w.__boundDepthTexture=ft}if(L.depthTexture&&!w.__autoAllocateDepthBuffer)if(q)for(let ft=0;ft<6;ft++)kt(w.__webglFramebuffer[ft],L,ft);else L.texture.mipmaps.length>0?kt(w.__webglFramebuffer[0],L,0):kt(w.__webglFramebuffer,L,0);else if(q){w.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[ft]),w.__webglDepthbuffer[ft]===void 0)w.__webglDepthbuffer[ft]=i.createRenderbuffer(),ee(w.__webglDepthbuffer[ft],L,!1);else{let at=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,bt=w.__webglDepthbuffer[ft];i.bindRenderbuffer(i.RENDERBUFFER,bt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,bt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),ee(w.__webglDepthbuffer,L,!1);else{let at=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,bt=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,bt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,bt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function fe(L,w,q){let ft=n.get(L);w!==void 0&&Dt(ft.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&me(L)}function _e(L){let w=L.texture,q=n.get(L),ft=n.get(w);L.addEventListener("dispose",O),I(L);let at=L.textures,bt=L.isWebGLCubeRenderTarget===!0,Et=at.length>1;if(Et||(ft.__webglTexture===void 0&&(ft.__webglTexture=i.createTexture()),ft.__version=w.version,o.memory.textures++),bt){q.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0){q.__webglFramebuffer[nt]=[];for(let st=0;st<w.mipmaps.length;st++)q.__webglFramebuffer[nt][st]=i.createFramebuffer()}else q.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(w.mipmaps.length>0){q.__webglFramebuffer=[];for(let nt=0;nt<w.mipmaps.length;nt++)q.__webglFramebuffer[nt]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(Et)for(let nt=0,st=at.length;nt<st;nt++){let mt=n.get(at[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&Tt(L)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];q.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[nt]);let mt=r.convert(st.format,st.colorSpace),k=r.convert(st.type),rt=E(st.internalFormat,mt,k,st.normalized,st.colorSpace,L.isXRRenderTarget===!0),it=he(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,rt,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,q.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),ee(q.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(bt){e.bindTexture(i.TEXTURE_CUBE_MAP,ft.__webglTexture),se(i.TEXTURE_CUBE_MAP,w);for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Dt(q.__webglFramebuffer[nt][st],L,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Dt(q.__webglFramebuffer[nt],L,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);M(w)?x(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(Et){for(let nt=0,st=at.length;nt<st;nt++){let mt=at[nt],k=n.get(mt),rt=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(rt=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,k.__webglTexture),se(rt,mt),Dt(q.__webglFramebuffer,L,mt,i.COLOR_ATTACHMENT0+nt,rt,0),M(mt)&&x(rt)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(nt=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,ft.__webglTexture),se(nt,w),w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Dt(q.__webglFramebuffer[st],L,w,i.COLOR_ATTACHMENT0,nt,st);else Dt(q.__webglFramebuffer,L,w,i.COLOR_ATTACHMENT0,nt,0);M(w)?x(nt):w.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&me(L)}function B(L){let w=L.textures;for(let q=0,ft=w.length;q<ft;q++){let at=w[q];if(M(at)&&at.mipmapsAutoUpdate===!0){let bt=R(L),Et=n.get(at).__webglTexture;e.bindTexture(bt,Et),x(bt),e.unbindTexture()}}}let Mt=[];function Xt(L){if(L.samples>0){if(Tt(L)===!1){let w=L.textures,q=L.width,ft=L.height,at=i.COLOR_BUFFER_BIT,bt=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Et=n.get(L),nt=w.length>1;if(nt)for(let mt=0;mt<w.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Et.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Et.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Et.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Et.__webglFramebuffer);for(let mt=0;mt<w.length;mt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Et.__webglColorRenderbuffer[mt]);let k=n.get(w[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,q,ft,0,0,q,ft,at,i.NEAREST),l===!0&&(Mt.length=0,Mt.push(i.COLOR_ATTACHMENT0+mt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Mt.push(bt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Mt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<w.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,Et.__webglColorRenderbuffer[mt]);let k=n.get(w[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Et.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,k,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Et.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let w=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function he(L){return Math.min(s.maxSamples,L.samples)}function Tt(L){let w=n.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Ue(L){let w=o.render.frame;h.get(L)!==w&&(h.set(L,w),L.update())}function $t(L,w){let q=L.colorSpace,ft=L.format,at=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||q!==ca&&q!==xs&&(Re.getTransfer(q)===Oe?(ft!==Ni||at!==Zn)&&te("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ce("WebGLTextures: Unsupported texture color space:",q)),w}function Qt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=ht,this.resetTextureUnits=Q,this.getTextureUnits=et,this.setTextureUnits=dt,this.setTexture2D=gt,this.setTexture2DArray=xt,this.setTexture3D=Lt,this.setTextureCube=wt,this.rebindTextures=fe,this.setupRenderTarget=_e,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Xt,this.setupDepthRenderbuffer=me,this.setupFrameBufferTexture=Dt,this.useMultisampledRTT=Tt,this.dispose=V}function q1(i,t){function e(n,s=xs){let r,o=Re.getTransfer(s);if(n===Zn)return i.UNSIGNED_BYTE;if(n===th)return i.UNSIGNED_SHORT_4_4_4_4;if(n===eh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===$f)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Zf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===qf)return i.BYTE;if(n===Yf)return i.SHORT;if(n===wo)return i.UNSIGNED_SHORT;if(n===Qc)return i.INT;if(n===Li)return i.UNSIGNED_INT;if(n===vi)return i.FLOAT;if(n===Di)return i.HALF_FLOAT;if(n===Jf)return i.ALPHA;if(n===Kf)return i.RGB;if(n===Ni)return i.RGBA;if(n===fs)return i.DEPTH_COMPONENT;if(n===ys)return i.DEPTH_STENCIL;if(n===nh)return i.RED;if(n===ih)return i.RED_INTEGER;if(n===Ws)return i.RG;if(n===sh)return i.RG_INTEGER;if(n===rh)return i.RGBA_INTEGER;if(n===Xa||n===qa||n===Ya||n===$a)if(o===Oe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Xa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Xa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===$a)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===oh||n===ah||n===lh||n===ch)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===oh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ah)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===lh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ch)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===hh||n===uh||n===fh||n===dh||n===ph||n===Za||n===mh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===hh||n===uh)return o===Oe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===fh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===dh)return r.COMPRESSED_R11_EAC;if(n===ph)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Za)return r.COMPRESSED_RG11_EAC;if(n===mh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===gh||n===_h||n===yh||n===xh||n===vh||n===Sh||n===Mh||n===bh||n===wh||n===Th||n===Eh||n===Ah||n===Rh||n===Ch)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===gh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===_h)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===yh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===xh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===vh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Sh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Mh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===bh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===wh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Th)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Eh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Ah)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Rh)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ch)return o===Oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ph||n===Ih||n===Lh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Ph)return o===Oe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ih)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Lh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Dh||n===Nh||n===Ja||n===Uh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Dh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Nh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ja)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Uh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===_r?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Y1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,$1=`
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

}`,xd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ba(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Yi({vertexShader:Y1,fragmentShader:$1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Sn(new dr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},vd=class extends Ii{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,p=null,_=typeof XRWebGLBinding<"u",m=new xd,g={},y=e.getContextAttributes(),M=null,x=null,R=[],E=[],v=new _t,b=null,I=null,T=new Xn;T.viewport=new Qe;let P=new Xn;P.viewport=new Qe;let O=[T,P],H=new $c,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let gt=R[tt];return gt===void 0&&(gt=new uo,R[tt]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(tt){let gt=R[tt];return gt===void 0&&(gt=new uo,R[tt]=gt),gt.getGripSpace()},this.getHand=function(tt){let gt=R[tt];return gt===void 0&&(gt=new uo,R[tt]=gt),gt.getHandSpace()};function Y(tt){let gt=E.indexOf(tt.inputSource);if(gt===-1)return;let xt=R[gt];xt!==void 0&&(xt.update(tt.inputSource,tt.frame,c||o),xt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function W(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",ct);for(let tt=0;tt<R.length;tt++){let gt=E[tt];gt!==null&&(E[tt]=null,R[tt].disconnect(gt))}N=null,V=null,m.reset();for(let tt in g)delete g[tt];if(t.setRenderTarget(M),d=null,f=null,u=null,s=null,x=null,ht.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(v.width,v.height,!1),I!==null){let tt=I.camera;tt.fov=I.fov,tt.zoom=I.zoom,tt.updateProjectionMatrix(),I=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&te("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,n.isPresenting===!0&&te("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",W),s.addEventListener("inputsourceschange",ct),y.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(v),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Lt=null,wt=null;y.depth&&(wt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=y.stencil?ys:fs,Lt=y.stencil?_r:Li);let Vt={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Vt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),x=new ci(f.textureWidth,f.textureHeight,{format:Ni,type:Zn,depthTexture:new gs(f.textureWidth,f.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let xt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),x=new ci(d.framebufferWidth,d.framebufferHeight,{format:Ni,type:Zn,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ht.setContext(s),ht.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ct(tt){for(let gt=0;gt<tt.removed.length;gt++){let xt=tt.removed[gt],Lt=E.indexOf(xt);Lt>=0&&(E[Lt]=null,R[Lt].disconnect(xt))}for(let gt=0;gt<tt.added.length;gt++){let xt=tt.added[gt],Lt=E.indexOf(xt);if(Lt===-1){for(let Vt=0;Vt<R.length;Vt++)if(Vt>=E.length){E.push(xt),Lt=Vt;break}else if(E[Vt]===null){E[Vt]=xt,Lt=Vt;break}if(Lt===-1)break}let wt=R[Lt];wt&&wt.connect(xt)}}function J(tt,gt){gt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(gt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let gt=tt.near,xt=tt.far;m.texture!==null&&(m.depthNear>0&&(gt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),H.near=P.near=T.near=gt,H.far=P.far=T.far=xt,(N!==H.near||V!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),N=H.near,V=H.far),H.layers.mask=tt.layers.mask|6,T.layers.mask=H.layers.mask&-5,P.layers.mask=H.layers.mask&-3;let Lt=tt.parent,wt=H.cameras;J(H,Lt);for(let Vt=0;Vt<wt.length;Vt++)J(wt[Vt],Lt);H.projectionMatrix.copy(T.projectionMatrix),H.projectionMatrixInverse.copy(T.projectionMatrixInverse),I===null&&tt.isPerspectiveCamera&&(I={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,H,Lt)};function Q(tt,gt,xt){xt===null?tt.matrix.copy(gt.matrixWorld):(tt.matrix.copy(xt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(gt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(gt.projectionMatrix),tt.projectionMatrixInverse.copy(gt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=co*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(tt){l=tt,f!==null&&(f.fixedFoveation=tt),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(H)},this.getCameraTexture=function(tt){return g[tt]};let et=null;function dt(tt,gt){if(h=gt.getViewerPose(c||o),p=gt,h!==null){let xt=h.views;d!==null&&(t.setRenderTargetFramebuffer(x,d.framebuffer),t.setRenderTarget(x));let Lt=!1;xt.length!==H.cameras.length&&(H.cameras.length=0,Lt=!0);for(let Jt=0;Jt<xt.length;Jt++){let se=xt[Jt],ne=null;if(d!==null)ne=d.getViewport(se);else{let vt=u.getViewSubImage(f,se);ne=vt.viewport,Jt===0&&(t.setRenderTargetTextures(x,vt.colorTexture,vt.depthStencilTexture),t.setRenderTarget(x))}let ot=O[Jt];ot===void 0&&(ot=new Xn,ot.layers.enable(Jt),ot.viewport=new Qe,O[Jt]=ot),ot.matrix.fromArray(se.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(se.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ne.x,ne.y,ne.width,ne.height),Jt===0&&(H.matrix.copy(ot.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Lt===!0&&H.cameras.push(ot)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=n.getBinding();let Jt=u.getDepthInformation(xt[0]);Jt&&Jt.isValid&&Jt.texture&&m.init(Jt,s.renderState)}if(wt&&wt.includes("camera-access")&&_){t.state.unbindTexture(),u=n.getBinding();for(let Jt=0;Jt<xt.length;Jt++){let se=xt[Jt].camera;if(se){let ne=g[se];ne||(ne=new ba,g[se]=ne);let ot=u.getCameraImage(se);ne.sourceTexture=ot}}}}for(let xt=0;xt<R.length;xt++){let Lt=E[xt],wt=R[xt];Lt!==null&&wt!==void 0&&wt.update(Lt,gt,c||o)}et&&et(tt,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),p=null}let ht=new B0;ht.setAnimationLoop(dt),this.setAnimationLoop=function(tt){et=tt},this.dispose=function(){}}},Z1=new De,$0=new de;$0.set(-1,0,0,0,1,0,0,0,1);function J1(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,ad(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,M,x){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),f(m,g),g.isMeshPhysicalMaterial&&d(m,g,x)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,y,M):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Yn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Yn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=t.get(g),M=y.envMap,x=y.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(Z1.makeRotationFromEuler(x)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply($0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=M*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function f(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function d(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Yn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let y=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function K1(i,t,e,n){let s={},r={};function o(y,M){let x=M.program;n.uniformBlockBinding(y,x,s[y.id])}function a(y,M){let x=s[y.id];x===void 0&&(p(y),x=l(y),s[y.id]=x,y.addEventListener("dispose",m));let R=M.program;n.updateUBOMapping(y,R);let E=t.render.frame;r[y.id]!==E&&(c(y),r[y.id]=E)}function l(y){let M=i.createBuffer(),x=y.__size,R=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,x,R),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(y){let M=s[y.id],x=y.uniforms,R=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let E=0,v=x.length;E<v;E++){let b=x[E];if(Array.isArray(b))for(let I=0,T=b.length;I<T;I++)h(b[I],E,I,R);else h(b,E,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,M,x,R){if(f(y,M,x,R)===!0){let E=y.__offset,v=y.value;if(Array.isArray(v)){let b=0;for(let I=0;I<v.length;I++){let T=v[I],P=_(T,!0);u(T,y.__data,b),b+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,y.__data)}}function u(y,M,x){typeof y=="number"||typeof y=="boolean"?M[x]=y:y.isMatrix3?(M[x]=y.elements[0],M[x+1]=y.elements[1],M[x+2]=y.elements[2],M[x+3]=0,M[x+4]=y.elements[3],M[x+5]=y.elements[4],M[x+6]=y.elements[5],M[x+7]=0,M[x+8]=y.elements[6],M[x+9]=y.elements[7],M[x+10]=y.elements[8],M[x+11]=0):ArrayBuffer.isView(y)?M.set(y.subarray(0,M.length-x),x):y.toArray(M,x)}function f(y,M,x,R){let E=y.value,v=M+"_"+x;if(Array.isArray(E)){R[v]===void 0&&(R[v]=[]);let b=R[v],I=!1;for(let T=0;T<E.length;T++)d(E[T],b,T)===!0&&(I=!0);return I}return d(E,R,v)}function d(y,M,x){if(M[x]===void 0)return typeof y=="number"||typeof y=="boolean"?M[x]=y:ArrayBuffer.isView(y)?M[x]=y.slice():M[x]=y.clone(),!0;{let R=M[x];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return M[x]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function p(y){let M=y.uniforms,x=0,R=16;for(let v=0,b=M.length;v<b;v++){let I=Array.isArray(M[v])?M[v]:[M[v]];for(let T=0,P=I.length;T<P;T++){let O=I[T],H=Array.isArray(O.value)?O.value:[O.value],N=Array.isArray(M[v])||Array.isArray(O.value),V=x;for(let W=0,ct=H.length;W<ct;W++){let J=H[W],Q=_(J,N),et=x%R,dt=et%Q.boundary,ht=et+dt;x+=dt,ht!==0&&R-ht<Q.storage&&(x+=R-ht),W===0&&(V=x),x+=Q.storage}let Y=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new Y((x-V)/Float32Array.BYTES_PER_ELEMENT),O.__offset=V}}let E=x%R;return E>0&&(x+=R-E),y.__size=x,y.__cache={},this}function _(y,M){let x={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(x.boundary=4,x.storage=4):y.isVector2?(x.boundary=8,x.storage=8):y.isVector3||y.isColor?(x.boundary=16,x.storage=12):y.isVector4?(x.boundary=16,x.storage=16):y.isMatrix3?(x.boundary=16,x.storage=48):y.isMatrix4?(x.boundary=16,x.storage=64):y.isTexture?te("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(x.boundary=16,x.storage=y.byteLength):te("WebGLRenderer: Unsupported uniform value type.",y),M===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}function m(y){let M=y.target;M.removeEventListener("dispose",m),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var j1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Zi=null;function Q1(){return Zi===null&&(Zi=new ya(j1,16,16,Ws,Di),Zi.name="DFG_LUT",Zi.minFilter=qn,Zi.magFilter=qn,Zi.wrapS=Wi,Zi.wrapT=Wi,Zi.generateMipmaps=!1,Zi.needsUpdate=!0),Zi}var Gh=class{constructor(t={}){let{canvas:e=i0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=Zn}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let _=d,m=new Set([rh,sh,ih]),g=new Set([Zn,Li,wo,_r,th,eh]),y=new Uint32Array(4),M=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},R=null,E=null,v=[],b=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=$i,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,P=!1,O=null,H=null,N=null,V=null;this._outputColorSpace=ai;let Y=0,W=0,ct=null,J=-1,Q=null,et=new Qe,dt=new Qe,ht=null,tt=new oe(0),gt=0,xt=e.width,Lt=e.height,wt=1,Vt=null,ie=null,Jt=new Qe(0,0,xt,Lt),se=new Qe(0,0,xt,Lt),ne=!1,ot=new Fs,vt=new wc,yt=!1,Bt=!1,Dt=new De,ee=new z,kt=new Qe,me={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},fe=!1;function _e(){return ct===null?wt:1}let B=n;function Mt(C,G){return e.getContext(C,G)}let Xt,he,Tt,Ue,$t,Qt,L,w,q,ft,at,bt,Et,nt,st,mt,k,rt,it,Ct,St,Rt,Kt;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",qt,!1),e.addEventListener("webglcontextrestored",le,!1),e.addEventListener("webglcontextcreationerror",Nt,!1),B===null){let G="webgl2";if(B=Mt(G,C),B===null)throw Mt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ae()}catch(C){throw e.removeEventListener("webglcontextlost",qt,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Nt,!1),ce("WebGLRenderer: "+C.message),C}function ae(){Xt=new hw(B),Xt.init(),St=new q1(B,Xt),he=new Qb(B,Xt,t,St),Tt=new W1(B,Xt),he.reversedDepthBuffer&&f&&Tt.buffers.depth.setReversed(!0),H=B.createFramebuffer(),N=B.createFramebuffer(),V=B.createFramebuffer(),Ue=new dw(B),$t=new P1,Qt=new X1(B,Xt,Tt,$t,he,St,Ue),L=new cw(T),w=new mS(B),Rt=new Kb(B,w),q=new uw(B,w,Ue,Rt),ft=new mw(B,q,w,Rt,Ue),rt=new pw(B,he,Qt),st=new tw($t),at=new C1(T,L,Xt,he,Rt,st),bt=new J1(T,$t),Et=new L1,nt=new B1(Xt),k=new Jb(T,L,Tt,ft,p,l),mt=new H1(T,ft,he),Kt=new K1(B,Ue,he,Tt),it=new jb(B,Xt,Ue),Ct=new fw(B,Xt,Ue),Ue.programs=at.programs,T.capabilities=he,T.extensions=Xt,T.properties=$t,T.renderLists=Et,T.shadowMap=mt,T.state=Tt,T.info=Ue}_!==Zn&&(I=new _w(_,e.width,e.height,a,s,r));let ut=new vd(T,B);this.xr=ut,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let C=Xt.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Xt.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(C){C!==void 0&&(wt=C,this.setSize(xt,Lt,!1))},this.getSize=function(C){return C.set(xt,Lt)},this.setSize=function(C,G,j=!0){if(ut.isPresenting){te("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=C,Lt=G,e.width=Math.floor(C*wt),e.height=Math.floor(G*wt),j===!0&&(e.style.width=C+"px",e.style.height=G+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,C,G)},this.getDrawingBufferSize=function(C){return C.set(xt*wt,Lt*wt).floor()},this.setDrawingBufferSize=function(C,G,j){xt=C,Lt=G,wt=j,e.width=Math.floor(C*j),e.height=Math.floor(G*j),this.setViewport(0,0,C,G)},this.setEffects=function(C){if(_===Zn){ce("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let G=0;G<C.length;G++)if(C[G].isOutputPass===!0){te("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(et)},this.getViewport=function(C){return C.copy(Jt)},this.setViewport=function(C,G,j,$){C.isVector4?Jt.set(C.x,C.y,C.z,C.w):Jt.set(C,G,j,$),Tt.viewport(et.copy(Jt).multiplyScalar(_e()).round())},this.getScissor=function(C){return C.copy(se)},this.setScissor=function(C,G,j,$){C.isVector4?se.set(C.x,C.y,C.z,C.w):se.set(C,G,j,$),Tt.scissor(dt.copy(se).multiplyScalar(_e()).round())},this.getScissorTest=function(){return ne},this.setScissorTest=function(C){Tt.setScissorTest(ne=C)},this.setOpaqueSort=function(C){Vt=C},this.setTransparentSort=function(C){ie=C},this.getClearColor=function(C){return C.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(C=!0,G=!0,j=!0){let $=0;if(C){let Z=!1;if(ct!==null){let Pt=ct.texture.format;Z=m.has(Pt)}if(Z){let Pt=ct.texture.type,Ut=g.has(Pt),It=k.getClearColor(),Ft=k.getClearAlpha(),Zt=It.r,ue=It.g,Me=It.b;Ut?(y[0]=Zt,y[1]=ue,y[2]=Me,y[3]=Ft,B.clearBufferuiv(B.COLOR,0,y)):(M[0]=Zt,M[1]=ue,M[2]=Me,M[3]=Ft,B.clearBufferiv(B.COLOR,0,M))}else $|=B.COLOR_BUFFER_BIT}G&&($|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),O=C},this.dispose=function(){e.removeEventListener("webglcontextlost",qt,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Nt,!1),k.dispose(),Et.dispose(),nt.dispose(),Qt.dispose(),$t.dispose(),L.dispose(),ft.dispose(),q.dispose(),Rt.dispose(),Kt.dispose(),at.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",sl),ut.removeEventListener("sessionend",Ui),Ki.stop()};function qt(C){C.preventDefault(),nd("WebGLRenderer: Context Lost."),P=!0}function le(){nd("WebGLRenderer: Context Restored."),P=!1;let C=Ue.autoReset,G=mt.enabled,j=mt.autoUpdate,$=mt.needsUpdate,Z=mt.type;ae(),Ue.autoReset=C,mt.enabled=G,mt.autoUpdate=j,mt.needsUpdate=$,mt.type=Z}function Nt(C){ce("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function ge(C){let G=C.target;G.removeEventListener("dispose",ge),qe(G)}function qe(C){kn(C),$t.remove(C)}function kn(C){let G=$t.get(C).programs;G!==void 0&&(G.forEach(function(j){at.releaseProgram(j)}),C.isShaderMaterial&&at.releaseShaderCache(C))}this.renderBufferDirect=function(C,G,j,$,Z,Pt){G===null&&(G=me);let Ut=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,It=Do(C,G,j,$,Z);Tt.setMaterial($,Ut);let Ft=j.index,Zt=1;if($.wireframe===!0){if(Ft=q.getWireframeAttribute(j),Ft===void 0)return;Zt=2}let ue=j.drawRange,Me=j.attributes.position,Yt=ue.start*Zt,be=(ue.start+ue.count)*Zt;Pt!==null&&(Yt=Math.max(Yt,Pt.start*Zt),be=Math.min(be,(Pt.start+Pt.count)*Zt)),Ft!==null?(Yt=Math.max(Yt,0),be=Math.min(be,Ft.count)):Me!=null&&(Yt=Math.max(Yt,0),be=Math.min(be,Me.count));let tn=be-Yt;if(tn<0||tn===1/0)return;Rt.setup(Z,$,It,j,Ft);let Be,ke=it;if(Ft!==null&&(Be=w.get(Ft),ke=Ct,ke.setIndex(Be)),Z.isMesh)$.wireframe===!0?(Tt.setLineWidth($.wireframeLinewidth*_e()),ke.setMode(B.LINES)):ke.setMode(B.TRIANGLES);else if(Z.isLine){let _n=$.linewidth;_n===void 0&&(_n=1),Tt.setLineWidth(_n*_e()),Z.isLineSegments?ke.setMode(B.LINES):Z.isLineLoop?ke.setMode(B.LINE_LOOP):ke.setMode(B.LINE_STRIP)}else Z.isPoints?ke.setMode(B.POINTS):Z.isSprite&&ke.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(Xt.get("WEBGL_multi_draw"))ke.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let _n=Z._multiDrawStarts,Ht=Z._multiDrawCounts,cn=Z._multiDrawCount,Te=Ft?w.get(Ft).bytesPerElement:1,Qi=$t.get($).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)Qi.setValue(B,"_gl_DrawID",hn),ke.render(_n[hn]/Te,Ht[hn])}else if(Z.isInstancedMesh)ke.renderInstances(Yt,tn,Z.count);else if(j.isInstancedBufferGeometry){let _n=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ht=Math.min(j.instanceCount,_n);ke.renderInstances(Yt,tn,Ht)}else ke.render(Yt,tn)};function Po(C,G,j,$){O!==null&&C.isNodeMaterial&&O.setObject($,C),yt===!0&&st.setState(C,j,!1),C.transparent===!0&&C.side===fi&&C.forceSinglePass===!1?(C.side=Yn,C.needsUpdate=!0,Fi(C,G,$),C.side=Hs,C.needsUpdate=!0,Fi(C,G,$),C.side=fi):Fi(C,G,$)}this.compile=function(C,G,j=null){j===null&&(j=C),O!==null&&O.renderStart(C,G,j),E=nt.get(j),E.init(G),b.push(E),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),C!==j&&C.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),O!==null&&O.updateLights(E.state.lightsArray),Bt=this.localClippingEnabled,yt=st.init(this.clippingPlanes,Bt),yt===!0&&st.setGlobalState(this.clippingPlanes,G),O!==null&&mt.render(E.state.shadowsArray,j,G);let $=new Set;return C.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Pt=Z.material;if(Pt)if(Array.isArray(Pt))for(let Ut=0;Ut<Pt.length;Ut++){let It=Pt[Ut];Po(It,j,G,Z),$.add(It)}else Po(Pt,j,G,Z),$.add(Pt)}),E=b.pop(),O!==null&&O.renderEnd(),$},this.compileAsync=function(C,G,j=null){let $=this.compile(C,G,j);return new Promise(Z=>{function Pt(){if($.forEach(function(Ut){let Ft=$t.get(Ut).currentProgram;(Ft===void 0||Ft.isReady())&&$.delete(Ut)}),$.size===0){Z(C);return}setTimeout(Pt,10)}Xt.get("KHR_parallel_shader_compile")!==null?Pt():setTimeout(Pt,10)})};let vr=null;function eu(C){vr&&vr(C)}function sl(){Ki.stop()}function Ui(){Ki.start()}let Ki=new B0;Ki.setAnimationLoop(eu),typeof self<"u"&&Ki.setContext(self),this.setAnimationLoop=function(C){vr=C,ut.setAnimationLoop(C),C===null?Ki.stop():Ki.start()},ut.addEventListener("sessionstart",sl),ut.addEventListener("sessionend",Ui),this.render=function(C,G){if(G!==void 0&&G.isCamera!==!0){ce("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;O!==null&&O.renderStart(C,G);let j=ut.enabled===!0&&ut.isPresenting===!0,$=I!==null&&(ct===null||j)&&I.begin(T,ct);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(G),G=ut.getCamera()),C.isScene===!0&&C.onBeforeRender(T,C,G,ct),E=nt.get(C,b.length),E.init(G),E.state.textureUnits=Qt.getTextureUnits(),b.push(E),Dt.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?vt.setFromArrayCamera(G):ot.setFromProjectionMatrix(Dt,xi,G.reversedDepth),Bt=this.localClippingEnabled,yt=st.init(this.clippingPlanes,Bt),R=Et.get(C,v.length),R.init(),v.push(R),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let Ut=T.xr.getDepthSensingMesh();Ut!==null&&ji(Ut,G,-1/0,T.sortObjects)}ji(C,G,0,T.sortObjects),R.finish(),O!==null&&O.updateLights(E.state.lightsArray),T.sortObjects===!0&&R.sort(Vt,ie),fe=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,fe&&k.addToRenderList(R,C),this.info.autoReset===!0&&this.info.reset(),yt===!0&&st.beginShadows();let Z=E.state.shadowsArray;if(mt.render(Z,C,G),yt===!0&&st.endShadows(),($&&I.hasRenderPass())===!1){let Ut=R.opaque,It=R.transmissive;if(E.setupLights(),G.isArrayCamera){let Ft=G.cameras;if(It.length>0)for(let Zt=0,ue=Ft.length;Zt<ue;Zt++){let Me=Ft[Zt];Si(Ut,It,C,Me)}fe&&k.render(C);for(let Zt=0,ue=Ft.length;Zt<ue;Zt++){let Me=Ft[Zt];Io(R,C,Me,Me.viewport)}}else It.length>0&&Si(Ut,It,C,G),fe&&k.render(C),Io(R,C,G)}ct!==null&&W===0&&(Qt.updateMultisampleRenderTarget(ct),Qt.updateRenderTargetMipmap(ct)),$&&I.end(T),C.isScene===!0&&C.onAfterRender(T,C,G),Rt.resetDefaultState(),J=-1,Q=null,b.pop(),b.length>0?(E=b[b.length-1],Qt.setTextureUnits(E.state.textureUnits),yt===!0&&st.setGlobalState(T.clippingPlanes,E.state.camera)):E=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,O!==null&&O.renderEnd()};function ji(C,G,j,$){if(C.visible===!1)return;if(C.layers.test(G.layers)){if(C.isGroup)j=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(G);else if(C.isLight)E.pushLight(C),C.castShadow&&E.pushShadow(C);else if(C.isSprite){let Ut=G.isArrayCamera?vt:ot;if(!C.frustumCulled||C.intersectsFrustum(Ut)){$&&kt.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Dt);let It=ft.update(C),Ft=C.material;Ft.visible&&R.push(C,It,Ft,j,kt.z,null,G)}}else if(C.isMesh||C.isLine||C.isPoints){let Ut=G.isArrayCamera?vt:ot;if(!C.frustumCulled||C.intersectsFrustum(Ut)){let It=ft.update(C),Ft=C.material;if($&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),kt.copy(C.boundingSphere.center)):(It.boundingSphere===null&&It.computeBoundingSphere(),kt.copy(It.boundingSphere.center)),kt.applyMatrix4(C.matrixWorld).applyMatrix4(Dt)),Array.isArray(Ft)){let Zt=It.groups;for(let ue=0,Me=Zt.length;ue<Me;ue++){let Yt=Zt[ue],be=Ft[Yt.materialIndex];be&&be.visible&&R.push(C,It,be,j,kt.z,Yt,G)}}else Ft.visible&&R.push(C,It,Ft,j,kt.z,null,G)}}}let Pt=C.children;for(let Ut=0,It=Pt.length;Ut<It;Ut++)ji(Pt[Ut],G,j,$)}function Io(C,G,j,$){let{opaque:Z,transmissive:Pt,transparent:Ut}=C;E.setupLightsView(j),yt===!0&&st.setGlobalState(T.clippingPlanes,j),$&&Tt.viewport(et.copy($)),Z.length>0&&nn(Z,G,j),Pt.length>0&&nn(Pt,G,j),Ut.length>0&&nn(Ut,G,j),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function Si(C,G,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[$.id]===void 0){let Yt=Xt.has("EXT_color_buffer_half_float")||Xt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[$.id]=new ci(1,1,{generateMipmaps:!0,type:Yt?Di:Zn,minFilter:_s,samples:Math.max(4,he.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Re.workingColorSpace})}let Pt=E.state.transmissionRenderTarget[$.id],Ut=$.viewport||et;Pt.setSize(Ut.z*T.transmissionResolutionScale,Ut.w*T.transmissionResolutionScale);let It=T.getRenderTarget(),Ft=T.getActiveCubeFace(),Zt=T.getActiveMipmapLevel();T.setRenderTarget(Pt),T.getClearColor(tt),gt=T.getClearAlpha(),gt<1&&T.setClearColor(16777215,.5),T.clear(),fe&&k.render(j);let ue=T.toneMapping;T.toneMapping=$i;let Me=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),E.setupLightsView($),yt===!0&&st.setGlobalState(T.clippingPlanes,$),nn(C,j,$),Qt.updateMultisampleRenderTarget(Pt),Qt.updateRenderTargetMipmap(Pt),Xt.has("WEBGL_multisampled_render_to_texture")===!1){let Yt=!1;for(let be=0,tn=G.length;be<tn;be++){let Be=G[be],{object:ke,geometry:_n,material:Ht,group:cn}=Be;if(Ht.side===fi&&ke.layers.test($.layers)){let Te=Ht.side;Ht.side=Yn,Ht.needsUpdate=!0,an(ke,j,$,_n,Ht,cn),Ht.side=Te,Ht.needsUpdate=!0,Yt=!0}}Yt===!0&&(Qt.updateMultisampleRenderTarget(Pt),Qt.updateRenderTargetMipmap(Pt))}T.setRenderTarget(It,Ft,Zt),T.setClearColor(tt,gt),Me!==void 0&&($.viewport=Me),T.toneMapping=ue}function nn(C,G,j){let $=G.isScene===!0?G.overrideMaterial:null;for(let Z=0,Pt=C.length;Z<Pt;Z++){let Ut=C[Z],{object:It,geometry:Ft,group:Zt}=Ut,ue=Ut.material;ue.allowOverride===!0&&$!==null&&(ue=$),It.layers.test(j.layers)&&an(It,G,j,Ft,ue,Zt)}}function an(C,G,j,$,Z,Pt){O!==null&&Z.isNodeMaterial&&O.setObject(C,Z),C.onBeforeRender(T,G,j,$,Z,Pt),C.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),Z.onBeforeRender(T,G,j,$,C,Pt),Z.transparent===!0&&Z.side===fi&&Z.forceSinglePass===!1?(Z.side=Yn,Z.needsUpdate=!0,T.renderBufferDirect(j,G,$,Z,C,Pt),Z.side=Hs,Z.needsUpdate=!0,T.renderBufferDirect(j,G,$,Z,C,Pt),Z.side=fi):T.renderBufferDirect(j,G,$,Z,C,Pt),C.onAfterRender(T,G,j,$,Z,Pt)}function ln(C){let G=0;for(let j of C)j.texture!==null&&G++;return G}function Fi(C,G,j){G.isScene!==!0&&(G=me);let $=$t.get(C),Z=E.state.lights,Pt=E.state.shadowsArray,Ut=Z.state.version,It=at.getParameters(C,Z.state,Pt,G,j,E.state.lightProbeGridArray),Ft=at.getProgramCacheKey(It),Zt=$.programs;$.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?G.environment:null,$.fog=G.fog;let ue=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;$.envMap=L.get(C.envMap||$.environment,ue),$.envMapRotation=$.environment!==null&&C.envMap===null?G.environmentRotation:C.envMapRotation,Zt===void 0&&(C.addEventListener("dispose",ge),Zt=new Map,$.programs=Zt,$.programVariants=new Map);let Me=Zt.get(Ft);if(Me!==void 0){if($.currentProgram===Me&&$.lightsStateVersion===Ut)return Lo(C,It),Me}else It.uniforms=at.getUniforms(C),O!==null&&C.isNodeMaterial&&O.build(C,j,It),C.onBeforeCompile(It,T),Me=at.acquireProgram(It,Ft),Zt.set(Ft,Me),$.uniforms=It.uniforms;let Yt=$.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Yt.clippingPlanes=st.uniform),Lo(C,It),$.needsLights=Ms(C),$.lightsStateVersion=Ut,$.needsLights&&(Yt.ambientLightColor.value=Z.state.ambient,Yt.lightProbe.value=Z.state.probe,Yt.sunLights.value=Z.state.sun,Yt.sunLightShadows.value=Z.state.sunShadow,Yt.directionalLights.value=Z.state.directional,Yt.directionalLightShadows.value=Z.state.directionalShadow,Yt.spotLights.value=Z.state.spot,Yt.spotLightShadows.value=Z.state.spotShadow,Yt.rectAreaLights.value=Z.state.rectArea,Yt.ltc_1.value=Z.state.rectAreaLTC1,Yt.ltc_2.value=Z.state.rectAreaLTC2,Yt.pointLights.value=Z.state.point,Yt.pointLightShadows.value=Z.state.pointShadow,Yt.hemisphereLights.value=Z.state.hemi,Yt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Yt.sunShadowCascade.value=Z.state.sunShadowCascade,Yt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Yt.spotLightMatrix.value=Z.state.spotLightMatrix,Yt.spotLightMap.value=Z.state.spotLightMap,Yt.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=ln(E.state.lightProbeGridArray),$.currentProgram=Me,$.uniformsList=null,Me}function Kn(C,G,j,$,Z){let Pt=$t.get(C),Ut=Pt.currentProgram.id+","+$+","+Z,It=Pt.programVariants.get(Ut);return It===void 0?(It=Fi(C,G,j),Pt.programVariants.set(Ut,It)):(Pt.currentProgram=It,Pt.uniformsList=null,Pt.outputColorSpace=$,Pt.toneMapping=Z),It}function Ss(C){if(C.uniformsList===null){let G=C.currentProgram.getUniforms();C.uniformsList=To.seqWithValue(G.seq,C.uniforms)}return C.uniformsList}function Lo(C,G){let j=$t.get(C);j.outputColorSpace=G.outputColorSpace,j.batching=G.batching,j.batchingColor=G.batchingColor,j.instancing=G.instancing,j.instancingColor=G.instancingColor,j.instancingMorph=G.instancingMorph,j.skinning=G.skinning,j.morphTargets=G.morphTargets,j.morphNormals=G.morphNormals,j.morphColors=G.morphColors,j.morphTargetsCount=G.morphTargetsCount,j.numClippingPlanes=G.numClippingPlanes,j.numIntersection=G.numClipIntersection,j.vertexAlphas=G.vertexAlphas,j.vertexTangents=G.vertexTangents,j.toneMapping=G.toneMapping}function Do(C,G,j,$,Z){G.isScene!==!0&&(G=me),Qt.resetTextureUnits();let Pt=G.fog,Ut=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?G.environment:null,It=ct===null?T.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:Re.workingColorSpace,Ft=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Zt=L.get($.envMap||Ut,Ft),ue=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,Me=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Yt=!!j.morphAttributes.position,be=!!j.morphAttributes.normal,tn=!!j.morphAttributes.color,Be=$i;$.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Be=T.toneMapping);let ke=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,_n=ke!==void 0?ke.length:0,Ht=$t.get($),cn=E.state.lights;if(yt===!0&&(Bt===!0||C!==Q)){let ze=C===Q&&$.id===J;st.setState($,C,ze)}let Te=!1,Qi=!1;$.version===Ht.__version?Ht.needsLights&&Ht.lightsStateVersion!==cn.state.version||Z.isBatchedMesh&&Ht.batching===!1||!Z.isBatchedMesh&&Ht.batching===!0||Z.isBatchedMesh&&Ht.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ht.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ht.instancing===!1||!Z.isInstancedMesh&&Ht.instancing===!0||Z.isSkinnedMesh&&Ht.skinning===!1||!Z.isSkinnedMesh&&Ht.skinning===!0||Z.isInstancedMesh&&Ht.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ht.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ht.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ht.instancingMorph===!1&&Z.morphTexture!==null||Ht.envMap!==Zt||$.fog===!0&&Ht.fog!==Pt||Ht.numClippingPlanes!==void 0&&(Ht.numClippingPlanes!==st.numPlanes||Ht.numIntersection!==st.numIntersection)||Ht.vertexAlphas!==ue||Ht.vertexTangents!==Me||Ht.morphTargets!==Yt||Ht.morphNormals!==be||Ht.morphColors!==tn||Ht.morphTargetsCount!==_n||Ht.numLightProbeGrids!==ln(E.state.lightProbeGridArray)?Te=!0:(Ht.outputColorSpace!==It||Ht.toneMapping!==Be)&&(Qi=!0):(Te=!0,Ht.__version=$.version);let hn=Ht.currentProgram;(Te===!0||Qi===!0)&&(hn=Qi===!0?Kn($,G,Z,It,Be):Fi($,G,Z),O&&$.isNodeMaterial&&O.onUpdateProgram($,hn,Ht));let br=!1,Oi=!1,ts=!1,ye=hn.getUniforms(),sn=Ht.uniforms;if(Tt.useProgram(hn.program)&&(br=!0,Oi=!0,ts=!0),$.id!==J&&(J=$.id,Oi=!0),br||Q!==C){Tt.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),ye.setValue(B,"projectionMatrix",C.projectionMatrix),ye.setValue(B,"viewMatrix",C.matrixWorldInverse);let un=ye.map.cameraPosition;un!==void 0&&un.setValue(B,ee.setFromMatrixPosition(C.matrixWorld)),he.logarithmicDepthBuffer&&ye.setValue(B,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ye.setValue(B,"isOrthographic",C.isOrthographicCamera===!0),Q!==C&&(Q=C,Oi=!0,ts=!0)}if(Ht.needsLights&&(cn.state.sunShadowMap.length>0&&ye.setValue(B,"sunShadowMap",cn.state.sunShadowMap,Qt),cn.state.directionalShadowMap.length>0&&ye.setValue(B,"directionalShadowMap",cn.state.directionalShadowMap,Qt),cn.state.spotShadowMap.length>0&&ye.setValue(B,"spotShadowMap",cn.state.spotShadowMap,Qt),cn.state.pointShadowMap.length>0&&ye.setValue(B,"pointShadowMap",cn.state.pointShadowMap,Qt)),Z.isSkinnedMesh){ye.setOptional(B,Z,"bindMatrix"),ye.setOptional(B,Z,"bindMatrixInverse");let ze=Z.skeleton;ze&&(ze.boneTexture===null&&ze.computeBoneTexture(),ye.setValue(B,"boneTexture",ze.boneTexture,Qt))}Z.isBatchedMesh&&(ye.setOptional(B,Z,"batchingTexture"),ye.setValue(B,"batchingTexture",Z._matricesTexture,Qt),ye.setOptional(B,Z,"batchingIdTexture"),ye.setValue(B,"batchingIdTexture",Z._indirectTexture,Qt),ye.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ye.setValue(B,"batchingColorTexture",Z._colorsTexture,Qt));let zn=j.morphAttributes;if((zn.position!==void 0||zn.normal!==void 0||zn.color!==void 0)&&rt.update(Z,j,hn),(Oi||Ht.receiveShadow!==Z.receiveShadow)&&(Ht.receiveShadow=Z.receiveShadow,ye.setValue(B,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&G.environment!==null&&(sn.envMapIntensity.value=G.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=Q1()),Oi){if(ye.setValue(B,"toneMappingExposure",T.toneMappingExposure),Ht.needsLights&&Sr(sn,ts),Pt&&$.fog===!0&&bt.refreshFogUniforms(sn,Pt),bt.refreshMaterialUniforms(sn,$,wt,Lt,E.state.transmissionRenderTarget[C.id]),Ht.needsLights&&Ht.numLightProbeGrids>0){let ze=x,un=0;for(let Un of E.state.lightProbeGridArray)Un.texture!==null&&(ze.textures[un]=Un.texture,ze.min[un]=Un.boundingBox.min,ze.max[un]=Un.boundingBox.max,ze.resolution[un]=Un.resolution,un++);for(let Un in ze)ze[Un].length=un;sn.probesSH.value=ze.textures,sn.probesMin.value=ze.min,sn.probesMax.value=ze.max,sn.probesResolution.value=ze.resolution}To.upload(B,Ss(Ht),sn,Qt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(To.upload(B,Ss(Ht),sn,Qt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ye.setValue(B,"center",Z.center),ye.setValue(B,"modelViewMatrix",Z.modelViewMatrix),ye.setValue(B,"normalMatrix",Z.normalMatrix),ye.setValue(B,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let ze=$.uniformsGroups;for(let un=0,Un=ze.length;un<Un;un++){let rl=ze[un];Kt.update(rl,hn),Kt.bind(rl,hn)}}return hn}function Sr(C,G){C.ambientLightColor.needsUpdate=G,C.lightProbe.needsUpdate=G,C.sunLights.needsUpdate=G,C.sunLightShadows.needsUpdate=G,C.directionalLights.needsUpdate=G,C.directionalLightShadows.needsUpdate=G,C.pointLights.needsUpdate=G,C.pointLightShadows.needsUpdate=G,C.spotLights.needsUpdate=G,C.spotLightShadows.needsUpdate=G,C.rectAreaLights.needsUpdate=G,C.hemisphereLights.needsUpdate=G}function Ms(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(C,G,j){let $=$t.get(C);$.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),$t.get(C.texture).__webglTexture=G,$t.get(C.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,G){let j=$t.get(C);j.__webglFramebuffer=G,j.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(C,G=0,j=0){ct=C,Y=G,W=j;let $=null,Z=!1,Pt=!1;if(C){let It=$t.get(C);if(It.__useDefaultFramebuffer!==void 0){Tt.bindFramebuffer(B.FRAMEBUFFER,It.__webglFramebuffer),et.copy(C.viewport),dt.copy(C.scissor),ht=C.scissorTest,Tt.viewport(et),Tt.scissor(dt),Tt.setScissorTest(ht),J=-1;return}else if(It.__webglFramebuffer===void 0)Qt.setupRenderTarget(C);else if(It.__hasExternalTextures)Qt.rebindTextures(C,$t.get(C.texture).__webglTexture,$t.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let ue=C.depthTexture;if(It.__boundDepthTexture!==ue){if(ue!==null&&$t.has(ue)&&(C.width!==ue.image.width||C.height!==ue.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Qt.setupDepthRenderbuffer(C)}}let Ft=C.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(Pt=!0);let Zt=$t.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Zt[G])?$=Zt[G][j]:$=Zt[G],Z=!0):C.samples>0&&Qt.useMultisampledRTT(C)===!1?$=$t.get(C).__webglMultisampledFramebuffer:Array.isArray(Zt)?$=Zt[j]:$=Zt,et.copy(C.viewport),dt.copy(C.scissor),ht=C.scissorTest}else et.copy(Jt).multiplyScalar(wt).floor(),dt.copy(se).multiplyScalar(wt).floor(),ht=ne;if(j!==0&&($=H),Tt.bindFramebuffer(B.FRAMEBUFFER,$)&&Tt.drawBuffers(C,$),Tt.viewport(et),Tt.scissor(dt),Tt.setScissorTest(ht),Z){let It=$t.get(C.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+G,It.__webglTexture,j)}else if(Pt){let It=G;for(let Ft=0;Ft<C.textures.length;Ft++){let Zt=$t.get(C.textures[Ft]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ft,Zt.__webglTexture,j,It)}}else if(C!==null&&j!==0){let It=$t.get(C.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,It.__webglTexture,j)}J=-1};function Mr(C){let G=$t.get(C);return(G.__readFormat!==C.format||G.__readType!==C.type)&&(G.__readFormat=C.format,G.__readType=C.type,G.__formatReadable=he.textureFormatReadable(C.format),G.__typeReadable=he.textureTypeReadable(C.type)),G}this.readRenderTargetPixels=function(C,G,j,$,Z,Pt,Ut,It=0){if(!(C&&C.isWebGLRenderTarget)){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=$t.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Tt.bindFramebuffer(B.FRAMEBUFFER,Ft);try{let Zt=C.textures[It],ue=Zt.format,Me=Zt.type;C.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+It);let Yt=Mr(Zt);if(Yt.__formatReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Yt.__typeReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=C.width-$&&j>=0&&j<=C.height-Z&&B.readPixels(G,j,$,Z,St.convert(ue),St.convert(Me),Pt)}finally{let Zt=ct!==null?$t.get(ct).__webglFramebuffer:null;Tt.bindFramebuffer(B.FRAMEBUFFER,Zt)}}},this.readRenderTargetPixelsAsync=async function(C,G,j,$,Z,Pt,Ut,It=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=$t.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(G>=0&&G<=C.width-$&&j>=0&&j<=C.height-Z){Tt.bindFramebuffer(B.FRAMEBUFFER,Ft);let Zt=C.textures[It],ue=Zt.format,Me=Zt.type;C.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+It);let Yt=Mr(Zt);if(Yt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Yt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let be=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,be),B.bufferData(B.PIXEL_PACK_BUFFER,Pt.byteLength,B.STREAM_READ),B.readPixels(G,j,$,Z,St.convert(ue),St.convert(Me),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let tn=ct!==null?$t.get(ct).__webglFramebuffer:null;Tt.bindFramebuffer(B.FRAMEBUFFER,tn);let Be=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await r0(B,Be,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,be),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Pt),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(be),B.deleteSync(Be),Pt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,G=null,j=0){let $=Math.pow(2,-j),Z=Math.floor(C.image.width*$),Pt=Math.floor(C.image.height*$),Ut=G!==null?G.x:0,It=G!==null?G.y:0;Qt.setTexture2D(C,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Ut,It,Z,Pt),Tt.unbindTexture()},this.copyTextureToTexture=function(C,G,j=null,$=null,Z=0,Pt=0){let Ut,It,Ft,Zt,ue,Me,Yt,be,tn,Be=C.isCompressedTexture?C.mipmaps[Pt]:C.image;if(j!==null)Ut=j.max.x-j.min.x,It=j.max.y-j.min.y,Ft=j.isBox3?j.max.z-j.min.z:1,Zt=j.min.x,ue=j.min.y,Me=j.isBox3?j.min.z:0;else{let ye=Math.pow(2,-Z);Ut=Math.floor(Be.width*ye),It=Math.floor(Be.height*ye),C.isDataArrayTexture?Ft=Be.depth:C.isData3DTexture?Ft=Math.floor(Be.depth*ye):Ft=1,Zt=0,ue=0,Me=0}$!==null?(Yt=$.x,be=$.y,tn=$.z):(Yt=0,be=0,tn=0);let ke=St.convert(G.format),_n=St.convert(G.type),Ht;G.isData3DTexture?(Qt.setTexture3D(G,0),Ht=B.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Qt.setTexture2DArray(G,0),Ht=B.TEXTURE_2D_ARRAY):(Qt.setTexture2D(G,0),Ht=B.TEXTURE_2D),Tt.activeTexture(B.TEXTURE0),Tt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,G.flipY),Tt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),Tt.pixelStorei(B.UNPACK_ALIGNMENT,G.unpackAlignment);let cn=Tt.getParameter(B.UNPACK_ROW_LENGTH),Te=Tt.getParameter(B.UNPACK_IMAGE_HEIGHT),Qi=Tt.getParameter(B.UNPACK_SKIP_PIXELS),hn=Tt.getParameter(B.UNPACK_SKIP_ROWS),br=Tt.getParameter(B.UNPACK_SKIP_IMAGES);Tt.pixelStorei(B.UNPACK_ROW_LENGTH,Be.width),Tt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Be.height),Tt.pixelStorei(B.UNPACK_SKIP_PIXELS,Zt),Tt.pixelStorei(B.UNPACK_SKIP_ROWS,ue),Tt.pixelStorei(B.UNPACK_SKIP_IMAGES,Me);let Oi=C.isDataArrayTexture||C.isData3DTexture,ts=G.isDataArrayTexture||G.isData3DTexture;if(C.isDepthTexture){let ye=$t.get(C),sn=$t.get(G),zn=$t.get(ye.__renderTarget),ze=$t.get(sn.__renderTarget);Tt.bindFramebuffer(B.READ_FRAMEBUFFER,zn.__webglFramebuffer),Tt.bindFramebuffer(B.DRAW_FRAMEBUFFER,ze.__webglFramebuffer);for(let un=0;un<Ft;un++)Oi&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,$t.get(C).__webglTexture,Z,Me+un),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,$t.get(G).__webglTexture,Pt,tn+un)),B.blitFramebuffer(Zt,ue,Zt+Ut,ue+It,Yt,be,Yt+Ut,be+It,B.DEPTH_BUFFER_BIT,B.NEAREST);Tt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||C.isRenderTargetTexture||$t.has(C)){let ye=$t.get(C),sn=$t.get(G);Tt.bindFramebuffer(B.READ_FRAMEBUFFER,N),Tt.bindFramebuffer(B.DRAW_FRAMEBUFFER,V);for(let zn=0;zn<Ft;zn++)Oi?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ye.__webglTexture,Z,Me+zn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ye.__webglTexture,Z),ts?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,sn.__webglTexture,Pt,tn+zn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,sn.__webglTexture,Pt),Z!==0?B.blitFramebuffer(Zt,ue,Zt+Ut,ue+It,Yt,be,Yt+Ut,be+It,B.COLOR_BUFFER_BIT,B.NEAREST):ts?B.copyTexSubImage3D(Ht,Pt,Yt,be,tn+zn,Zt,ue,Ut,It):B.copyTexSubImage2D(Ht,Pt,Yt,be,Zt,ue,Ut,It);Tt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else ts?C.isDataTexture||C.isData3DTexture?B.texSubImage3D(Ht,Pt,Yt,be,tn,Ut,It,Ft,ke,_n,Be.data):G.isCompressedArrayTexture?B.compressedTexSubImage3D(Ht,Pt,Yt,be,tn,Ut,It,Ft,ke,Be.data):B.texSubImage3D(Ht,Pt,Yt,be,tn,Ut,It,Ft,ke,_n,Be):C.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Pt,Yt,be,Ut,It,ke,_n,Be.data):C.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Pt,Yt,be,Be.width,Be.height,ke,Be.data):B.texSubImage2D(B.TEXTURE_2D,Pt,Yt,be,Ut,It,ke,_n,Be);Tt.pixelStorei(B.UNPACK_ROW_LENGTH,cn),Tt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Te),Tt.pixelStorei(B.UNPACK_SKIP_PIXELS,Qi),Tt.pixelStorei(B.UNPACK_SKIP_ROWS,hn),Tt.pixelStorei(B.UNPACK_SKIP_IMAGES,br),Pt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&B.generateMipmap(Ht),Tt.unbindTexture()},this.initRenderTarget=function(C){$t.get(C).__webglFramebuffer===void 0&&Qt.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Qt.setTextureCube(C,0):C.isData3DTexture?Qt.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Qt.setTexture2DArray(C,0):Qt.setTexture2D(C,0),Tt.unbindTexture()},this.resetState=function(){Y=0,W=0,ct=null,Tt.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return xi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Re._getDrawingBufferColorSpace(t),e.unpackColorSpace=Re._getUnpackColorSpace()}};var Z0={type:"change"},Md={type:"start"},K0={type:"end"},Wh=new lr,J0=new li,tT=Math.cos(70*Oh.DEG2RAD),wn=new z,Jn=2*Math.PI,Ne={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Sd=1e-6,Xh=class extends Va{constructor(t,e=null){super(t,e),this.state=Ne.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Gs.ROTATE,MIDDLE:Gs.DOLLY,RIGHT:Gs.PAN},this.touches={ONE:Vs.ROTATE,TWO:Vs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Ln,this._lastTargetPosition=new z,this._quat=new Ln().setFromUnitVectors(t.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new vo,this._sphericalDelta=new vo,this._scale=1,this._panOffset=new z,this._rotateStart=new _t,this._rotateEnd=new _t,this._rotateDelta=new _t,this._panStart=new _t,this._panEnd=new _t,this._panDelta=new _t,this._dollyStart=new _t,this._dollyEnd=new _t,this._dollyDelta=new _t,this._dollyDirection=new z,this._mouse=new _t,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=nT.bind(this),this._onPointerDown=eT.bind(this),this._onPointerUp=iT.bind(this),this._onContextMenu=hT.bind(this),this._onMouseWheel=oT.bind(this),this._onKeyDown=aT.bind(this),this._onTouchStart=lT.bind(this),this._onTouchMove=cT.bind(this),this._onMouseDown=sT.bind(this),this._onMouseMove=rT.bind(this),this._interceptControlDown=uT.bind(this),this._interceptControlUp=fT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ne.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Z0),this.update(),this.state=Ne.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;wn.copy(e).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===Ne.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Jn:n>Math.PI&&(n-=Jn),s<-Math.PI?s+=Jn:s>Math.PI&&(s-=Jn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),e.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Wh.origin.copy(this.object.position),Wh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Wh.direction))<tT?this.object.lookAt(this.target):(J0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Wh.intersectPlane(J0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Sd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Sd||this._lastTargetPosition.distanceToSquared(this.target)>Sd?(this.dispatchEvent(Z0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Jn/60*this.autoRotateSpeed*t:Jn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){wn.setFromMatrixColumn(e,0),wn.multiplyScalar(-t),this._panOffset.add(wn)}_panUp(t,e){this.screenSpacePanning===!0?wn.setFromMatrixColumn(e,1):(wn.setFromMatrixColumn(e,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(t),this._panOffset.add(wn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new _t,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function eT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function nT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function iT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(K0),this.state=Ne.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function sT(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Gs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ne.DOLLY;break;case Gs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ne.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ne.ROTATE}break;case Gs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ne.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ne.PAN}break;default:this.state=Ne.NONE}this.state!==Ne.NONE&&this.dispatchEvent(Md)}function rT(i){switch(this.state){case Ne.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ne.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ne.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function oT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ne.NONE||(i.preventDefault(),this.dispatchEvent(Md),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(K0))}function aT(i){this.enabled!==!1&&this._handleKeyDown(i)}function lT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Vs.ROTATE:if(this.enableRotate===!1){this.state=Ne.NONE;break}this._handleTouchStartRotate(i),this.state=Ne.TOUCH_ROTATE;break;case Vs.PAN:if(this.enablePan===!1){this.state=Ne.NONE;break}this._handleTouchStartPan(i),this.state=Ne.TOUCH_PAN;break;default:this.state=Ne.NONE}break;case 2:switch(this.touches.TWO){case Vs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ne.TOUCH_DOLLY_PAN;break;case Vs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ne.TOUCH_DOLLY_ROTATE;break;default:this.state=Ne.NONE}break;default:this.state=Ne.NONE}this.state!==Ne.NONE&&this.dispatchEvent(Md)}function cT(i){switch(this._trackPointer(i),this.state){case Ne.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ne.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ne.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ne.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ne.NONE}}function hT(i){this.enabled!==!1&&i.preventDefault()}function uT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function fT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function bd(i,t=!1){let e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new gn;l.morphTargetsRelative=a;let c=0;for(let h=0;h<i.length;++h){let u=i[h],f=0,d=0;if(e!==(u.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in u.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(u.attributes[p]),f++}if(f!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==u.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in u.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(u.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(u.morphAttributes[p]),d++}if(d!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=u.index.count;else if(u.attributes.position!==void 0)p=u.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,h),c+=p}}if(e){let h=0,u=[];for(let f=0;f<i.length;++f){let d=i[f].index;for(let p=0;p<d.count;++p)u.push(d.getX(p)+h);h+=i[f].attributes.position.count}l.setIndex(u)}for(let h in r){let u=j0(r[h]);if(!u)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,u)}for(let h in o){let u=o[h][0].length;if(u!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let f=0;f<u;++f){let d=[];for(let _=0;_<o[h].length;++_)d.push(o[h][_][f]);let p=j0(d);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(p)}}}return l}function j0(i){let t,e,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new Pn(o,e,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let u=l/e;for(let f=0,d=h.count;f<d;f++)for(let p=0;p<e;p++){let _=h.getComponent(f,p);a.setComponent(f+u,p,_)}}else o.set(h.array,l);l+=h.count*e}return s!==void 0&&(a.gpuType=s),a}var Ao=40,dT=24e3,pT=100,Q0=48,mT=401,t_=254,di=(i,t=new z)=>t.set(i[1],-i[2],-i[0]);function e_(i,t){let[e,n,s]=[i.heading_rad/2,i.pitch_rad/2,i.roll_rad/2],r=wd[0].set(0,-Math.sin(e),0,Math.cos(e)),o=wd[1].set(Math.sin(n),0,0,Math.cos(n)),a=wd[2].set(0,0,-Math.sin(s),Math.cos(s));return t.copy(r).multiply(o).multiply(a)}var wd=[new Ln,new Ln,new Ln];function gT(i,t){let e=[],n=i==="tanker"?new qi(.34,.26,.6):new qi(.2,.12,.28),s=new _o(.22).translate(0,.28,0);if(t){for(let a of[Math.PI/4,-Math.PI/4])e.push(new dr(.34,1.3).rotateX(Math.PI/2).rotateY(a));let o=new ur(.14,.5,3).rotateX(-Math.PI/2).translate(0,.02,-.35);return e.push(o,...i==="pursuer"?[]:[n],...i==="target"?[s]:[]),bd(e.map(a=>a.index?a.toNonIndexed():a))}for(let[o,a]of[[1,1],[1,-1],[-1,1],[-1,-1]]){let l=new hr(.22,.22,.03,10);l.translate(.32*o,.05,.32*a);let c=new qi(.06,.05,.45);c.translate(0,0,.22),c.rotateY(Math.atan2(o,a)),e.push(l,c)}let r=new ur(.09,.3,6);return r.rotateX(-Math.PI/2),r.translate(0,.02,-.28),e.push(r,n),i==="target"&&e.push(s),bd(e.map(o=>o.index?o.toNonIndexed():o))}var qh=class{constructor(t,e,n){this.canvas=t,this.names=e,this.renderer=new Gh({canvas:t,antialias:!1,powerPreference:"low-power"}),this.scene=new pa,this.camera=new Xn(50,1,.05,5e3),this.controls=new Xh(this.camera,t),this.controls.maxPolarAngle=.97*Math.PI,this.controls.addEventListener("change",()=>this.dirty=!0),this.dirty=!0,this.mode="free";let s=new Ba(16777215,2.2);s.position.set(30,80,20),this.scene.add(new ka(16777215,1.3),s),this.material=new yo({side:fi}),this.bodies=new Map,this.lines=this.#t(0),this.paths=this.#t(0),this.scene.add(this.lines,this.paths),this.fixed=new hs,this.scene.add(this.fixed),this.madeOf=null,this.world=null,this.pathsOf={version:-1,until_s:NaN,chosen:null,dark:!1,at:0},this.size=1,this.places=[],this.target=new z,this.framed=!1,this.framedFar=0,this.touched=!1,this.controls.addEventListener("start",()=>this.touched=!0),this.width=0,this.height=0;let r=[0,0];t.addEventListener("pointerdown",o=>r=[o.clientX,o.clientY]),t.addEventListener("pointerup",o=>{if(Math.hypot(o.clientX-r[0],o.clientY-r[1])>4)return;let a=this.places.map(l=>({...l,off:Math.hypot(l.x-o.offsetX,l.y-o.offsetY)})).sort((l,c)=>l.off-c.off)[0];n(a&&a.off<24?a.sysid:null,o)}),t.addEventListener("keydown",o=>this.#e(o))}#e(t){let e={ArrowLeft:[.1,0],ArrowRight:[-.1,0],ArrowUp:[0,.08],ArrowDown:[0,-.08]}[t.key],n=this.camera.position.clone().sub(this.controls.target);if(e){let s=Math.hypot(n.x,n.z),r=Math.atan2(n.x,n.z)-e[0],o=Math.min(Math.max(Math.atan2(n.y,s)+e[1],-.2),1.5),a=n.length();n.set(a*Math.cos(o)*Math.sin(r),a*Math.sin(o),a*Math.cos(o)*Math.cos(r))}else if(t.key==="+"||t.key==="-")n.multiplyScalar(t.key==="+"?.85:1.18);else return t.key==="0"?void this.whole():void 0;this.camera.position.copy(this.controls.target).add(n),this.touched=!0,this.controls.update(),this.dirty=!0,t.preventDefault(),t.stopPropagation()}whole(){this.framed=this.touched=!1,this.mode="free",this.dirty=!0}#t(t){let e=new gn;e.setAttribute("position",new Pn(new Float32Array(3*t),3)),e.setAttribute("color",new Pn(new Float32Array(3*t),3));let n=new cr(e,new Os({vertexColors:!0,transparent:!0,opacity:.9}));return n.frustumCulled=!1,n}#n(t,e,n){let s=t.geometry;if(s.attributes.position.array.length<e.length){s.dispose();let a=new gn,l=Math.ceil(e.length*1.5);a.setAttribute("position",new Pn(new Float32Array(l-l%3),3)),a.setAttribute("color",new Pn(new Float32Array(l-l%3),3)),t.geometry=a}let{position:r,color:o}=t.geometry.attributes;r.array.set(e),o.array.set(n),r.needsUpdate=o.needsUpdate=!0,t.geometry.setDrawRange(0,e.length/3)}#s(t,e){let n=t.sessionAt(e),s=n?.wind,r=`${JSON.stringify(s??0)} ${JSON.stringify(t.session?.plans??0)} ${t.session?.vehicles.length} ${Ae().dark}`;if(this.madeOf===r&&this.world===n&&this.fixed.children.length)return;[this.madeOf,this.world]=[r,n];for(let y of this.fixed.children)(y instanceof Sn||y instanceof cr)&&y.geometry.dispose();this.fixed.clear();let o=Ae(),a=$o(t)??[[-10,10],[-10,10]],l=Math.max(a[0][1]-a[0][0],a[1][1]-a[1][0],10),c=Ul(l/6),h=2*Math.ceil(.75*l/c),u=new za(h*c,h,o.grid,o.grid),f=y=>Math.round((y[0]+y[1])/2/c)*c;u.position.set(f(a[1]),0,-f(a[0])),this.fixed.add(u);let d=new yo({color:o.solid,transparent:!0,opacity:.6,side:fi});for(let y of n?.obstacles??[]){let[M,x,R]=y.centre_ned,E=Math.max(y.bottom_d-y.top_d,.05),v;if(y.kind==="sphere")v=new Sn(new Da(y.radius_m??.5,20,14),d),di([M,x,R],v.position);else if(!y.outline_ne.length)v=new Sn(new _o(.3),d),di([M,x,R],v.position);else{let b=new mo;y.outline_ne.forEach(([I,T],P)=>b[P?"lineTo":"moveTo"](T,I)),v=new Sn(new La(b,{depth:E,bevelEnabled:!1}),d),v.rotation.x=-Math.PI/2,v.position.y=-y.bottom_d}this.fixed.add(v)}let p=[],_=[],m=(y,M,x)=>y.slice(1).forEach((R,E)=>{let v=di(y[E]),b=di(R),I=Math.min(Math.max(Math.round(v.distanceTo(b)/x),1),mT);for(let T=0;T<I;T+=2)p.push(...v.clone().lerp(b,T/I).toArray(),...v.clone().lerp(b,Math.min(T+1,I)/I).toArray()),_.push(...M.toArray(),...M.toArray())});for(let y of n?.vehicles??[])m(y.path_ned,new oe(o.soft),.8);for(let{points:y,colour:M}of Nm(t.session))m(y,new oe(M),Math.max(l/150,.8));if(s){let y=(s.from_deg+180)*Math.PI/180,M=new z(Math.sin(y),0,-Math.cos(y)),x=new z((a[1][0]+a[1][1])/2,.12*l,-(a[0][0]+a[0][1])/2),R=.14*l,E=x.clone().addScaledVector(M,-.62*l);this.fixed.add(new Ga(M,E,R,o.ink,.3*R,.14*R))}let g=this.#t(0);this.#n(g,p,_),this.fixed.add(g);for(let y of t.session?.bases??[]){let M=new Sn(new hr(1,1,.1,24),d);di(y.p_ned,M.position),this.fixed.add(M)}this.span=l,this.size=Math.min(Math.max(l/45,.6),4),this.scene.background=new oe(o.paper)}#i(t){let e=$o(t);if(!e)return 8;let[[n,s],[r,o]]=e;return 1.3*Math.max(1,1.3/this.camera.aspect)*Math.max(s-n,.9*(o-r),8)}#r(t){let e=$o(t);if(!e||!t.count)return;let[[n,s],[r,o]]=e,a=this.#i(t);this.target.set((r+o)/2,2,-(n+s)/2),this.controls.target.copy(this.target),this.camera.position.set(this.target.x-.35*a,2+.5*a,this.target.z+.72*a),this.controls.update(),this.framed=!0,this.framedFar=a}draw(t,e,{chosen:n,selected:s,paths:r,until_s:o,trail_s:a}){let l=this.canvas.getBoundingClientRect();if(!l.width||!l.height)return;(this.width!==l.width||this.height!==l.height)&&([this.width,this.height]=[l.width,l.height],this.renderer.setPixelRatio(Math.min(window.devicePixelRatio||1,2)),this.renderer.setSize(l.width,l.height,!1),this.camera.aspect=l.width/l.height,this.camera.updateProjectionMatrix()),this.#s(t,e.t_s);let c=this.#i(t)>1.15*this.framedFar;(!this.framed||c&&!this.touched)&&this.#r(t),this.#a(e,n),this.#o(t,e),this.paths.visible=r,r&&this.#l(t,o,a,n),this.#c(e,n),this.renderer.render(this.scene,this.camera),this.#h(e,n,s)}#a(t,e){let n=new Map([["pursuer",0],["target",0],["tanker",0]]),s=new De,r=new Ln,o=new z,a=new z,l=new oe,c=t.vehicles.length>Ao;for(let h of t.vehicles){if(!h.p_ned||this.mode==="first"&&h.sysid===e)continue;let u=n.has(h.role)?h.role:"pursuer",f=`${u} ${c}`,d=this.bodies.get(f);d||(d=new xa(gT(u,c),this.material,t_+1),d.frustumCulled=!1,this.bodies.set(f,d),this.scene.add(d));let p=n.get(u)??0;if(p>t_)continue;let _=this.size*(h.sysid===e?1.35:1);d.setMatrixAt(p,s.compose(di(h.p_ned,o),e_(h,r),a.setScalar(_))),d.setColorAt(p,l.set(h.alive?pn(h.sysid):Ae().solid)),n.set(u,p+1)}for(let[h,u]of this.bodies)u.count=h.endsWith(String(c))?n.get(h.split(" ")[0])??0:0,u.instanceMatrix.needsUpdate=!0,u.instanceColor&&(u.instanceColor.needsUpdate=!0)}#o(t,e){let n=[],s=[],r=Ae(),[o,a,l]=[new oe(r.soft),new oe(r.warn),new oe(r.crowd.replace(/,[^,]*\)$/,")").replace("rgba","rgb"))],c=(d,p,_)=>{n.push(d.x,d.y,d.z,p.x,p.y,p.z),s.push(_.r,_.g,_.b,_.r,_.g,_.b)},h=new Map,u=e.vehicles.length<=Ao,f=t.session?.ring_m??null;for(let d of e.vehicles){if(!d.p_ned)continue;let p=di(d.p_ned);if(h.set(d.sysid,p),u&&c(p,p.clone().setY(0),l),u&&d.aim_ned&&c(p,di(d.aim_ned),o),d.role==="target"&&f!==null)for(let _=0;_<Q0;_+=1){let[m,g]=[_,_+1].map(y=>2*Math.PI*y/Q0);c(new z(p.x+f*Math.cos(m),p.y,p.z+f*Math.sin(m)),new z(p.x+f*Math.cos(g),p.y,p.z+f*Math.sin(g)),o)}}for(let d of t.session?.bases??[])h.set(`base ${d.name}`,di(d.p_ned));for(let d of e.services){let p=h.get(d.tanker??`base ${d.base}`),_=h.get(d.receiver);if(!p||!_)continue;let m=d.phase==="transfer"?1:9;for(let g=0;g<m;g+=2)c(p.clone().lerp(_,g/m),p.clone().lerp(_,(g+1)/m),a);if(d.phase==="transfer")for(let g of[-.06,.06])c(p.clone().add(new z(0,g,0)),_.clone().add(new z(0,g,0)),a)}for(let d of e.traffic){let p=di(d.p_ned),_=.6*this.size,[m,g]=[p.clone().setY(p.y+_),p.clone().setY(p.y-_)],y=[[_,0],[0,_],[-_,0],[0,-_]].map(([M,x])=>new z(p.x+M,p.y,p.z+x));y.forEach((M,x)=>{c(m,M,a),c(g,M,a),c(M,y[(x+1)%4],a)})}this.#n(this.lines,n,s)}#l(t,e,n,s){let r=Ae().dark,o=this.pathsOf,a=performance.now();if(o.version===t.version&&o.until_s===e&&o.chosen===s&&o.dark===r||t.columns.size>Ao&&a-o.at<900&&o.chosen===s&&o.dark===r&&e>=o.until_s)return;this.pathsOf={version:t.version,until_s:e,chosen:s,dark:r,at:a};let l=si(t.t_s,e+1e-6,t.count)+1,c=si(t.t_s,e-n,t.count)+1,h=[],u=[],f=new oe(Ae().paper);for(let[d,{n:p,e:_,d:m}]of t.columns){let g=t.columns.size>Ao,y=new oe(pn(d));(s===null?g:d!==s)&&y.lerp(f,g?.6:.45);let M=g&&d!==s?c:0,x=Math.max(Math.ceil((l-M)/(g?pT:dT/t.columns.size)),1);for(let R=M;R<l-1;R+=x){let E=Math.min(R+x,l-1);Number.isNaN(p[R])||Number.isNaN(p[E])||(h.push(_[R],-m[R],-p[R],_[E],-m[E],-p[E]),u.push(y.r,y.g,y.b,y.r,y.g,y.b))}}this.#n(this.paths,h,u)}#c(t,e){let n=t.vehicles.find(r=>r.sysid===e);if(this.controls.enabled=this.mode!=="first"||!n?.p_ned,!n?.p_ned||this.mode==="free"){this.controls.update();return}let s=di(n.p_ned);if(this.mode==="follow"){let r=this.camera.position.clone().sub(this.controls.target),o=Math.min(r.length(),14*this.size);this.controls.target.copy(s),this.camera.position.copy(s).add(r.setLength(Math.max(o,2*this.size))),this.camera.lookAt(s);return}e_(n,this.camera.quaternion),this.camera.position.copy(s).add(new z(0,.12,0).applyQuaternion(this.camera.quaternion))}#h(t,e,n){let s=Math.min(window.devicePixelRatio||1,2),{width:r,height:o}=this;this.names.width!==Math.round(r*s)&&(this.names.width=Math.round(r*s)),this.names.height!==Math.round(o*s)&&(this.names.height=Math.round(o*s));let a=Vr(this.names);a.setTransform(s,0,0,s,0,0),a.clearRect(0,0,r,o),a.font="600 12px system-ui, sans-serif";let{ink:l,paper:c,warn:h}=Ae(),u=new z,f=t.vehicles.length>Ao;this.places=[];let d=[],p=(m,g,y,M)=>{d.some(([x,R])=>Math.abs(x-g)<24&&Math.abs(R-y)<13)||(d.push([g,y]),a.lineWidth=3,a.strokeStyle=c,a.strokeText(m,g+9,y-7),a.fillStyle=M,a.fillText(m,g+9,y-7))},_=[...t.vehicles].sort((m,g)=>+(g.sysid===e)-+(m.sysid===e)||g.severity-m.severity);for(let m of _){if(!m.p_ned||(di(m.p_ned,u).project(this.camera),u.z>1))continue;let[g,y]=[(u.x+1)/2*r,(1-u.y)/2*o];this.places.push({sysid:m.sysid,x:g,y}),Nl(a,m,g,y,f?5:8),n.has(m.sysid)&&(m.sysid!==e||this.mode!=="first")&&(a.strokeStyle=l,a.lineWidth=m.sysid===e?2.5:1.5,a.beginPath(),a.arc(g,y,15,0,2*Math.PI),a.stroke()),d.length<Ao&&(!f||m.sysid===e||m.severity>1||m.role!=="pursuer")&&p(String(m.sysid),g,y,l)}for(let m of t.traffic)di(m.p_ned,u).project(this.camera),u.z<=1&&p(m.callsign,(u.x+1)/2*r,(1-u.y)/2*o,h)}};var Td=14,el=[];function n_(i){el=i}function i_(i){let t=el.findIndex(e=>e.name===i.condition);return t<0?el.length:t}function _T(i,t){return i.slice(0,Td).map((n,s)=>`${n.sysid}${n.figure?` (${n.figure}${s||!t?"":` ${t}`})`:""}`).join(", ")+(i.length>Td?` and ${i.length-Td} more`:"")}var Yh=class{constructor(t){this.well=F("p",{class:"well"}),this.parts=new Map;let e=F("ul");for(let{name:n,title:s}of el){let[r,o]=[F("b"),F("span",{class:"figures-of"})],a=F("button",{type:"button",onclick:()=>t(this.parts.get(n)?.sysids??[])},F("span",{class:"sign","aria-hidden":"true"},Wu[n]??""),r,o),l=F("li",{class:n,"data-condition":n,"data-title":s},a);l.hidden=!0,e.append(l),this.parts.set(n,{item:l,button:a,count:r,text:o,sysids:[]})}this.counts=F("p",{class:"unseen","aria-live":"polite"}),this.all=F("div",{class:"all"}),this.element=F("section",{class:"strip","aria-label":"trouble"},this.well,e,this.all,this.counts)}show(t){let e=[];for(let{name:r,title:o,unit:a}of el){let l=this.parts.get(r);if(!l)continue;let c=t.vehicles.filter(u=>u.condition===r).sort((u,f)=>f.urgency-u.urgency||u.sysid-f.sysid);if(l.sysids=c.map(u=>u.sysid),l.item.hidden!==!c.length&&(l.item.hidden=!c.length),!c.length)continue;let h=`${o}: ${_T(c,a)}`;Ge(l.count,String(c.length)),Ge(l.text,h),l.button.title=`${h}. Click to select.`,e.push(`${c.length} ${o.toLowerCase()}`)}let n=t.vehicles.filter(r=>r.armed).length,s=e.length?"":`All well · ${t.vehicles.length} ${t.vehicles.length===1?"vehicle":"vehicles"}, ${n} armed`;this.well.hidden!==!s&&(this.well.hidden=!s),Ge(this.well,s),Ge(this.counts,e.join(", "))}};var $h=10,yT=40,Xs=[{key:"id",name:"id",text:i=>String(i.sysid),sort:i=>i.sysid},{key:"trouble",name:"trouble",word:!0,text:i=>i.trouble.join(", ")||i.note||(i.landed?"landed":""),sort:i_},{key:"state",name:"state",word:!0,folds:!0,text:i=>i.state||(i.alive?"–":"lost"),sort:i=>i.state},{key:"mode",name:"mode",word:!0,folds:!0,text:i=>i.mode||"–",sort:i=>i.mode},{key:"role",name:"role",word:!0,folds:!0,text:i=>i.role,sort:i=>i.role},{key:"battery",name:"battery %",text:i=>xe(i.battery===null?null:100*i.battery,0),sort:i=>i.battery??-1},{key:"height",name:"height m",text:i=>xe(i.height_m,1),sort:i=>i.height_m??-1e9},{key:"speed",name:"speed m/s",text:i=>xe(i.speed_m_s,1),sort:i=>i.speed_m_s},{key:"target",name:"target m",text:i=>xe(i.target_m,1),sort:i=>i.target_m??-1}],xT=Xs.filter(i=>i.folds),s_=i=>[i.word&&"word",i.folds&&"folds",i.key==="trouble"&&"trouble"].filter(Boolean).join(" "),Zh=class{constructor(t,e){this.choose=e,this.by="trouble",this.down=!1,this.rows=new Map,this.shown_at=0,this.filter=F("input",{type:"search",placeholder:"filter, e.g. tanker, served, 12","aria-label":"filter vehicles",oninput:()=>this.again()}),this.goto=F("input",{type:"text",inputmode:"numeric",size:4,placeholder:"id","aria-label":"go to vehicle"});let n=F("form",{class:"goto",onsubmit:r=>{r.preventDefault();let o=Number(this.goto.value);this.rows.has(o)&&e(o,!0),this.goto.setCustomValidity(this.rows.has(o)?"":"There is no such vehicle."),this.goto.reportValidity()}},this.goto,F("button",{type:"submit"},"go to"));this.goto.addEventListener("input",()=>this.goto.setCustomValidity("")),this.totals=F("p",{class:"totals small","aria-live":"off"}),this.histogram=F("div",{class:"histogram",role:"img"}),this.heads=Xs.map(r=>{let o=F("button",{type:"button",onclick:()=>this.sortBy(r.key)},r.name);return F("th",{scope:"col",class:s_(r)},o)}),this.body=F("tbody");let s=F("table",{class:"fleet"},F("thead",{},F("tr",{},...this.heads)),this.body);t.append(F("div",{class:"tools"},this.filter,n),this.totals,this.histogram,F("div",{class:"scroll fleet-scroll",tabindex:0,role:"region","aria-label":"vehicles"},s)),this.sortBy("trouble",!1)}sortBy(t,e=!0){this.down=e&&this.by===t&&!this.down,this.by=t,this.heads.forEach((n,s)=>{Xs[s].key===t?n.setAttribute("aria-sort",this.down?"descending":"ascending"):n.removeAttribute("aria-sort")}),this.again()}again(){this.last&&this.show(this.last.snapshot,this.last.chosen,this.last.picked,!0)}show(t,e,n,s=!1){let r=this.last?.picked!==n;this.last={snapshot:t,chosen:e,picked:n};let o=t.vehicles.length>yT?500:180;if(!s&&!r&&performance.now()-this.shown_at<o)return;this.shown_at=performance.now();let a=this.filter.value.trim().toLowerCase(),l=Xs.find(u=>u.key===this.by)??Xs[0],c=[...t.vehicles].sort((u,f)=>{let[d,p]=[l.sort(u),l.sort(f)],_=d<p?-1:d>p?1:u.sysid-f.sysid;return this.down?-_:_}),h=[];for(let u of c){let f=this.rows.get(u.sysid)??this.#e(u);Xs.forEach((g,y)=>Ge(f.texts[y],g.text(u))),Ge(f.sign,Im(u)),Ge(f.folded,xT.map(g=>g.text(u)).filter(g=>g!=="–").join(" · "));let d=pn(u.sysid);f.colour!==d&&(f.swatch.style.background=f.colour=d);let p=`${u.sysid} ${u.role} ${u.label} ${u.state} ${u.mode} ${u.note} ${u.trouble.join(" ")}`.toLowerCase(),_=a!==""&&!a.split(/\s+/).every(g=>/^\d+$/.test(g)?String(u.sysid).startsWith(g):p.includes(g));f.row.hidden!==_&&(f.row.hidden=_);let m=String(n.has(u.sysid));f.row.getAttribute("aria-selected")!==m&&f.row.setAttribute("aria-selected",m),f.row.className!==u.condition&&(f.row.className=u.condition),h.push(f.row)}(h.some((u,f)=>this.body.children[f]!==u)||this.body.children.length!==h.length)&&this.body.replaceChildren(...h),this.#t(t),r&&e!==null&&this.rows.get(e)?.row.scrollIntoView({block:"nearest"})}between(t,e,n){if(!(n.target instanceof Node&&this.body.contains(n.target)))return null;let s=[...this.rows].filter(([,a])=>!a.row.hidden).sort(([,a],[,l])=>a.row.rowIndex-l.row.rowIndex).map(([a])=>a),[r,o]=[s.indexOf(t),s.indexOf(e)].sort((a,l)=>a-l);return r<0?null:s.slice(r,o+1)}#e(t){let e=F("i",{class:"swatch"}),n=F("span",{class:"sign","aria-hidden":"true"}),s=F("small",{class:"folded"}),r=Xs.map((l,c)=>c?F("span"):F("button",{type:"button",class:"link"})),o=Xs.map((l,c)=>{let h={id:[e],trouble:[n]}[l.key]??[];return F("td",{class:s_(l)},...h,r[c],l.key==="trouble"?s:null)}),a={row:F("tr",{onclick:l=>this.choose(t.sysid,!1,l)},...o),texts:r,sign:n,folded:s,swatch:e,colour:""};return this.rows.set(t.sysid,a),a}#t(t){let e=new Map,n=new Array($h).fill(0);for(let a of t.vehicles){let l=a.mode||a.state||"unknown";e.set(l,(e.get(l)??0)+1),a.battery!==null&&Number.isFinite(a.battery)&&(n[Math.min(Math.max(Math.floor($h*a.battery),0),$h-1)]+=1)}let s=[...e].sort((a,l)=>l[1]-a[1]).map(([a,l])=>`${l} ${a}`);Ge(this.totals,`${t.vehicles.length} vehicles: ${s.join(", ")}`);let r=Math.max(...n,1);for(;this.histogram.children.length<$h;)this.histogram.append(F("span"));n.forEach((a,l)=>{let c=this.histogram.children[l];c.style.height=`${100*a/r}%`,c.title=`${a} with ${10*l} to ${10*l+10} %`,c.className=l<2?"low":""});let o=n[0]+n[1];this.histogram.setAttribute("aria-label",`batteries, by tenths from empty to full: ${n.join(", ")}; ${o} below 20 %`)}};var vT=100;function nl(){let i=Number.parseFloat(new URLSearchParams(location.hash.slice(1)).get("t")??"");return Number.isFinite(i)?i:null}var Jh=class{constructor(t,e){this.player=e,this.marks=F("canvas",{class:"marks","aria-hidden":"true"}),this.slider=F("input",{type:"range",min:0,max:1,step:.1,value:0,"aria-label":"time",oninput:()=>{this.dragged_at=performance.now(),e.seek(Number(this.slider.value))}}),this.dragged_at=-1/0,this.play=F("button",{type:"button",onclick:()=>e.toggle()},"pause"),this.slower=F("button",{type:"button","aria-label":"slower",onclick:()=>e.faster(-1)},"−"),this.quicker=F("button",{type:"button","aria-label":"faster",onclick:()=>e.faster(1)},"+"),this.speed=F("span",{class:"value"}),this.time=F("span",{class:"value time"}),this.live=F("button",{type:"button",class:"live",onclick:()=>e.newest?.()},"live"),this.live.hidden=!e.newest,this.marked="",t.append(F("div",{class:"tools"},this.play,this.slower,this.speed,this.quicker,this.time,this.live),F("div",{class:"line"},this.marks,this.slider))}show({now_s:t,begin_s:e,end_s:n,playing:s,speed:r,following:o,events:a}){Ge(this.play,s?"pause":"play"),Ge(this.speed,r),Ge(this.time,`${Ai(t)} of ${Ai(n)}`),this.live.setAttribute("aria-pressed",String(o));let[l,c]=[e.toFixed(1),Math.max(n,e+.1).toFixed(1)];this.slider.min!==l&&(this.slider.min=l),this.slider.max!==c&&(this.slider.max=c),performance.now()-this.dragged_at>4*vT&&(this.slider.value=t.toFixed(1)),this.slider.setAttribute("aria-valuetext",Ai(t));let u=`${this.marks.clientWidth} ${a.length} ${l} ${c} ${Ae().dark}`;if(u===this.marked)return;this.marked=u;let{width:f,height:d,scale:p}=bl(this.marks),_=Vr(this.marks),{bad:m,warn:g,soft:y}=Ae();_.setTransform(p,0,0,p,0,0),_.clearRect(0,0,f,d);let M=Math.max(n-e,.1);for(let x of["info","warning","critical"]){_.fillStyle=x==="info"?y:x==="warning"?g:m;let R=x==="info"?.4:x==="warning"?.7:1;for(let E of a)E.level!==x||E.t_s<e||E.t_s>n||_.fillRect((E.t_s-e)/M*f-.75,d*(1-R),1.5,d*R)}}};var vs=[.1,.25,.5,1,2,5,10,20,50,100],qs=16,ST=20,MT=500,bT=300,wT=200,TT=[{title:"Distance to target",unit:"m",digits:2,channel:"target",zero:!0},{title:"Battery",unit:"%",digits:1,channel:"battery",zero:!0},{title:"Height",unit:"m",digits:2,channel:"height"},{title:"Speed",unit:"m/s",digits:2,channel:"speed",zero:!0},{title:"State v of each competitor",unit:"",digits:3,channel:"v",range:[-.03,1.06]},{title:"Frames lost so far",unit:"",digits:0,channel:"lost",zero:!0}],Ro=class{constructor(t,{charts:e,player:n}){this.flight=new Il,this.time=new Pl,this.at_s=null,this.chosen=null,this.selected=new Set,this.shown=new Set,this.given=!1,this.paths=!0,this.whole_paths=!1,this.view="space",this.player=n,this.playing=!0,this.speed="",this.begin_s=void 0,this.end_s=void 0,this.dirty=!0,this.drawn_ms=0,this.frames=0,this.after=[],this.current=null,this.paneled=null,this.paneledFor=null,this.charted=-1,this.charted_at=0,this.shown_at=0,this.time.seek=y=>n.seek(y),this.drawnFirst=()=>{},this.first=new Promise(y=>this.drawnFirst=()=>y(null));let s=(y,M)=>this.pick(y,M);this.strip=new Yh(y=>this.select(y));let r=F("canvas",{class:"space",tabindex:0,role:"img","aria-label":"the fleet in space; arrow keys turn, + and − zoom, 0 shows everything"}),o=F("canvas",{class:"names","aria-hidden":"true"}),a=F("canvas",{class:"map",tabindex:0,role:"img","aria-label":"the fleet from above, north up; arrow keys move, + and − zoom, 0 shows everything"});this.views={space:F("button",{type:"button",onclick:()=>this.show("space")},"3-D"),map:F("button",{type:"button",onclick:()=>this.show("map")},"map")},this.camera=F("select",{"aria-label":"camera",onchange:()=>this.setCamera(this.camera.value)},F("option",{value:"free"},"free view"),F("option",{value:"follow"},"follow chosen"),F("option",{value:"first"},"from its eyes"));let l=F("button",{type:"button",onclick:()=>this.whole()},"show all");this.pathsButton=F("button",{type:"button","aria-pressed":"true",onclick:()=>this.togglePaths()},"paths"),this.wind=F("span",{class:"soft wind"});let c=F("div",{class:"picture"},r,o,a),h=F("div",{class:"tools"},this.views.space,this.views.map,this.camera,l,this.pathsButton,this.wind),u=F("section",{class:"card scene","aria-label":"picture"},h,c),f=F("section",{class:"card time-line","aria-label":"time"}),d=F("section",{class:"card","aria-label":"fleet"},F("h2",{},"Fleet")),p=F("section",{class:"card vehicle","aria-label":"vehicle"},F("h2",{},"Vehicle")),_=F("section",{class:"card contest","aria-label":"competition and refuelling"},F("h2",{},"Competition and refuelling")),m=F("section",{class:"card","aria-label":"events"},F("h2",{},"Events"));this.vehicleAt=F("div",{class:"vehicle-page"}),this.orders=F("div",{class:"tools orders"}),this.selection=F("p",{class:"small selection","aria-live":"polite"}),p.append(this.selection,this.orders,this.vehicleAt),this.contestAt=F("div"),_.append(this.contestAt),this.plansAt=F("div",{class:"plans"}),this.plansCard=F("section",{class:"card","aria-label":"missions and fences"},F("h2",{},"Missions and fences"),this.plansAt),this.plansCard.hidden=!0,t.append(F("div",{class:"flight"},F("div",{class:"wide"},u,f),F("div",{class:"narrow"},d,p),F("div",{class:"narrow"},this.plansCard,_,m))),this.map=new Wr(a,s);try{this.space=new qh(r,o,s)}catch{this.space=null,this.views.space.disabled=!0}this.timeline=new Jh(f,n),this.table=new Zh(d,(y,M,x)=>{this.pick(y,x),M&&this.setCamera("follow")}),this.events=new Fl(m,y=>{y.sysid>0&&y.sysid<255&&this.choose(y.sysid),n.seek(y.t_s)}),this.charts=[],this.picker=null,e&&this.#e(t),this.show(this.space?"space":"map"),El(()=>{this.dirty=!0,this.charted_at=0,this.space&&(this.space.pathsOf.version=-1),this.table.again(),this.fillPicker()}),new ResizeObserver(()=>this.dirty=!0).observe(c);let g=()=>{requestAnimationFrame(g),this.#s()};requestAnimationFrame(g)}#e(t){this.picker=F("fieldset",{class:"picker"},F("legend",{},"Vehicles:"));let e=F("div",{class:"figures"});t.append(F("section",{class:"charts","aria-label":"charts"},F("h2",{},"Over time"),this.picker,e));let n=new IntersectionObserver(s=>{for(let r of s){let o=this.charts.find(a=>a.div===r.target);o&&(o.seen=r.isIntersecting),this.charted_at=0}});for(let s of TT){let r=F("div",{class:"plot",role:"img","aria-label":`${s.title} over time`});e.append(F("figure",{},r)),this.charts.push({chart:new Gr(r,this.time,o=>this.label(o)),div:r,make:()=>this.#t(s),seen:!1}),n.observe(r)}}#t(t){let{flight:e}=this,n=e.t_s.subarray(0,e.count),s=[];for(let[u,f]of e.columns){let d=f[t.channel].subarray(0,e.count);this.shown.has(u)&&d.some(p=>!Number.isNaN(p))&&s.push({id:u,x:n,y:d})}let r=e.newest?.goal,o=t.channel==="target"&&r?.pursue_within_m?[{y:r.pursue_within_m,label:`goal: within ${r.pursue_within_m} m`}]:[],a=e.columns.size>qs?this.#n(t.channel):void 0,l=t.channel==="battery"||t.channel==="v"?[...e.newest?.history??[],...e.newest?.services??[]]:[],c=t.channel==="v"?l.map(u=>({t_s:u.decided_at_s,id:u.receiver,label:`→ ${u.receiver}`})):[],h=t.channel!=="battery"?[]:(e.newest?.history??[]).filter(u=>u.start_s!==null&&this.shown.has(u.receiver)).map(u=>({from:u.start_s??0,to:u.end_s??e.last_s,id:u.receiver}));return{panels:[{...t,limits:o,lines:s,own:[],band:a}],marks:c,spans:h}}#n(t){let{flight:e}=this,n=Math.max(Math.floor(e.count/bT),1),s=[...e.columns.values()].map(c=>c[t]),[r,o,a,l]=[[],[],[],[]];for(let c=0;c<e.count;c+=n){let h=Float32Array.from(s,u=>u[c]).filter(u=>!Number.isNaN(u)).sort();r.push(e.t_s[c]),o.push(h[0]??NaN),a.push(h[h.length>>1]??NaN),l.push(h[h.length-1]??NaN)}return{least:{x:r,y:o},median:{x:r,y:a},greatest:{x:r,y:l},count:s.length}}label(t){return this.flight.session?.vehicles.find(e=>e.sysid===t)?.label??`vehicle ${t}`}members(){let t=this.flight.session?.vehicles??[];Tl(t),this.given||(this.shown=new Set(t.length>qs?[]:t.map(n=>n.sysid))),this.space&&(this.space.madeOf=null),this.plansCard.hidden=!Hr(this.flight.session).length;let e=this.flight.session?.wind;Ge(this.wind,e?`wind ${xe(e.speed_m_s,1)} m/s from ${xe(e.from_deg,0)}°`:""),this.fillPicker(),this.dirty=!0}fillPicker(){if(!this.picker)return;let t=this.flight.session?.vehicles??[],n=(t.length>qs?t.filter(s=>this.shown.has(s.sysid)):t).map(s=>{let r=F("i",{class:"swatch"});return r.style.background=pn(s.sysid),F("button",{type:"button","aria-pressed":String(this.shown.has(s.sysid)),onclick:()=>this.toggle(s.sysid)},r,s.label)});if(this.picker.replaceChildren(F("legend",{},t.length>qs?"Drawn singly:":"Vehicles:"),...n),t.length>qs){let s=F("select",{"aria-label":"draw one more vehicle singly",onchange:()=>s.value&&this.toggle(Number(s.value))},F("option",{value:""},"one more …"),...t.filter(o=>!this.shown.has(o.sysid)).map(o=>F("option",{value:o.sysid},o.label)));this.picker.append(s,F("span",{class:"small soft"},"The ground is from the least to the greatest of all vehicles, dotted their median."))}}toggle(t){this.shown.delete(t)||this.shown.add(t),this.given=!0,this.fillPicker(),this.charted_at=0,this.after.forEach(e=>e())}choose(t){this.select(t===null?[]:[t])}pick(t,e){if(t===null||!(e?.shiftKey||e?.ctrlKey||e?.metaKey))return this.choose(t);let n=e.shiftKey&&this.chosen!==null?this.table.between(this.chosen,t,e):null;if(n)return this.select([...new Set([t,...n,...this.selected])]);let s=[...this.selected].filter(r=>r!==t);this.select(this.selected.has(t)?s:[t,...s])}select(t){let e=t[0]??null;this.chosen=e,this.selected=new Set(t),Ge(this.selection,t.length>1?`${t.length} vehicles selected: hold, return and land go to all of them.`:""),(this.flight.session?.vehicles.length??0)>qs&&e!==null&&!this.shown.has(e)&&this.toggle(e),e===null&&this.setCamera("free"),this.dirty=!0}chooseNext(t){let e=(this.flight.session?.vehicles??[]).map(s=>s.sysid).sort((s,r)=>s-r);if(!e.length)return;let n=this.chosen===null?t>0?-1:0:e.indexOf(this.chosen);this.choose(e[(n+t+e.length)%e.length])}show(t){this.view=t==="space"&&this.space?"space":"map";for(let[e,n]of Object.entries(this.views))n.setAttribute("aria-pressed",String(e===this.view));this.map.canvas.hidden=this.view!=="map",this.space&&(this.space.canvas.hidden=this.space.names.hidden=this.view!=="space"),this.setCamera(this.camera.value)}setCamera(t){this.camera.value=t,this.space&&(this.space.mode=t),this.map.follow=t!=="free",this.dirty=!0}nextCamera(){let t=["free","follow","first"];this.setCamera(t[(t.indexOf(this.camera.value)+1)%t.length])}whole(){this.setCamera("free"),this.map.whole(),this.space?.whole(),this.dirty=!0}togglePaths(){this.paths=!this.paths,this.pathsButton.setAttribute("aria-pressed",String(this.paths)),this.dirty=!0}nextTheme(){nr()}present(){let{flight:t,at_s:e}=this;return e===null?t.newest:t.at(e)}#s(){let t=performance.now(),e=(this.view==="space"?this.space?.dirty:this.map.dirty)??!1;if(!this.dirty&&!e)return void this.#i(t);let n=this.present();if(!n)return;this.dirty=!1,this.map.dirty=!1,this.space&&(this.space.dirty=!1);let s=this.at_s??n.t_s,r={chosen:this.chosen,selected:this.selected,paths:this.paths,until_s:s,trail_s:this.whole_paths&&!this.playing?1/0:ST};this.view==="space"?this.space?.draw(this.flight,n,r):this.map.draw(this.flight,n,r),this.frames+=1,this.drawnFirst(),this.current=n,this.time.begin_s=this.flight.first_s,this.time.end_s=Math.max(this.flight.last_s,this.end_s??0),this.time.setNow(s),this.timeline.show({now_s:s,begin_s:this.begin_s??this.flight.first_s,end_s:this.end_s??Math.max(this.flight.last_s,n.t_s),playing:this.playing,speed:this.speed,following:this.at_s===null,events:this.flight.events}),this.#i(t)}#i(t){let e=this.current;if(e&&t-this.shown_at>(this.flight.columns.size>qs?2.5:1)*wT&&this.paneled!==e){this.shown_at=t,this.paneled=e,this.table.show(e,this.chosen,this.selected),this.strip.show(e),Om(this.plansAt,this.flight.session,e),zm(this.contestAt,e,n=>this.label(n)),$u(this.vehicleAt,e,this.chosen),this.events.show(this.flight.events,this.at_s??1/0,n=>this.label(n));return}if(e&&this.paneledFor!==this.selected&&(this.paneledFor=this.selected,this.table.show(e,this.chosen,this.selected,!0),$u(this.vehicleAt,e,this.chosen)),this.charts.length&&t-this.charted_at>(this.flight.columns.size>qs?2:1)*MT&&this.charted!==this.flight.version){this.charted_at=t,this.charted=this.flight.version;for(let n of this.charts)n.seen&&n.chart.draw(n.make(),this.shown)}this.charted_at===0&&(this.charted=-1)}};var r_=[.25,.5,1,2,4],ET=4401,AT="skytender",Kh=class{constructor(t,e,n){this.restart=n,this.take=t,this.changed=e,this.state="connecting",this.heard=0,this.sent=0,this.tries=0,this.socket=null,this.waiting=new Map,this.token=new URLSearchParams(location.hash.slice(1)).get("token")??""}open(){let t=location.protocol==="https:"?"wss":"ws",e=new WebSocket(`${t}://${location.host}/stream`,[AT,`token.${this.token||"none"}`]);this.socket=e,e.onopen=()=>{this.tries=0,this.#t("open")},e.onmessage=n=>{let s=JSON.parse(n.data);for(let r of Array.isArray(s)?s:[s])this.#e(r)},e.onclose=n=>{if(this.state!=="ended"){if(this.#n(),n.code===ET)return void this.#t("refused");this.#t("lost"),setTimeout(()=>this.open(),1e3*r_[Math.min(this.tries,r_.length-1)]),this.tries+=1}}}#e(t){if(t.type==="reply"){let e=this.waiting.get(String(t.id));this.waiting.delete(String(t.id)),e?.(t.ok,t.text);return}if(t.type==="session"&&t.events!==void 0){let e=t.told??0,n=e<this.heard,s=Math.min(e-(n?0:this.heard),t.events.length);this.heard=e,n&&this.restart(),t={...t,events:t.events.slice(t.events.length-s)}}else t.type==="snapshot"?this.heard+=t.events.length:t.type==="end"&&this.#t("ended");this.take(t)}send(t,e){if(this.state!=="open"||!this.socket)return void e?.(!1,"There is no connection: it was not sent.");this.sent+=1;let n=`page-${this.sent}`;e&&this.waiting.set(n,e),this.socket.send(JSON.stringify({...t,id:n}))}#t(t){this.state=t,this.changed(t)}#n(){for(let t of this.waiting.values())t(!1,"The connection was lost before an answer came.");this.waiting.clear()}};var jh=class{constructor(t,e){this.orders=t,this.send=e,this.notices=F("div",{class:"notices",role:"status","aria-live":"polite"}),this.dialog=F("dialog",{class:"ask","aria-labelledby":"ask-question"}),document.body.append(this.notices,this.dialog)}notice(t,e=""){let n=F("p",{class:e},t);for(this.notices.append(n);this.notices.children.length>4;)this.notices.firstChild?.remove();setTimeout(()=>n.remove(),e==="bad"?12e3:6e3)}askMany(t,e,n,s,r){if(this.dialog.open)return;let o=(r()?.vehicles??[]).filter(d=>e.includes(d.sysid)),a=o.flatMap(d=>Ed(d)?[`${s(d.sysid)} ${Ed(d)}`]:[]),l=o.filter(d=>!Ed(d)).map(d=>d.sysid),c=`${t.name[0].toUpperCase()}${t.name.slice(1)} ${n?"all ":""}${o.length} vehicles?`,h=F("ul",{class:"refusing"},...a.map(d=>F("li",{},d))),u=n?"":e.join(", "),f=F("button",{type:"submit",value:"yes",class:"primary"},"Yes");f.disabled=!l.length,this.dialog.replaceChildren(F("form",{method:"dialog"},F("h2",{id:"ask-question"},c),u?F("p",{},u):null,t.means?F("p",{class:"soft"},t.means):null,a.length?F("p",{class:"bad"},`${a.length} of them cannot:`):null,a.length?h:null,F("p",{class:"buttons"},f,F("button",{type:"submit",value:"no"},"No")))),this.dialog.returnValue="no",this.dialog.onclose=()=>{if(this.dialog.returnValue!=="yes")return;let d=[],p=l.length;this.notice(`${t.name} ${l.length} vehicles: sent`);for(let _ of l)this.send({command:t.command,sysid:_},(m,g)=>{if(m||d.push(g||`${s(_)}: not taken`),p-=1,p)return;let y=`${t.name}: ${l.length-d.length} of ${l.length} obey.`;this.notice([y,...d].join(" "),d.length?"bad":"good")})},this.dialog.showModal(),(l.length?f:this.dialog.querySelector("button[value=no]"))?.focus()}ask(t,e,n,s){if(this.dialog.open)return;if(t.of_vehicle&&e===null)return void this.notice("No vehicle is chosen: choose one in the table, on the map or by its id.","bad");let r=t.command==="pause"&&s()?.phase==="paused",o=r?"Go on with the session?":t.question.replace("{}",e===null?"":n(e)),a=()=>s()?.vehicles.find(_=>_.sysid===e),l=F("p",{class:"soft"}),c=()=>{let _=t.of_vehicle?a():void 0;Ge(l,[_?RT(_):"",t.means].filter(Boolean).join(". "))},h=t.command==="retarget"?(s()?.vehicles??[]).filter(_=>_.role==="target"):[];if(t.command==="retarget"&&!h.length)return void this.notice("There is no target.","bad");let u=F("select",{"aria-label":"target"},...h.map(_=>F("option",{value:_.sysid},_.label))),f=F("button",{type:"submit",value:"yes",class:"primary"},"Yes"),d=F("form",{method:"dialog"},F("h2",{id:"ask-question"},o),l,h.length?F("p",{},u):null,F("p",{class:"buttons"},f,F("button",{type:"submit",value:"no"},"No")));this.dialog.replaceChildren(d),this.dialog.returnValue="no",this.dialog.onclose=()=>{if(clearInterval(p),this.dialog.returnValue!=="yes")return;let _={command:r?"resume":t.command};t.of_vehicle&&(_.sysid=e),h.length&&(_.target=Number(u.value));let m=t.of_vehicle&&e!==null?`${t.name} ${n(e)}`:r?"resume":t.name;this.notice(`${m}: sent`),this.send(_,(g,y)=>this.notice(`${m}: ${y||(g?"taken":"not taken")}`,g?"good":"bad"))},c();let p=setInterval(c,500);this.dialog.showModal(),f.focus()}};function Ed(i){return i.alive?i.heard_s===null?"has not sent any telemetry yet.":"":"is dead."}function RT(i){let t=i.battery===null?"":`, battery ${(100*i.battery).toFixed(0)} %`,e=i.height_m===null?"":`, ${i.height_m.toFixed(1)} m high`;return`${i.mode||i.state||"mode not known"}${e}${t}`}var o_={whole:680,half:332},CT=30;async function PT(i){let t=atob((document.getElementById(i)?.textContent??"").trim()),e=Uint8Array.from(t,s=>s.charCodeAt(0)),n=new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(n).arrayBuffer()}function Qh(i){document.documentElement.dataset[i]=String(Math.round(performance.now()))}function Ad(i,t,e,n,s){let r=new Uint16Array(i,t,e),o=new Float64Array(e),a=(s-n)/65534;for(let l=0;l<e;l+=1)o[l]=r[l]===65535?NaN:n+a*r[l];return o}function a_({x:i,y:t},e){return Float32Array.from(e,n=>{let s=si(i,n);if(s<0)return NaN;let r=Math.min(s+1,i.length-1),o=i[r]-i[s],a=t[s]+(o>0?(n-i[s])/o:0)*(t[r]-t[s]);return Number.isNaN(a)?t[s]:a})}async function l_(i,t){let e=JSON.parse(document.getElementById("model")?.textContent??"{}"),n=await PT("series");Qh("unpacked");let s=I=>({...I,x:Ad(n,I.at,I.n,0,e.end_s),y:Ad(n,I.at+2*I.n,I.n,I.low,I.high)}),r=I=>Float32Array.from(Ad(n,I.at,I.n,I.low,I.high));for(let I of Object.values(e.figures))for(let T of I.panels??[])if(T.lines=T.lines.map(s),T.own=T.own.map(s),T.band)for(let P of["least","median","greatest"])T.band[P]=s(T.band[P]);Tl(e.vehicles.map(I=>({sysid:I.id,role:I.role,colour:I.colour})));let o=new Set(e.chosen),a=I=>e.vehicles.find(T=>T.id===I)?.label??String(I),l=document.getElementById("app"),c=l&&e.flight?IT(l,e,e.flight,r):null,h=c?.time??new Rd(e.end_s);if(h.begin_s=0,h.end_s=e.end_s,c){c.shown=o,c.given=!0,c.after.push(()=>x());let I=t(c,[],()=>{}),T=F("div",{class:"tools only-screen"},F("button",{type:"button",onclick:()=>nr()},"dark / light"),F("button",{type:"button",onclick:()=>I.showModal()},"keys ?"));l?.before(T)}let u=[];for(let I of document.querySelectorAll(".plot[data-figure]")){let T=e.figures[I.dataset.figure??""];!T&&I.dataset.figure!=="flight"||u.push({div:I,draw:f(I,T),drawn:!1})}function f(I,T){if(I.dataset.figure==="flight")return()=>d(I);if(T.kind==="timeline")return()=>Am(I,T,h);if(T.kind==="ledger")return()=>Rm(I,T,o,a);let P=new Gr(I,h,a);return O=>P.draw(T,o,O)}function d(I){if(!c)return;let T=F("canvas",{class:"still"});I.replaceChildren(T);let P=c.flight.at(e.end_s);P&&new Wr(T,()=>{}).draw(c.flight,P,{chosen:null,selected:new Set,paths:!0,until_s:e.end_s,trail_s:1/0,shown:o}),I.dataset.lines=String(o.size)}let p=I=>I.classList.contains("only-print");function _(I,T){I.drawn||I.div.replaceChildren(),I.draw(T),I.drawn=!0}let m=()=>u.filter(I=>I.drawn&&!p(I.div)).forEach(I=>_(I)),g=document.querySelector("fieldset.picker");function y(){g.querySelectorAll("button, select").forEach(O=>O.remove());let I=e.many?[...o].sort((O,H)=>O-H):e.vehicles.map(O=>O.id);for(let O of I){let H=F("i",{class:"swatch"});H.style.background=pn(O),g.append(F("button",{type:"button","aria-pressed":String(o.has(O)),onclick:()=>M(O)},H,a(O)))}if(!e.many)return;let T=e.vehicles.filter(O=>!o.has(O.id)).map(O=>F("option",{value:O.id},O.label)),P=F("select",{"aria-label":"show one more vehicle",onchange:()=>P.value&&M(Number(P.value))},F("option",{value:""},"show one more …"),...T);g.append(P)}function M(I){o.delete(I)||o.add(I),x()}function x(){y(),m(),c&&(c.dirty=!0)}y(),NT(),c&&await c.first,Qh("first");let R=u.filter(I=>!p(I.div)),E=new Set(R);for(let I of R)_(I),E.delete(I),await new Promise(T=>{setTimeout(T)});Qh("flat"),requestAnimationFrame(()=>requestAnimationFrame(()=>Qh("all"))),El(()=>{y(),m()});let v=document.body.clientWidth,b=!1;return window.addEventListener("resize",()=>{b||document.body.clientWidth===v||(v=document.body.clientWidth,m())}),window.addEventListener("beforeprint",()=>{b=!0,Hu(!0);for(let I of u)_(I,I.div.closest(".pair")?o_.half:o_.whole)}),window.addEventListener("afterprint",()=>{b=!1,Hu(!1),m()}),c}var Rd=class{constructor(t){this.begin_s=0,this.end_s=t,this.now_s=NaN,this.zoom=null,this.charts=new Set}get range(){return this.zoom??[0,this.end_s]}setZoom(t){this.zoom=t;let[e,n]=this.range;for(let s of this.charts)for(let r of s.plots)r.setScale("x",{min:e,max:n})}setNow(){}seek(){}point(){}};function IT(i,t,e,n){let s={playing:!1,speed:5,at:performance.now()},r={seek:c=>{o.at_s=Math.min(Math.max(c,0),e.end_s),o.dirty=!0},toggle:()=>{s.playing=!s.playing,s.playing&&(o.at_s??e.end_s)>=e.end_s&&(o.at_s=0),s.at=performance.now(),a()},faster:c=>{s.speed=vs[Math.min(Math.max(vs.indexOf(s.speed)+c,0),vs.length-1)],a()},newest:null},o=new Ro(i,{charts:!1,player:r});o.whole_paths=!0;let a=()=>{o.playing=s.playing,o.speed=`×${s.speed}`,o.dirty=!0};LT(o.flight,t,e,n),o.begin_s=0,o.end_s=e.end_s,o.members(),a();let l=()=>r.seek(nl()??e.end_s);return l(),addEventListener("hashchange",()=>nl()!==null&&l()),setInterval(()=>{let c=performance.now();s.playing&&(o.at_s=Math.min((o.at_s??0)+.001*(c-s.at)*s.speed,e.end_s),o.at_s>=e.end_s&&(s.playing=!1),a()),s.at=c},CT),o}function LT(i,t,e,n){i.session=e.session;let s=e.solids??[];i.worlds=(e.worlds??[]).map(([l,c,h])=>({t_s:l,session:{...e.session,obstacles:c.map(u=>s[u]),vehicles:e.session.vehicles.map(u=>({...u,path_ned:h[String(u.sysid)]??u.path_ned}))}})),i.events=e.events,i.count=i.capacity=e.count,i.t_s=Float64Array.from({length:e.count},(l,c)=>c*e.end_s/(e.count-1)),i.share=new Float32Array(e.count).fill(NaN);let r=(l,c)=>new Map((t.figures[l]?.panels[c]?.lines??[]).map(h=>[h.id,h])),o={battery:r("battery",0),speed:r("motion",0),target:r("target",0),v:r("contest",0)},a=t.figures.contest?.panels[1]?.own[0];a&&(i.share=a_(a,i.t_s));for(let l of e.vehicles){let c={};for(let f of ss)c[f]=null;[c.n,c.e,c.d]=l.p.map(n),c.height=c.d.map(f=>-f);for(let f of["heading","roll","pitch"])c[f]=l[f]?n(l[f]):new Float32Array(e.count);for(let[f,d]of Object.entries(o)){let p=d.get(l.sysid);c[f]=p?f==="v"?DT(p,i.t_s):a_(p,i.t_s):null}let h=new Float32Array(e.count).fill(NaN);for(let f of ss)c[f]??=h;i.columns.set(l.sysid,c);let u=new qo;for(let[f,d,p,_]of e.words[String(l.sysid)]??[])u.t_s.push(f),u.rows.push({mode:d,armed:p,landed:!_});i.words.set(l.sysid,u)}for(let l of e.traffic)i.traffic.set(l.callsign,l.p.map(n));i.newest={type:"snapshot",t_s:e.end_s,duration_s:e.session.duration_s,speed:null,phase:"ended",vehicles:[],traffic:[],competition:{v:{},tau:{},leader:null,share:null,runner_up:null,threshold:e.threshold},services:[],history:e.history,refuelled:e.history.length,goal:e.goal,inspected:{},events:[]},i.version+=1}function DT({x:i,y:t},e){return Float32Array.from(e,n=>t[si(i,n)]??NaN)}function NT(){for(let i of document.querySelectorAll("table.sorts")){let t=[...i.tHead?.rows[0].cells??[]];t.forEach((e,n)=>{let s=()=>{let r=e.getAttribute("aria-sort")!=="ascending";t.forEach(l=>l.removeAttribute("aria-sort")),e.setAttribute("aria-sort",r?"ascending":"descending");let o=l=>l.cells[n].textContent??"",a=[...i.tBodies[0].rows].sort((l,c)=>o(l).localeCompare(o(c),void 0,{numeric:!0}));i.tBodies[0].append(...r?a:a.reverse())};e.replaceChildren(F("button",{type:"button",onclick:s},e.textContent??""))})}}var Co=Math.PI/180,c_=6378137,h_=.00669438;function UT(i){let t=1-h_*Math.sin(i*Co)**2;return[Co*c_*(1-h_)/t**1.5,Co*c_*Math.cos(i*Co)/Math.sqrt(t)]}var FT=(i,t)=>(i+180)/360*t,OT=(i,t)=>(1-Math.asinh(Math.tan(i*Co))/Math.PI)/2*t,BT=(i,t)=>Math.atan(Math.sinh(Math.PI*(1-2*i/t)))/Co,tu=class{constructor(t,e){this.template=t,this.arrived=e,this.kept=new Map;let n=new URL(t.replace(/[{}]/g,"")).hostname;this.credit=/(^|\.)openstreetmap\.org$/.test(n)?"© OpenStreetMap contributors":`map: ${n}`}draw(t,e,n,s,r,o){let[a,l]=e;if(Math.abs(a)>85)return;let[c,h]=UT(a),u=Math.min(Math.max(Math.round(Math.log2(360*h*n.perMetre/256)),0),19),f=2**u,[d,p]=[n.height/2/n.perMetre,n.width/2/n.perMetre],[_,m]=[-p,p].map(M=>Math.floor(FT(l+(n.e+M)/h,f))),[g,y]=[d,-d].map(M=>Math.min(Math.max(Math.floor(OT(a+(n.n+M)/c,f)),0),f-1));if(!((m-_+1)*(y-g+1)>80)){for(let M=g;M<=y;M+=1){let[x,R]=[M,M+1].map(E=>r((BT(E,f)-a)*c));for(let E=_;E<=m;E+=1){let v=this.#e(u,(E%f+f)%f,M);if(!v.complete||!v.naturalWidth)continue;let[b,I]=[E,E+1].map(T=>s((360*T/f-180-l)*h));t.drawImage(v,b,x,I-b,R-x)}}t.font="11px system-ui, sans-serif",t.lineWidth=3,t.strokeStyle=o.paper,t.strokeText(this.credit,5,14),t.fillStyle=o.ink,t.fillText(this.credit,5,14)}}#e(t,e,n){let s=this.template.replace("{z}",String(t)).replace("{x}",String(e)).replace("{y}",String(n)),r=this.kept.get(s);return r||(r=new Image,r.referrerPolicy="origin",r.onload=this.arrived,r.src=s,this.kept.size>=400&&this.kept.delete(this.kept.keys().next().value??""),this.kept.set(s,r),r)}};var kT=[["space","pause, or go on"],["← →","10 s back or on (replay, report, or back in a live flight)"],["< >","slower, faster"],["End","back to the newest"],["[ ]","the vehicle before, after"],["g","go to a vehicle by its id"],["/","filter vehicles"],["3 m","in space, map"],["c","camera: free, follow, from its eyes"],["0","show everything"],["v","paths on or off"],["d","dark or light"],["?","this page"]],u_=10;function f_(i,t,e){let n=F("dialog",{class:"ask","aria-label":"keys"}),s=[...kT,...t.map(o=>[o.key.toUpperCase(),o.what])].map(([o,a])=>F("tr",{},F("th",{scope:"row"},o),F("td",{class:"word"},a)));n.append(F("h2",{},"Keys"),F("table",{},F("tbody",{},...s)),F("form",{method:"dialog"},F("button",{},"Close"))),document.body.append(n);let r={" ":()=>i.player.toggle(),ArrowLeft:()=>i.player.seek((i.time.now_s??0)-u_),ArrowRight:()=>i.player.seek(i.time.now_s+u_),"<":()=>i.player.faster(-1),">":()=>i.player.faster(1),End:()=>i.player.newest?.(),"[":()=>i.chooseNext(-1),"]":()=>i.chooseNext(1),g:()=>i.table.goto.focus(),"/":()=>i.table.filter.focus(),3:()=>i.show("space"),m:()=>i.show("map"),c:()=>i.nextCamera(),0:()=>i.whole(),v:()=>i.togglePaths(),d:()=>nr(),"?":()=>n.showModal()};return document.addEventListener("keydown",o=>{let a=o.target;if(o.ctrlKey||o.metaKey||o.altKey||a.closest("dialog"))return;if(a.matches("input:not([type=range]), select, textarea")){o.key==="Escape"&&a.blur();return}if(a.matches("input[type=range]")&&o.key.startsWith("Arrow")||a.matches("button, summary")&&(o.key===" "||o.key==="Enter"))return;let l=t.find(c=>c.key.toUpperCase()===o.key&&o.shiftKey);if(l)e(l);else if(r[o.key])r[o.key]();else return;o.preventDefault()}),n}function zT(i){let t=document.getElementById("app"),e=F("h1",{},"connecting …"),n=F("span",{class:"badge"}),s=F("span",{class:"badge phase"}),[r,o]=[F("b",{class:"bad"}),F("span")],a=F("p",{class:"soft small goal-line"},r,o),l=F("button",{type:"button"},"keys ?"),c=F("button",{type:"button",onclick:()=>nr()},"dark / light"),h=F("p",{class:"connection",role:"alert"});h.hidden=!0;let u=F("div",{class:"tools orders"}),f=F("header",{class:"top"},F("div",{class:"tools"},e,n,s,u,c,l),a,h);t.before(f);let d=!1,p=!1,_,m=!1,g="",y={seek:T=>{d?b.send({command:"seek",t_s:T},M):(x.at_s=T>=x.flight.last_s-.05?null:Math.max(T,x.flight.first_s),x.dirty=!0)},toggle:()=>{d?b.send({command:_?.paused||x.flight.newest?.phase==="ended"?"resume":"pause"},M):E(i.orders.find(T=>T.command==="pause"))},faster:T=>{if(!d)return void R.notice("Speed can be changed only in a replay.");let P=_?.speed??1,O=vs.reduce((H,N,V)=>Math.abs(N-P)<Math.abs(vs[H]-P)?V:H,0);b.send({command:"speed",speed:vs[Math.min(Math.max(O+T,0),vs.length-1)]},M)},newest:()=>{x.at_s=null,x.dirty=!0}},M=(T,P)=>{T||R.notice(P,"bad")},x=new Ro(t,{charts:!0,player:y});f.append(x.strip.element),i.tiles&&(x.map.tiles=new tu(i.tiles,()=>x.map.dirty=!0));let R=new jh(i.orders,(T,P)=>b.send(T,P)),E=T=>{if(!m)return void R.notice(d?"A recording takes no commands.":"View-only link: commands are disabled.","bad");T.of_many&&x.selected.size>1?R.askMany(T,[...x.selected],!1,v,()=>x.flight.newest):R.ask(T,x.chosen,v,()=>x.flight.newest)},v=T=>x.label(T);for(let T of i.orders.filter(P=>P.of_many&&P.command!=="land")){let P=()=>(x.flight.newest?.vehicles??[]).map(O=>O.sysid);x.strip.all.append(F("button",{type:"button",title:`${T.name} all vehicles`,onclick:()=>R.askMany(T,P(),!0,v,()=>x.flight.newest)},`all: ${T.name}`))}l.addEventListener("click",f_(x,i.orders,E).showModal.bind(document.querySelector("dialog[aria-label=keys]")));for(let T of i.orders){let P=F("button",{type:"button",title:`${T.what} (Shift+${T.key.toUpperCase()})`,onclick:()=>E(T)},T.name);(T.of_vehicle?x.orders:u).append(P)}let b=new Kh(T=>{if(T.type==="session"){x.flight.begin(T),x.flight.tell(T.events??[]),d=T.source==="replay";let P=nl();d&&!p&&P!==null&&y.seek(P),p=!0,m=!!T.control&&!d,document.title=`${T.name} – Skytender`,Ge(e,T.name),Ge(n,{session:"live",monitor:"monitor",replay:"replay"}[T.source]);for(let O of[u,x.orders,x.strip.all])O.hidden=!m;x.timeline.live.hidden=d,x.members()}else if(T.type==="snapshot"){_=T.replay,x.flight.take(T),x.flight.tell(T.events),d?(x.begin_s=_?.from_s,x.end_s=_?.to_s,x.playing=!_?.paused&&T.phase!=="ended",x.speed=`×${_?.speed??1}`):(x.playing=T.phase!=="paused",x.speed=T.speed?`×${T.speed.toFixed(T.speed<10?1:0)}`:""),Ge(s,`${T.phase} ${Ai(T.t_s)}${T.duration_s?` of ${Ai(T.duration_s)}`:""}`);let{goal:P}=T,O=P.pursue_for_s&&P.pursue_held_s!==null?`pursuit held ${P.pursue_held_s.toFixed(0)} of ${P.pursue_for_s.toFixed(0)} s`:"",H=P.refuelled_at_least?`${T.refuelled} refuelled, at least ${P.refuelled_at_least} wanted`:T.refuelled?`${T.refuelled} refuelled`:"",N=P.broken.map(V=>V.text+(V.t_s===null?"":` (${V.t_s.toFixed(1)} s)`));Ge(r,N.length?`${N.length} ${N.length===1?"goal":"goals"} failed: ${N.join("; ")}. `:""),Ge(o,[O,H].filter(Boolean).join("; ")),a.title=a.textContent??"",x.dirty=!0}else T.type==="end"&&(g=`The session has ended: ${T.text||T.outcome||"unknown"}. The page keeps what it has seen.`,I())},()=>I(),()=>x.flight.clear()),I=()=>{let P={connecting:"",open:"",ended:g,lost:"The connection is lost; the page tries again by itself. What is shown is the last that came.",refused:"This link lacks its token, or the token is of another session: open the whole link that `gcs` printed."}[b.state];h.hidden=!P,h.className=`connection ${b.state==="ended"?"soft":"bad"}`,Ge(h,P),b.state==="refused"&&Ge(e,"no entry"),document.documentElement.dataset.connection=b.state};return b.open(),Object.assign(x,{operator:R})}wm();var il=JSON.parse(document.getElementById("config")?.textContent??"{}");bm(il.palette);n_(il.conditions);var GT=il.source==="report"?l_(il,f_):zT(il);Object.assign(window,{skytender:GT});})();
