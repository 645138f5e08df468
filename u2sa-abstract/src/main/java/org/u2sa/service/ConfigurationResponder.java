package org.u2sa.service;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.ChangeOrigin;
import org.u2sa.interfaces.configuration.ConfigurationCheck;
import org.u2sa.interfaces.configuration.ConfigurationOutcome;
import org.u2sa.interfaces.configuration.WrittenChange;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.inbox.AnsweredOrders;
import org.u2sa.service.inbox.ContractOrders;

/**
 * Answers queries and change requests for a service's configuration (thesis 3.2.1.1) on its thread;
 * {@link ConfigurationWriter} validates and writes.
 */
final class ConfigurationResponder {
  private static final String TOO_MANY =
      "too many changes at once; nothing was changed: try again in a second";

  private static final String NOT_LASTING =
      "not saved: the service has no configuration file, and forgets this when it is restarted";

  private final ServiceConfiguration service;
  private final XmlConfiguration configuration;
  private final ServiceConnection connection;
  private final ServiceHealth health;
  private final ConfigurationCheck check;
  private final Consumer<Set<String>> changed;

  private final ContractOrders answered;
  private final Set<String> waiting = new HashSet<>(); // identities of requests being written
  private final ConfigurationWriter writer;
  private final ChangeRate rate = new ChangeRate();
  private long refused; // requests above the rate limit

  /**
   * @param answered requests that have been answered, also by a predecessor
   * @param check refuses inconsistent changes
   * @param changed called after a change, with the names of the variables
   */
  ConfigurationResponder(
      ServiceConfiguration service,
      ServiceConnection connection,
      ServiceHealth health,
      ConfigurationWriter writer,
      ContractOrders answered,
      ConfigurationCheck check,
      Consumer<Set<String>> changed) {
    this.service = service;
    this.connection = connection;
    this.health = health;
    this.writer = writer;
    this.answered = answered;
    this.check = check;
    this.changed = changed;
    configuration = service.variables();
  }

  void answer(U2SAData request) {
    if (request instanceof ConfigurationChange change) {
      change(change);
    } else if (request instanceof ConfigurationTransaction transaction) {
      once(
          transaction,
          transaction.requestId(),
          transaction.author(),
          inTime(transaction, transaction(transaction)),
          written -> result(transaction.requestId(), transaction.author(), written));
    } else if (request instanceof ConfigurationUndo undo) {
      ChangeOrigin by = by(undo.author());
      once(
          undo,
          undo.requestId(),
          undo.author(),
          inTime(undo, () -> configuration.writeUndo(by, check)),
          written -> result(undo.requestId(), undo.author(), written));
    } else {
      connection.publish(Channels.CONFIGURATION, configuration());
    }
  }

  private ConfigurationResponse configuration() {
    return new ConfigurationResponse()
        .serviceName(service.name())
        .variables(configuration.describe())
        .revision(configuration.revision());
  }

  private void change(ConfigurationChange change) {
    String name = change.variableName();
    ChangeOrigin by = by("");
    once(
        change,
        "",
        "",
        inTime(
            change,
            () ->
                configuration.write(Map.of(name, change.value()), OptionalLong.empty(), by, check)),
        written -> result(name, written));
  }

  private U2SAData result(String variable, WrittenChange written) {
    ConfigurationOutcome outcome = takeEffect(written, "");
    ConfigurationChangeResult result =
        new ConfigurationChangeResult()
            .serviceName(service.name())
            .variableName(variable)
            .accepted(outcome.accepted())
            .value(outcome.assignments().isEmpty() ? "" : outcome.assignments().get(0).value());
    remark(outcome).ifPresent(result::reason);
    return result;
  }

  private Supplier<WrittenChange> inTime(U2SAData order, Supplier<WrittenChange> write) {
    return service
        .lateness(order)
        .<Supplier<WrittenChange>>map(reason -> () -> configuration.refuse(reason))
        .orElse(write);
  }

  private Supplier<WrittenChange> transaction(ConfigurationTransaction transaction) {
    Map<String, String> wanted = new LinkedHashMap<>();
    for (ConfigurationAssignment assignment : transaction.assignments()) {
      String first = wanted.putIfAbsent(assignment.variableName(), assignment.value());
      if (first != null) {
        String reason = "variable \"" + assignment.variableName() + "\" is named twice";
        return () -> configuration.refuse(reason);
      }
    }
    ChangeOrigin by = by(transaction.author());
    return () -> configuration.write(wanted, transaction.revision(), by, check);
  }

  /** Carries out a request, unless it arrived twice. */
  private void once(
      U2SAData request,
      String requestId,
      String author,
      Supplier<WrittenChange> write,
      Function<WrittenChange, U2SAData> result) {
    Optional<U2SAData> before = answered.answer(requestId, request);
    Optional<String> identity = AnsweredOrders.identity(requestId, request);
    if (before.isPresent()) {
      connection.publish(Channels.CONFIGURATION, before.get());
    } else if (identity.isEmpty() || waiting.add(identity.get())) {
      order(
          author,
          write,
          written -> {
            identity.ifPresent(waiting::remove);
            U2SAData answer = result.apply(written);
            answered.remember(requestId, request, answer);
            connection.publish(Channels.CONFIGURATION, answer);
          });
    }
  }

  private U2SAData result(String requestId, String author, WrittenChange written) {
    ConfigurationOutcome outcome = takeEffect(written, author);
    ConfigurationTransactionResult result =
        new ConfigurationTransactionResult()
            .requestId(requestId)
            .serviceName(service.name())
            .accepted(outcome.accepted())
            .assignments(outcome.assignments())
            .revision(outcome.revision())
            .author(author);
    remark(outcome).ifPresent(result::reason);
    return result;
  }

  private Optional<String> remark(ConfigurationOutcome outcome) {
    boolean isLost = !outcome.changed().isEmpty() && !configuration.isLasting();
    return isLost ? Optional.of(NOT_LASTING) : outcome.refusal();
  }

  /** Queues the change for writing, or refuses it unread above the rate limit. */
  private void order(String author, Supplier<WrittenChange> write, Consumer<WrittenChange> answer) {
    boolean allowed = rate.allows(author, service.clock().micros());
    if (allowed && writer.order(new ConfigurationWriter.Order(() -> write(write), answer))) {
      return;
    }
    refused++;
    answer.accept(configuration.refuse(TOO_MANY));
  }

  /** On the writer's thread. */
  private WrittenChange write(Supplier<WrittenChange> change) {
    try {
      return change.get();
    } catch (RuntimeException e) { // thrown by the service's own check
      String what = "a configuration change could not be checked: " + e;
      health.error(what);
      service.log(LogLevelEnum.WARN, what);
      return configuration.refuse("the service could not check it: " + e);
    }
  }

  private ConfigurationOutcome takeEffect(WrittenChange written, String author) {
    ConfigurationOutcome outcome = written.takeEffect();
    log(outcome, author);
    if (!outcome.changed().isEmpty()) {
      changed.accept(outcome.changed());
    }
    return outcome;
  }

  private ChangeOrigin by(String author) {
    return new ChangeOrigin(service.clock().micros(), service.name(), author);
  }

  private void log(ConfigurationOutcome outcome, String author) {
    String who = author.isEmpty() ? "an unnamed client" : "\"" + author + "\"";
    if (outcome.refusal().equals(Optional.of(TOO_MANY))) {
      if (Long.bitCount(refused) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
        service.log(LogLevelEnum.WARN, TOO_MANY + " (" + refused + " so far, now for " + who + ")");
      }
      return;
    }
    if (!outcome.accepted()) {
      service.log(
          LogLevelEnum.ERROR,
          "configuration not changed for " + who + ": " + outcome.refusal().get());
      return;
    }
    for (ConfigurationAssignment assignment : outcome.assignments()) {
      service.log(
          LogLevelEnum.INFO,
          String.format(
              "variable \"%s\" changed by %s: %s → %s (revision %s)",
              assignment.variableName(),
              who,
              assignment.previous().orElse("?"),
              assignment.value(),
              outcome.revision()));
    }
  }

  /**
   * Rate limit on changes: a burst, then a fixed rate, per author and in total, because author
   * names are not authenticated.
   */
  private static final class ChangeRate {
    private static final int AUTHORS = 64; // tracked individually
    private static final double EACH_AT_ONCE = 40;
    private static final double EACH_PER_S = 10;
    private static final double ALL_AT_ONCE = 80;
    private static final double ALL_PER_S = 20;

    private final Map<String, Allowance> authors =
        new LinkedHashMap<>(AUTHORS, 0.75f, true) {
          private static final long serialVersionUID = 1L;

          @Override
          protected boolean removeEldestEntry(Map.Entry<String, Allowance> eldest) {
            return size() > AUTHORS;
          }
        };
    private final Allowance all = new Allowance(ALL_AT_ONCE, ALL_PER_S);

    /** Token bucket. */
    private static final class Allowance {
      private final double most;
      private final double perS;
      private double left;
      private long atMicros;

      Allowance(double most, double perS) {
        this.most = most;
        this.perS = perS;
        left = most;
      }

      boolean hasOne(long nowMicros) {
        left = Math.min(most, left + Clock.seconds(Math.max(0, nowMicros - atMicros)) * perS);
        atMicros = nowMicros;
        return left >= 1.0;
      }
    }

    /** Whether the author may request another change; counts it if so. */
    boolean allows(String author, long nowMicros) {
      Allowance own =
          authors.computeIfAbsent(author, name -> new Allowance(EACH_AT_ONCE, EACH_PER_S));
      boolean allowed = own.hasOne(nowMicros) & all.hasOne(nowMicros);
      if (allowed) {
        own.left--;
        all.left--;
      }
      return allowed;
    }
  }
}
