package org.u2sa.messages.contract;

import java.util.List;
import java.util.OptionalLong;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** A service's configuration. */
public final class ConfigurationResponse extends ServiceMessage<ConfigurationResponse> {
  private static final Schema<ConfigurationResponse> SCHEMA =
      Schema.of(ConfigurationResponse.class, ConfigurationResponse::new, U2SAData.TYPE)
          .requiring(SERVICE_NAME);
  private static final ValueField<ConfigurationResponse, List<ConfigurationVariable>> VARIABLES =
      SCHEMA.messages("variables", ConfigurationVariable.TYPE);
  private static final ValueField<ConfigurationResponse, Long> REVISION =
      SCHEMA.since(2).optionalCount("revision", "");

  public static final MessageType<ConfigurationResponse> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationResponse> type() {
    return TYPE;
  }

  /** All its variables. */
  public List<ConfigurationVariable> variables() {
    return require(VARIABLES);
  }

  public ConfigurationResponse variables(List<? extends ConfigurationVariable> value) {
    return put(VARIABLES, List.copyOf(value));
  }

  /**
   * Change counter of this configuration; given in a {@link ConfigurationTransaction}, it prevents
   * two writers from overwriting each other's changes.
   */
  public OptionalLong revision() {
    return optionalCount(REVISION);
  }

  public ConfigurationResponse revision(long value) {
    return put(REVISION, value);
  }
}
