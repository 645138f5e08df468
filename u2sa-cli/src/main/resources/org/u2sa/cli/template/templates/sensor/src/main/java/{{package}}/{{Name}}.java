package {{package}};

import java.util.Random;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/** Measures the vehicle's altitude above mean sea level. Out: sensed-state. */
public final class {{Name}} extends ProprioceptiveSensor {
  private static final double RATE_HZ = 10.0;

  private record Variables(
      @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0.2)
          @Description("Standard deviation of a reading.")
          double noise) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final Random random;

  public {{Name}}(ServiceContext context) {
    super(context, "{{Name}}", RATE_HZ);
    random = new Random(context.seed());
  }

  @Override
  protected void step(double nowS) {
    publish(
        new StateInformation()
            .sensorName(sensorName())
            .z(altitudeM(nowS))
            .zSigma(tuning.get().noise()));
  }

  /** Simulated: 100 m, and a slow swell. Read your device here; return empty while it is disconnected. */
  private double altitudeM(double nowS) {
    return 100.0 + 5.0 * Math.sin(nowS / 10.0) + tuning.get().noise() * random.nextGaussian();
  }
}
