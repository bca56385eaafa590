// The network between a phone and the server, which a spec can cut, and through which it sees every
// request that really went out.
import http from "node:http";
import net from "node:net";
import { once } from "node:events";

/** A way to the server at `base`. `change` may alter the text of a file on the way. */
export async function openNetwork(base, change = (_path, text) => text) {
  const target = new URL(base);
  const sockets = new Set();
  const requests = [];
  const server = http.createServer((request, response) => {
    requests.push(`${request.method} ${request.url}`);
    const options = { host: target.hostname, port: target.port, path: request.url };
    const { method, headers } = request;
    // "Not changed" would hide a change that is made on the way.
    delete headers["if-none-match"];
    const onwards = http.request({ ...options, method, headers }, async (answer) => {
      const parts = await answer.toArray();
      const bytes = Buffer.concat(parts);
      const text = String(answer.headers["content-type"]).startsWith("text/");
      const body = text ? Buffer.from(change(request.url, bytes.toString())) : bytes;
      const kept = { ...answer.headers };
      delete kept["transfer-encoding"];
      if (body.length > 0) kept["content-length"] = body.length;
      response.writeHead(answer.statusCode, kept).end(body);
    });
    onwards.on("error", () => response.destroy());
    request.pipe(onwards);
  });
  server.on("upgrade", (request, socket, head) => {
    const onwards = net.connect(target.port, target.hostname, () => {
      const lines = request.rawHeaders.flatMap((name, index, all) =>
        index % 2 === 0 ? [`${name}: ${all[index + 1]}`] : [],
      );
      onwards.write([`GET ${request.url} HTTP/1.1`, ...lines, "", ""].join("\r\n"));
      onwards.write(head);
      socket.pipe(onwards).pipe(socket);
    });
    for (const one of [socket, onwards]) one.on("error", () => undefined);
    socket.on("close", () => onwards.destroy());
    onwards.on("close", () => socket.destroy());
  });
  server.on("connection", (socket) => {
    sockets.add(socket);
    socket.on("close", () => sockets.delete(socket));
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address();
  const cut = async () => {
    const closed = once(server, "close");
    server.close();
    for (const socket of sockets) socket.destroy();
    await closed;
  };
  return {
    url: `http://127.0.0.1:${port}/`,
    /** What has passed, such as "GET /". */
    requests,
    cut,
    restore: async () => {
      server.listen(port, "127.0.0.1");
      await once(server, "listening");
    },
  };
}
