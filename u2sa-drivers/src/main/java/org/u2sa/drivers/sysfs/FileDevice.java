package org.u2sa.drivers.sysfs;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.Device;

/** A device read from files with one number each: all readable, or none. */
public abstract class FileDevice<R extends Device.Reading> implements Device<R> {
  private static final int MAX_BYTES = 64; // of a number; the file may be of any length

  private final List<Path> files;
  private Optional<R> latest = Optional.empty();
  private String trouble = "not read yet";
  private int connections;

  /** Uses files that may be absent. */
  protected FileDevice(List<Path> files) {
    this.files = List.copyOf(files);
  }

  /** Converts the values, finite and in file order, to a reading. */
  protected abstract R reading(long nowMicros, double[] numbers);

  @Override
  public final Optional<R> read(long nowMicros) {
    double[] numbers = new double[files.size()];
    try {
      for (int i = 0; i < numbers.length; i++) {
        numbers[i] = number(files.get(i));
      }
    } catch (IOException | NumberFormatException e) { // a lost device is a state, not an exception
      trouble = e.toString();
      return latest;
    }
    connections += isConnected() ? 0 : 1;
    trouble = "";
    if (!isOf(nowMicros)) {
      latest = Optional.of(reading(nowMicros, numbers));
    }
    return latest;
  }

  private static double number(Path file) throws IOException {
    byte[] text = new byte[MAX_BYTES];
    int length;
    try (InputStream in = Files.newInputStream(file)) {
      length = Math.max(0, in.read(text)); // sysfs gives a number at once
    }
    double number = Double.parseDouble(new String(text, 0, length, US_ASCII).trim());
    if (!Double.isFinite(number)) {
      throw new NumberFormatException(file + ": " + number + " is not a finite number");
    }
    return number;
  }

  /** Whether the latest reading already has this time. */
  private boolean isOf(long nowMicros) {
    return latest.isPresent() && latest.get().measuredAtMicros() == nowMicros;
  }

  @Override
  public final boolean isConnected() {
    return trouble.isEmpty();
  }

  @Override
  public final int connections() {
    return connections;
  }

  @Override
  public final String trouble() {
    return trouble;
  }
}
