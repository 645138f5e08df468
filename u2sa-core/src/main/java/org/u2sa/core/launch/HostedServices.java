package org.u2sa.core.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.NameTakenException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.service.ServiceSwap;
import org.u2sa.service.U2SAService;

/**
 * The services that run as threads of this process. The list may be read and changed by any thread;
 * ending and making services takes time and happens outside its lock.
 *
 * <p>A restart ends the current instance (its {@code release} leaves actuators neutral) and starts
 * a new one of the same class, name and configuration file, unless a dry run shows beforehand that
 * it cannot be created. A thread that hangs cannot be ended in Java: it is disconnected and
 * abandoned.
 *
 * <p>A swap replaces a running service with another class ({@link ServiceSwap}) with the same
 * configuration. After a swap, a restart creates the swapped-in class; the next run of the system
 * uses the system file again.
 */
final class HostedServices implements ServiceHost {
  /** Longest wait for a service's thread to end. */
  private static final double SWAP_WITHIN_S = 2.0;

  private static final long END_WITHIN_MS = 5_000;

  private final ServiceMaker maker;
  private final boolean supervised;
  private final Consumer<String> console;
  private final List<Hosted> list = new ArrayList<>(); // in the order of the system file
  private boolean closing;

  /**
   * A service.
   *
   * @param entry its entry in the system file, with its configuration
   * @param className current class: the entry's class until swapped
   */
  record Hosted(
      SystemFile.Entry entry,
      String className,
      XmlConfiguration configuration,
      U2SAService service) {}

  /**
   * @param supervised whether an external supervisor starts and restarts the services
   */
  HostedServices(ServiceMaker maker, boolean supervised, Consumer<String> console) {
    this.maker = maker;
    this.supervised = supervised;
    this.console = console;
  }

  /** Creates the services of a system file without starting them. */
  void makeAll(List<SystemFile.Entry> entries) {
    List<XmlConfiguration> configurations = new ArrayList<>();
    for (SystemFile.Entry entry : entries) {
      XmlConfiguration configuration = maker.configuration(entry);
      configurations.add(configuration);
      add(new Hosted(entry, entry.className(), configuration, made(entry, configuration)));
    }
    configurations.forEach(XmlConfiguration::refuseUndeclared);
  }

  private U2SAService made(SystemFile.Entry entry, XmlConfiguration configuration) {
    try {
      return maker.make(entry, configuration);
    } catch (NameTakenException e) {
      String other =
          present(e.name())
              .map(hosted -> "the service in line " + hosted.entry().element().line())
              .orElse("a service of the run");
      throw entry
          .element()
          .error(
              String.format(
                  "service name \"%s\" is taken by %s; expected another SERVICE NAME in its"
                      + " configuration",
                  e.name(), other));
    }
  }

  private synchronized void add(Hosted hosted) {
    list.add(hosted);
  }

  /** Snapshot of the services, in the order of the system file. */
  synchronized List<U2SAService> services() {
    return list.stream().map(Hosted::service).collect(Collectors.toList());
  }

  /** The service of that name, running or ended. */
  synchronized Optional<Hosted> present(String serviceName) {
    return list.stream()
        .filter(hosted -> hosted.service().getServiceName().equals(serviceName))
        .findFirst();
  }

  /**
   * Replaces a service with another, unless the system is ending.
   *
   * @return whether it was replaced; if not, the caller ends the new one
   */
  synchronized boolean replace(Hosted old, Hosted successor) {
    int place = list.indexOf(old);
    if (closing || place < 0) {
      return false;
    }
    list.set(place, successor);
    return true;
  }

  @Override
  public boolean isFor(ServiceOrder order) {
    boolean hosted = present(order.serviceName()).isPresent();
    return hosted && (!supervised || order.action() == ServiceAction.SWAP);
  }

  @Override
  public Optional<String> start(String serviceName) {
    Hosted old = present(serviceName).orElseThrow();
    if (old.service().isRunning()) {
      return Optional.of("service " + serviceName + " is already running");
    }
    return startInPlaceOf(old);
  }

  @Override
  public Optional<String> restart(String serviceName) {
    return startInPlaceOf(present(serviceName).orElseThrow());
  }

  @Override
  public Optional<String> swap(String serviceName, String className) {
    Hosted old = present(serviceName).orElseThrow();
    XmlConfiguration configuration = old.configuration().forSuccessor();
    try {
      U2SAService made = maker.makeInPlaceOf(old.service(), className, configuration);
      Hosted successor = new Hosted(old.entry(), className, configuration, made);
      Optional<String> refusal =
          new ServiceSwap(old.service(), made, () -> replace(old, successor))
              .order()
              .await(SWAP_WITHIN_S);
      if (refusal.isEmpty() && !configuration.withoutEffect().isEmpty()) {
        made.log("does not declare " + configuration.withoutEffect() + " (they have no effect)");
      }
      return refusal;
    } catch (RuntimeException | LinkageError e) { // missing class, invalid variable, broken jar
      return Optional.of(e instanceof BadInputException ? e.getMessage() : e.toString());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.of("the launcher was interrupted; see the log for the outcome");
    }
  }

  private Optional<String> startInPlaceOf(Hosted old) {
    try {
      // An invalid file rejects the order before the running service is ended. The successor reads
      // the file again: here all variables are declared, so its device could not tell variables set
      // in the file from those it may set itself.
      XmlConfiguration checked = configurationInPlaceOf(old);
      old.configuration().declared().forEach(checked::getVariable);
      checked.refuseUndeclared();
      if (old.service().isRunning()) {
        maker.tryOut(old.className(), configurationInPlaceOf(old));
      }
      XmlConfiguration configuration = configurationInPlaceOf(old);
      end(old.service());
      Hosted successor =
          new Hosted(
              old.entry(),
              old.className(),
              configuration,
              maker.makeAnew(old.className(), configuration));
      if (!replace(old, successor)) {
        successor.service().shutDown();
        return Optional.of("the system is ending");
      }
      successor.service().start();
      return Optional.empty();
    } catch (RuntimeException e) { // invalid file, missing device, no Communication Manager
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  private XmlConfiguration configurationInPlaceOf(Hosted old) {
    XmlConfiguration configuration = maker.configuration(old.entry());
    if (!old.className().equals(old.entry().className())) { // was swapped
      configuration.override("SERVICE NAME", old.service().getServiceName());
      configuration.tolerate(old.configuration().tolerated());
    }
    return configuration;
  }

  /** Ends a service if possible; returns within a few seconds in any case. */
  private void end(U2SAService service) {
    if (service.overdueHealth().isEmpty() && endsByKill(service)) {
      return;
    }
    service.abandon();
    if (service.isAlive()) {
      console.accept(
          "Service "
              + service.getServiceName()
              + " hangs and cannot be stopped: its thread is abandoned and disconnected from all others.");
    }
  }

  /** Runs on its own thread, because the service's release may hang. */
  private static boolean endsByKill(U2SAService service) {
    Thread ending = new Thread(service::shutDown, service.getServiceName() + "-end");
    ending.setDaemon(true);
    ending.start();
    boolean interrupted = false;
    try {
      ending.join(END_WITHIN_MS);
    } catch (InterruptedException e) {
      interrupted = true;
      service.kill(); // an interrupt asks the service to end; do not abandon it
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    return !service.isAlive() && !ending.isAlive();
  }

  /** Ends all services, last started first. No service is started afterwards. */
  void close() {
    List<U2SAService> all;
    synchronized (this) {
      closing = true;
      all = services();
    }
    // Last started first: control sends its neutral commands while the services that carry
    // them out still run.
    for (int i = all.size() - 1; i >= 0; i--) {
      end(all.get(i));
    }
  }
}
