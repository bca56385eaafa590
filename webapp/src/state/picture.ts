// A photo made small before it is sent: a few dozen kilobytes instead of megabytes.
import { Problem } from "../api/problem";
import { t } from "../texts";

const LONGEST_PX = 512;
const LARGEST_BYTES = 60_000;
const QUALITIES = [0.85, 0.7, 0.55, 0.4];

/** The size that fits into a square of `longest`, with the same proportions; never larger. */
export function fitted(width: number, height: number, longest: number): [number, number] {
  const scale = Math.min(1, longest / Math.max(width, height));
  return [Math.max(1, Math.round(width * scale)), Math.max(1, Math.round(height * scale))];
}

/** The photo as a small JPEG. What the camera wrote beside it, such as the place, is left out. */
export async function shrunk(file: Blob): Promise<Blob> {
  const photo = await createImageBitmap(file).catch(() => {
    throw new Problem("picture", t.teaching.picture.unreadable, t.teaching.picture.chooseOther, 0);
  });
  try {
    for (let longest = LONGEST_PX; longest >= 64; longest /= 2) {
      const [width, height] = fitted(photo.width, photo.height, longest);
      const canvas = document.createElement("canvas");
      Object.assign(canvas, { width, height });
      canvas.getContext("2d")?.drawImage(photo, 0, 0, width, height);
      for (const quality of QUALITIES) {
        const made = await new Promise<Blob | null>((done) =>
          canvas.toBlob(done, "image/jpeg", quality),
        );
        if (made && made.size <= LARGEST_BYTES) return made;
      }
    }
  } finally {
    photo.close();
  }
  throw new Problem("picture", t.teaching.picture.unreadable, t.teaching.picture.chooseOther, 0);
}

/** As an address that an image can show. */
export function asAddress(blob: Blob): Promise<string> {
  return new Promise((done, failed) => {
    const reader = new FileReader();
    reader.onload = () => done(String(reader.result));
    reader.onerror = () => failed(reader.error);
    reader.readAsDataURL(blob);
  });
}
