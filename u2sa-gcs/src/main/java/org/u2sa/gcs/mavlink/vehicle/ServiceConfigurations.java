package org.u2sa.gcs.mavlink.vehicle;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.schema.U2SAData;

/** The newest configuration of each service of the vehicle. */
public final class ServiceConfigurations {
  private static final int MAX_SERVICES = 256;

  private final Map<String, ConfigurationResponse> byService = new ConcurrentSkipListMap<>();
  private final AtomicLong changes = new AtomicLong();
  private final Set<String> changed = ConcurrentHashMap.newKeySet(); // services to ask again

  ServiceConfigurations() {}

  /** Takes a message, on any thread; ignores messages other than configurations. */
  void take(U2SAData message) {
    if (message instanceof ConfigurationResponse response) {
      boolean known = byService.containsKey(response.serviceName());
      if (known || byService.size() < MAX_SERVICES) {
        byService.put(response.serviceName(), response);
        changes.incrementAndGet();
      }
    } else if (message instanceof ConfigurationTransactionResult result && result.accepted()) {
      byService.computeIfPresent(
          result.serviceName(), (name, before) -> with(before, result.assignments()));
      changes.incrementAndGet();
      changed.add(result.serviceName());
    }
  }

  /** A station that reads back a value must not receive the old one. */
  private static ConfigurationResponse with(
      ConfigurationResponse before, List<? extends ConfigurationAssignment> assignments) {
    List<ConfigurationVariable> variables = new ArrayList<>();
    for (ConfigurationVariable each : before.variables()) {
      ConfigurationVariable variable = (ConfigurationVariable) each.copy();
      assignments.stream()
          .filter(one -> one.variableName().equals(each.name()))
          .forEach(one -> variable.value(one.value()));
      variables.add(variable);
    }
    ConfigurationResponse after = ((ConfigurationResponse) before.copy()).variables(variables);
    after.freeze();
    return after;
  }

  /** Asks the services whose configuration has changed. */
  void refresh(OrdersUnderWay orders) {
    for (String service : List.copyOf(changed)) {
      changed.remove(service);
      orders.tell(Channels.CONFIGURATION, new ConfigurationRequest().serviceName(service));
    }
  }

  public Map<String, ConfigurationResponse> byService() {
    return byService;
  }

  /** Number of configurations received; a change means that one may have changed. */
  public long changes() {
    return changes.get();
  }
}
