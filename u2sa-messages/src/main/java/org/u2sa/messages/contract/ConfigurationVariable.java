package org.u2sa.messages.contract;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** One variable of a service's configuration. */
public final class ConfigurationVariable extends U2SAData {
  private static final Schema<ConfigurationVariable> SCHEMA =
      Schema.of(ConfigurationVariable.class, ConfigurationVariable::new, U2SAData.TYPE);
  private static final ValueField<ConfigurationVariable, String> NAME = SCHEMA.requiredName("name");
  private static final ValueField<ConfigurationVariable, String> VARIABLE_TYPE =
      SCHEMA.name("variableType", "string");
  private static final ValueField<ConfigurationVariable, String> VALUE = SCHEMA.text("value", "");
  private static final ValueField<ConfigurationVariable, String> UNIT = SCHEMA.name("unit", "");
  private static final NumberField<ConfigurationVariable> MIN =
      SCHEMA.optionalNumber("min", "", -Double.MAX_VALUE, Double.MAX_VALUE);
  private static final NumberField<ConfigurationVariable> MAX =
      SCHEMA.optionalNumber("max", "", -Double.MAX_VALUE, Double.MAX_VALUE);
  private static final ValueField<ConfigurationVariable, String> DESCRIPTION =
      SCHEMA.text("description", "");
  private static final ValueField<ConfigurationVariable, List<String>> CHOICES =
      SCHEMA.since(2).optionalTexts("choices");

  public static final MessageType<ConfigurationVariable> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationVariable> type() {
    return TYPE;
  }

  /** Name, such as "HEADING GAIN". */
  public String name() {
    return require(NAME);
  }

  public ConfigurationVariable name(String value) {
    return put(NAME, value);
  }

  /** "string", "double", "int" or "boolean". */
  public String variableType() {
    return require(VARIABLE_TYPE);
  }

  public ConfigurationVariable variableType(String value) {
    return put(VARIABLE_TYPE, value);
  }

  /** Its value as text. */
  public String value() {
    return require(VALUE);
  }

  public ConfigurationVariable value(String value) {
    return put(VALUE, value);
  }

  /** Its unit; empty if none. */
  public String unit() {
    return require(UNIT);
  }

  public ConfigurationVariable unit(String value) {
    return put(UNIT, value);
  }

  /** Minimum value; empty if unbounded. */
  public OptionalDouble min() {
    return get(MIN);
  }

  public ConfigurationVariable min(double value) {
    return put(MIN, value);
  }

  /** Maximum value; empty if unbounded. */
  public OptionalDouble max() {
    return get(MAX);
  }

  public ConfigurationVariable max(double value) {
    return put(MAX, value);
  }

  /** Description; empty if none. */
  public String description() {
    return require(DESCRIPTION);
  }

  public ConfigurationVariable description(String value) {
    return put(DESCRIPTION, value);
  }

  /** Allowed values; empty if not restricted to a list. */
  public List<String> choices() {
    List<String> some = get(CHOICES);
    return some == null ? List.of() : some;
  }

  public ConfigurationVariable choices(List<String> value) {
    return put(CHOICES, List.copyOf(value));
  }
}
