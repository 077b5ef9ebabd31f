// Whether a graphics card draws, or this machine's processor does.
// @ts-check

/** @type {boolean | null} */
let known = null;

/** Whether WebGL is drawn by software: then drawings in the plane are cheaper by the processor, too. */
export function software() {
  if (known !== null) return known;
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const renderer = context && names ? String(context.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  known = !context || /swiftshader|llvmpipe|softpipe|software/i.test(renderer);
  return known;
}

/** @param {HTMLCanvasElement} canvas @returns {CanvasRenderingContext2D} */
export function plane(canvas) {
  return /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d", { willReadFrequently: software() }));
}

/** A length on a drawing, which grows with the page's letters as on very wide screens. @param {number} pixels */
export const sized = (pixels) => (pixels / 16) * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
