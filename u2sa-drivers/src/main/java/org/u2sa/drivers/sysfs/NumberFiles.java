package org.u2sa.drivers.sysfs;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.Attached;

/** Files with one number each that form one device: all readable, or none. */
final class NumberFiles implements Attached {
  private final List<Path> files;
  private String trouble = "not read yet";
  private int connections;

  /** Uses files that may be absent. */
  NumberFiles(List<Path> files) {
    this.files = List.copyOf(files);
  }

  /** Values in file order; empty if one cannot be read. */
  Optional<double[]> read() {
    double[] numbers = new double[files.size()];
    try {
      for (int i = 0; i < numbers.length; i++) {
        Path file = files.get(i);
        numbers[i] = Double.parseDouble(new String(Files.readAllBytes(file), US_ASCII).trim());
        if (!Double.isFinite(numbers[i])) {
          throw new NumberFormatException(file + ": " + numbers[i] + " is not a finite number");
        }
      }
    } catch (IOException | NumberFormatException e) { // a lost device is a state, not an exception
      trouble = e.toString();
      return Optional.empty();
    }
    connections += isConnected() ? 0 : 1;
    trouble = "";
    return Optional.of(numbers);
  }

  @Override
  public boolean isConnected() {
    return trouble.isEmpty();
  }

  @Override
  public int connections() {
    return connections;
  }

  @Override
  public String trouble() {
    return trouble;
  }
}
