package org.u2sa.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.Location;
import com.tngtech.archunit.core.importer.Locations;
import com.tngtech.archunit.lang.ArchRule;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every module's classes keep the rules of the house. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class HouseRulesTest {
  private JavaClasses house;

  /** No module depends on the application, so it is on no class path: read where it was built. */
  private static final Path APPLICATION =
      Paths.get("").toAbsolutePath().resolveSibling("u2sa-android").resolve("target/classes");

  @BeforeAll
  void readAllModules() {
    Set<Location> locations = new HashSet<>(Locations.ofPackage("org.u2sa"));
    if (Files.isDirectory(APPLICATION)) {
      locations.add(Location.of(APPLICATION));
    }
    house =
        new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .withImportOption(location -> !location.contains("/test-classes/"))
            .importLocations(locations);
  }

  @Test
  void house_asItStands_holdsClassesOfEveryModule() {
    assertThat(
            Stream.of(
                "messages",
                "interfaces",
                "service",
                "device",
                "estimation",
                "world",
                "mission",
                "planning",
                "control",
                "core",
                "mavlink",
                "drivers",
                "recorder",
                "sim",
                "report",
                "gcs",
                "cli",
                "flightgear",
                "trials",
                "scenarios",
                "spark"))
        .allSatisfy(
            module ->
                assertThat(house)
                    .anyMatch(type -> type.getPackageName().startsWith("org.u2sa." + module)));
  }

  @Test
  void names_ofAllClasses_areUnique() {
    Map<String, Set<String>> packages = new TreeMap<>();
    for (JavaClass type : house) {
      if (type.isTopLevelClass() && !type.getSimpleName().equals("package-info")) {
        packages
            .computeIfAbsent(type.getSimpleName(), name -> new TreeSet<>())
            .add(type.getPackageName());
      }
    }
    packages.values().removeIf(homes -> homes.size() == 1);
    assertThat(packages).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("rules")
  void rule_onAllModules_isKept(String name) {
    ArchRule rule = HouseRules.all().get(name);
    rule.check(house);
  }

  Set<String> rules() {
    return HouseRules.all().keySet();
  }
}
