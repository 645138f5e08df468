package {{package}};

import java.util.function.DoubleConsumer;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;

/** Moves a servo. In: actuation of its ACTUATOR NAME. Out: actuators. */
public final class {{Name}} extends Actuator {
  private static final Variable<Double> NEUTRAL =
      Variable.number("NEUTRAL", "us")
          .range(Range.of(500.0, 2500.0))
          .ifAbsent(1500.0)
          .describedAs("Length of the servo's pulse at 0 %.");

  private static final Variable<Double> FULL =
      Variable.number("FULL", "us")
          .range(Range.of(-1000.0, 1000.0))
          .ifAbsent(500.0)
          .describedAs("By how much the pulse is longer at 100 %.");

  private final DoubleConsumer servo; // takes the length of its pulse [µs]

  /** Called by the launcher. Put your device in place of this one, which moves nothing. */
  public {{Name}}(ServiceContext context) {
    this(context, pulseMicros -> {});
  }

  /** With any servo, as tests have one. */
  {{Name}}(ServiceContext context, DoubleConsumer servo) {
    super(context, "{{Name}}");
    getVariable(NEUTRAL); // wrong values must fail at the start
    getVariable(FULL);
    this.servo = servo;
  }

  @Override
  protected void actuate(double percentage) {
    servo.accept(getVariable(NEUTRAL) + percentage / 100.0 * getVariable(FULL));
  }

  @Override
  protected void neutral() {
    servo.accept(getVariable(NEUTRAL));
  }
}
