package org.u2sa.core.communication.web;

import io.netty.buffer.Unpooled;
import io.netty.handler.codec.http.FullHttpResponse;
import io.netty.handler.codec.http.HttpHeaderNames;
import io.netty.handler.codec.http.HttpRequest;
import io.netty.handler.codec.http.HttpResponseStatus;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.DiskThread;
import org.u2sa.interfaces.disk.RegularFile;

/**
 * A file of map tiles (PMTiles, version 3); the page reads one range per request. Like the page
 * itself, it needs no log-in. Thread-safe.
 */
public final class WebTiles {
  /** Path of the file at the web port. */
  static final String PATH = "/tiles.pmtiles";

  /** Maximum range, read in one go. */
  static final int LONGEST_RANGE = 1 << 20;

  private static final Pattern RANGE = Pattern.compile("bytes=([0-9]{1,18})-([0-9]{1,18})");
  private static final byte[] MAGIC = {'P', 'M', 'T', 'i', 'l', 'e', 's', 3};

  /** Maximum bytes of ranges being sent, because clients that request tiles have not logged in. */
  private static final long LARGEST_UNSENT =
      Math.min(16L << 20, Runtime.getRuntime().maxMemory() / 16);

  /** Maximum ranges that wait for the disk, which may hang. */
  static final int MAX_WAITING = 64;

  private final FileChannel file;
  private final long size;
  private final DiskThread disk;
  private final AtomicLong underWay = new AtomicLong();
  private final Semaphore places = new Semaphore(MAX_WAITING);

  private WebTiles(FileChannel file, long size, DiskThread disk) {
    this.file = file;
    this.size = size;
    this.disk = disk;
  }

  /**
   * Opens a file, for as long as the process runs.
   *
   * @throws BadInputException if it is missing or not a PMTiles file
   */
  public static WebTiles open(Path path) {
    return open(path, new DiskThread("u2sa-tiles"));
  }

  static WebTiles open(Path path, DiskThread disk) {
    RegularFile.problem(path)
        .ifPresent(
            what -> {
              throw new BadInputException(
                  "WEB TILES: " + path + ": " + what + "; expected PMTiles");
            });
    try {
      FileChannel file = FileChannel.open(path, StandardOpenOption.READ);
      ByteBuffer start = ByteBuffer.allocate(MAGIC.length);
      if (file.read(start, 0) != MAGIC.length || !Arrays.equals(start.array(), MAGIC)) {
        file.close();
        throw new BadInputException(
            "WEB TILES: " + path + ": not PMTiles version 3; other formats are not converted");
      }
      return new WebTiles(file, file.size(), disk);
    } catch (IOException e) {
      throw new BadInputException("WEB TILES: " + path + ": " + e.getMessage(), e);
    }
  }

  /**
   * Answers with the requested range: exactly one, within the file, at most 1 MiB. The sender must
   * call {@link #sent}.
   *
   * @param answered receives the answer, possibly later on the disk's thread
   */
  void answer(HttpRequest request, Consumer<FullHttpResponse> answered) {
    Matcher range = RANGE.matcher(request.headers().get(HttpHeaderNames.RANGE, ""));
    long from = range.matches() ? Long.parseLong(range.group(1)) : size;
    long to = range.matches() ? Math.min(Long.parseLong(range.group(2)), size - 1) : 0;
    long length = to - from + 1;
    if (length < 1 || length > LONGEST_RANGE) {
      answered.accept(WebResponses.error(HttpResponseStatus.REQUESTED_RANGE_NOT_SATISFIABLE));
    } else if (!isPlaceFor(length)) {
      answered.accept(WebResponses.error(HttpResponseStatus.SERVICE_UNAVAILABLE));
    } else {
      disk.execute(
          () -> {
            places.release();
            answered.accept(read(from, length));
          });
    }
  }

  private boolean isPlaceFor(long length) {
    if (!places.tryAcquire()) {
      return false;
    }
    boolean fits = underWay.addAndGet(length) <= Math.max(LONGEST_RANGE, LARGEST_UNSENT);
    if (!fits) {
      places.release();
      underWay.addAndGet(-length);
    }
    return fits;
  }

  private FullHttpResponse read(long from, long length) {
    ByteBuffer content = ByteBuffer.allocate((int) length);
    try {
      while (content.hasRemaining() && file.read(content, from + content.position()) >= 0) {
        // one read may return less
      }
    } catch (IOException e) {
      underWay.addAndGet(-length);
      return WebResponses.error(HttpResponseStatus.INTERNAL_SERVER_ERROR); // the card was removed
    }
    underWay.addAndGet(content.position() - length);
    FullHttpResponse response =
        WebResponses.response(
            HttpResponseStatus.PARTIAL_CONTENT,
            Unpooled.wrappedBuffer(content.array(), 0, content.position()));
    response
        .headers()
        .set(HttpHeaderNames.CONTENT_TYPE, "application/octet-stream")
        .set(HttpHeaderNames.CACHE_CONTROL, "no-store")
        .set(
            HttpHeaderNames.CONTENT_RANGE,
            "bytes " + from + "-" + (from + content.position() - 1) + "/" + size)
        .setInt(HttpHeaderNames.CONTENT_LENGTH, content.position());
    return response;
  }

  /** Called when a range has been sent or its connection has closed. */
  void sent(int bytes) {
    underWay.addAndGet(-bytes);
  }
}
