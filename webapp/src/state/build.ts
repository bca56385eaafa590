// Which build of the app this page is: the name of its own program file, which holds a hash.

export function ownFile(): string {
  const script = document.querySelector<HTMLScriptElement>('script[type="module"][src]');
  return script ? new URL(script.src, location.href).pathname : "";
}
