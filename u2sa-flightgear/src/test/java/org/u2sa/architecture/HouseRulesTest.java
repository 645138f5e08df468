package org.u2sa.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Set;
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

  @BeforeAll
  void readAllModules() {
    house =
        new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .withImportOption(location -> !location.contains("/test-classes/"))
            .importPackages("org.u2sa");
  }

  @Test
  void house_asItStands_holdsClassesOfEveryModule() {
    assertThat(Stream.of("messages", "interfaces", "service", "core", "sim"))
        .allSatisfy(
            module ->
                assertThat(house)
                    .anyMatch(type -> type.getPackageName().startsWith("org.u2sa." + module)));
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
