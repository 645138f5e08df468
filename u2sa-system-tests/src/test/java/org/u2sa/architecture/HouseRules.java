package org.u2sa.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackages;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaCodeUnitAccess;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.io.Externalizable;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executors;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.BaseStream;
import java.util.stream.Stream;

/**
 * What no class may break, each rule by name. Every rule also holds for a module that has no class
 * yet.
 */
final class HouseRules {
  private static final String ROOT = "org.u2sa.";

  /** Its boat's program is detached already. */
  private static final String STARTED_BY_A_VEHICLE =
      ROOT + "scenarios.roboboat.subvehicle.QuadrotorOnDeck";

  private static final String SYSTEM_CLOCK = ROOT + "interfaces.time.SystemClock";

  /** Which packages of ours each module's package may use, besides itself. */
  private static final Map<String, List<String>> ARROWS =
      Map.ofEntries(
          Map.entry("messages", List.of()),
          Map.entry("interfaces", List.of("messages")),
          Map.entry("service", List.of("messages", "interfaces")),
          Map.entry("device", List.of("messages", "interfaces", "service")),
          Map.entry("testkit", List.of("messages", "interfaces", "service", "device")),
          Map.entry("core", List.of("messages", "interfaces", "service", "device")),
          Map.entry("estimation", List.of("messages", "interfaces", "service", "device")),
          Map.entry("world", List.of("messages", "interfaces", "service", "device")),
          Map.entry("mission", List.of("messages", "interfaces", "service", "device")),
          Map.entry("planning", List.of("messages", "interfaces", "service", "device")),
          Map.entry("control", List.of("messages", "interfaces", "service", "device")),
          Map.entry("mavlink", List.of()),
          Map.entry("drivers", List.of("messages", "interfaces", "service", "device", "mavlink")),
          Map.entry("vision", List.of("messages", "interfaces", "service", "device", "world")),
          Map.entry("sim", List.of("messages", "interfaces", "service", "device")),
          Map.entry("recorder", List.of("messages", "interfaces", "service")),
          Map.entry("report", List.of("messages", "interfaces", "recorder")),
          Map.entry(
              "gcs",
              List.of(
                  "messages", "interfaces", "service", "core", "recorder", "report", "mavlink")),
          Map.entry(
              "cli",
              List.of(
                  "messages",
                  "interfaces",
                  "service",
                  "mission",
                  "control",
                  "core",
                  "recorder",
                  "report",
                  "gcs")),
          Map.entry(
              "flightgear",
              List.of("messages", "interfaces", "service", "mission", "control", "sim")),
          Map.entry(
              "trials",
              List.of(
                  "messages",
                  "interfaces",
                  "service",
                  "mission",
                  "estimation",
                  "world",
                  "core",
                  "drivers",
                  "sim",
                  "report",
                  "gcs",
                  "cli")),
          Map.entry(
              "scenarios",
              List.of(
                  "messages",
                  "interfaces",
                  "service",
                  "device",
                  "mission",
                  "planning",
                  "world",
                  "control",
                  "core",
                  "vision",
                  "sim",
                  "report",
                  "cli",
                  "flightgear",
                  "trials")),
          Map.entry("spark", List.of("interfaces", "cli", "trials")),
          Map.entry(
              "android",
              List.of(
                  "messages",
                  "interfaces",
                  "service",
                  "device",
                  "mission",
                  "core",
                  "vision",
                  "drivers",
                  "recorder")));

  /** Calls that read the time of day or of the machine. */
  private static final Map<String, Set<String>> TIME_READERS =
      Map.of(
          "java.lang.System", Set.of("currentTimeMillis", "nanoTime"),
          "java.time.Instant", Set.of("now"),
          "java.time.LocalDate", Set.of("now"),
          "java.time.LocalTime", Set.of("now"),
          "java.time.LocalDateTime", Set.of("now"),
          "java.time.OffsetDateTime", Set.of("now"),
          "java.time.ZonedDateTime", Set.of("now"),
          "java.time.Clock", Set.of("systemUTC", "systemDefaultZone", "system"),
          "java.util.Calendar", Set.of("getInstance"),
          "java.util.Date", Set.of("<init>"));

  /** Packages of services whose executions can be repeated. */
  private static final String[] REPEATABLE =
      Stream.of(
              "estimation", "mission", "planning", "control", "world", "core.safety", "core.health")
          .map(name -> ROOT + name + "..")
          .toArray(String[]::new);

  /** Calls whose result is another one in each process: chance, and orders that have a salt. */
  private static final Map<String, Set<String>> CHANCE =
      Map.of(
          "java.lang.Math", Set.of("random"),
          "java.lang.System", Set.of("identityHashCode"),
          "java.util.UUID", Set.of("randomUUID"),
          "java.util.Map", Set.of("of", "ofEntries", "copyOf"),
          "java.util.Set", Set.of("of", "copyOf"),
          "java.util.IdentityHashMap", Set.of("<init>"),
          "java.util.concurrent.ThreadLocalRandom", Set.of("current"));

  /** Classes that may use the standard streams. */
  private static final Set<String> OWN_OUTPUT =
      Set.of(
          ROOT + "cli.Main", // through the console
          ROOT + "cli.terminal.Console",
          ROOT + "cli.terminal.RawTerminal", // through the console
          ROOT + "interfaces.log.LogFile", // on the disk's thread, through the console
          // Programs without a vehicle in real time
          ROOT + "scenarios.barn.BarnMain",
          ROOT + "trials.campaign.WorkerMain",
          ROOT + "spark.ExecutorWorkers",
          ROOT + "spark.SparkDriver");

  private HouseRules() {}

  static Map<String, ArchRule> all() {
    Map<String, ArchRule> rules = new LinkedHashMap<>();
    ARROWS.forEach((module, allowed) -> rules.put("arrows of " + module, arrows(module, allowed)));
    rules.put("known packages", knownPackages());
    rules.put("named by subject", namedBySubject());
    rules.put("Moquette", confined("core.communication", "io.moquette.."));
    rules.put("Netty", nettyAtTheEdges());
    rules.put("Paho", confined("interfaces.mqtt", "org.eclipse.paho.."));
    rules.put(
        "one XML reader", // it takes neither DOCTYPE nor entities
        confined(
            "interfaces.xml",
            "javax.xml..",
            "org.xml.sax..",
            "com.ctc.wstx..",
            "com.fasterxml.jackson.dataformat.xml.."));
    rules.put(
        "BoofCV", confined("vision.calibration", "boofcv..", "georegression..", "org.ddogleg.."));
    rules.put("SVG", confined("report.picture", "org.apache.batik..", "org.w3c.dom.."));
    rules.put("charts", confined("report.picture", "org.jfree.."));
    rules.put("Spark", confined("spark", "org.apache.spark..", "scala.."));
    rules.put("no circles between packages", noCircles());
    rules.put("no circles between service classes", noCirclesBetweenClasses("service"));
    rules.put("one clock", oneClock());
    rules.put("services repeat", servicesRepeat());
    rules.put("no static mutable state", noStaticMutableState());
    rules.put("no Java serialization", noJavaSerialization());
    rules.put("no objects from data", noObjectsFromData());
    rules.put("one console", oneConsole());
    rules.put("vehicles do not wait for output", vehiclesDoNotWaitForOutput());
    rules.put(
        "small circles", ClassCircles.ofClassesIn(ROOT + "messages..", ROOT + "interfaces.."));
    rules.put("small packages", PackageSize.ofAll());
    rules.replaceAll((name, rule) -> rule.as(name).allowEmptyShould(true));
    return rules;
  }

  private static ArchRule arrows(String module, List<String> allowed) {
    String[] targets =
        Stream.concat(Stream.of(module), allowed.stream())
            .map(name -> ROOT + name + "..")
            .toArray(String[]::new);
    return noClasses()
        .that()
        .resideInAPackage(ROOT + module + "..")
        .should()
        .dependOnClassesThat(resideInAPackage("org.u2sa..").and(resideOutsideOfPackages(targets)));
  }

  private static ArchRule knownPackages() {
    String[] known =
        ARROWS.keySet().stream().map(name -> ROOT + name + "..").toArray(String[]::new);
    return classes().should().resideInAnyPackage(known);
  }

  private static ArchRule namedBySubject() {
    return noClasses()
        .should()
        .resideInAnyPackage(
            Stream.of("util", "utils", "impl", "misc", "helper", "helpers", "common")
                .map(name -> ".." + name + "..")
                .toArray(String[]::new));
  }

  private static ArchRule confined(String home, String... library) {
    return noClasses()
        .that()
        .resideOutsideOfPackage(ROOT + home + "..")
        .should()
        .dependOnClassesThat(resideInAnyPackage(library));
  }

  /** Only brokers and servers of viewers know it. */
  private static ArchRule nettyAtTheEdges() {
    return noClasses()
        .that()
        .resideOutsideOfPackages(ROOT + "core.communication..", ROOT + "gcs.socket..")
        .should()
        .dependOnClassesThat(resideInAnyPackage("io.netty.."));
  }

  private static ArchRule noCircles() {
    return slices().matching(ROOT + "(**)").should().beFreeOfCycles();
  }

  /** Nested classes count as their outermost one. */
  private static ArchRule noCirclesBetweenClasses(String module) {
    return slices()
        .assignedFrom(
            new SliceAssignment() {
              @Override
              public SliceIdentifier getIdentifierOf(JavaClass type) {
                return (type.getPackageName() + ".").startsWith(ROOT + module + ".")
                    ? SliceIdentifier.of(outermost(type).getName())
                    : SliceIdentifier.ignore();
              }

              @Override
              public String getDescription() {
                return "classes of " + ROOT + module;
              }
            })
        .should()
        .beFreeOfCycles();
  }

  private static JavaClass outermost(JavaClass type) {
    return type.getEnclosingClass().map(HouseRules::outermost).orElse(type);
  }

  private static ArchRule oneClock() {
    DescribedPredicate<JavaAccess<?>> readsTheTime =
        describe(
            "reads the machine's time",
            access ->
                TIME_READERS
                    .getOrDefault(access.getTargetOwner().getName(), Set.of())
                    .contains(access.getName()));
    return noClasses()
        .that()
        .doNotHaveFullyQualifiedName(SYSTEM_CLOCK)
        .should()
        .accessTargetWhere(readsTheTime);
  }

  /** A service that is executed again on the same messages and times is to do the same. */
  private static ArchRule servicesRepeat() {
    DescribedPredicate<JavaAccess<?>> differs =
        describe(
            "differs from one process to the next",
            access ->
                !access.getOrigin().getName().equals("<clinit>") // constants, to look things up in
                    && (isChance(access) || isThread(access)));
    return noClasses().that().resideInAnyPackage(REPEATABLE).should().accessTargetWhere(differs);
  }

  private static boolean isChance(JavaAccess<?> access) {
    String owner = access.getTargetOwner().getName();
    boolean unseeded = owner.equals("java.util.Random") && access.getName().equals("<init>");
    if (unseeded) {
      return hasParameters(access, 0);
    }
    // Map.of() and Set.of(one) have but one order.
    boolean single =
        owner.equals("java.util.Map") && (hasParameters(access, 0) || isMapOfOne(access))
            || owner.equals("java.util.Set") && hasParameters(access, 0);
    return !single && CHANCE.getOrDefault(owner, Set.of()).contains(access.getName());
  }

  private static boolean isMapOfOne(JavaAccess<?> access) {
    return access.getName().equals("of") && hasParameters(access, 2);
  }

  private static boolean hasParameters(JavaAccess<?> access, int count) {
    return access instanceof JavaCodeUnitAccess<?> call
        && call.getTarget().getRawParameterTypes().size() == count;
  }

  private static boolean isThread(JavaAccess<?> access) {
    JavaClass owner = access.getTargetOwner();
    boolean made = access.getName().equals("<init>") && owner.isEquivalentTo(Thread.class);
    boolean parallel =
        access.getName().equals("parallelStream")
            || access.getName().equals("parallel") && owner.isAssignableTo(BaseStream.class);
    return made
        || parallel
        || owner.isEquivalentTo(Executors.class)
        || owner.isEquivalentTo(CompletableFuture.class)
        || owner.isEquivalentTo(ForkJoinPool.class)
        || owner.getName().equals(SYSTEM_CLOCK);
  }

  private static ArchRule noStaticMutableState() {
    DescribedPredicate<JavaField> written =
        describe(
            "static and written by people",
            field ->
                field.getModifiers().contains(JavaModifier.STATIC)
                    && !field.getModifiers().contains(JavaModifier.SYNTHETIC));
    DescribedPredicate<JavaClass> mutable =
        describe(
            "mutable by its type",
            type ->
                type.getPackageName().startsWith("java.util.concurrent.atomic")
                    || type.isEquivalentTo(StringBuilder.class)
                    || type.isEquivalentTo(ThreadLocal.class)
                    || isCollectionThatCanOnlyBeMutable(type));
    return fields().that(written).should().beFinal().andShould().notHaveRawType(mutable);
  }

  /**
   * ArrayList, ConcurrentHashMap and the like; a field declared as List or Map may hold an
   * unmodifiable one.
   */
  private static boolean isCollectionThatCanOnlyBeMutable(JavaClass type) {
    return type.getPackageName().startsWith("java.util")
        && !type.isInterface()
        && (type.isAssignableTo(Collection.class) || type.isAssignableTo(Map.class));
  }

  private static ArchRule noJavaSerialization() {
    DescribedPredicate<JavaClass> declaresIt =
        describe(
            "Serializable by its own declaration",
            type ->
                type.getRawInterfaces().stream()
                    .anyMatch(
                        parent ->
                            parent.isEquivalentTo(Serializable.class)
                                || parent.isEquivalentTo(Externalizable.class)));
    return noClasses()
        .should()
        .dependOnClassesThat(
            describe(
                "write or read objects as Java serialization does",
                type ->
                    type.isEquivalentTo(ObjectOutputStream.class)
                        || type.isEquivalentTo(ObjectInputStream.class)))
        .orShould(com.tngtech.archunit.lang.conditions.ArchConditions.be(declaresIt));
  }

  /** What is printed past the console could hold up a thread of a vehicle. */
  private static ArchRule oneConsole() {
    return noClasses()
        .that(
            describe(
                "run vehicles in their process",
                type ->
                    !type.getPackageName().equals(ROOT + "testkit")
                        && !OWN_OUTPUT.contains(outermost(type).getName())))
        .should()
        .accessField(System.class, "out")
        .orShould()
        .accessField(System.class, "err");
  }

  private static ArchRule vehiclesDoNotWaitForOutput() {
    return classes()
        .that(
            describe(
                "start a vehicle from a command line",
                type ->
                    !type.getPackageName().startsWith(ROOT + "android")
                        && !type.getName().equals(STARTED_BY_A_VEHICLE)
                        && calls(type, ROOT + "core.launch.RunningSystem", "start")))
        .should(
            com.tngtech.archunit.lang.conditions.ArchConditions.be(
                describe(
                    "detached from the console",
                    type -> calls(type, ROOT + "cli.terminal.PlainLines", "detach"))));
  }

  private static boolean calls(JavaClass type, String owner, String method) {
    return type.getMethodCallsFromSelf().stream()
        .anyMatch(
            call -> call.getTargetOwner().getName().equals(owner) && call.getName().equals(method));
  }

  /** Readers that make objects of classes that the data names, as Jackson's default typing does. */
  private static ArchRule noObjectsFromData() {
    return noClasses()
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("com.fasterxml.jackson.databind..", "java.beans..", "java.rmi..");
  }
}
