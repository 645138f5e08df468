package org.u2sa.android.sensor

import android.Manifest
import android.content.Context
import android.content.pm.PackageManager
import android.hardware.Sensor
import android.hardware.SensorEvent
import android.hardware.SensorEventListener
import android.hardware.SensorManager
import android.location.Location
import android.location.LocationListener
import android.location.LocationManager
import android.os.Handler
import android.os.HandlerThread
import android.os.SystemClock
import org.u2sa.device.port.GpsFix
import org.u2sa.interfaces.time.Clock
import org.u2sa.messages.frame.Point

private const val SAMPLE_EVERY_MICROS = 20_000
private const val FIX_EVERY_MS = 200L
private const val NANOS_PER_MICRO = 1_000L
private const val PASCALS_PER_HECTOPASCAL = 100.0

/**
 * The sensors of this phone. Absent sensors and denied permissions yield no readings. Callbacks run on a dedicated thread that
 * ends with [close].
 */
class AndroidPhoneSensors(private val context: Context, private val clock: Clock) : PhoneSensors {
    private val thread = HandlerThread("u2sa-phone-sensors").apply { start() }
    private val sensorManager = context.getSystemService(Context.SENSOR_SERVICE) as SensorManager
    private val locationManager = context.getSystemService(Context.LOCATION_SERVICE) as LocationManager

    @Volatile private var fix: GpsFix? = null
    @Volatile private var orientation: PhoneOrientation? = null
    @Volatile private var acceleration: PhoneSensors.Sample? = null
    @Volatile private var turnRate: PhoneSensors.Sample? = null
    @Volatile private var pressure: PhoneSensors.Pressure? = null
    @Volatile private var trouble = ""

    private val motion = object : SensorEventListener {
        override fun onSensorChanged(event: SensorEvent) = take(event)

        override fun onAccuracyChanged(sensor: Sensor, accuracy: Int) = Unit // the rotation vector reports its own accuracy
    }

    private val location = object : LocationListener {
        override fun onLocationChanged(location: Location) {
            fix = fixOf(location, measuredAt(location.elapsedRealtimeNanos))
        }

        override fun onProviderEnabled(provider: String) {
            trouble = ""
        }

        override fun onProviderDisabled(provider: String) {
            trouble = "location is switched off in the phone's settings"
        }

        @Deprecated("Never called since Android 10, but abstract on Android 9 and 10")
        override fun onStatusChanged(provider: String?, status: Int, extras: android.os.Bundle?) = Unit
    }

    init {
        val handler = Handler(thread.looper)
        listOf(Sensor.TYPE_ROTATION_VECTOR, Sensor.TYPE_ACCELEROMETER, Sensor.TYPE_GYROSCOPE, Sensor.TYPE_PRESSURE)
            .mapNotNull(sensorManager::getDefaultSensor)
            .forEach { sensorManager.registerListener(motion, it, SAMPLE_EVERY_MICROS, handler) }
        listenToGps()
    }

    private fun listenToGps() {
        val allowed = context.checkSelfPermission(Manifest.permission.ACCESS_FINE_LOCATION)
        trouble = when {
            allowed != PackageManager.PERMISSION_GRANTED -> "location permission was denied"
            LocationManager.GPS_PROVIDER !in locationManager.allProviders -> "the phone has no GPS"
            else -> {
                locationManager.requestLocationUpdates(
                    LocationManager.GPS_PROVIDER, FIX_EVERY_MS, 0.0f, location, thread.looper,
                )
                if (locationManager.isProviderEnabled(LocationManager.GPS_PROVIDER)) "" else "location is switched off"
            }
        }
    }

    private fun take(event: SensorEvent) {
        val at = measuredAt(event.timestamp)
        when (event.sensor.type) {
            Sensor.TYPE_ROTATION_VECTOR -> PhoneOrientation.of(at, event.values)?.let { orientation = it }
            Sensor.TYPE_ACCELEROMETER -> sample(at, event.values)?.let { acceleration = it }
            Sensor.TYPE_GYROSCOPE -> sample(at, event.values)?.let { turnRate = it }
            Sensor.TYPE_PRESSURE ->
                if (event.values[0] > 0.0f) {
                    pressure = PhoneSensors.Pressure(at, event.values[0] * PASCALS_PER_HECTOPASCAL)
                }
        }
    }

    private fun sample(at: Long, values: FloatArray): PhoneSensors.Sample? =
        if (values.size >= 3 && values.take(3).all { it.isFinite() }) {
            PhoneSensors.Sample(at, Point.of(values[0].toDouble(), values[1].toDouble(), values[2].toDouble()))
        } else {
            null
        }

    /** Android timestamps count from boot, so they are converted via the reading's age. */
    private fun measuredAt(elapsedRealtimeNanos: Long): Long {
        val ageMicros = (SystemClock.elapsedRealtimeNanos() - elapsedRealtimeNanos) / NANOS_PER_MICRO
        return clock.micros() - maxOf(0L, ageMicros)
    }

    override fun read() = PhoneSensors.Reading(fix, orientation, acceleration, turnRate, pressure, trouble)

    override fun close() {
        sensorManager.unregisterListener(motion)
        locationManager.removeUpdates(location)
        thread.quitSafely()
    }
}
