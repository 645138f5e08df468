package org.u2sa.vision.picture;

import java.io.ByteArrayOutputStream;
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
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    two(out, START);
    segment(out, APPLICATION_0, 'J', 'F', 'I', 'F', 0, 1, 1, 0, 0, 1, 0, 1, 0, 0);
    table(out, 0, luminance);
    if (coloured) {
      table(out, 1, chrominance);
    }
    frame(out, frame, coloured);
    code(out, 0, HuffmanCode.LUMINANCE_DC);
    code(out, OTHERS_CLASS, HuffmanCode.LUMINANCE_AC);
    if (coloured) {
      code(out, 1, HuffmanCode.CHROMINANCE_DC);
      code(out, OTHERS_CLASS | 1, HuffmanCode.CHROMINANCE_AC);
      segment(out, SCAN, 3, 1, 0x00, 2, 0x11, 3, 0x11, 0, 63, 0);
      colours(out, new PicturePlanes(frame));
    } else {
      segment(out, SCAN, 1, 1, 0x00, 0, 63, 0);
      greys(out, new PicturePlanes(frame));
    }
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

  private static void table(ByteArrayOutputStream out, int number, QuantizationTable table) {
    int[] content = new int[1 + CosineTransform.SAMPLES];
    content[0] = number;
    for (int i = 0; i < CosineTransform.SAMPLES; i++) {
      content[1 + i] = table.step(i);
    }
    segment(out, QUANTIZATION, content);
  }

  private static void frame(ByteArrayOutputStream out, CameraFrame frame, boolean coloured) {
    int height = frame.height();
    int width = frame.width();
    int high = height >>> Byte.SIZE;
    int wide = width >>> Byte.SIZE;
    if (coloured) { // 2 x 2 luminance samples per chroma sample
      segment(out, FRAME, 8, high, height, wide, width, 3, 1, 0x22, 0, 2, 0x11, 1, 3, 0x11, 1);
    } else {
      segment(out, FRAME, 8, high, height, wide, width, 1, 1, 0x11, 0);
    }
  }

  private static void code(ByteArrayOutputStream out, int which, HuffmanCode code) {
    byte[] counts = code.counts();
    byte[] symbols = code.symbols();
    int[] content = new int[1 + counts.length + symbols.length];
    content[0] = which;
    for (int i = 0; i < counts.length; i++) {
      content[1 + i] = counts[i];
    }
    for (int i = 0; i < symbols.length; i++) {
      content[1 + counts.length + i] = symbols[i];
    }
    segment(out, HUFFMAN, content);
  }

  private void greys(ByteArrayOutputStream out, PicturePlanes planes) {
    EntropyWriter writer = new EntropyWriter(out);
    int last = 0;
    for (int row = 0; row < planes.height(); row += CosineTransform.SIDE) {
      for (int column = 0; column < planes.width(); column += CosineTransform.SIDE) {
        last = brightness(writer, planes, row, column, last);
      }
    }
    writer.end();
  }

  private void colours(ByteArrayOutputStream out, PicturePlanes planes) {
    EntropyWriter writer = new EntropyWriter(out);
    int side = CosineTransform.SIDE;
    int last = 0;
    int[] lastColours = new int[2];
    for (int row = 0; row < planes.height(); row += 2 * side) {
      for (int column = 0; column < planes.width(); column += 2 * side) {
        last = brightness(writer, planes, row, column, last);
        last = brightness(writer, planes, row, column + side, last);
        last = brightness(writer, planes, row + side, column, last);
        last = brightness(writer, planes, row + side, column + side, last);
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

  /** Writes a luminance block; returns its DC coefficient. */
  private int brightness(
      EntropyWriter writer, PicturePlanes planes, int row, int column, int last) {
    planes.brightness(row, column, samples);
    quantize(luminance);
    writer.block(coefficients, last, HuffmanCode.LUMINANCE_DC, HuffmanCode.LUMINANCE_AC);
    return coefficients[0];
  }

  private void quantize(QuantizationTable table) {
    transform.forward(samples, frequencies);
    table.quantize(frequencies, coefficients);
  }
}
