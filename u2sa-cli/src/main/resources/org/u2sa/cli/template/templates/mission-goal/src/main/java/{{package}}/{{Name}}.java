package {{package}};

import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/** A place to go to and stay at. In missions: {@code <{{name}}>}. */
public final class {{Name}} extends Waypoint {
  private static final Schema<{{Name}}> SCHEMA =
      Schema.of("{{Name}}", {{Name}}.class, {{Name}}::new, Waypoint.TYPE);
  private static final NumberField<{{Name}}> STAY = SCHEMA.optionalNumber("stay", "s", 0.0);

  /** The schema. */
  public static final MessageType<{{Name}}> TYPE = SCHEMA.build();

  @Override
  public MessageType<{{Name}}> type() {
    return TYPE;
  }

  /** How long to stay [s]; 0 until set. */
  public double stay() {
    return get(STAY).orElse(0.0);
  }

  /** Sets {@link #stay()}. */
  public {{Name}} stay(double seconds) {
    put(STAY, seconds);
    return this;
  }
}
