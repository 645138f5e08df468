package org.u2sa.cli.remote;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.stream.Collectors;
import org.u2sa.core.communication.discovery.BrokerSearch;
import org.u2sa.core.communication.discovery.FoundBroker;
import org.u2sa.gcs.remote.BrokerAddress;
import org.u2sa.gcs.remote.LocalSystems;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Options of all commands that join a running system in another process or on another host, and the
 * connection to it; used as {@code @Mixin RemoteSystem remote}:
 *
 * <pre>{@code
 * try (RemoteLink link = remote.connect()) {
 *   Optional<ServiceOrderResult> result =
 *       link.first(
 *           Channels.SERVICE_ORDERS,
 *           order.requestId(id),
 *           ServiceOrderResult.class,
 *           answer -> answer.requestId().equals(id));
 * }
 * }</pre>
 *
 * Failures (no broker, no system, several systems) are exceptions that the command line reports in
 * one line.
 */
public final class RemoteSystem {
  private static final double LONGEST_S = 3_600.0;

  /** Services report every 0.25 s by default; twice that plus some slack. */
  private static final double LISTEN_ON_S = 0.6;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  private BrokerAddress broker = BrokerAddress.parse("localhost"); // null if it must be found first
  private boolean isNamed; // whether the broker was given
  private String systemId;
  private double timeoutS = 3.0;

  @Option(
      names = "--broker",
      paramLabel = "HOST[:PORT]",
      description =
          "Address of the system's broker; auto: find it by mDNS. Default: the broker of the "
              + "system running on this machine, otherwise localhost:1883.")
  private void broker(String value) {
    isNamed = true;
    try {
      broker = value.equals(BrokerSearch.AUTO) ? null : BrokerAddress.parse(value);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(command.commandLine(), "--broker " + e.getMessage());
    }
  }

  @Option(
      names = "--system",
      paramLabel = "ID",
      description = "The system to join. Default: the only system found.")
  private void systemId(String value) {
    try {
      systemId = Topic.checkSystemId(value);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(command.commandLine(), "--system: " + e.getMessage());
    }
  }

  @Option(
      names = "--timeout",
      paramLabel = "S",
      description = "How long to wait for answers [s]. Default: 3.")
  private void timeout(double value) {
    if (!(value > 0.0 && value <= LONGEST_S)) {
      throw new ParameterException(
          command.commandLine(), "--timeout " + value + ": expected more than 0, at most 3600 s");
    }
    timeoutS = value;
  }

  @Option(
      names = "--user",
      paramLabel = "NAME",
      defaultValue = "",
      description = "User name for a secured broker.")
  private String user;

  @Option(
      names = "--password-file",
      paramLabel = "FILE",
      defaultValue = "",
      description = "File whose first line is the user's password.")
  private String passwordFile;

  @Option(
      names = "--ca",
      paramLabel = "FILE",
      defaultValue = "",
      description = "Certificate (PEM) of the authority that certified the secured broker.")
  private String caFile;

  /**
   * Joins the system.
   *
   * @throws org.u2sa.interfaces.communication.CommunicationException if no broker answers
   * @throws RunFailedException if no system is found
   * @throws BadInputException if several are found and none was chosen
   */
  public RemoteLink connect() throws InterruptedException {
    return new RemoteLink(transport(), name(), new SystemClock(), timeoutS, this::tell);
  }

  /**
   * {@link #connect} for orders, which are stamped with the system's time ({@link
   * RemoteLink#adoptTime}).
   */
  public RemoteLink connectForOrders() throws InterruptedException {
    RemoteLink link = connect();
    link.adoptTime();
    return link;
  }

  /**
   * Joins the chosen system, or all systems at the broker if none was chosen, without discovery.
   *
   * @throws org.u2sa.interfaces.communication.CommunicationException if no broker answers
   */
  public RemoteLink connectToAll() throws InterruptedException {
    Clock clock = new SystemClock();
    findBroker(clock);
    String id = isChosen() ? systemId : Topic.ANY_SYSTEM;
    return new RemoteLink(transportTo(id), name(), clock, timeoutS, this::tell);
  }

  /**
   * These options for each applicable broker: the named one, or those at which this account runs
   * the chosen system (any system if none was chosen). Returns options for the default broker if it
   * runs none. Reports unreadable registry entries on standard error and continues, because a stop
   * must not wait for them.
   */
  public List<RemoteSystem> atEachBroker() {
    if (isNamed) {
      return List.of(this);
    }
    List<RemoteSystem> each =
        LocalSystems.ofAccount().brokers(Optional.ofNullable(systemId), this::tell).stream()
            .map(this::at)
            .toList();
    return each.isEmpty() ? List.of(at(broker)) : each;
  }

  private RemoteSystem at(BrokerAddress address) {
    RemoteSystem there = new RemoteSystem();
    there.command = command;
    there.broker = address;
    there.isNamed = true;
    there.systemId = systemId;
    there.timeoutS = timeoutS;
    there.user = user;
    there.passwordFile = passwordFile;
    there.caFile = caFile;
    return there;
  }

  /** Whether the system was chosen by its ID. */
  public boolean isChosen() {
    return systemId != null;
  }

  /**
   * The systems known without discovery: the chosen one, or those that this account runs at the
   * broker. For {@link #connectToAll}, once it has found the broker.
   */
  public Set<String> known() {
    return isChosen() ? Set.of(systemId) : LocalSystems.ofAccount().at(broker);
  }

  /**
   * Returns an unconnected transport for a service that joins the system. Fails like {@link
   * #connect}, except if a system was chosen by ID: then an unreachable broker is detected only
   * when connecting.
   */
  public MqttTransport transport() throws InterruptedException {
    Clock clock = new SystemClock();
    findBroker(clock);
    return transportTo(systemId == null ? theOnlyOne(clock) : systemId);
  }

  /**
   * Returns an unconnected transport to a system that may be absent, by the chosen ID.
   *
   * @param otherwise default ID if none was chosen
   */
  public MqttTransport transport(String otherwise) throws InterruptedException {
    findBroker(new SystemClock());
    return transportTo(systemId == null ? otherwise : systemId);
  }

  private void findBroker(Clock clock) throws InterruptedException {
    if (broker == null) {
      broker = search(clock);
    } else if (!isNamed) {
      isNamed = true;
      broker = LocalSystems.ofAccount().theOnly(Optional.ofNullable(systemId)).orElse(broker);
    }
  }

  private BrokerAddress search(Clock clock) throws InterruptedException {
    FoundBroker found = BrokerSearch.theOnly(Optional.ofNullable(systemId), clock, timeoutS);
    if (found.encrypted() && caFile.isEmpty()) {
      throw new BadInputException("the broker " + found + " needs TLS: --ca names its authority");
    }
    return new BrokerAddress(found.host(), found.port());
  }

  private String theOnlyOne(Clock clock) throws InterruptedException {
    SortedSet<String> heard = heard(name(), clock);
    if (heard.isEmpty()) {
      throw nobodyHeard();
    }
    if (heard.size() > 1) {
      throw new BadInputException(
          String.format(
              "several systems found at %s: %s; choose one with --system",
              broker, String.join(", ", heard)));
    }
    return heard.first();
  }

  /** Error for a broker without systems. */
  public RunFailedException nobodyHeard() {
    return new RunFailedException(
        String.format(
            Locale.ROOT,
            "no system found at %s within %.1f s; is one running? Use --broker for another broker",
            broker,
            timeoutS));
  }

  /**
   * Returns a hint for a silent system: the other systems at the broker, and the closest match.
   * Empty if the system was not chosen by ID. Warns on standard error if there is no token.
   */
  public Optional<String> otherSystems(RemoteLink link) throws InterruptedException {
    explainRefusal();
    if (systemId == null) {
      return Optional.empty();
    }
    SortedSet<String> heard = heard(name() + "-search", link.clock());
    heard.remove(systemId);
    return Optional.of(
        "  "
            + (heard.isEmpty()
                ? "no other system found at " + broker
                : "heard at " + broker + ": " + String.join(", ", heard))
            + NearestNames.didYouMean(systemId, heard));
  }

  /** Failure for a missing answer, with the {@linkplain #otherSystems other systems}. */
  public RunFailedException unanswered(RemoteLink link, String what) throws InterruptedException {
    return new RunFailedException(
        what + otherSystems(link).map(others -> ";" + others.substring(1)).orElse(""));
  }

  /**
   * Warns on standard error that the user may lack the right, or that this account has no token for
   * the broker, with the searched locations: the broker silently ignores commands of others. For
   * ineffective commands.
   */
  public void explainRefusal() {
    if (!user.isEmpty()) {
      tell(
          String.format(
              "the broker drops what no role of user \"%s\" may publish, without an answer; its own output tells (docs/security.md, Roles)",
              user));
      return;
    }
    if (broker == null || !caFile.isEmpty()) {
      return;
    }
    List<Path> looked = LocalToken.missing(broker.hostInAddress(), broker.port());
    if (!looked.isEmpty()) {
      tell(
          String.format(
              "this account has no token for the broker at %s, which ignores commands without one unless its LOCAL COMMANDS is everybody; looked for %s",
              broker, looked.stream().map(Path::toString).collect(Collectors.joining(" and "))));
    }
  }

  /**
   * Discovers systems by health reports at the broker: waits for the first, then briefly for
   * others. Lost connections are not reported, because a missing system is reported at the end.
   */
  private SortedSet<String> heard(String name, Clock clock) throws InterruptedException {
    SortedSet<String> heard = new ConcurrentSkipListSet<>();
    try (RemoteLink everywhere =
        new RemoteLink(transportTo(Topic.ANY_SYSTEM), name, clock, timeoutS, trouble -> {})) {
      everywhere.listen(Channels.HEALTH, report -> heard.add(report.systemId()));
      everywhere.await(() -> !heard.isEmpty(), timeoutS);
      if (!heard.isEmpty()) {
        everywhere.await(() -> false, Math.min(timeoutS, LISTEN_ON_S));
      }
    }
    heard.remove("");
    return heard;
  }

  private MqttTransport transportTo(String id) {
    return new MqttTransport(
            broker.hostInAddress(),
            broker.port(),
            id,
            new MessageCodec(MessageTypes.loadable(this::tell)),
            BrokerAccess.of(user, passwordFile, !caFile.isEmpty(), caFile).orAccount())
        .ofTool()
        .waiting(timeoutS); // the broker may be restarting
  }

  private String name() {
    return "u2sa-" + command.name();
  }

  /** Writes trouble to the standard error. */
  public void tell(String trouble) {
    PrintWriter err = command.commandLine().getErr();
    err.println("u2sa: " + trouble);
    err.flush();
  }

  /** Returns the broker's address for messages: {@code host:port}. */
  public String brokerAddress() {
    return broker == null ? BrokerSearch.AUTO : broker.toString();
  }
}
