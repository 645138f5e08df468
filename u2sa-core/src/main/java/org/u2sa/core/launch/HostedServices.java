package org.u2sa.core.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.service.U2SAService;

/**
 * The services that run as threads of this process. The list may be read and changed by any thread;
 * ending and making services takes time and happens outside its lock.
 *
 * <p>A restart ends the present instance (its {@code release} leaves actuators neutral), and makes
 * and starts a new one of the same class, name and configuration file. A thread that hangs cannot
 * be ended in Java: it is cut off from all others and given up.
 *
 * <p><b>Hot swap plugs in at {@link #swap}</b>: {@link #present} gives what runs and the entry it
 * was made from, {@link ServiceMaker} makes the successor, and {@link #replace} puts it into the
 * list, so that {@link #services}, a later restart (of the new class) and the end of the system all
 * know it.
 */
final class HostedServices implements ServiceHost {
  private final ServiceMaker maker;
  private final boolean supervised;
  private final Consumer<String> console;
  private final List<Hosted> list = new ArrayList<>(); // in the order of the system file
  private boolean closing;

  /** A service and the entry of the system file that it was made from. */
  record Hosted(SystemFile.Entry entry, U2SAService service) {}

  /**
   * @param supervised whether somebody outside this process starts and restarts its service
   */
  HostedServices(ServiceMaker maker, boolean supervised, Consumer<String> console) {
    this.maker = maker;
    this.supervised = supervised;
    this.console = console;
  }

  /** Makes the services of a system file; none is started. */
  void makeAll(List<SystemFile.Entry> entries) {
    List<XmlConfiguration> configurations = new ArrayList<>();
    for (SystemFile.Entry entry : entries) {
      XmlConfiguration configuration = maker.configuration(entry);
      configurations.add(configuration);
      add(new Hosted(entry, maker.make(entry, configuration)));
    }
    configurations.forEach(XmlConfiguration::refuseUndeclared);
  }

  private synchronized void add(Hosted hosted) {
    list.add(hosted);
  }

  /** The services at this moment, in the order of the system file. */
  synchronized List<U2SAService> services() {
    return list.stream().map(Hosted::service).collect(Collectors.toList());
  }

  /** The service of that name, whether it runs or has ended. */
  synchronized Optional<Hosted> present(String serviceName) {
    return list.stream()
        .filter(hosted -> hosted.service().getServiceName().equals(serviceName))
        .findFirst();
  }

  /**
   * Puts a service in the place of another one, unless the system is ending.
   *
   * @return whether it was done; otherwise the caller ends the new one
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
      return Optional.of("service " + serviceName + " runs already");
    }
    return startAnew(old);
  }

  @Override
  public Optional<String> restart(String serviceName) {
    return startAnew(present(serviceName).orElseThrow());
  }

  @Override
  public Optional<String> swap(String serviceName, String className) {
    return Optional.of("a service cannot be swapped by this launcher");
  }

  private Optional<String> startAnew(Hosted old) {
    end(old.service());
    try {
      XmlConfiguration configuration = maker.configuration(old.entry());
      Hosted successor = new Hosted(old.entry(), maker.make(old.entry(), configuration));
      if (!replace(old, successor)) {
        successor.service().kill();
        return Optional.of("the system is ending");
      }
      successor.service().start();
      return Optional.empty();
    } catch (RuntimeException e) { // a wrong file, a missing device, no Communication Manager
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  private void end(U2SAService service) {
    service.kill();
    if (service.isAlive()) {
      console.accept(
          "Service "
              + service.getServiceName()
              + " hangs and cannot be ended: its thread is given up, cut off from all others.");
      service.interrupt(); // in case it waits for something
    }
  }

  /** Ends all services, last started first. Nothing is started from here on. */
  void close() {
    List<U2SAService> all;
    synchronized (this) {
      closing = true;
      all = services();
    }
    // Last started, first ended: control says its neutral commands while the services that carry
    // them out still run.
    for (int i = all.size() - 1; i >= 0; i--) {
      all.get(i).kill();
    }
  }
}
