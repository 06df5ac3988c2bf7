package org.toqa;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static com.tngtech.archunit.library.plantuml.rules.PlantUmlArchCondition.Configuration.consideringOnlyDependenciesInAnyPackage;
import static com.tngtech.archunit.library.plantuml.rules.PlantUmlArchCondition.adhereToPlantUmlDiagram;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rooms of {@code docs/architecture.puml}, and who alone may use what. */
class ArchitectureTest {
  private static final JavaClasses PRODUCT =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .importPackages("org.toqa");

  @Test
  void everyRoomUsesOnlyTheRoomsItIsDrawnToUse() throws Exception {
    classes()
        .that()
        .resideOutsideOfPackage("org.toqa.app..")
        .should(
            adhereToPlantUmlDiagram(
                    Path.of("docs/architecture.puml").toUri().toURL(),
                    consideringOnlyDependenciesInAnyPackage("org.toqa.."))
                .ignoreDependenciesWithTarget(resideInAPackage("org.toqa.geometry..")))
        .check(PRODUCT);
  }

  @ParameterizedTest
  @ValueSource(strings = {"fleet", "web", "agent", "app", "traffic"})
  void everyRoomWithinARoomUsesOnlyThoseItIsDrawnToUse(String room) throws Exception {
    String inside = "org.toqa." + room + "..";
    classes()
        .that()
        .resideInAPackage(inside)
        .should(
            adhereToPlantUmlDiagram(
                Path.of("docs", "rooms", room + ".puml").toUri().toURL(),
                consideringOnlyDependenciesInAnyPackage(inside)))
        .check(PRODUCT);
  }

  @Test
  void noTwoPackagesUseEachOtherInACircle() {
    slices().matching("org.toqa.(**)").should().beFreeOfCycles().check(PRODUCT);
  }

  @Test
  void onlyTheStoreSpeaksSql() {
    onlyIn(
        new String[] {"org.toqa.store.."},
        "java.sql..",
        "javax.sql..",
        "org.jdbi..",
        "org.flywaydb..",
        "com.zaxxer..");
  }

  @Test
  void onlyTheWebSpeaksHttp() {
    onlyIn(new String[] {"org.toqa.web..", "org.toqa.app.server.."}, "jakarta.servlet..");
  }

  @Test
  void onlyTheAppKnowsTheEmbeddedServer() {
    onlyIn(new String[] {"org.toqa.app.server.."}, "org.apache.catalina..", "org.apache.tomcat..");
  }

  @Test
  void onlyTheFleetIsMadeOfActors() {
    onlyIn(
        new String[] {
          "org.toqa.fleet.manager..",
          "org.toqa.fleet.dispatch..",
          "org.toqa.fleet.floor..",
          "org.toqa.fleet.robot.."
        },
        "org.apache.pekko..");
  }

  @Test
  void onlyTheTrustOfTheLinkKnowsCertificatesAndTls() {
    onlyIn(new String[] {"org.toqa.link.trust.."}, "org.bouncycastle..");
    onlyIn(new String[] {"org.toqa.link.trust..", "org.toqa.telemetry.mqtt.."}, "javax.net.ssl..");
  }

  @Test
  void onlyTheTelemetrySpeaksMqtt() {
    onlyIn(
        new String[] {"org.toqa.telemetry.mqtt.."},
        "org.eclipse.paho..",
        "io.moquette..",
        "io.netty..");
  }

  @Test
  void onlyCommandsPrint() {
    noClasses()
        .that()
        .resideOutsideOfPackages("org.toqa.app..", "org.toqa.launch..")
        .and()
        .doNotHaveFullyQualifiedName("org.toqa.agent.Main")
        .should()
        .accessField(System.class, "out")
        .orShould()
        .accessField(System.class, "err")
        .check(PRODUCT);
  }

  /** What judges the smooth planner shares no code with it. */
  @Test
  void theExactLengthAndTheSmoothPlannerStandApart() {
    noClasses()
        .that()
        .resideInAPackage("org.toqa.planning.exact..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("org.toqa.planning.smooth..", "org.toqa.planning")
        .check(PRODUCT);
    noClasses()
        .that()
        .resideOutsideOfPackages(
            "org.toqa.planning.exact..", "org.toqa.app.bench..", "org.toqa.lab..")
        .should()
        .dependOnClassesThat()
        .resideInAPackage("org.toqa.planning.exact..")
        .check(PRODUCT);
  }

  /** Agents share their threads: who waited in one would stop the others. */
  @Test
  void noAgentSleeps() {
    noClasses()
        .that()
        .resideInAnyPackage("org.toqa.fleet..", "org.toqa.traffic..", "org.toqa.mission..")
        .and() // its threads are its own, and store
        .doNotHaveSimpleName("StoreWriter")
        .should()
        .callMethod(Thread.class, "sleep", long.class)
        .orShould()
        .callMethod(Thread.class, "sleep", Duration.class)
        .orShould()
        .callMethod(TimeUnit.class, "sleep", long.class)
        .check(PRODUCT);
  }

  /** The libraries may be used in the rooms, and nowhere else. */
  private static void onlyIn(String[] rooms, String... libraries) {
    noClasses()
        .that()
        .resideOutsideOfPackages(rooms)
        .and()
        .resideInAPackage("org.toqa..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(libraries)
        .check(PRODUCT);
  }
}
