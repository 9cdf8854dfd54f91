/** Comparing pictures, in a browser. */
import type { Page } from "playwright-core";

/**
 * Mean difference of two pictures, given as addresses of their data, as a share of the largest one there can be. The
 * second may have more pixels, and is drawn as large as the first.
 */
export function difference(page: Page, one: string, other: string): Promise<number> {
  return page.evaluate(
    async ([a, b]) => {
      const decoded = async (address: string) => {
        const image = new Image();
        image.src = address;
        await image.decode();
        return image;
      };
      const [one, other] = [await decoded(a), await decoded(b)];
      const { width, height } = one;
      if (Math.abs(width * other.height - height * other.width) > width) throw new Error("pictures of different shape");
      const pixels = (image: HTMLImageElement) => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [width, height];
        const context = canvas.getContext("2d")!;
        context.imageSmoothingQuality = "high";
        context.drawImage(image, 0, 0, width, height);
        return context.getImageData(0, 0, width, height).data;
      };
      const [first, second] = [pixels(one), pixels(other)];
      let sum = 0;
      for (let i = 0; i < first.length; ++i) sum += Math.abs(first[i] - second[i]);
      return sum / (255 * first.length);
    },
    [one, other] as const,
  );
}

/** A picture as wide as this, as the address of its data. */
export function narrow(page: Page, address: string, width: number, type: string): Promise<string> {
  return page.evaluate(
    async ([address, width, type]) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [width, Math.max(1, Math.round((width * image.height) / image.width))];
      const context = canvas.getContext("2d")!;
      context.fillStyle = "white";
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.imageSmoothingQuality = "high";
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      return canvas.toDataURL(type, 0.6);
    },
    [address, width, type] as const,
  );
}

/**
 * Of what two pictures have on their grounds (the commonest colour), the part that differs, from 0 to 1. Both are looked at 60 pixels wide, so
 * that letters of another font and lines that are rounded otherwise count little.
 */
export function inkDifference(page: Page, one: string, other: string): Promise<number> {
  return page.evaluate(
    async ([a, b]) => {
      const pixels = async (address: string, height?: number) => {
        const image = new Image();
        image.src = address;
        await image.decode();
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [60, height ?? Math.max(1, Math.round((60 * image.height) / image.width))];
        const context = canvas.getContext("2d")!;
        context.imageSmoothingQuality = "high";
        context.drawImage(image, 0, 0, canvas.width, canvas.height);
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
        const count = new Map<string, number>();
        for (let i = 0; i < data.length; i += 4) {
          const colour = [data[i] >> 3, data[i + 1] >> 3, data[i + 2] >> 3].join();
          count.set(colour, (count.get(colour) ?? 0) + 1);
        }
        const ground = [...count].reduce((most, now) => (now[1] > most[1] ? now : most))[0].split(",").map((c) => 8 * Number(c) + 4);
        return { data, ground, height: canvas.height };
      };
      const first = await pixels(a);
      const second = await pixels(b, first.height);
      let [ink, moved] = [0, 0];
      for (let i = 0; i < first.data.length; ++i) {
        if (i % 4 === 3) continue;
        ink += Math.abs(first.data[i] - first.ground[i % 4]) + Math.abs(second.data[i] - second.ground[i % 4]);
        moved += Math.abs(first.data[i] - second.data[i]);
      }
      return moved / Math.max(1, ink);
    },
    [one, other] as const,
  );
}
