package org.u2sa.drivers.sysfs;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.PitotTube;
import org.u2sa.service.ServiceContext;

/**
 * A differential pressure sensor that Linux's industrial I/O reads, such as Honeywell's HSC or ABP
 * series; static pressure and temperature are the standard atmosphere's.
 */
public final class IioPitotTube extends FileDevice<PitotTube.Impact> implements PitotTube {
  private static final double PASCALS = 1000.0;

  private final double scale;

  /**
   * @param file of the pressure difference; need not be there
   * @param scale kilopascals of its unit
   */
  IioPitotTube(Path file, double scale) {
    super(List.of(file));
    this.scale = scale;
  }

  @Override
  Impact reading(long nowMicros, double[] numbers) {
    return new Impact(
        nowMicros, PASCALS * scale * numbers[0], OptionalDouble.empty(), OptionalDouble.empty());
  }

  /** PITOT TUBE IIO in a configuration. */
  public static final class Provider extends DeviceProvider<PitotTube> {
    /** For {@link java.util.ServiceLoader}. */
    public Provider() {
      super(PitotTube.class, "IIO");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(IioPressure.Scale.class);
    }

    @Override
    protected PitotTube open(String name, ServiceContext context) {
      return new IioPitotTube(IioPressure.file(context), IioPressure.scale(context));
    }
  }
}
