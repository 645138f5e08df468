package org.u2sa.drivers.sysfs;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.Device;

/** A device whose reading is the numbers of some files. */
abstract class FileDevice<R extends Device.Reading> implements Device<R> {
  private final NumberFiles files;
  private Optional<R> latest = Optional.empty();

  /** Of files that need not be there yet. */
  FileDevice(List<Path> files) {
    this.files = new NumberFiles(files);
  }

  /** What the numbers mean, in the order of the files. */
  abstract R reading(long nowMicros, double[] numbers);

  @Override
  public final Optional<R> read(long nowMicros) {
    Optional<double[]> numbers = files.read();
    if (numbers.isPresent() && !isOf(nowMicros)) {
      latest = Optional.of(reading(nowMicros, numbers.get()));
    }
    return latest;
  }

  /** Whether the newest reading is of that moment already. */
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
