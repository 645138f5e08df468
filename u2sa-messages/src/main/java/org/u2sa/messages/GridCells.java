package org.u2sa.messages;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/**
 * Wire form of a grid's cells: zlib-compressed (RFC 1950), Base64-encoded (RFC 4648, with padding)
 * and split into consecutive texts. Text, so that JSON readers can also decode it.
 */
final class GridCells {
  static final int MAX_SIDE = 4_096;
  static final int MAX_CELLS = MAX_SIDE * MAX_SIDE;

  /**
   * Heap that a process needs for each cell of the grids that it receives [bytes]: the grid itself,
   * its successor, and a planner's maps, with room for everything else.
   */
  private static final int HEAP_BYTES_PER_CELL = 64;

  private static final int PIECE_BYTES = 48_000; // a multiple of 3: Base64 pads the last piece only
  private static final int BUFFER_BYTES = 16_384;

  private GridCells() {}

  static int side(String name, long cells) {
    if (cells < 0 || cells > MAX_SIDE) {
      throw new IllegalArgumentException(
          "OccupancyGrid." + name + ": " + cells + "; expected 0…" + MAX_SIDE);
    }
    return (int) cells;
  }

  static List<String> pack(byte[] cells) {
    Deflater deflater = new Deflater(Deflater.BEST_SPEED);
    try {
      deflater.setInput(cells);
      deflater.finish();
      ByteArrayOutputStream packed = new ByteArrayOutputStream();
      byte[] buffer = new byte[BUFFER_BYTES];
      while (!deflater.finished()) {
        packed.write(buffer, 0, deflater.deflate(buffer));
      }
      return pieces(packed.toByteArray());
    } finally {
      deflater.end();
    }
  }

  private static List<String> pieces(byte[] packed) {
    List<String> pieces = new ArrayList<>();
    for (int from = 0; from < packed.length; from += PIECE_BYTES) {
      int length = Math.min(PIECE_BYTES, packed.length - from);
      byte[] piece = new byte[length];
      System.arraycopy(packed, from, piece, 0, length);
      pieces.add(Base64.getEncoder().encodeToString(piece));
    }
    return pieces;
  }

  /**
   * Unpacks the cells of a received message; never allocates more memory than columns and rows
   * imply.
   *
   * @throws IllegalStateException naming the inconsistency
   */
  static byte[] unpack(List<String> pieces, int columns, int rows) {
    return unpack(pieces, columns, rows, maxReceived(Runtime.getRuntime().maxMemory()));
  }

  /** Maximum cells of a received grid in a process with the given heap size [bytes]. */
  static long maxReceived(long heapBytes) {
    return Math.min(MAX_CELLS, heapBytes / HEAP_BYTES_PER_CELL);
  }

  static byte[] unpack(List<String> pieces, int columns, int rows, long maxCells) {
    if ((long) columns * rows > maxCells) {
      throw broken(
          String.format(
              "%s × %s are more than the %s that fit into the heap", columns, rows, maxCells),
          null);
    }
    byte[] cells = new byte[columns * rows];
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(Base64.getDecoder().decode(String.join("", pieces)));
      int filled = 0;
      while (filled < cells.length) {
        int more = inflater.inflate(cells, filled, cells.length - filled);
        if (more == 0) {
          throw broken("end after " + filled + " of " + cells.length, null);
        }
        filled += more;
      }
      if (inflater.inflate(new byte[1]) != 0) {
        throw broken("are more than " + columns + " × " + rows, null);
      }
      return cells;
    } catch (DataFormatException | IllegalArgumentException e) {
      throw broken("are not zlib data in Base64", e);
    } finally {
      inflater.end();
    }
  }

  private static IllegalStateException broken(String what, Exception cause) {
    return new IllegalStateException("OccupancyGrid.cells: " + what, cause);
  }
}
