package org.u2sa.drivers.range;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.drivers.sonar.SonarModel;
import org.u2sa.drivers.sysfs.FileDevice;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;

/**
 * A range finder with analog output, on an ADC supported by Linux industrial I/O: a file such as
 * {@code /sys/bus/iio/devices/iio:device0/in_voltage0_raw}.
 */
public final class AnalogRangeFinder extends FileDevice<RangeFinder.Distance>
    implements RangeFinder {
  /**
   * Range [m] and voltage [V] of Sharp's GP2Y0A21YK0F, near to far: 0.4 V at 0.8 m, 2.3 V at 0.1 m,
   * and the typical curve of data sheet OP13008EN, figure 2, in between.
   */
  private static final double[][] SHARP = {
    {0.10, 2.30},
    {0.15, 1.65},
    {0.20, 1.30},
    {0.30, 0.92},
    {0.40, 0.74},
    {0.50, 0.61},
    {0.60, 0.52},
    {0.70, 0.45},
    {0.80, 0.40}
  };

  private static final double MARGIN =
      0.1; // tolerance beyond the curve's ends, relative: sensors vary

  private final double voltsPerCount;
  private final DoubleFunction<OptionalDouble> curve;

  /**
   * @param file file with the ADC counts; may be absent
   * @param curve range [m] over voltage [V]
   */
  AnalogRangeFinder(Path file, double voltsPerCount, DoubleFunction<OptionalDouble> curve) {
    super(List.of(file));
    this.voltsPerCount = voltsPerCount;
    this.curve = curve;
  }

  /**
   * Range of a MaxBotix LV-MaxSonar-EZ [m]: supply / 512 volts per inch, 6…254 inches (data sheet
   * PD11832). Closer objects read as 6 inches.
   */
  static OptionalDouble maxBotixLvM(double volts, double supplyV) {
    return SonarModel.LV.rangeM(volts / (supplyV / 512.0));
  }

  /**
   * Range of a Sharp GP2Y0A21YK0F [m], 0.10…0.80: interpolates 1 / range between curve points, to
   * which voltage is roughly proportional. Below 0.1 m the voltage falls again and the object
   * appears far: mount the sensor 0.1 m back.
   */
  static OptionalDouble sharpM(double volts) {
    int last = SHARP.length - 1;
    if (!(volts <= SHARP[0][1] * (1.0 + MARGIN)) || volts < SHARP[last][1]) {
      return OptionalDouble.empty(); // NaN or out of range
    }
    int far = 1;
    while (volts < SHARP[far][1]) {
      far++;
    }
    double[] near = SHARP[far - 1];
    double share = Math.min(1.0, (volts - SHARP[far][1]) / (near[1] - SHARP[far][1]));
    return OptionalDouble.of(
        1.0 / (1.0 / SHARP[far][0] + share * (1.0 / near[0] - 1.0 / SHARP[far][0])));
  }

  @Override
  protected Distance reading(long nowMicros, double[] numbers) {
    return new Distance(nowMicros, curve.apply(numbers[0] * voltsPerCount));
  }

  /** Provider of MODEL = LV ANALOG and SHARP. */
  public static final class Provider extends DeviceProvider<RangeFinder> {
    private record Variables(
        @Variable(unit = "V", min = 0, max = 10, minExcluded = true, ifAbsent = 0.001)
            @Description("LV ANALOG, SHARP: voltage per count of the converter in CONNECTION.")
            double voltsPerCount,
        @Variable(unit = "V", min = 2.5, max = 5.5, ifAbsent = 5)
            @Description("LV ANALOG: supply voltage of the sonar.")
            double sonarSupply) {}

    public Provider() {
      super(RangeFinder.class, "LV ANALOG", "SHARP");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(Variables.class);
    }

    @Override
    protected RangeFinder open(String name, ServiceContext context) {
      Variables tuning = context.configuration().settings(Variables.class).get();
      String connection = (String) context.configuration().getVariable("CONNECTION");
      return new AnalogRangeFinder(
          context.configuration().resolve(connection),
          tuning.voltsPerCount(),
          name.equals("SHARP")
              ? AnalogRangeFinder::sharpM
              : volts -> maxBotixLvM(volts, tuning.sonarSupply()));
    }
  }
}
