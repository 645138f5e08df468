package org.u2sa.gcs.configuration;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.stream.Collectors;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.remote.Unanswered;
import org.u2sa.gcs.services.DirectoryObservation;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.units.NumberWithUnit;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.schema.U2SAData;

/** Reads and changes the configuration of a running system's services over its link. */
public final class RemoteConfiguration {
  private final RemoteLink link;
  private List<String> silent = List.of();

  public RemoteConfiguration(RemoteLink link) {
    this.link = link;
  }

  /**
   * Collects the answers of all known services, by name, until all have answered or the link times
   * out.
   */
  public List<ConfigurationResponse> all() throws InterruptedException {
    return answersOr(Set.of());
  }

  /**
   * Answer of one service.
   *
   * @throws BadInputException if other services answer but not this one
   * @throws RunFailedException if no service answers
   */
  public ConfigurationResponse of(String service) throws InterruptedException {
    List<ConfigurationResponse> answers = answersOr(Set.of(service));
    for (ConfigurationResponse answer : answers) {
      if (answer.serviceName().equals(service)) {
        return answer;
      }
    }
    if (answers.isEmpty()) {
      throw nobody(service, "");
    }
    Set<String> there =
        answers.stream()
            .map(ConfigurationResponse::serviceName)
            .collect(Collectors.toCollection(TreeSet::new));
    throw new BadInputException(
        String.format(
            "no service \"%s\" answered in system \"%s\"; found: %s%s",
            service,
            link.systemId(),
            String.join(", ", there),
            NearestNames.didYouMean(service, there)));
  }

  /**
   * Returns the answers once the given services (default: all) have answered. All are asked, even
   * for a single one, so that a mistyped name can be reported with the existing names.
   */
  private List<ConfigurationResponse> answersOr(Set<String> these) throws InterruptedException {
    DirectoryObservation heard = DirectoryObservation.begin(link);
    Map<String, ConfigurationResponse> answers = new ConcurrentSkipListMap<>();
    link.ask(
        Channels.CONFIGURATION,
        new ConfigurationRequest().serviceName(""),
        ConfigurationResponse.class,
        answer -> answers.put(answer.serviceName(), answer),
        () ->
            !these.isEmpty() && answers.keySet().containsAll(these)
                || heard.areAmong(answers.keySet()));
    silent = new ArrayList<>(heard.names());
    silent.removeAll(answers.keySet());
    return new ArrayList<>(answers.values());
  }

  /** Running services that have not answered the latest request. */
  public List<String> silent() {
    return List.copyOf(silent);
  }

  /**
   * The variable of that name.
   *
   * @throws BadInputException if the service has no such variable
   */
  public static ConfigurationVariable variable(ConfigurationResponse of, String name) {
    List<String> names =
        of.variables().stream().map(ConfigurationVariable::name).collect(Collectors.toList());
    int index = names.indexOf(name);
    if (index < 0) {
      throw new BadInputException(
          String.format(
              "%s, variable \"%s\": not found%s",
              of.serviceName(), name, NearestNames.didYouMean(name, names)));
    }
    return of.variables().get(index);
  }

  /**
   * A value as the service expects it: a number with a unit is converted to the declared one. Other
   * text is left for the service to validate.
   *
   * @throws BadInputException if the unit cannot be converted
   */
  public static String inUnitOf(ConfigurationVariable declared, String service, String value) {
    Optional<NumberWithUnit> quantity = NumberWithUnit.of(value);
    boolean number = declared.variableType().equals("double") && !declared.unit().isEmpty();
    if (!number || quantity.isEmpty()) {
      return value;
    }
    if (quantity.get().unit().equals(declared.unit())) {
      return quantity.get().number();
    }
    try {
      return Double.toString(quantity.get().in(declared.unit()));
    } catch (IllegalArgumentException e) {
      throw new BadInputException(
          service + ", variable \"" + declared.name() + "\": " + e.getMessage(), e);
    }
  }

  /**
   * Changes variables of a service.
   *
   * @param transaction without request ID and author
   * @throws RunFailedException if rejected, with the service's reason, or not answered
   */
  public ConfigurationTransactionResult change(ConfigurationTransaction transaction)
      throws InterruptedException {
    String id = UUID.randomUUID().toString();
    return result(transaction.requestId(id).author(Operator.name()), id, transaction.serviceName());
  }

  /**
   * Undoes a service's last change.
   *
   * @throws RunFailedException if rejected, with the service's reason, or not answered
   */
  public ConfigurationTransactionResult undo(String service) throws InterruptedException {
    String id = UUID.randomUUID().toString();
    return result(
        new ConfigurationUndo().requestId(id).serviceName(service).author(Operator.name()),
        id,
        service);
  }

  private ConfigurationTransactionResult result(U2SAData request, String id, String service)
      throws InterruptedException {
    ConfigurationTransactionResult result =
        link.first(
                Channels.CONFIGURATION,
                request,
                ConfigurationTransactionResult.class,
                each -> each.requestId().equals(id) && each.serviceName().equals(service))
            .orElseThrow(() -> nobody(service, "; " + Unanswered.EXPIRING));
    if (!result.accepted()) {
      throw new RunFailedException(result.reason());
    }
    return result;
  }

  private RunFailedException nobody(String service, String later) {
    return new RunFailedException(
        String.format(
            "%s of system \"%s\" did not answer within %s s; ./u2sa config list shows which services do%s",
            service, link.systemId(), link.timeoutS(), later));
  }

  /** Text of a change: one line per variable, and the revision with the service's remark. */
  public static List<String> told(
      ConfigurationTransactionResult result, ConfigurationResponse before) {
    List<String> lines =
        result.assignments().stream()
            .map(assignment -> told(assignment, variable(before, assignment.variableName())))
            .collect(Collectors.toList());
    String remark = result.reason().isEmpty() ? "" : "; " + result.reason();
    lines.add(result.serviceName() + " is at revision " + result.revision() + remark);
    return lines;
  }

  private static String told(ConfigurationAssignment assignment, ConfigurationVariable variable) {
    String unit = variable.unit().isEmpty() ? "" : " " + variable.unit();
    return String.format(
        "%s: %s%s%s",
        assignment.variableName(),
        assignment.previous().map(previous -> previous + " → ").orElse(""),
        assignment.value(),
        unit);
  }
}
