package org.u2sa.drivers.sysfs;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.port.PitotTube;
import org.u2sa.service.ServiceContext;

/**
 * A differential pressure sensor on Linux industrial I/O, such as Honeywell HSC or ABP; static
 * pressure and temperature are taken from the standard atmosphere.
 */
public final class IioPitotTube extends FileDevice<PitotTube.Impact> implements PitotTube {
  private static final double PASCALS = 1000.0;

  private final double scale;

  /**
   * @param file differential pressure file; may be absent
   * @param scale kilopascals per unit
   */
  IioPitotTube(Path file, double scale) {
    super(List.of(file));
    this.scale = scale;
  }

  @Override
  protected Impact reading(long nowMicros, double[] numbers) {
    return new Impact(
        nowMicros, PASCALS * scale * numbers[0], OptionalDouble.empty(), OptionalDouble.empty());
  }

  /** Provider of PITOT TUBE = IIO. */
  public static final class Provider extends DeviceProvider<PitotTube> {
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
