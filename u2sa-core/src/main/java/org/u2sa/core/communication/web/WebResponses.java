package org.u2sa.core.communication.web;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.handler.codec.http.DefaultFullHttpResponse;
import io.netty.handler.codec.http.FullHttpResponse;
import io.netty.handler.codec.http.HttpHeaderNames;
import io.netty.handler.codec.http.HttpHeaders;
import io.netty.handler.codec.http.HttpMethod;
import io.netty.handler.codec.http.HttpRequest;
import io.netty.handler.codec.http.HttpResponseStatus;
import io.netty.handler.codec.http.HttpVersion;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.zip.GZIPOutputStream;

/**
 * The page's files as HTTP responses, compressed once. Every response, errors included, forbids
 * scripts and connections of other origins, framing, and guessing of types. Immutable.
 */
public final class WebResponses {
  /** Directives of Content-Security-Policy (W3C, CSP level 3); 'self' includes the WebSocket. */
  private static final String POLICY =
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self';"
          + " base-uri 'none'; form-action 'none'; frame-ancestors 'none';"
          + " require-trusted-types-for 'script'; trusted-types 'none'";

  private final Map<String, Stored> files = new HashMap<>();
  private final WebTiles tiles; // null: none

  private record Stored(String mediaType, byte[] plain, byte[] zipped, String tag) {}

  /** Prepares the responses of a page without map tiles. */
  public WebResponses(WebSite site) {
    this(site, null);
  }

  /**
   * Prepares the responses of a page.
   *
   * @param tiles null: none
   */
  public WebResponses(WebSite site, WebTiles tiles) {
    this.tiles = tiles;
    site.files()
        .forEach(
            (path, file) ->
                files.put(
                    path,
                    new Stored(
                        file.mediaType(),
                        file.content(),
                        zipped(file.content()),
                        tag(file.content()))));
  }

  /**
   * Answers a GET or HEAD.
   *
   * @param answered receives the answer; that of a map tile possibly later on another thread
   */
  void answer(HttpRequest request, String path, Consumer<FullHttpResponse> answered) {
    boolean isTile = path.equals(WebTiles.PATH) && request.method().equals(HttpMethod.GET);
    if (isTile && tiles != null) {
      tiles.answer(request, answered);
    } else {
      answered.accept(
          isTile
              ? response(HttpResponseStatus.NO_CONTENT, Unpooled.EMPTY_BUFFER) // no error to log
              : answer(request, path));
    }
  }

  private FullHttpResponse answer(HttpRequest request, String path) {
    Stored file = files.get(path);
    if (file == null) {
      return error(HttpResponseStatus.NOT_FOUND);
    }
    boolean isKnown = file.tag.equals(request.headers().get(HttpHeaderNames.IF_NONE_MATCH));
    String accepted = request.headers().get(HttpHeaderNames.ACCEPT_ENCODING, "");
    boolean isZipped = accepted.contains("gzip");
    byte[] content = isZipped ? file.zipped : file.plain;
    boolean isBare = isKnown || request.method().equals(HttpMethod.HEAD);
    FullHttpResponse response =
        response(
            isKnown ? HttpResponseStatus.NOT_MODIFIED : HttpResponseStatus.OK,
            isBare ? Unpooled.EMPTY_BUFFER : Unpooled.wrappedBuffer(content));
    HttpHeaders headers = response.headers();
    headers.set(HttpHeaderNames.ETAG, file.tag);
    headers.set(HttpHeaderNames.CACHE_CONTROL, "no-cache"); // revalidate each time
    headers.set(HttpHeaderNames.VARY, HttpHeaderNames.ACCEPT_ENCODING);
    if (!isKnown) {
      headers.set(HttpHeaderNames.CONTENT_TYPE, file.mediaType);
      headers.setInt(HttpHeaderNames.CONTENT_LENGTH, content.length);
      if (isZipped) {
        headers.set(HttpHeaderNames.CONTENT_ENCODING, "gzip");
      }
    }
    return response;
  }

  /** Called when a response has been sent or its connection has closed. */
  void sent(HttpResponseStatus status, int bytes) {
    if (status.equals(HttpResponseStatus.PARTIAL_CONTENT)) {
      tiles.sent(bytes);
    }
  }

  /** An error, with its name as text. */
  static FullHttpResponse error(HttpResponseStatus status) {
    ByteBuf text = Unpooled.copiedBuffer(status + "\n", StandardCharsets.US_ASCII);
    FullHttpResponse response = response(status, text);
    response.headers().set(HttpHeaderNames.CACHE_CONTROL, "no-store");
    response.headers().set(HttpHeaderNames.CONTENT_TYPE, "text/plain; charset=us-ascii");
    response.headers().setInt(HttpHeaderNames.CONTENT_LENGTH, text.readableBytes());
    return response;
  }

  static FullHttpResponse response(HttpResponseStatus status, ByteBuf content) {
    FullHttpResponse response = new DefaultFullHttpResponse(HttpVersion.HTTP_1_1, status, content);
    response
        .headers()
        .set("Content-Security-Policy", POLICY)
        .set("X-Content-Type-Options", "nosniff")
        .set("X-Frame-Options", "DENY")
        .set("Referrer-Policy", "no-referrer")
        .set("Cross-Origin-Opener-Policy", "same-origin")
        .set("Cross-Origin-Resource-Policy", "same-origin")
        .set("Permissions-Policy", "camera=(), geolocation=(), microphone=()");
    return response;
  }

  private static byte[] zipped(byte[] content) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (GZIPOutputStream out = new GZIPOutputStream(bytes)) {
      out.write(content);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // cannot happen in memory
    }
    return bytes.toByteArray();
  }

  private static String tag(byte[] content) {
    try {
      byte[] digest = MessageDigest.getInstance("SHA-256").digest(content);
      return '"' + Base64.getUrlEncoder().withoutPadding().encodeToString(digest) + '"';
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("SHA-256 is unavailable in this Java", e);
    }
  }
}
