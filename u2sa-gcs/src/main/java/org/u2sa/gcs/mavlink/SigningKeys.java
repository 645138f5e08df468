package org.u2sa.gcs.mavlink;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.u2sa.core.security.SecretFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.mavlink.MavlinkSigning;

/**
 * The passphrases of a process's MAVLink links. All links of a vehicle with the same passphrase
 * admit a packet once between them: one that was recorded on a link is a replay on the others.
 * Thread-safe.
 */
public final class SigningKeys {
  private static final int MAX_BYTES = 8_192;

  private final Map<VehicleKey, MavlinkSigning> known = new HashMap<>();

  private record VehicleKey(String systemId, String passphrase) {}

  /**
   * Signing for one link of a vehicle.
   *
   * @param file its first line is the passphrase; only its owner may read it
   * @param unixMicros wall clock [µs since 1970]
   * @param warnings receives a line when a packet with the right signature is too old
   * @throws BadInputException if there is no passphrase, or others may use the file
   */
  synchronized MavlinkSigning of(
      String systemId, Path file, LongSupplier unixMicros, Consumer<String> warnings) {
    String passphrase = passphrase(file);
    return known.computeIfAbsent(
        new VehicleKey(systemId, passphrase),
        key -> new MavlinkSigning(passphrase, unixMicros, warnings));
  }

  private static String passphrase(Path file) {
    RegularFile.require(file, "the MAVLink passphrase in line 1");
    try {
      SecretFile.tooOpen(file.toRealPath())
          .ifPresent(
              what -> {
                throw new BadInputException("MAVLink key " + what);
              });
      if (Files.size(file) > MAX_BYTES) {
        throw new BadInputException(
            file + ": longer than " + MAX_BYTES + " bytes; expected the MAVLink passphrase");
      }
      List<String> lines = Files.readAllLines(file);
      if (lines.isEmpty() || lines.get(0).trim().isEmpty()) {
        throw new BadInputException(file + ": expected the MAVLink passphrase in line 1");
      }
      return lines.get(0).trim();
    } catch (IOException e) {
      throw new BadInputException(file + ": the MAVLink passphrase cannot be read: " + e, e);
    }
  }
}
