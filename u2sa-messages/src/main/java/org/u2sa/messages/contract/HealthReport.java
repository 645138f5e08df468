package org.u2sa.messages.contract;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** A service's heartbeat (thesis 3.5.3). Counts start when the service does. */
public class HealthReport extends ServiceMessage<HealthReport> {
  private static final Schema<HealthReport> SCHEMA =
      Schema.of(HealthReport.class, HealthReport::new, U2SAData.TYPE).requiring(SERVICE_NAME);
  private static final ValueField<HealthReport, ServiceStatus> STATUS =
      SCHEMA.requiredChoice("status", ServiceStatus.class);
  private static final ValueField<HealthReport, String> LAST_ERROR =
      SCHEMA.optionalNote("lastError");
  private static final ValueField<HealthReport, Long> INBOX_DEPTH = SCHEMA.count("inboxDepth", "");
  private static final ValueField<HealthReport, Long> DROPPED = SCHEMA.count("dropped", "");
  private static final ValueField<HealthReport, Long> REFUSED = SCHEMA.count("refused", "");
  private static final ValueField<HealthReport, Long> OVERRUNS = SCHEMA.count("overruns", "");
  private static final ValueField<HealthReport, Long> EXCEPTIONS = SCHEMA.count("exceptions", "");
  private static final NumberField<HealthReport> CALLBACK_P50 =
      SCHEMA.optionalNumber("callbackP50", "s", 0.0);
  private static final NumberField<HealthReport> CALLBACK_P99 =
      SCHEMA.optionalNumber("callbackP99", "s", 0.0);
  private static final ValueField<HealthReport, String> INSTANCE =
      SCHEMA.since(2).optionalName("instance");
  private static final NumberField<HealthReport> INTERVAL =
      SCHEMA.optionalNumber("interval", "s", 0.0);
  private static final ValueField<HealthReport, Boolean> THREAD_ALIVE =
      SCHEMA.optionalFlag("threadAlive");
  private static final NumberField<HealthReport> CALLBACK_RUNNING =
      SCHEMA.optionalNumber("callbackRunning", "s", 0.0);
  private static final NumberField<HealthReport> DATA_AGE =
      SCHEMA.optionalNumber("dataAge", "s", 0.0);
  private static final ValueField<HealthReport, Long> PUBLISHED =
      SCHEMA.optionalCount("published", "");
  private static final ValueField<HealthReport, Long> EXPIRED = SCHEMA.optionalCount("expired", "");
  private static final ValueField<HealthReport, Long> MISSED = SCHEMA.optionalCount("missed", "");
  private static final ValueField<HealthReport, Long> REPLACED =
      SCHEMA.since(3).optionalCount("replaced", "");
  private static final ValueField<HealthReport, Long> COMMANDS_OBEYED =
      SCHEMA.optionalCount("commandsObeyed", "");
  private static final ValueField<HealthReport, Long> COMMANDS_REFUSED =
      SCHEMA.optionalCount("commandsRefused", "");
  private static final ValueField<HealthReport, String> REFUSED_SUBSCRIPTIONS =
      SCHEMA.optionalText("refusedSubscriptions");
  private static final ValueField<HealthReport, List<String>> EMERGENCY_STOPS =
      SCHEMA.since(3).optionalTexts("emergencyStops");
  private static final ValueField<HealthReport, List<String>> REMARKS =
      SCHEMA.optionalNotes("remarks");

  public static final MessageType<HealthReport> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends HealthReport> type() {
    return TYPE;
  }

  /** Life-cycle status. */
  public ServiceStatus status() {
    return require(STATUS);
  }

  public HealthReport status(ServiceStatus value) {
    return put(STATUS, value);
  }

  /** The latest error; empty if none. */
  public Optional<String> lastError() {
    return Optional.ofNullable(get(LAST_ERROR));
  }

  public HealthReport lastError(String value) {
    return put(LAST_ERROR, value);
  }

  /** Messages waiting in the inbox. */
  public long inboxDepth() {
    return require(INBOX_DEPTH);
  }

  public HealthReport inboxDepth(long value) {
    return put(INBOX_DEPTH, value);
  }

  /**
   * Messages lost because the inbox was full. Reports without {@link #replaced()} include replaced
   * messages here.
   */
  public long dropped() {
    return require(DROPPED);
  }

  public HealthReport dropped(long value) {
    return put(DROPPED, value);
  }

  /** Messages rejected as unreadable or unexpected. */
  public long refused() {
    return require(REFUSED);
  }

  public HealthReport refused(long value) {
    return put(REFUSED, value);
  }

  /** Steps that took longer than their period. */
  public long overruns() {
    return require(OVERRUNS);
  }

  public HealthReport overruns(long value) {
    return put(OVERRUNS, value);
  }

  /** Exceptions caught. */
  public long exceptions() {
    return require(EXCEPTIONS);
  }

  public HealthReport exceptions(long value) {
    return put(EXCEPTIONS, value);
  }

  /** Median callback duration [s]; empty before the first callback. */
  public OptionalDouble callbackP50() {
    return get(CALLBACK_P50);
  }

  public HealthReport callbackP50(double value) {
    return put(CALLBACK_P50, value);
  }

  /** 99th percentile of callback duration [s]; empty before the first callback. */
  public OptionalDouble callbackP99() {
    return get(CALLBACK_P99);
  }

  public HealthReport callbackP99(double value) {
    return put(CALLBACK_P99, value);
  }

  /**
   * ID of this start of the service, unique in the system; the same in its discovery response and
   * its {@link ConnectionLost} will message.
   */
  public Optional<String> instance() {
    return Optional.ofNullable(get(INSTANCE));
  }

  public HealthReport instance(String value) {
    return put(INSTANCE, value);
  }

  /** Report period [s]; a service without a report for much longer counts as silent. */
  public OptionalDouble interval() {
    return get(INTERVAL);
  }

  public HealthReport interval(double value) {
    return put(INTERVAL, value);
  }

  /**
   * Whether the service's thread is alive; reported by the launcher if the service itself is
   * silent, empty in the service's own reports.
   */
  public Optional<Boolean> threadAlive() {
    return Optional.ofNullable(get(THREAD_ALIVE));
  }

  public HealthReport threadAlive(boolean value) {
    return put(THREAD_ALIVE, value);
  }

  /**
   * Running time of the current callback or step [s]; reported by the launcher if the service
   * itself is silent.
   */
  public OptionalDouble callbackRunning() {
    return get(CALLBACK_RUNNING);
  }

  public HealthReport callbackRunning(double value) {
    return put(CALLBACK_RUNNING, value);
  }

  /**
   * Time since the service last published data, not counting contract messages [s]; empty before
   * the first.
   */
  public OptionalDouble dataAge() {
    return get(DATA_AGE);
  }

  public HealthReport dataAge(double value) {
    return put(DATA_AGE, value);
  }

  /** Messages published, not counting contract messages. */
  public OptionalLong published() {
    return optionalCount(PUBLISHED);
  }

  public HealthReport published(long value) {
    return put(PUBLISHED, value);
  }

  /** Messages that missed their deadline and were treated as absent. */
  public OptionalLong expired() {
    return optionalCount(EXPIRED);
  }

  public HealthReport expired(long value) {
    return put(EXPIRED, value);
  }

  /** Messages sent to it over MQTT and lost in transit. */
  public OptionalLong missed() {
    return optionalCount(MISSED);
  }

  public HealthReport missed(long value) {
    return put(MISSED, value);
  }

  /**
   * Emergency stops in force at this service, by {@link EmergencyStop#identity()}; absent if it
   * does not obey emergency stops, an empty list if none is in force.
   */
  public Optional<List<String>> emergencyStops() {
    return Optional.ofNullable(get(EMERGENCY_STOPS));
  }

  public HealthReport emergencyStops(List<String> value) {
    return put(EMERGENCY_STOPS, List.copyOf(value));
  }

  /**
   * Queued messages superseded by newer ones of the same source on latest-value channels; not a
   * loss. Empty if the service does not count them.
   */
  public OptionalLong replaced() {
    return optionalCount(REPLACED);
  }

  public HealthReport replaced(long value) {
    return put(REPLACED, value);
  }

  /** Commands executed by its actuators; empty if it has no actuators. */
  public OptionalLong commandsObeyed() {
    return optionalCount(COMMANDS_OBEYED);
  }

  public HealthReport commandsObeyed(long value) {
    return put(COMMANDS_OBEYED, value);
  }

  /**
   * Commands addressed to its actuators but not executed, for any reason; empty if it has no
   * actuators.
   */
  public OptionalLong commandsRefused() {
    return optionalCount(COMMANDS_REFUSED);
  }

  public HealthReport commandsRefused(long value) {
    return put(COMMANDS_REFUSED, value);
  }

  /**
   * Remarks on the service's parts, each starting with the part's name and a colon; empty if none.
   */
  public List<String> remarks() {
    List<String> remarks = get(REMARKS);
    return remarks == null ? List.of() : remarks;
  }

  public HealthReport remarks(List<String> value) {
    return put(REMARKS, List.copyOf(value));
  }

  /** Comma-separated names of the channels whose subscription the broker refused; empty if none. */
  public Optional<String> refusedSubscriptions() {
    return Optional.ofNullable(get(REFUSED_SUBSCRIPTIONS));
  }

  public HealthReport refusedSubscriptions(String value) {
    return put(REFUSED_SUBSCRIPTIONS, value);
  }
}
