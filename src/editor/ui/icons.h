// The icons in use, of Material Design Icons 1.6, as UTF-8. The build reads this file and embeds
// these alone: every line ends with its code point.
#pragma once

namespace artisketch::icon {

inline constexpr const char* kMenu = "\xEF\x8D\x9C";                  // U+F35C
inline constexpr const char* kCheck = "\xEF\x84\xAC";                 // U+F12C
inline constexpr const char* kPencil = "\xEF\x8F\xAB";                // U+F3EB
inline constexpr const char* kBone = "\xEF\x82\xB9";                  // U+F0B9
inline constexpr const char* kWalk = "\xEF\x96\x83";                  // U+F583
inline constexpr const char* kCubeOutline = "\xEF\x86\xA7";           // U+F1A7
inline constexpr const char* kUndoVariant = "\xEF\x95\x8D";           // U+F54D
inline constexpr const char* kRedoVariant = "\xEF\x91\x8F";           // U+F44F
inline constexpr const char* kExport = "\xEF\x88\x87";                // U+F207
inline constexpr const char* kHelpCircleOutline = "\xEF\x98\xA5";     // U+F625
inline constexpr const char* kCursorDefaultOutline = "\xEF\x86\xB5";  // U+F1B5
inline constexpr const char* kVectorPolyline = "\xEF\x95\xA1";        // U+F561
inline constexpr const char* kAutoFix = "\xEF\x81\xA8";               // U+F068
inline constexpr const char* kContentCut = "\xEF\x86\x90";            // U+F190
inline constexpr const char* kCompare = "\xEF\x86\x8A";               // U+F18A
inline constexpr const char* kContentCopy = "\xEF\x86\x8F";           // U+F18F
inline constexpr const char* kFlipToBack = "\xEF\x89\x87";            // U+F247
inline constexpr const char* kFlipToFront = "\xEF\x89\x88";           // U+F248
inline constexpr const char* kImage = "\xEF\x8B\xA9";                 // U+F2E9
inline constexpr const char* kVectorCurve = "\xEF\x95\x99";           // U+F559
inline constexpr const char* kGrid = "\xEF\x8B\x81";                  // U+F2C1
inline constexpr const char* kPalette = "\xEF\x8F\x98";               // U+F3D8
inline constexpr const char* kChevronLeft = "\xEF\x85\x81";           // U+F141
inline constexpr const char* kChevronRight = "\xEF\x85\x82";          // U+F142
inline constexpr const char* kChevronDown = "\xEF\x85\x80";           // U+F140
inline constexpr const char* kMinus = "\xEF\x8D\xB4";                 // U+F374
inline constexpr const char* kPlus = "\xEF\x90\x95";                  // U+F415
inline constexpr const char* kArrowExpandAll = "\xEF\x81\x8C";        // U+F04C
inline constexpr const char* kFullscreen = "\xEF\x8A\x93";            // U+F293
inline constexpr const char* kAlert = "\xEF\x80\xA6";                 // U+F026
inline constexpr const char* kTriangle = "\xEF\x94\xB6";              // U+F536
inline constexpr const char* kCrosshairsGps = "\xEF\x86\xA4";         // U+F1A4
inline constexpr const char* kCursorMove = "\xEF\x86\xB6";            // U+F1B6
inline constexpr const char* kRotate3d = "\xEF\x91\xA4";              // U+F464
inline constexpr const char* kRotateRight = "\xEF\x91\xA7";           // U+F467
inline constexpr const char* kSwapHorizontal = "\xEF\x93\xA1";        // U+F4E1
inline constexpr const char* kLockOutline = "\xEF\x8D\x81";           // U+F341
inline constexpr const char* kBackupRestore = "\xEF\x81\xAF";         // U+F06F
inline constexpr const char* kKeyVariant = "\xEF\x8C\x8B";            // U+F30B
inline constexpr const char* kVectorCircleVariant = "\xEF\x95\x97";   // U+F557
inline constexpr const char* kArrowExpand = "\xEF\x98\x96";           // U+F616
inline constexpr const char* kRepeat = "\xEF\x91\x96";                // U+F456
inline constexpr const char* kPlay = "\xEF\x90\x8A";                  // U+F40A
inline constexpr const char* kPause = "\xEF\x8F\xA4";                 // U+F3E4
inline constexpr const char* kSkipPrevious = "\xEF\x92\xAE";          // U+F4AE
inline constexpr const char* kSkipNext = "\xEF\x92\xAD";              // U+F4AD
inline constexpr const char* kDiamond = "\xEF\x87\x88";               // U+F1C8
inline constexpr const char* kCubeSend = "\xEF\x86\xA8";              // U+F1A8
inline constexpr const char* kPrinter3d = "\xEF\x90\xAB";             // U+F42B
inline constexpr const char* kImageMultiple = "\xEF\x8B\xB9";         // U+F2F9
inline constexpr const char* kCheckCircle = "\xEF\x97\xA0";           // U+F5E0
inline constexpr const char* kClose = "\xEF\x85\x96";                 // U+F156
inline constexpr const char* kDownload = "\xEF\x87\x9A";              // U+F1DA
inline constexpr const char* kFolderOutline = "\xEF\x89\x96";         // U+F256
inline constexpr const char* kFolderImage = "\xEF\x89\x8F";           // U+F24F
inline constexpr const char* kEyeOff = "\xEF\x88\x89";                // U+F209
inline constexpr const char* kRefresh = "\xEF\x91\x90";               // U+F450
inline constexpr const char* kContentSave = "\xEF\x86\x93";           // U+F193
inline constexpr const char* kContentSaveSettings = "\xEF\x98\x9B";   // U+F61B
inline constexpr const char* kHistory = "\xEF\x8B\x9A";               // U+F2DA
inline constexpr const char* kThemeLightDark = "\xEF\x94\x8E";        // U+F50E
inline constexpr const char* kKeyboard = "\xEF\x8C\x8C";              // U+F30C
inline constexpr const char* kTexture = "\xEF\x94\x8C";               // U+F50C
inline constexpr const char* kDelete = "\xEF\x87\x80";                // U+F1C0
inline constexpr const char* kFileDocumentBox = "\xEF\x88\x9A";       // U+F21A
inline constexpr const char* kCached = "\xEF\x83\xA8";                // U+F0E8
inline constexpr const char* kCamera = "\xEF\x84\x80";                // U+F100
inline constexpr const char* kRecord = "\xEF\x91\x8A";                // U+F44A
inline constexpr const char* kCropSquare = "\xEF\x86\xA2";            // U+F1A2
inline constexpr const char* kArrowLeftBold = "\xEF\x81\x8E";         // U+F04E
inline constexpr const char* kTarget = "\xEF\x93\xBE";                // U+F4FE
inline constexpr const char* kMagnifyPlus = "\xEF\x8D\x8B";           // U+F34B
inline constexpr const char* kFolderMultipleImage = "\xEF\x89\x94";   // U+F254
inline constexpr const char* kRun = "\xEF\x91\xAE";                   // U+F46E
inline constexpr const char* kLink = "\xEF\x8C\xB7";                  // U+F337
inline constexpr const char* kLightbulbOutline = "\xEF\x8C\xB6";      // U+F336

}  // namespace artisketch::icon
