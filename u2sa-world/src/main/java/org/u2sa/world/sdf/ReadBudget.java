package org.u2sa.world.sdf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.u2sa.interfaces.BadInputException;

/**
 * Limits how much data a world may read: models and meshes count each time they are included. A few
 * short files that include each other would otherwise take years.
 */
final class ReadBudget {
  private static final long MAX_BYTES = 512L << 20;
  private static final long MIN_COST = 65_536; // for opening a file, however short

  private final Path world;
  private long left = MAX_BYTES;

  /**
   * @param world its file, for the message
   */
  ReadBudget(Path world) {
    this.world = world;
  }

  /**
   * Takes the cost of reading a file.
   *
   * @throws BadInputException if the budget is exhausted
   * @throws IOException if its size cannot be read, or it is not a regular file
   */
  void take(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw new IOException("is not a regular file");
    }
    take(Math.max(MIN_COST, Files.size(file)));
  }

  /**
   * Takes the cost of a part of a file that is repeated.
   *
   * @throws BadInputException if the budget is exhausted
   */
  void take(long bytes) {
    left -= bytes;
    if (left < 0) {
      throw new BadInputException(
          world
              + ": the world's models and meshes exceed "
              + (MAX_BYTES >> 20)
              + " MB, each counted as often as it is included");
    }
  }
}
