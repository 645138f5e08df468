package org.u2sa.messages.cbor;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * Lists of numbers and points as typed arrays (RFC 8746): a tag gives the number format of a packed
 * byte string. Points are the rows of a two-dimensional array.
 */
public final class TypedArrays {
  /** Tag of a multi-dimensional array, row-major (3.1.1): [dimensions, elements]. */
  public static final int ROW_MAJOR = 40;

  /** Tag of little-endian float64, the native order of processors (2.1): the only one written. */
  static final int FLOAT_64_LITTLE_ENDIAN = 86;

  private static final int FIRST_FLOAT = 80;
  private static final int FIRST_LITTLE_ENDIAN = 84;
  private static final int LENGTH = 3; // bits of a tag: 0 float16, 1 float32, 2 float64, 3 float128
  private static final int COORDINATES = 3;
  private static final int POINT_BYTES = COORDINATES * Double.BYTES;

  private TypedArrays() {}

  /** Whether the tag is readable: floats of 16, 32 or 64 bits, in either byte order. */
  public static boolean isOfFloats(long tag) {
    return tag >= FIRST_FLOAT && tag <= FLOAT_64_LITTLE_ENDIAN && (tag & LENGTH) != LENGTH;
  }

  /** Reads the numbers of a typed array after its tag. */
  public static double[] read(CborInput in, long tag) {
    ByteBuffer data = CborStrings.bytesInPlace(in);
    data.order(tag < FIRST_LITTLE_ENDIAN ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
    int size = Short.BYTES << (tag & LENGTH);
    int count = data.remaining() / size;
    if (count * size != data.remaining()) {
      throw Limits.expected(
          String.format(
              "a byte string of whole float%s, not %s bytes", size * Byte.SIZE, data.remaining()));
    }
    double[] values = new double[count];
    switch (size) {
      case Double.BYTES -> data.asDoubleBuffer().get(values);
      case Float.BYTES -> {
        for (int i = 0; i < count; i++) {
          values[i] = data.getFloat();
        }
      }
      default -> {
        for (int i = 0; i < count; i++) {
          values[i] = CborInput.half(data.getShort());
        }
      }
    }
    return values;
  }

  /** Writes numbers as a typed array. */
  public static void write(CborOutput out, Numbers values) {
    out.tag(FLOAT_64_LITTLE_ENDIAN);
    values.put(out.byteString(values.size() * Double.BYTES));
  }

  /** Writes points as a two-dimensional typed array. */
  public static void writePoints(CborOutput out, List<Point> points) {
    out.tag(ROW_MAJOR);
    out.array(2);
    out.array(2);
    out.count(points.size());
    out.count(COORDINATES);
    out.tag(FLOAT_64_LITTLE_ENDIAN);
    ByteBuffer data = out.byteString(points.size() * POINT_BYTES);
    for (Point point : points) {
      data.putDouble(point.x());
      data.putDouble(point.y());
      data.putDouble(point.z());
    }
  }
}
