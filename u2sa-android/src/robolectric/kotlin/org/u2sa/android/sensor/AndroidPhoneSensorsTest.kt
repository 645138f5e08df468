package org.u2sa.android.sensor

import android.Manifest
import android.hardware.Sensor
import android.hardware.SensorManager
import android.location.LocationManager
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.data.Offset.offset
import org.junit.After
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.Shadows.shadowOf
import org.robolectric.shadows.ShadowSensor
import org.robolectric.shadows.SensorEventBuilder
import org.u2sa.android.OnPhone
import org.u2sa.interfaces.time.SystemClock

@RunWith(RobolectricTestRunner::class)
class AndroidPhoneSensorsTest {
    private val phone = OnPhone()
    private val clock = SystemClock()
    private val manager = phone.application.getSystemService(SensorManager::class.java)
    private val made = mutableListOf<AndroidPhoneSensors>()

    @After
    fun close() = made.forEach(AndroidPhoneSensors::close)

    private fun sensors() = AndroidPhoneSensors(phone.application, clock).also(made::add)

    private fun has(type: Int): Sensor = ShadowSensor.newInstance(type).also { shadowOf(manager).addSensor(it) }

    private fun measures(sensor: Sensor, vararg values: Float) {
        val event = SensorEventBuilder.newBuilder().setSensor(sensor).setValues(values)
            .setTimestamp(android.os.SystemClock.elapsedRealtimeNanos()).build()
        shadowOf(manager).sendSensorEventToListeners(event)
    }

    @Test
    fun read_eachSensor_isInSiUnitsAndOfTheRunsClock() {
        val rotation = has(Sensor.TYPE_ROTATION_VECTOR)
        val acceleration = has(Sensor.TYPE_ACCELEROMETER)
        val gyroscope = has(Sensor.TYPE_GYROSCOPE)
        val barometer = has(Sensor.TYPE_PRESSURE)
        val sensors = sensors()
        val before = clock.micros()
        measures(rotation, 0f, 0f, 0f, 1f)
        measures(acceleration, 1f, 2f, 9.8f)
        measures(gyroscope, 0.1f, 0.2f, 0.3f)
        measures(barometer, 1013.25f)

        val reading = sensors.read()
        assertThat(reading.orientation!!.attitude(Mounting.FLAT).psi).isCloseTo(0.0, offset(1e-9))
        assertThat(reading.orientation!!.measuredAtMicros).isBetween(before, clock.micros())
        assertThat(reading.acceleration!!.vector.z()).isCloseTo(9.8, offset(1e-6))
        assertThat(reading.turnRate!!.vector.y()).isCloseTo(0.2, offset(1e-6))
        assertThat(reading.pressure!!.pascals).isCloseTo(101_325.0, offset(0.1))
    }

    @Test
    fun read_valuesThatAreNoNumbers_areLeftOut() {
        val rotation = has(Sensor.TYPE_ROTATION_VECTOR)
        val acceleration = has(Sensor.TYPE_ACCELEROMETER)
        val sensors = sensors()
        measures(rotation, Float.NaN, 0f, 0f, 1f)
        measures(acceleration, 0f, Float.POSITIVE_INFINITY, 0f)

        assertThat(sensors.read().orientation).isNull()
        assertThat(sensors.read().acceleration).isNull()
    }

    @Test
    fun read_phoneWithoutAnySensor_isEmpty() {
        val reading = sensors().read()
        assertThat(reading.orientation).isNull()
        assertThat(reading.pressure).isNull()
        assertThat(reading.fix).isNull()
    }

    @Test
    fun read_locationNotAllowed_saysSo() {
        assertThat(sensors().read().trouble).contains("permission")
    }

    @Test
    fun read_locationAllowed_isAFixWithItsUncertainty() {
        phone.allow(Manifest.permission.ACCESS_FINE_LOCATION)
        val locations = phone.application.getSystemService(LocationManager::class.java)
        shadowOf(locations).setProviderEnabled(LocationManager.GPS_PROVIDER, true)
        val sensors = sensors()
        phone.await("a fix") {
            phone.isAt(-81.05, 29.19)
            sensors.read().fix != null
        }

        val fix = sensors.read().fix!!
        assertThat(fix.valid()).isTrue()
        assertThat(fix.longitudeDeg()).isEqualTo(-81.05)
        assertThat(fix.eastMps().asDouble).isCloseTo(1.5 * Math.sqrt(0.5), offset(1e-6))
        assertThat(fix.horizontalSigmaM().asDouble).isCloseTo(3.0 / 1.51, offset(1e-6))
        assertThat(fix.altitudeM()).isEmpty() // above the ellipsoid, not the sea
        assertThat(sensors.read().trouble).isEmpty()
    }
}
