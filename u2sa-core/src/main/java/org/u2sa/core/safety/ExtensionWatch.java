package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/** Watch that delegates to an extension's {@link SafetyCheck}. */
final class ExtensionWatch implements Watch {
  private static final Pattern NAME = Pattern.compile("[a-z][a-z0-9 ]*");

  private final SafetyCheck check;
  private final Hazard hazard;
  private Optional<String> reported = Optional.empty(); // trouble
  private Optional<String> inherited = Optional.empty(); // trouble, until a message arrives

  private ExtensionWatch(SafetyCheck check) {
    this.check = check;
    String name = check.name();
    if (!NAME.matcher(name).matches()) {
      throw new BadInputException(
          String.format(
              "safety check %s: name \"%s\"; expected lower-case letters, digits and spaces",
              check.getClass().getName(), name));
    }
    hazard = new Hazard(name, "ON " + name.toUpperCase(Locale.ROOT), check.defaultAction());
  }

  /**
   * The watches of all checks on the class path.
   *
   * @throws BadInputException if a check's name is malformed or taken
   */
  static List<ExtensionWatch> discovered(Configurator configuration) {
    List<ExtensionWatch> watches = new ArrayList<>();
    List<Hazard> taken = new ArrayList<>(Hazard.STANDARD);
    for (SafetyCheckProvider provider : ServiceLoader.load(SafetyCheckProvider.class)) {
      for (SafetyCheck check : provider.checks(configuration)) {
        ExtensionWatch watch = new ExtensionWatch(check);
        for (Hazard other : taken) {
          if (other.variable().equals(watch.hazard.variable())
              || other.words().equals(watch.hazard.words())) {
            throw new BadInputException(
                "safety check " + check.getClass().getName() + ": name \"" + other + "\" is taken");
          }
        }
        taken.add(watch.hazard);
        watches.add(watch);
      }
    }
    return watches;
  }

  Set<Channel<?>> channels() {
    return check.channels();
  }

  @Override
  public boolean hears(Channel<?> channel) {
    return check.channels().contains(channel);
  }

  @Override
  public Hazard hazard() {
    return hazard;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    check.see(message, nowMicros);
    inherited = Optional.empty();
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    reported.ifPresent(words -> state.text(key(), words));
  }

  /** The predecessor's result counts until this check has received data. */
  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    inherited = check.channels().isEmpty() ? Optional.empty() : state.text(key());
  }

  private String key() {
    return "check " + hazard.words();
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    Optional<String> trouble = check.trouble(nowMicros);
    reported = trouble.isPresent() ? trouble : inherited;
    return reported;
  }

  @Override
  public Optional<String> objection(long nowMicros) {
    return check.objection(nowMicros);
  }
}
