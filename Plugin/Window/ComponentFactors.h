#ifndef galaxy_ComponentFactors_h
#define galaxy_ComponentFactors_h

#include <QMap>
#include <QStringList>
#include <QVariantList>

namespace galaxy
{
/// A property of Splats by component name, such as ComponentSize: what is not named has its
/// default. `width` values follow each name.
class ComponentFactors
{
public:
  explicit ComponentFactors(int width = 1)
    : width(width)
  {
  }

  /// As the property lists them: a name and its values, one after the other.
  QVariantList list() const;
  void set(const QVariantList& list);

  QStringList names() const { return this->values.keys(); }
  bool has(const QString& name) const { return this->values.contains(name); }
  /// One value a component; `fallback` where it is not named.
  double value(const QString& name, double fallback) const;
  QVariantList at(const QString& name) const { return this->values.value(name); }

  /// False where nothing changes. A list that is empty, or a value that is `fallback`, is not
  /// named any more.
  bool change(const QString& name, const QVariantList& list);
  bool change(const QString& name, double value, double fallback);

private:
  int width;
  QMap<QString, QVariantList> values;
};
}

#endif
