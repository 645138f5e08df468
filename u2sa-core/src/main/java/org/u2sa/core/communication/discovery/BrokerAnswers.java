package org.u2sa.core.communication.discovery;

import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.core.communication.discovery.DnsMessage.Question;

/** Collects answers to a search for brokers, in any order and number. Thread-safe. */
final class BrokerAnswers {
  private static final int MOST = 64; // maximum brokers: anybody may invent some
  private static final int MAX_QUESTIONS = 32; // in a message

  private final Set<List<String>> instances = new LinkedHashSet<>(); // these: guarded by this
  private final Map<List<String>, DnsRecord> services = new HashMap<>(); // by instance
  private final Map<List<String>, DnsRecord> texts = new HashMap<>(); // by instance
  private final Map<List<String>, DnsRecord> addresses = new HashMap<>(); // by host

  /** Adds a message's information about brokers; returns whether any of it was new. */
  synchronized boolean take(DnsMessage message) {
    boolean isNew = false;
    // Keeps services of known instances only, and addresses of their hosts only.
    for (int type : new int[] {DnsRecord.POINTER, DnsRecord.SERVICE, DnsRecord.ADDRESS}) {
      for (DnsRecord record : message.records()) {
        boolean isMeant = record.type() == type && record.ttlS() != 0;
        isNew |= isMeant && take(record);
      }
    }
    for (DnsRecord record : message.records()) {
      boolean isText = record.type() == DnsRecord.TEXT && instances.contains(record.name());
      isNew |= isText && texts.putIfAbsent(record.name(), record) == null;
    }
    return isNew;
  }

  private boolean take(DnsRecord record) {
    return switch (record.type()) {
      case DnsRecord.POINTER ->
          record.name().equals(AnnouncedBroker.TYPE)
              && instances.size() < MOST
              && target(record).filter(instances::add).isPresent();
      case DnsRecord.SERVICE ->
          instances.contains(record.name()) && services.putIfAbsent(record.name(), record) == null;
      default ->
          record.data().length == Integer.BYTES
              && services.values().stream().anyMatch(each -> isAt(each, record.name()))
              && addresses.putIfAbsent(record.name(), record) == null;
    };
  }

  private static boolean isAt(DnsRecord service, List<String> host) {
    return target(service).filter(host::equals).isPresent();
  }

  private static Optional<List<String>> target(DnsRecord record) {
    try {
      return Optional.of(DnsMessage.target(record));
    } catch (IOException e) {
      return Optional.empty(); // bytes that are not text; ignore such a host
    }
  }

  /** Next questions: for brokers, and for missing information about those already found. */
  synchronized DnsMessage questions() {
    List<Question> questions = new ArrayList<>();
    questions.add(new Question(AnnouncedBroker.TYPE, DnsRecord.POINTER));
    for (List<String> instance : instances) {
      if (!texts.containsKey(instance)) {
        questions.add(new Question(instance, DnsRecord.TEXT));
      }
      Optional<List<String>> host =
          Optional.ofNullable(services.get(instance)).flatMap(BrokerAnswers::target);
      if (host.isEmpty()) {
        questions.add(new Question(instance, DnsRecord.SERVICE));
      } else if (!addresses.containsKey(host.get())) {
        questions.add(new Question(host.get(), DnsRecord.ADDRESS));
      }
    }
    return new DnsMessage(
        questions.subList(0, Math.min(questions.size(), MAX_QUESTIONS)), List.of());
  }

  /** U2SA brokers whose information is complete; one that is on several networks counts once. */
  synchronized Collection<FoundBroker> found() {
    Map<String, FoundBroker> found = new LinkedHashMap<>(); // by ID
    for (List<String> instance : instances) {
      DnsRecord service = services.get(instance);
      DnsRecord text = texts.get(instance);
      if (service != null && text != null) {
        target(service)
            .map(addresses::get)
            .ifPresent(address -> add(found, service, text.properties(), address));
      }
    }
    return found.values();
  }

  private static void add(
      Map<String, FoundBroker> found,
      DnsRecord service,
      Map<String, String> properties,
      DnsRecord address) {
    String systems = properties.get(AnnouncedBroker.SYSTEMS);
    if (systems == null) {
      return; // not a U2SA broker
    }
    String host = text(address);
    found.putIfAbsent(
        properties.getOrDefault(AnnouncedBroker.ID, host + ":" + service.port()),
        new FoundBroker(
            host,
            service.port(),
            Arrays.stream(systems.split(",")).map(String::trim).collect(Collectors.toSet()),
            Boolean.parseBoolean(properties.get(AnnouncedBroker.ENCRYPTED))));
  }

  private static String text(DnsRecord address) {
    try {
      return InetAddress.getByAddress(address.data()).getHostAddress();
    } catch (IOException e) {
      throw new IllegalStateException(e); // four bytes are always a valid address
    }
  }
}
