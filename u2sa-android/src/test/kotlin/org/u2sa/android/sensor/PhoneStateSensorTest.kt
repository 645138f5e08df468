package org.u2sa.android.sensor

import java.util.OptionalDouble
import kotlin.math.cos
import kotlin.math.sin
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.data.Offset.offset
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Test
import org.u2sa.messages.frame.MagneticModel
import org.u2sa.device.port.GpsFix
import org.u2sa.interfaces.communication.Channels
import org.u2sa.messages.StateInformation
import org.u2sa.messages.frame.Point
import org.u2sa.testkit.ServiceKit

private const val LATITUDE = 29.19
private const val LONGITUDE = -81.05

class PhoneStateSensorTest {
    private val kit = ServiceKit()
    private var reading = PhoneSensors.Reading()
    private var closed = false
    private val sensors = object : PhoneSensors {
        override fun read() = reading

        override fun close() {
            closed = true
        }
    }

    @AfterEach
    fun close() = kit.close()

    private fun start() = kit.start { PhoneStateSensor(it, sensors) }

    private fun fix(atS: Double, altitude: OptionalDouble = OptionalDouble.empty(), valid: Boolean = true) = GpsFix(
        (atS * 1e6).toLong(), LATITUDE, LONGITUDE, altitude, OptionalDouble.of(2.0), OptionalDouble.of(-1.0),
        OptionalDouble.empty(), OptionalDouble.of(3.0), OptionalDouble.empty(), 8, valid,
    )

    /** Flat on its back, its top edge to the east of magnetic north by this. */
    private fun heading(atS: Double, degrees: Double): PhoneOrientation {
        val half = -Math.toRadians(degrees) / 2.0
        return PhoneOrientation.of((atS * 1e6).toLong(), floatArrayOf(0f, 0f, sin(half).toFloat(), cos(half).toFloat()))!!
    }

    private fun newest(): StateInformation = kit.latest(Channels.SENSED_STATE).orElseThrow()

    private fun published(name: String) = kit.published(Channels.SENSED_STATE).filter { it.sensorName() == "PhoneSensor $name" }

    @Test
    fun step_oneFixForManySteps_isPublishedOnceAtItsOwnTime() {
        start()
        reading = PhoneSensors.Reading(fix = fix(0.0))
        kit.advance(1.0)

        val only = published("GPS").single()
        assertThat(only.timestamp()).hasValue(0)
        assertThat(only.x()).hasValue(LONGITUDE)
        assertThat(only.y()).hasValue(LATITUDE)
        assertThat(only.xDot()).hasValue(2.0)
        assertThat(only.xSigma()).hasValue(3.0)

        reading = PhoneSensors.Reading(fix = fix(1.0))
        kit.advance(1.0)
        assertThat(published("GPS").map { it.timestamp().asLong }).containsExactly(0L, 1_000_000L)
    }

    @Test
    fun step_attitudesOfOneFix_eachIsPublishedOnceWithoutAPlace() {
        start()
        reading = PhoneSensors.Reading(fix = fix(0.0), orientation = heading(0.0, 90.0))
        kit.advance(0.3)
        reading = PhoneSensors.Reading(fix = fix(0.0), orientation = heading(0.3, 80.0))
        kit.advance(0.3)

        assertThat(published("GPS")).hasSize(1)
        assertThat(published("attitude").map { it.timestamp().asLong }).containsExactly(0L, 300_000L)
        assertThat(published("attitude")).allSatisfy { assertThat(it.x()).isEmpty() }
    }

    @Test
    fun step_measurementsThatNoMessageTakes_areReportedAndTheServiceGoesOn() {
        start()
        for (i in 0 until 40) {
            reading = PhoneSensors.Reading(fix = fix(kit.nowS()), pressure = PhoneSensors.Pressure(0, Double.NaN))
            kit.advance(0.1)
        }
        val health = kit.latest(Channels.HEALTH).orElseThrow()
        assertThat(health.exceptions()).isZero()
        assertThat(health.lastError().orElse("")).contains("invalid data").contains("StateInformation.z")

        reading = PhoneSensors.Reading(fix = fix(kit.nowS()))
        kit.advance(0.1)
        assertThat(published("GPS")).hasSize(1)
    }

    @Test
    fun step_attitudeBeforeTheFirstFix_waitsForIt() {
        start()
        reading = PhoneSensors.Reading(orientation = heading(0.0, 90.0))
        kit.advance(0.2)
        assertThat(kit.published(Channels.SENSED_STATE)).isEmpty()
    }

    @Test
    fun step_compassHeading_isTurnedToTrueNorth() {
        start()
        reading = PhoneSensors.Reading(fix = fix(0.0), orientation = heading(0.0, 90.0))
        kit.advance(0.05)

        val declination = MagneticModel.declinationRad(LATITUDE, LONGITUDE, 0.0, 1970.0)
        assertThat(Math.toDegrees(declination)).isBetween(-9.0, -5.0) // Florida: magnetic north lies to the west
        assertThat(newest().psi().asDouble).isCloseTo(Math.toRadians(90.0) + declination, offset(1e-6))
        assertThat(newest().psiSigma()).hasValue(0.17)
    }

    @Test
    fun step_phoneAtRest_feelsNoAcceleration() {
        start()
        reading = PhoneSensors.Reading(
            fix = fix(0.0),
            orientation = heading(0.0, 30.0),
            acceleration = PhoneSensors.Sample(0, Point.of(0.0, 0.0, 9.80665)),
            turnRate = PhoneSensors.Sample(0, Point.of(0.0, 0.0, -0.2)),
        )
        kit.advance(0.05)

        assertThat(newest().zDoubleDot().asDouble).isCloseTo(0.0, offset(1e-6))
        assertThat(newest().psiDot().asDouble).isCloseTo(0.2, offset(1e-9)) // about the phone's downward axis: to the right
    }

    @Test
    fun step_phoneSpeedsUpForward_acceleratesAlongItsHeading() {
        start()
        reading = PhoneSensors.Reading(
            fix = fix(0.0),
            orientation = heading(0.0, 90.0),
            acceleration = PhoneSensors.Sample(0, Point.of(0.0, 1.5, 9.80665)),
        )
        kit.advance(0.05)

        val psi = newest().psi().asDouble
        assertThat(newest().xDoubleDot().asDouble).isCloseTo(1.5 * sin(psi), offset(1e-6))
        assertThat(newest().yDoubleDot().asDouble).isCloseTo(1.5 * cos(psi), offset(1e-6))
    }

    @Test
    fun step_noAltitudeFromGps_takesTheBarometersWithItsUncertainty() {
        start()
        reading = PhoneSensors.Reading(fix = fix(0.0), pressure = PhoneSensors.Pressure(0, 89_874.6))
        kit.advance(0.05)

        assertThat(newest().z().asDouble).isCloseTo(1_000.0, offset(1.0)) // ISO 2533, table 1
        assertThat(newest().zSigma()).hasValue(100.0)
    }

    @Test
    fun step_fixTooOldOrNotValid_saysNothing() {
        start()
        reading = PhoneSensors.Reading(fix = fix(0.0, valid = false))
        kit.advance(3.0)
        reading = PhoneSensors.Reading(fix = fix(0.1))
        kit.advance(0.5)
        assertThat(kit.published(Channels.SENSED_STATE)).isEmpty()

        reading = PhoneSensors.Reading(fix = fix(1.5))
        kit.advance(0.5)
        assertThat(published("GPS")).hasSize(1)
    }

    @Test
    fun step_attitudeTooOld_isNotPublished() {
        start()
        reading = PhoneSensors.Reading(fix = fix(0.0))
        kit.advance(1.0)
        reading = PhoneSensors.Reading(fix = fix(0.0), orientation = heading(0.4, 90.0))
        kit.advance(0.5)
        assertThat(published("attitude")).isEmpty()

        reading = PhoneSensors.Reading(fix = fix(0.0), orientation = heading(1.4, 90.0))
        kit.advance(0.2)
        assertThat(published("attitude")).hasSize(1)
    }

    @Test
    fun kill_sensorsAreClosed() {
        val service = start()
        service.kill()
        assertThat(closed).isTrue()
    }
}
