package org.u2sa.drivers.camera;

import java.util.Arrays;
import java.util.Optional;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.interfaces.DecodingLimit;

/**
 * Extracts JPEG files from a byte stream by parsing segment lengths, so that thumbnails in a header
 * do not end the image (ITU-T T.81, B.1 and B.2). Other bytes are skipped.
 */
final class JpegFramer extends ByteParser<CameraFrame> {
  private static final int LARGEST_BYTES = 1 << 24;
  private static final int FIRST_ROOM_BYTES = 1 << 16;
  private static final int MARKER = 0xFF;
  private static final int START_OF_IMAGE = 0xD8;
  private static final int END_OF_IMAGE = 0xD9;
  private static final int START_OF_SCAN = 0xDA;
  private static final int FIRST_RESTART = 0xD0;
  private static final int FIRST_START_OF_FRAME = 0xC0;
  private static final int LAST_START_OF_FRAME = 0xCF;
  private static final int HUFFMAN_TABLE = 0xC4;
  private static final int EXTENSION = 0xC8;
  private static final int ARITHMETIC_TABLE = 0xCC;
  private static final long MAX_PIXELS = 1L << 25;
  private static final int BYTES_PER_PIXEL = 24; // that a decoder of progressive images may need
  private static final long MAX_SCANNED = 1L << 27; // pixels times scans: half a second of decoding
  private static final int SIZE_END =
      9; // length of a frame header up to its width: marker, length, precision, height, width

  private final DecodingLimit limit;
  private byte[] bytes = new byte[FIRST_ROOM_BYTES];
  private int length;
  private int segment; // start of the next segment; after START_OF_SCAN, start of the data
  private boolean isScan;
  private int frameHeader; // start of the last frame header; 0 if none yet
  private int scans;
  private long beganMicros;

  JpegFramer() {
    this(Runtime.getRuntime().maxMemory());
  }

  /**
   * @param heapBytes maximum heap: larger images than fit a decoder's share are refused
   */
  JpegFramer(long heapBytes) {
    limit = new DecodingLimit(Math.min(MAX_PIXELS, heapBytes / BYTES_PER_PIXEL), MAX_SCANNED);
  }

  @Override
  public void accept(byte[] from, int count, long nowMicros) {
    for (int i = 0; i < count; i++) {
      accept(from[i], nowMicros);
    }
  }

  private void accept(byte each, long nowMicros) {
    if (length == 0) {
      beganMicros = nowMicros;
    }
    if (length == bytes.length) {
      bytes = Arrays.copyOf(bytes, 2 * length);
    }
    bytes[length++] = each;
    if (length <= 2) {
      begin(each & 0xFF);
    } else if (isScan) {
      scan(each & 0xFF);
    } else if (length == segment + 2) {
      mark();
    } else if (length == segment + 4) {
      segmentLength();
    }
    if (length >= LARGEST_BYTES) {
      drop("an image of more than " + LARGEST_BYTES + " bytes");
    }
  }

  private void begin(int each) {
    boolean fits = length == 1 ? each == MARKER : each == START_OF_IMAGE;
    segment = 2;
    if (!fits) {
      length = each == MARKER ? 1 : 0;
      bytes[0] = (byte) MARKER;
    }
  }

  private int unsigned(int at) {
    return bytes[at] & 0xFF;
  }

  private int unsigned16(int at) {
    return unsigned(at) << 8 | unsigned(at + 1);
  }

  private void mark() {
    int marker = unsigned(segment + 1);
    if (unsigned(segment) != MARKER || marker < FIRST_START_OF_FRAME) {
      drop("missing marker at the end of a segment");
    } else if (marker == MARKER) {
      length--; // fill bytes may precede a marker
    } else if (marker >= FIRST_RESTART && marker <= END_OF_IMAGE) {
      drop("an image without data");
    }
  }

  private void segmentLength() {
    int marker = unsigned(segment + 1);
    boolean isFrame =
        marker <= LAST_START_OF_FRAME
            && marker != HUFFMAN_TABLE
            && marker != EXTENSION
            && marker != ARITHMETIC_TABLE;
    int segmentBytes = unsigned16(segment + 2);
    if (segmentBytes < (isFrame ? SIZE_END - 2 : 2)) {
      drop("a segment of " + segmentBytes + " bytes");
      return;
    }
    isScan = marker == START_OF_SCAN;
    if (isFrame) {
      frameHeader = segment;
    }
    segment += 2 + segmentBytes;
    if (isScan) {
      scans++;
      refuseIfSlow();
    }
  }

  private void refuseIfSlow() {
    if (frameHeader != 0) {
      limit.problem(width(), height(), scans).ifPresent(this::drop);
    }
  }

  private int height() {
    return unsigned16(frameHeader + 5);
  }

  private int width() {
    return unsigned16(frameHeader + 7);
  }

  private void scan(int each) {
    if (length <= segment || unsigned(length - 2) != MARKER) {
      return;
    }
    if (each == END_OF_IMAGE) {
      end();
    } else if (each >= FIRST_START_OF_FRAME
        && each != MARKER
        && (each < FIRST_RESTART || each > END_OF_IMAGE)) {
      isScan = false; // another scan of a progressive image
      segment = length - 2;
    }
  }

  private void end() {
    int height = frameHeader == 0 ? 0 : height();
    int width = frameHeader == 0 ? 0 : width();
    if (width == 0 || height == 0) {
      drop("an image without a size");
      return;
    }
    found(
        new CameraFrame(
            beganMicros,
            width,
            height,
            CameraFrame.PixelFormat.JPEG,
            Arrays.copyOf(bytes, length),
            Optional.empty()));
    reset();
  }

  private void drop(String why) {
    refuse(why);
    reset();
  }

  @Override
  public void reset() {
    length = 0;
    isScan = false;
    frameHeader = 0;
    scans = 0;
  }
}
