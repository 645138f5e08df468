package org.u2sa.messages.contract;

import java.util.Optional;
import java.util.OptionalLong;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Condition of a service as seen by the health monitor (thesis 3.5.3), and the countermeasure in
 * progress.
 */
public final class ServiceCondition extends ServiceMessage<ServiceCondition> {
  private static final Schema<ServiceCondition> SCHEMA =
      Schema.of(ServiceCondition.class, ServiceCondition::new, U2SAData.TYPE)
          .since(2)
          .requiring(SERVICE_NAME);
  private static final ValueField<ServiceCondition, Condition> CONDITION =
      SCHEMA.requiredChoice("condition", Condition.class);
  private static final ValueField<ServiceCondition, Long> SINCE =
      SCHEMA.optionalCount("since", "us");
  private static final ValueField<ServiceCondition, String> REASON = SCHEMA.note("reason");
  private static final ValueField<ServiceCondition, String> ACTION = SCHEMA.note("action");
  private static final ValueField<ServiceCondition, Long> RESTARTS = SCHEMA.count("restarts", "");
  private static final ValueField<ServiceCondition, String> INSTANCE =
      SCHEMA.optionalName("instance");

  public static final MessageType<ServiceCondition> TYPE = SCHEMA.build();

  @Override
  public MessageType<ServiceCondition> type() {
    return TYPE;
  }

  /** The condition. */
  public Condition condition() {
    return require(CONDITION);
  }

  public ServiceCondition condition(Condition value) {
    return put(CONDITION, value);
  }

  /** Start of the condition [µs of the run's clock]. */
  public OptionalLong since() {
    return optionalCount(SINCE);
  }

  public ServiceCondition since(long value) {
    return put(SINCE, value);
  }

  /** Evidence for the condition. */
  public String reason() {
    return require(REASON);
  }

  public ServiceCondition reason(String value) {
    return put(REASON, value);
  }

  /** Countermeasure, such as "restart 2 of 3"; empty if none. */
  public String action() {
    return require(ACTION);
  }

  public ServiceCondition action(String value) {
    return put(ACTION, value);
  }

  /** Number of restarts. */
  public long restarts() {
    return require(RESTARTS);
  }

  public ServiceCondition restarts(long value) {
    return put(RESTARTS, value);
  }

  /** Last seen instance of the service. */
  public Optional<String> instance() {
    return Optional.ofNullable(get(INSTANCE));
  }

  public ServiceCondition instance(String value) {
    return put(INSTANCE, value);
  }
}
