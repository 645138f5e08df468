package org.u2sa.drivers.sysfs;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.port.Barometer;
import org.u2sa.device.port.DepthGauge;
import org.u2sa.device.port.Pressure;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;

/**
 * A pressure sensor on Linux industrial I/O, such as BMP280, MS5611 or MS5837. {@code
 * in_pressure_input} is in kilopascal, as is {@code in_pressure_raw} times {@code
 * in_pressure_scale} (Documentation/ABI/testing/sysfs-bus-iio).
 */
public final class IioPressure extends FileDevice<Pressure> implements Barometer, DepthGauge {
  private static final double PASCALS = 1000.0;

  private final double scale;

  /**
   * @param file pressure file; may be absent
   * @param scale kilopascals per unit; 1 for files named {@code …input}
   */
  IioPressure(Path file, double scale) {
    super(List.of(file));
    this.scale = scale;
  }

  @Override
  protected Pressure reading(long nowMicros, double[] numbers) {
    return new Pressure(nowMicros, PASCALS * scale * numbers[0], OptionalDouble.empty());
  }

  /** Variable common to all pressure files. */
  record Scale(
      @Variable(unit = "kPa", min = 0, minExcluded = true, ifAbsent = 1)
          @Description("IIO: kilopascals per unit of the file; 1 for in_pressure_input.")
          double fileScale) {}

  private static IioPressure open(ServiceContext context) {
    return new IioPressure(file(context), scale(context));
  }

  static Path file(ServiceContext context) {
    return context
        .configuration()
        .resolve((String) context.configuration().getVariable("CONNECTION"));
  }

  static double scale(ServiceContext context) {
    return context.configuration().settings(Scale.class).get().fileScale();
  }

  /** Provider of BAROMETER = IIO. */
  public static final class BarometerProvider extends DeviceProvider<Barometer> {
    public BarometerProvider() {
      super(Barometer.class, "IIO");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(Scale.class);
    }

    @Override
    protected Barometer open(String name, ServiceContext context) {
      return IioPressure.open(context);
    }
  }

  /** Provider of DEPTH GAUGE = IIO. */
  public static final class DepthGaugeProvider extends DeviceProvider<DepthGauge> {
    public DepthGaugeProvider() {
      super(DepthGauge.class, "IIO");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(Scale.class);
    }

    @Override
    protected DepthGauge open(String name, ServiceContext context) {
      return IioPressure.open(context);
    }
  }
}
