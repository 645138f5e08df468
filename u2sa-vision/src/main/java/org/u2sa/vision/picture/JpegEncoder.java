package org.u2sa.vision.picture;

import java.io.ByteArrayOutputStream;
import java.util.stream.IntStream;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;

/**
 * Encodes images as baseline JPEG (ITU-T T.81, JFIF 1.01) with chroma subsampling 4:2:0. Pure Java,
 * because desktop and Android encoders have no common interface; output is byte-identical on both.
 * Not thread-safe.
 */
public final class JpegEncoder {
  private static final int START = 0xFFD8;
  private static final int END = 0xFFD9;
  private static final int APPLICATION_0 = 0xFFE0;
  private static final int QUANTIZATION = 0xFFDB;
  private static final int FRAME = 0xFFC0;
  private static final int HUFFMAN = 0xFFC4;
  private static final int SCAN = 0xFFDA;
  private static final int LARGEST_SIDE = 0xFFFF;
  private static final int OTHERS_CLASS = 0x10; // table class of AC codes

  private final QuantizationTable luminance;
  private final QuantizationTable chrominance;
  private final CosineTransform transform = new CosineTransform();
  private final double[] samples = new double[CosineTransform.SAMPLES];
  private final double[] frequencies = new double[CosineTransform.SAMPLES];
  private final int[] coefficients = new int[CosineTransform.SAMPLES];

  /**
   * @param quality 1 (smallest) … 100 (best), as in libjpeg
   * @throws IllegalArgumentException if out of range
   */
  public JpegEncoder(int quality) {
    luminance = QuantizationTable.luminance(quality);
    chrominance = QuantizationTable.chrominance(quality);
  }

  /**
   * Encodes a frame as a JPEG file; JPEG frames are returned as-is.
   *
   * @throws IllegalArgumentException if a side is longer than 65535 pixels
   */
  public byte[] encode(CameraFrame frame) {
    if (frame.format() == PixelFormat.JPEG) {
      return frame.pixels().clone();
    }
    if (frame.width() > LARGEST_SIDE || frame.height() > LARGEST_SIDE) {
      throw new IllegalArgumentException(
          frame + ": expected sides of at most " + LARGEST_SIDE + " pixels for JPEG");
    }
    boolean coloured = frame.format() == PixelFormat.RGB24;
    int height = frame.height();
    int width = frame.width();
    int high = height >>> Byte.SIZE;
    int wide = width >>> Byte.SIZE;
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    two(out, START);
    segment(out, APPLICATION_0, 'J', 'F', 'I', 'F', 0, 1, 1, 0, 0, 1, 0, 1, 0, 0);
    segment(out, QUANTIZATION, with(0, luminance.steps()));
    if (coloured) { // 2 x 2 luminance samples per chroma sample
      segment(out, QUANTIZATION, with(1, chrominance.steps()));
      segment(out, FRAME, 8, high, height, wide, width, 3, 1, 0x22, 0, 2, 0x11, 1, 3, 0x11, 1);
    } else {
      segment(out, FRAME, 8, high, height, wide, width, 1, 1, 0x11, 0);
    }
    code(out, 0, HuffmanCode.LUMINANCE_DC);
    code(out, OTHERS_CLASS, HuffmanCode.LUMINANCE_AC);
    if (coloured) {
      code(out, 1, HuffmanCode.CHROMINANCE_DC);
      code(out, OTHERS_CLASS | 1, HuffmanCode.CHROMINANCE_AC);
      segment(out, SCAN, 3, 1, 0x00, 2, 0x11, 3, 0x11, 0, 63, 0);
    } else {
      segment(out, SCAN, 1, 1, 0x00, 0, 63, 0);
    }
    blocks(out, frame, coloured);
    two(out, END);
    return out.toByteArray();
  }

  private static void two(ByteArrayOutputStream out, int value) {
    out.write(value >>> Byte.SIZE);
    out.write(value);
  }

  private static void segment(ByteArrayOutputStream out, int marker, int... content) {
    two(out, marker);
    two(out, 2 + content.length);
    for (int each : content) {
      out.write(each);
    }
  }

  private static int[] with(int first, int... others) {
    return IntStream.concat(IntStream.of(first), IntStream.of(others)).toArray();
  }

  private static void code(ByteArrayOutputStream out, int which, HuffmanCode code) {
    two(out, HUFFMAN);
    two(out, 3 + code.counts().length + code.symbols().length);
    out.write(which);
    out.write(code.counts(), 0, code.counts().length);
    out.write(code.symbols(), 0, code.symbols().length);
  }

  /** Writes luminance blocks, 2 × 2 per unit for colour pictures, followed by the chroma blocks. */
  private void blocks(ByteArrayOutputStream out, CameraFrame frame, boolean coloured) {
    PicturePlanes planes = new PicturePlanes(frame);
    EntropyWriter writer = new EntropyWriter(out);
    int side = CosineTransform.SIDE;
    int unit = coloured ? 2 * side : side;
    int last = 0;
    int[] lastColours = new int[coloured ? 2 : 0];
    for (int row = 0; row < frame.height(); row += unit) {
      for (int column = 0; column < frame.width(); column += unit) {
        for (int y = row; y < row + unit; y += side) {
          for (int x = column; x < column + unit; x += side) {
            planes.brightness(y, x, samples);
            quantize(luminance);
            writer.block(coefficients, last, HuffmanCode.LUMINANCE_DC, HuffmanCode.LUMINANCE_AC);
            last = coefficients[0];
          }
        }
        for (int colour = 0; colour < lastColours.length; colour++) {
          planes.colour(colour, row, column, samples);
          quantize(chrominance);
          writer.block(
              coefficients,
              lastColours[colour],
              HuffmanCode.CHROMINANCE_DC,
              HuffmanCode.CHROMINANCE_AC);
          lastColours[colour] = coefficients[0];
        }
      }
    }
    writer.end();
  }

  private void quantize(QuantizationTable table) {
    transform.forward(samples, frequencies);
    table.quantize(frequencies, coefficients);
  }
}
