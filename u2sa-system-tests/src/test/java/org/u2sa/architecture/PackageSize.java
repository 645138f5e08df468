package org.u2sa.architecture;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;

/** Refuses packages in which nobody finds anything. Nested classes do not count. */
final class PackageSize extends ArchCondition<JavaClass> {
  private static final int MAX_CLASSES = 30;

  private final Map<String, Integer> sizes = new TreeMap<>(); // by package

  private PackageSize() {
    super("be in a package of at most " + MAX_CLASSES);
  }

  static ArchRule ofAll() {
    return classes().that().areTopLevelClasses().should(new PackageSize());
  }

  @Override
  public void init(Collection<JavaClass> all) {
    sizes.clear();
    all.stream()
        .filter(type -> !type.getSimpleName().equals("package-info"))
        .forEach(type -> sizes.merge(type.getPackageName(), 1, Integer::sum));
  }

  @Override
  public void check(JavaClass type, ConditionEvents events) {
    int size = sizes.getOrDefault(type.getPackageName(), 0);
    if (size > MAX_CLASSES) {
      events.add(
          SimpleConditionEvent.violated(
              type, type.getName() + " is in a package of " + size + " classes"));
    }
  }
}
