package org.u2sa.service;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Supplier;
import org.u2sa.interfaces.ChangeOrigin;
import org.u2sa.interfaces.ConfigurationOutcome;
import org.u2sa.interfaces.LogLevelEnum;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;

/**
 * Answers for a service what others ask and change of its configuration (thesis 3.2.1.1). Runs on
 * the service's thread.
 */
final class ConfigurationResponder {
  private static final int REMEMBERED = 64;

  private final U2SAService service;
  private final XmlConfiguration configuration;

  /** The newest answers by request: a request that arrives twice is obeyed once. */
  private final Map<String, ConfigurationTransactionResult> answered =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(
            Map.Entry<String, ConfigurationTransactionResult> eldest) {
          return size() > REMEMBERED;
        }
      };

  ConfigurationResponder(U2SAService service, XmlConfiguration configuration) {
    this.service = service;
    this.configuration = configuration;
  }

  /** Whether the message is a request that {@link #answer} would answer. */
  boolean concerns(U2SAData message) {
    if (message instanceof ConfigurationRequest request) {
      return request.serviceName().isEmpty() || isForThis(request.serviceName());
    }
    if (message instanceof ConfigurationChange change) {
      return isForThis(change.serviceName());
    }
    if (message instanceof ConfigurationTransaction transaction) {
      return isForThis(transaction.serviceName());
    }
    return message instanceof ConfigurationUndo undo && isForThis(undo.serviceName());
  }

  private boolean isForThis(String serviceName) {
    return serviceName.equals(service.getServiceName());
  }

  /** Answers a request that concerns this service. Returns the variables that it changed. */
  Set<String> answer(U2SAData request) {
    if (request instanceof ConfigurationChange change) {
      return change(change);
    }
    if (request instanceof ConfigurationTransaction transaction) {
      return once(transaction.requestId(), transaction.author(), () -> transact(transaction));
    }
    if (request instanceof ConfigurationUndo undo) {
      return once(
          undo.requestId(),
          undo.author(),
          () -> configuration.undo(by(undo.author()), service::configurationRefusal));
    }
    service.publish(Channels.CONFIGURATION, configuration());
    return Set.of();
  }

  private ConfigurationResponse configuration() {
    return new ConfigurationResponse()
        .serviceName(service.getServiceName())
        .variables(configuration.describe())
        .revision(configuration.revision());
  }

  private Set<String> change(ConfigurationChange change) {
    String name = change.variableName();
    ConfigurationOutcome outcome =
        configuration.change(
            Map.of(name, change.value()),
            OptionalLong.empty(),
            by(""),
            service::configurationRefusal);
    log(outcome, "");
    ConfigurationChangeResult result =
        new ConfigurationChangeResult()
            .serviceName(service.getServiceName())
            .variableName(name)
            .accepted(outcome.accepted())
            .value(outcome.assignments().get(0).value());
    outcome.refusal().ifPresent(result::reason);
    service.publish(Channels.CONFIGURATION, result);
    return outcome.changed();
  }

  private ConfigurationOutcome transact(ConfigurationTransaction transaction) {
    List<ConfigurationAssignment> assignments = transaction.assignments();
    Map<String, String> wanted = new LinkedHashMap<>();
    for (ConfigurationAssignment assignment : assignments) {
      String first = wanted.putIfAbsent(assignment.variableName(), assignment.value());
      if (first != null) {
        return new ConfigurationOutcome(
            Optional.of("variable \"" + assignment.variableName() + "\" is named twice"),
            assignments,
            Set.of(),
            configuration.revision());
      }
    }
    return configuration.change(
        wanted, transaction.revision(), by(transaction.author()), service::configurationRefusal);
  }

  private Set<String> once(String requestId, String author, Supplier<ConfigurationOutcome> act) {
    ConfigurationTransactionResult before = answered.get(requestId);
    if (before != null) {
      service.publish(Channels.CONFIGURATION, before);
      return Set.of();
    }
    ConfigurationOutcome outcome = act.get();
    log(outcome, author);
    ConfigurationTransactionResult result =
        new ConfigurationTransactionResult()
            .requestId(requestId)
            .serviceName(service.getServiceName())
            .accepted(outcome.accepted())
            .assignments(outcome.assignments())
            .revision(outcome.revision())
            .author(author);
    outcome.refusal().ifPresent(result::reason);
    answered.put(requestId, result);
    service.publish(Channels.CONFIGURATION, result);
    return outcome.changed();
  }

  private ChangeOrigin by(String author) {
    return new ChangeOrigin(service.clock().micros(), service.getServiceName(), author);
  }

  private void log(ConfigurationOutcome outcome, String author) {
    String who = author.isEmpty() ? "somebody" : "\"" + author + "\"";
    if (!outcome.accepted()) {
      service.log(
          LogLevelEnum.ERROR,
          "configuration not changed for " + who + ": " + outcome.refusal().get());
      return;
    }
    for (ConfigurationAssignment assignment : outcome.assignments()) {
      service.log(
          LogLevelEnum.INFO,
          "variable \""
              + assignment.variableName()
              + "\" changed by "
              + who
              + ": "
              + assignment.previous().orElse("?")
              + " → "
              + assignment.value()
              + " (revision "
              + outcome.revision()
              + ")");
    }
  }
}
