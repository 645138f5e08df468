package org.u2sa.drivers.sysfs;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.Device;

/** A device read from numeric files. */
abstract class FileDevice<R extends Device.Reading> implements Device<R> {
  private final NumberFiles files;
  private Optional<R> latest = Optional.empty();

  /** Uses files that may be absent. */
  FileDevice(List<Path> files) {
    this.files = new NumberFiles(files);
  }

  /** Converts the values, in file order, to a reading. */
  abstract R reading(long nowMicros, double[] numbers);

  @Override
  public final Optional<R> read(long nowMicros) {
    Optional<double[]> numbers = files.read();
    if (numbers.isPresent() && !isOf(nowMicros)) {
      latest = Optional.of(reading(nowMicros, numbers.get()));
    }
    return latest;
  }

  /** Whether the latest reading already has this time. */
  private boolean isOf(long nowMicros) {
    return latest.isPresent() && latest.get().measuredAtMicros() == nowMicros;
  }

  @Override
  public final boolean isConnected() {
    return files.isConnected();
  }

  @Override
  public final int connections() {
    return files.connections();
  }

  @Override
  public final String trouble() {
    return files.trouble();
  }
}
