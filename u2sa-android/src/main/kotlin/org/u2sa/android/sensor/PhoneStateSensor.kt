package org.u2sa.android.sensor

import org.u2sa.drivers.compass.MagneticModel
import org.u2sa.drivers.gps.GpsFix
import org.u2sa.interfaces.Clock
import org.u2sa.interfaces.LogLevelEnum
import org.u2sa.interfaces.Range
import org.u2sa.interfaces.Variable
import org.u2sa.interfaces.communication.Channels
import org.u2sa.messages.StateInformation
import org.u2sa.messages.frame.Geodetic
import org.u2sa.messages.frame.Point
import org.u2sa.messages.frame.ReferenceFrame
import org.u2sa.service.ProprioceptiveSensor
import org.u2sa.service.ServiceContext

private const val STEPS_PER_S = 20.0
private const val GRAVITY_MPS2 = 9.80665
private const val MICROS_PER_YEAR = 365.2425 * 86_400.0e6
private const val EPOCH_YEAR = 1970.0

/**
 * What a phone knows of its vehicle by its own sensors, in one message: where it is by GPS, carried ahead by its velocity,
 * and how it lies. Out: sensed-state. Thesis 4.6.3: the phone's sensors, before a GPS and a compass joined the IOIO.
 *
 * It publishes nothing while the fix is older than FIX TIMEOUT: a vehicle that does not know where it is must hear that.
 */
class PhoneStateSensor(context: ServiceContext, private val sensors: PhoneSensors) :
    ProprioceptiveSensor(context, "PhoneSensor", STEPS_PER_S) {
    private val mounting = Mounting.valueOf(getVariable(MOUNTING))
    private val fixTimeoutMicros = Clock.micros(getVariable(FIX_TIMEOUT))
    private val attitudeTimeoutMicros = Clock.micros(getVariable(ATTITUDE_TIMEOUT))
    private val headingSigmaRad = getVariable(HEADING_SIGMA)
    private var said = ""

    override fun step(nowS: Double) {
        val reading = sensors.read()
        val now = clock().micros()
        report(trouble(reading, now))
        val fix = reading.fix?.takeIf { it.valid() && now - it.measuredAtMicros() <= fixTimeoutMicros } ?: return
        publish(Channels.SENSED_STATE, state(fix, reading, now))
    }

    private fun trouble(reading: PhoneSensors.Reading, now: Long): String = when {
        reading.trouble.isNotEmpty() -> reading.trouble
        reading.fix == null -> "no GPS fix yet"
        !reading.fix.valid() -> "GPS has no position"
        now - reading.fix.measuredAtMicros() > fixTimeoutMicros -> "GPS fix is too old"
        reading.orientation == null || now - reading.orientation.measuredAtMicros > attitudeTimeoutMicros -> "no attitude"
        else -> ""
    }

    private fun report(trouble: String) {
        if (trouble != said) {
            said = trouble
            log(if (trouble.isEmpty()) LogLevelEnum.INFO else LogLevelEnum.WARN, trouble.ifEmpty { "all sensors are there" })
        }
    }

    private fun state(fix: GpsFix, reading: PhoneSensors.Reading, now: Long): StateInformation {
        val state = StateInformation().sensorName(sensorName()).referenceFrame(ReferenceFrame.GLOBAL)
        state.timestamp(now)
        val place = place(fix, now)
        state.x(place.longitudeDeg()).y(place.latitudeDeg())
        fix.eastMps().ifPresent(state::xDot)
        fix.northMps().ifPresent(state::yDot)
        fix.upMps().ifPresent(state::zDot)
        fix.horizontalSigmaM().ifPresent { state.xSigma(it).ySigma(it) }
        altitude(fix, reading.pressure, state)
        val orientation = reading.orientation
        if (orientation != null && now - orientation.measuredAtMicros <= attitudeTimeoutMicros) {
            val declinationRad = MagneticModel.declinationRad(place.latitudeDeg(), place.longitudeDeg(), 0.0, year(now))
            attitude(orientation, declinationRad, state)
            movement(orientation, reading, declinationRad, state)
        }
        return state
    }

    /** The fix, carried ahead by its own velocity. */
    private fun place(fix: GpsFix, now: Long): Geodetic {
        val ageS = Clock.seconds(now - fix.measuredAtMicros())
        val measured = Geodetic(fix.longitudeDeg(), fix.latitudeDeg(), 0.0)
        val ahead = Point.of(fix.eastMps().orElse(0.0) * ageS, fix.northMps().orElse(0.0) * ageS, 0.0)
        return measured.fromEnu(ahead)
    }

    private fun altitude(fix: GpsFix, pressure: PhoneSensors.Pressure?, state: StateInformation) {
        if (fix.altitudeM().isPresent) {
            state.z(fix.altitudeM().asDouble)
            fix.verticalSigmaM().ifPresent(state::zSigma)
        } else if (pressure != null) {
            state.z(Barometer.altitudeM(pressure.pascals)).zSigma(Barometer.SIGMA_M)
        }
    }

    private fun attitude(orientation: Orientation, declinationRad: Double, state: StateInformation) {
        val attitude = orientation.attitude(mounting)
        state.phi(attitude.phi).theta(attitude.theta).psi((attitude.psi + declinationRad).mod(2.0 * Math.PI))
        state.psiSigma(orientation.headingSigmaRad ?: headingSigmaRad)
    }

    private fun movement(
        orientation: Orientation,
        reading: PhoneSensors.Reading,
        declinationRad: Double,
        state: StateInformation,
    ) {
        reading.acceleration?.let {
            val magnetic = orientation.toEnu(it.vector)
            val trueEnu = turned(magnetic, declinationRad)
            // at rest an accelerometer feels the ground push it up with one g
            state.xDoubleDot(trueEnu.x()).yDoubleDot(trueEnu.y()).zDoubleDot(trueEnu.z() - GRAVITY_MPS2)
        }
        reading.turnRate?.let { state.psiDot(-orientation.toEnu(it.vector).z()) } // psi grows clockwise, seen from above
    }

    /** A vector along magnetic east and north in true east and north. */
    private fun turned(magnetic: Point, declinationRad: Double): Point {
        val sin = Math.sin(declinationRad)
        val cos = Math.cos(declinationRad)
        return Point.of(
            cos * magnetic.x() + sin * magnetic.y(),
            -sin * magnetic.x() + cos * magnetic.y(),
            magnetic.z(),
        )
    }

    override fun release() = sensors.close()

    companion object {
        private val MOUNTING: Variable<String> = Variable.text("MOUNTING")
            .oneOf(*Mounting.entries.map(Mounting::name).toTypedArray())
            .ifAbsent(Mounting.FLAT.name)
            .describedAs("How the phone is fixed: FLAT on its back, top edge forward; UPRIGHT or SIDEWAYS with its camera forward.")
        private val FIX_TIMEOUT: Variable<Double> = Variable.number("FIX TIMEOUT", "s")
            .range(Range.of(0.1, 60.0))
            .ifAbsent(2.5)
            .describedAs("Age at which a GPS fix counts as lost.")
        private val ATTITUDE_TIMEOUT: Variable<Double> = Variable.number("ATTITUDE TIMEOUT", "s")
            .range(Range.of(0.1, 60.0))
            .ifAbsent(0.5)
            .describedAs("Age at which the phone's attitude counts as lost; the state then says no heading.")
        private val HEADING_SIGMA: Variable<Double> = Variable.number("HEADING SIGMA", "rad")
            .range(Range.positive())
            .ifAbsent(0.17)
            .describedAs("Standard deviation of the heading where the phone does not say one.")

        private fun year(micros: Long) = EPOCH_YEAR + micros / MICROS_PER_YEAR
    }
}
