/**
 * Messages as Foxglove's well-known protobuf types, so that Foxglove and other viewers show them
 * without setup. The schemas are from github.com/foxglove/foxglove-sdk (MIT), compiled by protoc.
 * Messages without a counterpart are not converted; recordings hold them natively.
 */
package org.u2sa.recorder.foxglove;
