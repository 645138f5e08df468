package org.u2sa.core.launch;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;

/**
 * The list of a vehicle's services (thesis 3.2): classes and configurations.
 *
 * <pre>{@code
 * <system id="cessna">
 *   <communication configuration="CommunicationManager.xml"/>
 *   <web port="8080"/>
 *   <rosbridge port="9090"/>
 *   <mavlink link="tcp:5760"/>
 *   <autonomy perception="discrete" decision="static response" independence="problem detection"/>
 *   <service class="org.u2sa.estimation.PassThroughStateEstimator" configuration="StateEstimator.xml"/>
 * </system>
 * }</pre>
 *
 * <p>In systems on several machines, the Communication Manager and each service name their {@code
 * host} ({@link #onHost}).
 *
 * @param file path of the file
 * @param systemId the vehicle's ID
 * @param communication the Communication Manager's configuration file; empty for defaults
 * @param delivery message delivery between the services of one process
 * @param communicationHost the host that runs the Communication Manager; empty: any
 * @param webPort TCP port of the operator's page; empty: as the Communication Manager is configured
 * @param rosbridgePort TCP port for clients of the rosbridge protocol; empty: likewise
 * @param mavlink links to MAVLink ground stations
 * @param autonomy the vehicle's stated autonomy (thesis 2.3); empty if not stated
 * @param services services in start order
 */
public record SystemFile(
    Path file,
    String systemId,
    Optional<Path> communication,
    Delivery delivery,
    String communicationHost,
    OptionalInt webPort,
    OptionalInt rosbridgePort,
    List<MavlinkEntry> mavlink,
    Optional<AutonomyLevels> autonomy,
    List<Entry> services) {
  private static final String USUAL_WEB_PORT = "8080";
  private static final String USUAL_ROSBRIDGE_PORT = "9090";
  private static final int HIGHEST_PORT = 65_535;

  /**
   * One service.
   *
   * @param className its class, with a public constructor that takes a ServiceContext
   * @param configuration its configuration file; empty for the variables' defaults
   * @param host host on which it runs, in systems on several hosts; empty if not given
   * @param element its XML element, for error messages
   */
  public record Entry(
      String className, Optional<Path> configuration, String host, XmlElement element) {
    /** The class's name without its package or enclosing class. */
    public String simpleName() {
      return className.substring(
          Math.max(className.lastIndexOf('.'), className.lastIndexOf('$')) + 1);
    }
  }

  public SystemFile {
    mavlink = List.copyOf(mavlink);
    services = List.copyOf(services);
  }

  /**
   * Reads a system file. Paths in it are relative to its own folder.
   *
   * @throws org.u2sa.interfaces.BadInputException if it is missing, malformed or contradictory;
   *     names file, line and element
   */
  public static SystemFile read(Path file) {
    XmlElement root = XmlReader.read(file, "system");
    root.refuseUnknownAttributes("id");
    root.refuseUnknownChildren(
        "communication", "web", "rosbridge", "mavlink", "autonomy", "service");
    String id = root.attribute("id");
    try {
      Topic.checkSystemId(id);
    } catch (IllegalArgumentException e) {
      throw root.error("id: " + e.getMessage());
    }
    List<XmlElement> communication = root.children("communication");
    if (communication.size() > 1) {
      throw communication
          .get(1)
          .error("a system has one Communication Manager, but this is the second");
    }
    communication.forEach(
        element -> element.refuseUnknownAttributes("configuration", "delivery", "host"));
    List<Entry> services = new ArrayList<>();
    for (XmlElement element : root.children("service")) {
      element.refuseUnknownAttributes("class", "configuration", "host");
      services.add(
          new Entry(
              element.attribute("class"), configuration(file, element), host(element), element));
    }
    if (services.isEmpty()) {
      throw root.error(
          "lists no service; expected at least one <service class=\"…\" configuration=\"…\"/>");
    }
    Optional<Path> manager =
        communication.isEmpty() ? Optional.empty() : configuration(file, communication.get(0));
    Delivery delivery =
        communication.isEmpty() ? Delivery.DIRECT : Delivery.of(communication.get(0));
    String host = communication.isEmpty() ? "" : host(communication.get(0));
    Optional<AutonomyLevels> autonomy = root.child("autonomy").map(AutonomyLevels::read);
    OptionalInt web = port(root, "web", USUAL_WEB_PORT);
    OptionalInt rosbridge = port(root, "rosbridge", USUAL_ROSBRIDGE_PORT);
    List<MavlinkEntry> mavlink =
        root.children("mavlink").stream()
            .map(each -> MavlinkEntry.read(file, each))
            .collect(Collectors.toList());
    return new SystemFile(
        file, id, manager, delivery, host, web, rosbridge, mavlink, autonomy, services);
  }

  /** The configuration files of the Communication Manager and of the services. */
  public List<Path> configurations() {
    List<Path> all = new ArrayList<>();
    communication.ifPresent(all::add);
    services.forEach(entry -> entry.configuration().ifPresent(all::add));
    return all;
  }

  private static OptionalInt port(XmlElement root, String server, String usual) {
    Optional<XmlElement> web = root.child(server);
    if (web.isEmpty()) {
      return OptionalInt.empty();
    }
    web.get().refuseUnknownAttributes("port");
    String port = web.get().optionalAttribute("port").orElse(usual);
    if (!port.matches("[1-9][0-9]{0,4}") || Integer.parseInt(port) > HIGHEST_PORT) {
      throw web.get().error("port \"" + port + "\": expected 1…" + HIGHEST_PORT);
    }
    return OptionalInt.of(Integer.parseInt(port));
  }

  private static String host(XmlElement element) {
    return element.optionalAttribute("host").orElse("");
  }

  /**
   * Copy with some of the services only.
   *
   * @param simpleNames simple class names of the services
   * @throws BadInputException if the file does not list exactly one service for each name
   */
  public SystemFile only(Collection<String> simpleNames) {
    List<String> known = new ArrayList<>();
    services.forEach(entry -> known.add(entry.simpleName()));
    for (String name : simpleNames) {
      if (!known.contains(name)) {
        throw new BadInputException(
            file + ": lists no service \"" + name + "\"; expected one of " + known);
      }
    }
    Set<String> chosen = new HashSet<>();
    for (Entry entry : services) {
      if (simpleNames.contains(entry.simpleName()) && !chosen.add(entry.simpleName())) {
        throw entry
            .element()
            .error(
                "is one more service \""
                    + entry.simpleName()
                    + "\"; services that run in separate processes need different class names");
      }
    }
    return with(entry -> simpleNames.contains(entry.simpleName()));
  }

  /**
   * Checked copy whose services can each run in their own process.
   *
   * @throws BadInputException if two classes have the same simple name
   */
  public SystemFile apart() {
    return only(services.stream().map(Entry::simpleName).collect(Collectors.toList()));
  }

  /** {@link #only(Collection)} with one service. */
  public SystemFile only(String simpleName) {
    return only(List.of(simpleName));
  }

  /**
   * Copy with the services of one host only; possibly none, on a host that only runs the
   * Communication Manager.
   *
   * @throws BadInputException if the file does not mention the host, or a service has no host
   */
  public SystemFile onHost(String host) {
    Set<String> known = new TreeSet<>();
    known.add(communicationHost);
    for (Entry entry : services) {
      if (entry.host().isEmpty()) {
        throw entry
            .element()
            .error("names no host; expected host=\"…\" at each service of a multi-host system");
      }
      known.add(entry.host());
    }
    known.remove("");
    if (!known.contains(host)) {
      throw new BadInputException(
          file + ": names no host \"" + host + "\"; expected one of " + known);
    }
    return with(entry -> entry.host().equals(host));
  }

  /** Copy with the Communication Manager only. */
  public SystemFile withoutServices() {
    return with(entry -> false);
  }

  private SystemFile with(Predicate<Entry> wanted) {
    List<Entry> some = services.stream().filter(wanted).collect(Collectors.toList());
    return new SystemFile(
        file,
        systemId,
        communication,
        delivery,
        communicationHost,
        webPort,
        rosbridgePort,
        mavlink,
        autonomy,
        some);
  }

  private static Optional<Path> configuration(Path file, XmlElement element) {
    Optional<String> named = element.optionalAttribute("configuration");
    if (named.isEmpty()) {
      return Optional.empty();
    }
    Path path = file.resolveSibling(named.get());
    if (!Files.isRegularFile(path)) {
      throw element.error("configuration \"" + named.get() + "\": there is no file " + path);
    }
    return Optional.of(path);
  }
}
