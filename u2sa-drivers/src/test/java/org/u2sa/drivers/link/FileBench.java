package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.u2sa.device.port.Device;
import org.u2sa.testkit.DeviceContract;

/** A device behind files that the kernel writes. */
public final class FileBench<R extends Device.Reading> extends DeviceContract.Bench<R> {
  private final Device<R> device;
  private final Map<Path, String> contents;
  private boolean isIn = true;

  /** With what the files say. */
  public FileBench(String name, Device<R> device, Map<Path, String> contents) {
    super(name);
    this.device = device;
    this.contents = contents;
  }

  @Override
  public Device<R> device() {
    return device;
  }

  @Override
  public void live(long nowMicros) {
    try {
      for (Map.Entry<Path, String> each : contents.entrySet()) {
        if (isIn) {
          Files.write(each.getKey(), each.getValue().getBytes(US_ASCII));
        } else {
          Files.deleteIfExists(each.getKey());
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void plug(boolean in) {
    isIn = in;
  }
}
