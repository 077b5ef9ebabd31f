// A recorded flight that the page carries.
// @ts-check
/** @param {unknown} config @param {unknown} keyboard */
export function recorded(config, keyboard) {
  throw new Error(`no recording is carried by this page (${typeof config}, ${typeof keyboard})`);
}
