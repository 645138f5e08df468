package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/**
 * Checks that actuators obey, using the counts of obeyed and refused commands in their services'
 * health reports. Reports a service that has refused every command for some time. Refusals while
 * disarmed are ignored.
 */
final class ActuationWatch implements Watch {
  private static final int MAX_SERVICES = 500; // beyond this number, silent ones are dropped
  private static final long FORGOTTEN_MICROS = 60 * Clock.MICROS_PER_SECOND;

  private static final String ARMED = "actuators armed";
  private static final String REFUSING = "actuators refusing";

  /** Last report of a service. */
  private static final class Heard {
    private String instance = "";
    private long obeyed;
    private long refused;
    private long refusedBefore; // count when it began to refuse all commands
    private long sinceMicros = Clock.NEVER; // when it began to do so; NEVER if it obeys or may not
    private long refusedMicros; // time of the last refusal
    private long heardMicros;
  }

  private final Supplier<SafetyVariables> settings;
  private final Map<String, Heard> services = new TreeMap<>();
  private boolean armed; // as published, which through a broker is heard later than decided

  ActuationWatch(Supplier<SafetyVariables> settings) {
    this.settings = settings;
  }

  @Override
  public Hazard hazard() {
    return Hazard.ACTUATION;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (message instanceof ArmingState state) {
      armed = state.armed();
      if (!armed) {
        services.values().forEach(service -> service.sinceMicros = Clock.NEVER);
      }
    } else if (message instanceof HealthReport report
        && report.commandsObeyed().isPresent()
        && counts(report.serviceName())) {
      hear(report, nowMicros);
    }
  }

  /** Whether it is an actuator service of this vehicle, as far as the settings name them. */
  private boolean counts(String service) {
    List<String> named = CauseText.names(settings.get().actuatorServices());
    return named.isEmpty() || named.contains(service);
  }

  private void hear(HealthReport report, long nowMicros) {
    if (services.size() >= MAX_SERVICES && !services.containsKey(report.serviceName())) {
      services.values().removeIf(each -> nowMicros - each.heardMicros > FORGOTTEN_MICROS);
    }
    Heard service = services.computeIfAbsent(report.serviceName(), name -> new Heard());
    service.heardMicros = nowMicros;
    String instance = report.instance().orElse("");
    long obeyed = report.commandsObeyed().getAsLong();
    long refused = report.commandsRefused().orElse(0L);
    boolean restarted = !instance.equals(service.instance) || refused < service.refused;
    if (!armed || restarted || obeyed != service.obeyed) {
      service.sinceMicros = Clock.NEVER;
    } else if (refused > service.refused) {
      if (service.sinceMicros == Clock.NEVER) {
        service.sinceMicros = nowMicros;
        service.refusedBefore = service.refused;
      }
      service.refusedMicros = nowMicros;
    }
    service.instance = instance;
    service.obeyed = obeyed;
    service.refused = refused;
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    List<String> values = new ArrayList<>();
    services.forEach(
        (name, service) -> {
          if (service.sinceMicros != Clock.NEVER) {
            values.addAll(
                List.of(
                    name,
                    service.instance,
                    Long.toString(service.obeyed),
                    Long.toString(service.refused),
                    Long.toString(service.refusedBefore),
                    Silence.seconds(nowMicros - service.sinceMicros)));
          }
        });
    state.flag(ARMED, armed).texts(REFUSING, values);
  }

  /** A service that refused all commands counts as refusing until it obeys or stops refusing. */
  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    armed = state.flag(ARMED);
    List<String> values = state.texts(REFUSING);
    for (int i = 0; i + 5 < values.size(); i += 6) {
      Heard service = new Heard();
      service.instance = values.get(i + 1);
      service.obeyed = Long.parseLong(values.get(i + 2));
      service.refused = Long.parseLong(values.get(i + 3));
      service.refusedBefore = Long.parseLong(values.get(i + 4));
      service.sinceMicros = nowMicros - Clock.micros(Double.parseDouble(values.get(i + 5)));
      service.refusedMicros = nowMicros;
      service.heardMicros = nowMicros;
      services.put(values.get(i), service);
    }
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    long timeMicros = Clock.micros(settings.get().refusalTime());
    for (Map.Entry<String, Heard> each : services.entrySet()) {
      Heard service = each.getValue();
      boolean refusesStill = nowMicros - service.refusedMicros <= timeMicros;
      if (service.sinceMicros != Clock.NEVER
          && refusesStill
          && nowMicros - service.sinceMicros >= timeMicros) {
        return Optional.of(
            String.format(
                "%s refuses all commands, %s in %s",
                each.getKey(),
                service.refused - service.refusedBefore,
                CauseText.seconds(Clock.seconds(nowMicros - service.sinceMicros))));
      }
    }
    return Optional.empty();
  }

  /** Before arming, actuators refuse all commands that require it. */
  @Override
  public Optional<String> objection(long nowMicros) {
    return Optional.empty();
  }
}
