package org.u2sa.device;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.Heading;
import org.u2sa.service.ServiceContext;

/** A compass that Linux's industrial I/O reads: a file with the magnetic heading [deg]. */
public final class IioCompass implements Compass {
  private static final double TURN_DEG = 360.0;

  private final Path file;
  private Optional<Heading> latest = Optional.empty();
  private String trouble = "not read yet";
  private int connections;

  /** Over that file, which need not be there. */
  public IioCompass(Path file) {
    this.file = file;
  }

  @Override
  public Optional<Heading> read(long nowMicros) {
    try {
      double headingDeg = Double.parseDouble(Files.readString(file).trim());
      if (!(headingDeg >= 0.0 && headingDeg <= TURN_DEG)) {
        throw new NumberFormatException(headingDeg + " is outside 0…360 deg");
      }
      latest = Optional.of(Heading.ofDegrees(nowMicros, headingDeg, false));
      connections += isConnected() ? 0 : 1;
      trouble = "";
    } catch (IOException | NumberFormatException e) { // a lost device is a state, no exception
      trouble = e.toString();
    }
    return latest;
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

  /** COMPASS IIO in a configuration. */
  public static final class Provider extends DeviceProvider<Compass> {
    /** For {@link java.util.ServiceLoader}. */
    public Provider() {
      super(Compass.class, "IIO");
    }

    @Override
    protected Compass open(String name, ServiceContext context) {
      return new IioCompass(Path.of((String) context.configuration().getVariable("CONNECTION")));
    }
  }
}
